//! Small piles: at rest, pushed, struck by a ball, dropped.

use super::thrown::FLOOR;
use crate::random_mechanism::build::{Build, attitude};
use crate::random_mechanism::model::{Force, Value};
use glam::{DQuat, DVec3};

impl Build {
    fn floor(&mut self, friction: f64, restitution: f64) -> usize {
        let material = self.material(friction, friction, restitution);
        self.fixed(FLOOR.to_owned(), DVec3::ZERO, DQuat::IDENTITY, material);
        material
    }

    /// A stack of boxes that stands: each lies on the one below, with its centre above it.
    fn stack(&mut self, count: usize, material: usize) -> Vec<usize> {
        let (mut at, mut bodies) = (DVec3::ZERO, Vec::new());
        for _ in 0..count {
            let edges = self.edges();
            let edges = DVec3::new(edges.x, edges.y, 0.5 * edges.z);
            let turn = self.random.between(0.0, 0.5);
            bodies.push(self.standing(at, edges, turn, material));
            at += DVec3::new(self.random.between(-0.03, 0.03), self.random.between(-0.03, 0.03), edges.z);
        }
        bodies
    }
}

/// A stack at rest.
pub(in crate::random_mechanism) fn rest(build: &mut Build) {
    build.scene.duration = 0.2;
    let friction = build.random.between(0.2, 1.0);
    let material = build.floor(friction, 0.0);
    let count = 2 + build.random.below(4);
    build.stack(count, material);
}

/// A stack of which a force pushes one body.
pub(in crate::random_mechanism) fn pushed(build: &mut Build) {
    build.scene.duration = 0.16;
    let friction = build.random.between(0.2, 0.8);
    let material = build.floor(friction, 0.0);
    let count = 1 + build.random.below(3);
    let bodies = build.stack(count, material);
    let body = bodies[build.random.below(bodies.len())];
    let name = build.scene.bodies[body].name.clone();
    let push = build.random.vector(-25.0, 25.0) * DVec3::new(1.0, 1.0, 0.1);
    let keys = vec![("body", Value::Text(format!("\"{name}\""))), ("force", Value::Direction(push))];
    build.scene.forces.push(Force { kind: "force", keys });
}

/// A ball that hits a block or a stack at rest.
pub(in crate::random_mechanism) fn struck(build: &mut Build) {
    (build.scene.duration, build.scene.step) = (0.14, 0.0004);
    let (friction, restitution) = (build.random.between(0.0, 0.8), build.random.one_of(&[0.0, 0.3, 0.6]));
    let material = build.floor(friction, restitution);
    let count = 1 + build.random.below(2);
    let bodies = build.stack(count, material);
    let target = build.scene.bodies[bodies[build.random.below(bodies.len())]].position;
    let radius = build.random.between(0.06, 0.12);
    let at = target + DVec3::new(-0.5, build.random.between(-0.08, 0.08), build.random.between(0.1, 0.2));
    let ball = build.solid(format!("sphere = {{ radius = {radius:?} }}"), radius, at, DQuat::from_rotation_x(0.4));
    let speed = build.random.between(3.0, 6.0);
    let member = build.body(ball);
    member.velocity = DVec3::X * speed;
    (member.material, member.is_loose) = (Some(material), true);
}

/// A few boxes and balls that are dropped together.
pub(in crate::random_mechanism) fn dropped(build: &mut Build) {
    build.scene.duration = 0.24;
    let (friction, restitution) = (build.random.one_of(&[0.0, 0.4, 0.8]), build.random.one_of(&[0.0, 0.0, 0.3]));
    let material = build.floor(friction, restitution);
    for k in 0..3 + build.random.below(3) {
        let layer = (k / 2) as f64;
        let at = DVec3::new(0.42 * (k % 2) as f64, 0.0, 0.2 + 0.36 * layer) + build.random.vector(-0.02, 0.02);
        let size = build.random.between(0.1, 0.16);
        let shape = if build.random.below(2) == 0 {
            format!("sphere = {{ radius = {size:?} }}")
        } else {
            let edge = 2.0 * size / 3.0_f64.sqrt();
            format!("box = {{ size = [{edge:?}, {edge:?}, {edge:?}] }}")
        };
        let orientation = attitude(&mut build.random);
        let body = build.solid(shape, size, at, orientation);
        let spin = build.random.vector(-1.0, 1.0);
        let member = build.body(body);
        (member.velocity, member.angular_velocity) = (DVec3::Z * -1.5, spin);
        (member.material, member.is_loose) = (Some(material), true);
    }
}
