//! Few bodies that fly, land, slide, roll, and are carried.

use crate::random_mechanism::build::{Build, attitude};
use crate::random_mechanism::model::{JointKind, Role};
use glam::{DQuat, DVec3};
use std::f64::consts::TAU;

/// A half-space below the plane z = 0.
pub(super) const FLOOR: &str = "half_space = { normal = [0, 0, 1] }";

impl Build {
    /// A convex body of any primitive shape; its size is that of its farthest point at the most.
    fn primitive(&mut self) -> (String, f64) {
        let random = &mut self.random;
        let (a, b, c) = (random.between(0.1, 0.4), random.between(0.1, 0.4), random.between(0.1, 0.4));
        match random.below(5) {
            0 | 1 => (format!("box = {{ size = [{a:?}, {b:?}, {c:?}] }}"), 0.5 * DVec3::new(a, b, c).length()),
            2 => (format!("sphere = {{ radius = {a:?} }}"), a),
            3 => (format!("cylinder = {{ radius = {a:?}, height = {b:?} }}"), a.hypot(0.5 * b)),
            _ => (format!("capsule = {{ radius = {a:?}, height = {b:?} }}"), a + 0.5 * b),
        }
    }

    /// Friction of a random size, static friction at times above it, and restitution.
    fn any_material(&mut self, is_rough: bool) -> usize {
        let any = self.random.unit();
        let restitution = self.random.one_of(&[0.0, 0.0, 0.5, 1.0, any]);
        let friction = if is_rough { self.random.between(0.1, 1.2) } else { 0.0 };
        let more = self.random.one_of(&[1.0, 1.0, 1.3]);
        self.material(friction, friction * more, restitution)
    }

    /// A body in the air, moving.
    fn flying(&mut self, at: DVec3, material: usize, speed: DVec3) -> usize {
        let (shape, size) = self.primitive();
        let orientation = attitude(&mut self.random);
        let body = self.solid(shape, size, at + DVec3::Z * size, orientation);
        let (spread, spin) = (self.random.vector(-1.0, 1.0), self.random.vector(-4.0, 4.0));
        let member = self.body(body);
        (member.velocity, member.angular_velocity) = (speed + spread, spin);
        (member.material, member.is_loose) = (Some(material), true);
        body
    }

    fn thrown(&mut self, is_rough: bool) {
        let material = self.any_material(is_rough);
        self.fixed(FLOOR.to_owned(), DVec3::ZERO, DQuat::IDENTITY, material);
        let at = DVec3::Z * self.random.between(0.02, 0.15);
        self.flying(at, material, DVec3::Z * -1.0);
        if self.random.below(3) == 0 {
            let aside = DVec3::new(1.2, 0.1, self.random.between(0.02, 0.2));
            self.flying(aside, material, DVec3::new(-2.0, 0.0, -0.5));
        }
    }

    /// A box that stands on the plane z = 0 at this place; gives it and half its height.
    pub(super) fn standing(&mut self, at: DVec3, edges: DVec3, turn: f64, material: usize) -> usize {
        let shape = format!("box = {{ size = [{:?}, {:?}, {:?}] }}", edges.x, edges.y, edges.z);
        let orientation = DQuat::from_rotation_z(turn);
        let body = self.solid(shape, 0.5 * edges.length(), at + DVec3::Z * (0.5 * edges.z), orientation);
        self.body(body).material = Some(material);
        body
    }

    pub(super) fn edges(&mut self) -> DVec3 {
        self.random.vector(0.15, 0.4)
    }
}

/// Bodies that land on a smooth floor.
pub(in crate::random_mechanism) fn smooth(build: &mut Build) {
    build.thrown(false);
}

/// Bodies that land on a rough floor.
pub(in crate::random_mechanism) fn rough(build: &mut Build) {
    build.thrown(true);
}

/// Two bodies that meet in space.
pub(in crate::random_mechanism) fn in_space(build: &mut Build) {
    build.scene.gravity = DVec3::ZERO;
    let is_rough = build.random.below(2) == 0;
    let material = build.any_material(is_rough);
    build.flying(DVec3::X * -0.6, material, DVec3::X * 3.0);
    build.flying(DVec3::new(0.6, 0.1, 0.05), material, DVec3::X * -3.0);
}

