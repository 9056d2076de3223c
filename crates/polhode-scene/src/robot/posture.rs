//! Where the links of a robot are: from the values of its coordinates to poses.
//!
//! `X_ML = X_MP X_PL X(q - q0)`, with M the frame of the model, P the parent, q0 the reference value at which the file gives `X_PL`.

use super::finding::{Findings, RobotDefect};
use super::model::{Robot, RobotCoordinate, RobotJointKind};
use super::reading::turned;
use glam::DVec3;
use polhode::spatial::Pose;
use std::collections::BTreeMap;

/// Values of the coordinates at the start, in the order of joints and coordinates: what is given, or the pose of the file, moved
/// into the limits.
pub(super) fn start(robot: &Robot, given: &BTreeMap<String, f64>, findings: &mut Findings) -> Vec<f64> {
    let mut values = Vec::with_capacity(robot.joints.len());
    for joint in &robot.joints {
        // Only joints of one coordinate have a value.
        let value = joint.coordinates.first().map_or(0.0, |coordinate| start_of(coordinate, given, findings));
        values.push(value);
    }
    for name in given.keys() {
        let joint = robot.joints.iter().find(|joint| joint.name == *name);
        if robot.joints.iter().any(|joint| joint.coordinates.iter().any(|own| own.name == *name)) {
            continue;
        }
        let (place, defect) = match joint {
            Some(joint) => (&joint.place, RobotDefect::NoCoordinate(joint.kind.name())),
            None => (&robot.place, RobotDefect::UnknownName { kind: "joint", name: name.clone() }),
        };
        findings.add(place, format!("configuration of `{name}`"), defect);
    }
    values
}

fn start_of(coordinate: &RobotCoordinate, given: &BTreeMap<String, f64>, findings: &mut Findings) -> f64 {
    let asked = given.get(&coordinate.name).copied();
    let value = asked.unwrap_or(coordinate.reference);
    let Some([lower, upper]) = coordinate.limits else { return value };
    let subject = || format!("joint `{}`", coordinate.name);
    match asked {
        Some(value) if !(lower..=upper).contains(&value) => {
            findings.add(&coordinate.place, subject(), RobotDefect::BeyondLimits { value, lower, upper });
            value
        }
        None if !(lower..=upper).contains(&value) => {
            let start = value.clamp(lower, upper);
            findings.add(&coordinate.place, subject(), RobotDefect::StartMoved { lower, upper, start });
            start
        }
        _ => value,
    }
}

/// `X_ML` of each link, for values in the order of the joints. Links stand behind their parents.
pub(super) fn poses(robot: &Robot, values: &[f64]) -> Vec<Pose> {
    let mut poses = vec![Pose::IDENTITY; robot.links.len()];
    for (joint, &value) in robot.joints.iter().zip(values) {
        let reference = joint.coordinates.first().map_or(0.0, |coordinate| coordinate.reference);
        let moved = match joint.kind {
            RobotJointKind::Hinge { axis } => about(joint.anchor, axis.get(), value - reference),
            RobotJointKind::Slider { axis } => Pose::from_translation(axis.get() * (value - reference)),
            _ => Pose::IDENTITY,
        };
        poses[joint.child] = poses[joint.parent] * joint.origin * moved;
    }
    poses
}

/// A rotation about an axis through a point.
fn about(anchor: DVec3, axis: DVec3, angle: f64) -> Pose {
    if angle == 0.0 {
        return Pose::IDENTITY;
    }
    let rotation = turned(axis, angle);
    Pose::new(rotation, anchor - rotation.rotate(anchor))
}

/// The reference values of all joints: those at which the file gives its poses.
pub(super) fn references(robot: &Robot) -> Vec<f64> {
    robot.joints.iter().map(|joint| joint.coordinates.first().map_or(0.0, |own| own.reference)).collect()
}
