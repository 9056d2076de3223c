//! What acts along the coordinates of joints: limits, motors, springs that are wound up, dry friction; and ropes.

use crate::random_mechanism::build::Build;
use crate::random_mechanism::model::{Coordinate, JointKind};
use glam::DVec3;
use std::f64::consts::PI;

/// Joints with coordinates.
const KINDS: &[JointKind] = &[JointKind::Hinge, JointKind::Slider, JointKind::Cylindrical, JointKind::Screw];

impl Build {
    /// A narrow range, so that it is reached within the piece.
    pub(super) fn limit(&mut self, joint: usize, coordinate: Coordinate) {
        let width = if coordinate == Coordinate::Angle { 0.3 } else { 0.1 };
        let (low, high) = (-width * self.random.between(0.1, 1.0), width * self.random.between(0.1, 1.0));
        let any = self.random.unit();
        let restitution = self.random.one_of(&[0.0, 0.0, 0.5, 1.0, any]);
        self.act(joint, coordinate, &format!("range = [{low:?}, {high:?}], restitution = {restitution:?}"));
    }

    /// Dry friction by an effort, or that of a bearing.
    pub(super) fn joint_friction(&mut self, joint: usize, coordinate: Coordinate, bearing: bool) {
        let random = &mut self.random;
        let words = if bearing {
            let coefficient = random.between(0.05, 0.6);
            let radius = if coordinate == Coordinate::Angle {
                format!(", radius = {:?}", random.between(0.01, 0.1))
            } else {
                String::new()
            };
            format!("friction = {{ coefficient = {coefficient:?}{radius} }}")
        } else {
            let effort = random.between(0.2, 8.0);
            let breakaway = effort * random.one_of(&[1.0, 1.0, 1.4]);
            format!("friction = {{ effort = {effort:?}, breakaway = {breakaway:?} }}")
        };
        self.act(joint, coordinate, &words);
    }
}

/// Trees with limits of their coordinates.
pub(in crate::random_mechanism) fn limits(build: &mut Build) {
    build.scene.duration = 0.4;
    for joint in build.any_tree(3, KINDS) {
        let coordinates = build.coordinates(joint);
        let coordinate = coordinates[build.random.below(coordinates.len())];
        build.limit(joint, coordinate);
    }
}

/// Ropes that hang loose and go taut.
pub(in crate::random_mechanism) fn rope(build: &mut Build) {
    build.scene.duration = 0.4;
    let mut from = (None, DVec3::ZERO);
    for _ in 0..=build.random.below(2) {
        let at = from.1 + build.random.direction() * build.random.between(0.2, 0.5);
        let end = at + build.random.direction() * 0.4;
        let body = build.bar(at, end);
        let pair: Vec<usize> = std::iter::once(body).chain(from.0).collect();
        let length = (at - from.1).length() * build.random.between(1.02, 1.3);
        let joint = build.line(JointKind::Rope, &pair, [at, from.1], length);
        let restitution = build.random.one_of(&[0.0, 0.5, 1.0]);
        build.scene.joints[joint].keys.push(("restitution", super::super::build::text(restitution)));
        from = (Some(body), end);
    }
}

/// A spring that is wound past half a turn, or unwinds from there, of a joint with an angle.
pub(in crate::random_mechanism) fn winding(build: &mut Build) {
    build.scene.duration = 0.6;
    let axis = build.random.direction();
    let kind = build.random.one_of(&[JointKind::Hinge, JointKind::Screw, JointKind::Cylindrical]);
    let end = build.random.direction() * 0.3;
    let body = build.bar(DVec3::ZERO, end);
    let joint = build.joint(kind, &[body], DVec3::ZERO, &[axis]);
    let inertia = build.inertia(joint, Coordinate::Angle);
    let rate = build.random.between(2.0, 5.0);
    let stiffness = inertia * rate * rate;
    let rest = build.random.one_of(&[0.0, 0.0, 4.0, -5.0]);
    let damping = build.random.one_of(&[0.0, 0.05]) * inertia * rate;
    build.act(joint, Coordinate::Angle, &format!("stiffness = {stiffness:?}, rest = {rest:?}, damping = {damping:?}"));
    if kind == JointKind::Cylindrical {
        build.spring(joint, Coordinate::Displacement);
    }
    let turn = axis * build.random.one_of(&[-1.0, 1.0]) * build.random.between(PI, 5.0) * rate;
    build.body(body).angular_velocity = turn;
    build.body(body).velocity = turn.cross(build.scene.bodies[body].position);
}

/// Servos of position or rate without a bound, also to angles beyond half a turn.
pub(in crate::random_mechanism) fn servo(build: &mut Build) {
    build.scene.duration = 0.5;
    for joint in build.any_tree(2, KINDS) {
        let coordinates = build.coordinates(joint);
        let coordinate = coordinates[build.random.below(coordinates.len())];
        let words = servo_words(build, joint, coordinate);
        build.act(joint, coordinate, &format!("motor = {{ {words} }}"));
    }
}

fn servo_words(build: &mut Build, joint: usize, coordinate: Coordinate) -> String {
    let inertia = build.inertia(joint, coordinate);
    let random = &mut build.random;
    let rate = random.between(4.0, 15.0);
    let goal = if coordinate == Coordinate::Angle { random.between(-5.0, 5.0) } else { random.between(-0.5, 0.5) };
    match random.below(3) {
        0 => format!("effort = {:?}", inertia * random.between(-20.0, 20.0)),
        1 => format!("velocity = {goal:?}, gain = {:?}", inertia * rate),
        _ => {
            let damping = 2.0 * inertia * rate * random.between(0.1, 1.0);
            format!("position = {goal:?}, stiffness = {:?}, damping = {damping:?}", inertia * rate * rate)
        }
    }
}

/// Servos that reach their bounds and leave them.
pub(in crate::random_mechanism) fn bounded_motor(build: &mut Build) {
    build.scene.duration = 0.4;
    for joint in build.any_tree(2, KINDS) {
        let coordinates = build.coordinates(joint);
        let coordinate = coordinates[build.random.below(coordinates.len())];
        let words = servo_words(build, joint, coordinate);
        let most = build.inertia(joint, coordinate) * build.random.between(2.0, 60.0);
        build.act(joint, coordinate, &format!("motor = {{ {words}, most = {most:?} }}"));
    }
}

/// Dry friction in joints: what moves stops, what rests is held or breaks away.
pub(in crate::random_mechanism) fn friction(build: &mut Build) {
    build.scene.duration = 0.2;
    for joint in build.any_tree(3, KINDS) {
        for &coordinate in build.coordinates(joint) {
            let bearing = build.random.below(3) == 0;
            build.joint_friction(joint, coordinate, bearing);
            if build.random.below(3) == 0 {
                build.spring(joint, coordinate);
            }
        }
    }
    if build.random.below(4) == 0 {
        build.at_rest();
    }
}