/// A box that slides on a level or sloping floor and may stop.
pub(in crate::random_mechanism) fn slide(build: &mut Build) {
    let slope = build.random.one_of(&[0.0, 0.2, 0.4]);
    let friction = build.random.between(0.2, 0.9);
    let more = build.random.one_of(&[1.0, 1.3]);
    let material = build.material(friction, friction * more, 0.0);
    build.fixed(FLOOR.to_owned(), DVec3::ZERO, DQuat::IDENTITY, material);
    let edges = build.edges();
    let body = build.standing(DVec3::ZERO, DVec3::new(edges.x, edges.y, 0.4 * edges.z), 0.3, material);
    build.scene.gravity = DQuat::from_rotation_y(slope) * build.scene.gravity;
    let turn = build.random.one_of(&[0.0, 1.0]) * build.random.between(-3.0, 3.0);
    let angle = build.random.between(0.0, TAU);
    let speed = build.random.between(0.0, 1.5);
    let member = build.body(body);
    member.velocity = DVec3::new(libm::cos(angle), libm::sin(angle), 0.0) * speed;
    member.angular_velocity = DVec3::Z * turn;
}

/// A ball, a cylinder or a capsule that rolls and slips.
pub(in crate::random_mechanism) fn roll(build: &mut Build) {
    let friction = build.random.between(0.05, 0.8);
    let material = build.material(friction, friction, 0.0);
    if build.random.below(3) == 0 {
        build.scene.materials[material] += "\nrolling_friction = 0.003";
    }
    build.fixed(FLOOR.to_owned(), DVec3::ZERO, DQuat::IDENTITY, material);
    build.scene.gravity = DQuat::from_rotation_y(build.random.between(0.0, 0.5)) * build.scene.gravity;
    let radius = build.random.between(0.05, 0.2);
    let (shape, orientation) = match build.random.below(3) {
        0 => (format!("sphere = {{ radius = {radius:?} }}"), attitude(&mut build.random)),
        1 => (format!("cylinder = {{ radius = {radius:?}, height = 0.3 }}"), lying(build)),
        _ => (format!("capsule = {{ radius = {radius:?}, height = 0.3 }}"), lying(build)),
    };
    let body = build.solid(shape, radius, DVec3::Z * radius, orientation);
    let (velocity, spin) = (build.random.vector(-1.0, 1.0), build.random.vector(-8.0, 8.0));
    let axis = orientation * DVec3::Z;
    let is_ball = build.scene.bodies[body].shape.as_ref().is_some_and(|shape| shape.starts_with("sphere"));
    let member = build.body(body);
    member.material = Some(material);
    member.velocity = DVec3::new(velocity.x, velocity.y, 0.0);
    member.angular_velocity = if is_ball { spin } else { axis * spin.x };
}

fn lying(build: &mut Build) -> DQuat {
    DQuat::from_rotation_z(build.random.between(0.0, TAU)) * DQuat::from_rotation_x(0.25 * TAU)
}

/// A box or a ball on a belt.
pub(in crate::random_mechanism) fn belt(build: &mut Build) {
    let friction = build.random.between(0.2, 0.9);
    let material = build.material(friction, friction, 0.0);
    let speed = build.random.vector(-1.5, 1.5);
    let belt = build.fixed("box = { size = [4, 4, 0.2] }".to_owned(), DVec3::Z * -0.1, DQuat::IDENTITY, material);
    build.body(belt).more.push(format!("surface_velocity = [{:?}, {:?}, 0]", speed.x, speed.y));
    if build.random.below(2) == 0 {
        let edges = build.edges();
        build.standing(DVec3::ZERO, DVec3::new(edges.x, edges.y, 0.5 * edges.z), 0.7, material);
    } else {
        let radius = build.random.between(0.05, 0.2);
        let body = build.solid(
            format!("sphere = {{ radius = {radius:?} }}"),
            radius,
            DVec3::Z * radius,
            DQuat::from_rotation_x(0.4),
        );
        build.body(body).material = Some(material);
    }
}

