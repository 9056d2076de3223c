//! Where the links of a robot are: from the values of its coordinates to poses.
//!
//! `X_ML = X_MP X_PL X(q - q0)`, with M the frame of the model, P the parent, q0 the reference value at which the file
//! gives `X_PL`.

use super::finding::{Findings, RobotDefect};
use super::model::{Robot, RobotCoordinate, RobotJoint, RobotJointKind};
use super::reading::turned;
use glam::DVec3;
use polhode::spatial::Pose;
use std::collections::BTreeMap;

/// Values of the coordinates at the start, in the order of joints and coordinates: what is given, or the pose of the
/// file, moved into the limits.
pub(super) fn start(robot: &Robot, given: &BTreeMap<String, f64>, findings: &mut Findings) -> Vec<f64> {
    let mut values = Vec::with_capacity(robot.joints.len());
    for joint in &robot.joints {
        // Only joints of one coordinate have a value.
        let value = joint.coordinates.first().map_or(0.0, |coordinate| start_of(coordinate, given, findings));
        values.push(value);
    }
    follow(robot, &mut values, given, findings);
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

/// Largest difference of a value that is given for a coordinate from the one that it has because it follows another,
/// rad or m: the digits of a file.
const SAME_VALUE: f64 = 1e-6;

/// Gives coordinates that follow others the values that follow.
fn follow(robot: &Robot, values: &mut [f64], given: &BTreeMap<String, f64>, findings: &mut Findings) {
    let place = |name: &str| {
        robot.joints.iter().position(|joint| joint.coordinates.first().is_some_and(|own| own.name == name))
    };
    // One may follow another that follows in turn: a chain of all of them is done after so many rounds.
    for _ in 0..robot.followers.len() {
        for own in &robot.followers {
            let Some(joint) = place(&own.name) else { continue };
            if own.is_held() {
                values[joint] = own.offset;
            } else if let Some(leader) = place(&own.leader) {
                values[joint] = own.multiplier * values[leader] + own.offset;
            }
        }
    }
    for own in &robot.followers {
        let Some(joint) = place(&own.name) else { continue };
        let (value, subject) = (values[joint], format!("joint `{}`", own.name));
        if let Some(&asked) = given.get(&own.name).filter(|&&asked| (asked - value).abs() > SAME_VALUE) {
            findings.add(
                &own.place,
                &subject,
                RobotDefect::Follows { leader: own.leader.clone(), value, given: asked },
            );
        }
        let limits = robot.joints[joint].coordinates.first().and_then(|own| own.limits);
        if let Some([lower, upper]) = limits.filter(|[lower, upper]| !(*lower..=*upper).contains(&value)) {
            findings.add(&own.place, subject, RobotDefect::BeyondLimits { value, lower, upper });
        }
    }
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
        poses[joint.child] = poses[joint.parent] * joint.origin * moved(joint, value);
    }
    poses
}

/// `X(q - q0)` of a joint at a value.
fn moved(joint: &RobotJoint, value: f64) -> Pose {
    let reference = joint.coordinates.first().map_or(0.0, |coordinate| coordinate.reference);
    match joint.kind {
        RobotJointKind::Hinge { axis } => about(joint.anchor, axis.get(), value - reference),
        RobotJointKind::Slider { axis } => Pose::from_translation(axis.get() * (value - reference)),
        _ => Pose::IDENTITY,
    }
}

/// The robot with joints fixed, at these values, that follow others by nothing.
pub(super) fn held(robot: &Robot, values: &[f64]) -> Robot {
    let mut held = robot.clone();
    for follower in robot.followers.iter().filter(|own| own.is_held()) {
        for (joint, &value) in held.joints.iter_mut().zip(values) {
            if joint.coordinates.first().is_some_and(|own| own.name == follower.name) {
                joint.origin = joint.origin * moved(joint, value);
                (joint.kind, joint.coordinates) = (RobotJointKind::Fixed, Vec::new());
            }
        }
    }
    held
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
