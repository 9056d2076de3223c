//! Trees of joints of all kinds, with springs and dampers along them; springs between bodies, and drag.

use crate::random_mechanism::build::{Build, across, text};
use crate::random_mechanism::model::{Force, JointKind, Value};
use glam::DVec3;

/// Kinds of joints that a tree has.
const KINDS: &[JointKind] = &[
    JointKind::Ball,
    JointKind::Hinge,
    JointKind::Universal,
    JointKind::Fixed,
    JointKind::Slider,
    JointKind::Cylindrical,
    JointKind::Screw,
    JointKind::Planar,
    JointKind::Rod,
];

impl Build {
    /// A tree of 1 to 4 bodies: each on an earlier one or on the world, by joints of these kinds. Gives the joints.
    pub(super) fn any_tree(&mut self, most: usize, kinds: &[JointKind]) -> Vec<usize> {
        let mut ends: Vec<(Option<usize>, DVec3)> = vec![(None, DVec3::ZERO)];
        let mut joints = Vec::new();
        for _ in 0..=self.random.below(most) {
            let (parent, at) = ends[self.random.below(ends.len())];
            let end = at + self.random.direction() * self.random.between(0.2, 0.7);
            let body = self.bar(at, end);
            let pair: Vec<usize> = std::iter::once(body).chain(parent).collect();
            let axis = self.random.direction();
            let kind = kinds[self.random.below(kinds.len())];
            let joint = match kind {
                JointKind::Rod => {
                    let other = at + self.random.direction() * self.random.between(0.1, 0.4);
                    self.line(kind, &pair, [other, at], 0.0)
                }
                JointKind::Universal => self.joint(kind, &pair, at, &[axis, across(axis)[0]]),
                JointKind::Ball | JointKind::Fixed => self.joint(kind, &pair, at, &[]),
                _ => self.joint(kind, &pair, at, &[axis]),
            };
            joints.push(joint);
            ends.push((Some(body), end));
        }
        joints
    }
}

/// A tree of joints of all kinds.
pub(in crate::random_mechanism) fn tree(build: &mut Build) {
    for joint in build.any_tree(4, KINDS) {
        for &coordinate in build.coordinates(joint) {
            if build.random.below(2) == 0 {
                build.spring(joint, coordinate);
            }
        }
    }
}

/// Springs between the bodies of a tree and the world, and drag on all.
pub(in crate::random_mechanism) fn forces(build: &mut Build) {
    build.any_tree(3, &[JointKind::Ball, JointKind::Hinge, JointKind::Universal, JointKind::Slider]);
    for body in 0..build.scene.bodies.len() {
        let (name, place) = (build.scene.bodies[body].name.clone(), build.scene.bodies[body].position);
        let anchor = place + build.random.direction() * build.random.between(0.3, 1.0);
        let mut keys = vec![
            ("body", Value::Text(format!("\"{name}\""))),
            ("anchor", Value::Point(anchor)),
            ("stiffness", text(build.random.between(5.0, 80.0))),
            ("rest_length", text(build.random.between(0.0, 0.5))),
        ];
        if build.random.below(2) == 0 {
            keys.push(("damping", text(build.random.between(0.1, 3.0))));
        }
        build.scene.forces.push(Force { kind: "spring", keys });
    }
    let law = build.random.one_of(&["\"linear\"", "\"quadratic\""]);
    let keys = vec![
        ("law", Value::Text(law.to_owned())),
        ("translational", text(build.random.between(0.1, 2.0))),
        ("rotational", text(build.random.between(0.01, 0.2))),
    ];
    build.scene.forces.push(Force { kind: "drag", keys });
}