/// Bodies on a turntable or a plate that shakes.
pub(in crate::random_mechanism) fn moving_floor(build: &mut Build) {
    build.scene.duration = 0.2;
    let friction = build.random.between(0.2, 1.0);
    let material = build.material(friction, friction, 0.0);
    let floor = build.driven(Some("box = { size = [4, 4, 0.2] }".to_owned()), DQuat::IDENTITY, 0.4);
    let spins = build.random.below(2) == 0;
    let rate = build.random.between(-4.0, 4.0);
    let member = build.body(floor);
    member.material = Some(material);
    member.position = DVec3::Z * -0.1;
    if spins {
        member.velocity = DVec3::ZERO;
        member.angular_velocity = DVec3::Z * rate;
        let keys =
            vec![("angular_velocity", crate::random_mechanism::model::Value::Direction(member.angular_velocity))];
        member.role = Role::Moved("constant", keys);
    }
    let edges = build.edges();
    let at = DVec3::new(build.random.between(0.0, 0.6), 0.2, 0.0);
    let body = build.standing(at, DVec3::new(edges.x, edges.y, 0.5 * edges.z), 0.2, material);
    if spins && build.random.below(2) == 0 {
        let member = build.body(body);
        member.velocity = (DVec3::Z * rate).cross(member.position);
        member.angular_velocity = DVec3::Z * rate;
    }
}

/// A body that slides over flush tiles.
pub(in crate::random_mechanism) fn seams(build: &mut Build) {
    build.scene.duration = 0.2;
    let is_rough = build.random.below(2) == 0;
    let friction = if is_rough { build.random.between(0.05, 0.4) } else { 0.0 };
    let material = build.material(friction, friction, 0.0);
    let tile = build.random.between(0.2, 0.5);
    for k in 0..8 {
        let at = DVec3::new(tile * (f64::from(k) + 0.5), 0.0, -0.1);
        build.fixed(format!("box = {{ size = [{tile:?}, 2, 0.2] }}"), at, DQuat::IDENTITY, material);
    }
    let radius = build.random.between(0.06, 0.15);
    let at = DVec3::new(0.2, build.random.between(-0.2, 0.2), 0.0);
    let body = if build.random.below(2) == 0 {
        let shape = format!("cylinder = {{ radius = {radius:?}, height = 0.05 }}");
        let body = build.solid(shape, radius, at + DVec3::Z * 0.025, DQuat::IDENTITY);
        build.body(body).material = Some(material);
        body
    } else {
        build.standing(at, DVec3::new(radius, 1.4 * radius, 0.05), 0.5, material)
    };
    let (speed, spin) = (build.random.between(1.0, 3.0), build.random.between(-3.0, 3.0));
    let member = build.body(body);
    (member.velocity, member.angular_velocity) = (DVec3::X * speed, DVec3::Z * spin);
}

/// Two or three jointed bodies that fall on a floor.
pub(in crate::random_mechanism) fn mechanism(build: &mut Build) {
    let is_rough = build.random.below(2) == 0;
    let material = build.any_material(is_rough);
    build.fixed(FLOOR.to_owned(), DVec3::ZERO, DQuat::IDENTITY, material);
    let mut before: Option<usize> = None;
    for k in 0..2 + build.random.below(2) {
        let at = DVec3::new(0.5 * k as f64, 0.0, 0.55);
        let (shape, size) = build.primitive();
        let orientation = attitude(&mut build.random);
        let body = build.solid(shape, size, at, orientation);
        build.body(body).material = Some(material);
        build.body(body).velocity = DVec3::Z * -2.0;
        build.body(body).angular_velocity = build.random.vector(-1.0, 1.0);
        if let Some(other) = before {
            let axis = build.random.direction();
            let kind = build.random.one_of(&[JointKind::Ball, JointKind::Hinge, JointKind::Hinge, JointKind::Slider]);
            let joint = build.joint(kind, &[body, other], at - DVec3::X * 0.25, &[axis]);
            if kind == JointKind::Hinge && build.random.below(2) == 0 {
                build.limit(joint, crate::random_mechanism::model::Coordinate::Angle);
            }
        }
        before = Some(body);
    }
    // Bodies two apart in the chain would overlap as they fold: they are let through each other.
    build.scene.apart = build.scene.bodies.iter().filter(|body| body.is_free()).map(|body| body.name.clone()).collect();
}
