//! Gears, prescribed motions of joints, and joints on bodies of prescribed motion.

use crate::random_mechanism::build::{Build, across, text};
use crate::random_mechanism::model::{Coordinate, JointKind, Member, Role, Value};
use glam::{DQuat, DVec3};
use std::f64::consts::TAU;

/// Wheels, racks and a rope over a pulley.
pub(in crate::random_mechanism) fn gears(build: &mut Build) {
    let mut before: Option<(usize, Coordinate)> = None;
    for k in 0..2 + build.random.below(2) {
        let (at, axis) = (DVec3::X * (0.8 * k as f64), build.random.direction());
        let kind = build.random.one_of(&[JointKind::Hinge, JointKind::Hinge, JointKind::Slider, JointKind::Screw]);
        let end = at + build.random.direction() * 0.3;
        let body = build.bar(at, end);
        let joint = build.joint(kind, &[body], at, &[axis]);
        let coordinate = build.coordinates(joint)[0];
        if build.random.below(2) == 0 {
            build.spring(joint, coordinate);
        }
        if let Some((first, of_first)) = before {
            let ratio = build.random.one_of(&[-1.0, 1.0]) * build.random.between(0.3, 3.0);
            let names = [first, joint].map(|number| format!("\"{}\"", build.scene.joints[number].name));
            build.scene.gears.push(format!("joints = [{}]\nratio = {ratio:?}", names.join(", ")));
            build.gears.push([(first, of_first, 1.0), (joint, coordinate, -ratio)]);
        }
        before = Some((joint, coordinate));
        if build.random.below(3) == 0 {
            let far = end + build.random.direction() * 0.3;
            let rider = build.bar(end, far);
            build.joint(JointKind::Hinge, &[rider, body], end, &[across(axis)[0]]);
        }
    }
}

/// A tree of which a coordinate has a prescribed motion.
pub(in crate::random_mechanism) fn prescribed(build: &mut Build) {
    let kinds = [JointKind::Hinge, JointKind::Slider, JointKind::Cylindrical, JointKind::Screw];
    let joints = build.any_tree(3, &kinds);
    for joint in joints {
        let coordinates = build.coordinates(joint);
        let coordinate = coordinates[build.random.below(coordinates.len())];
        if build.random.below(3) == 0 {
            build.spring(joint, coordinate);
            continue;
        }
        let random = &mut build.random;
        let (amplitude, frequency, phase) =
            (random.between(0.05, 0.5), random.between(0.5, 3.0), random.between(0.0, TAU));
        let (words, rate) = match random.below(3) {
            0 => (format!("rate = {amplitude:?}"), amplitude),
            1 => (
                format!("sine = {{ amplitude = {amplitude:?}, frequency = {frequency:?}, phase = {phase:?} }}"),
                amplitude * TAU * frequency * libm::cos(phase),
            ),
            _ => {
                let values: Vec<f64> = (0..4).map(|_| random.between(-0.2, 0.2)).collect();
                (format!("table = {{ times = [0, 0.1, 0.2, 0.4], values = {values:?} }}"), 0.0)
            }
        };
        build.act(joint, coordinate, &format!("motion = {{ {words} }}"));
        build.scene.joints[joint].rate = Some((coordinate, rate));
    }
}

impl Build {
    /// A body of prescribed motion at the origin, with a shape or without.
    pub(super) fn driven(&mut self, shape: Option<String>, orientation: DQuat, gentle: f64) -> usize {
        let random = &mut self.random;
        let (velocity, angular_velocity);
        let (motion, keys) = if random.below(2) == 0 {
            (velocity, angular_velocity) = (random.vector(-0.5, 0.5) * gentle, random.vector(-3.0, 3.0) * gentle);
            let keys = vec![
                ("velocity", Value::Direction(velocity)),
                ("angular_velocity", Value::Direction(angular_velocity)),
            ];
            ("constant", keys)
        } else {
            let (amplitude, axis) = (random.vector(-0.1, 0.1) * gentle, random.direction());
            let (angle, frequency) = (random.between(0.05, 0.5) * gentle, random.between(0.5, 3.0));
            let rate = TAU * frequency;
            (velocity, angular_velocity) = (amplitude * rate, axis * (angle * rate));
            let keys = vec![
                ("amplitude", Value::Direction(amplitude)),
                ("axis", Value::Direction(axis)),
                ("angle", text(angle)),
                ("frequency", text(frequency)),
            ];
            ("sine", keys)
        };
        let member = Member {
            name: "driven".to_owned(),
            size: 1.0,
            shape,
            role: Role::Moved(motion, keys),
            position: DVec3::ZERO,
            orientation,
            velocity,
            angular_velocity,
            material: None,
            more: Vec::new(),
            is_loose: false,
        };
        self.add(member)
    }
}

/// A chain on a body that has a prescribed motion.
pub(in crate::random_mechanism) fn on_driven(build: &mut Build) {
    let driver = build.driven(None, DQuat::IDENTITY, 1.0);
    let (mut parent, mut at) = (driver, build.random.direction() * 0.3);
    for _ in 0..=build.random.below(3) {
        let end = at + build.random.direction() * build.random.between(0.2, 0.5);
        let body = build.bar(at, end);
        let axis = build.random.direction();
        let kind = build.random.one_of(&[JointKind::Ball, JointKind::Hinge, JointKind::Slider, JointKind::Cylindrical]);
        let joint = build.joint(kind, &[body, parent], at, &[axis]);
        if parent != driver {
            // Springs to bodies of prescribed motion are refused by name.
            for &coordinate in build.coordinates(joint) {
                build.spring(joint, coordinate);
            }
        }
        (parent, at) = (body, end);
    }
}
