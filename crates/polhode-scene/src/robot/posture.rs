//! Where the links of a robot are: from the values of its coordinates to poses.
//!
//! `X_ML = X_MP X_PL X(q - q0)`, with M the frame of the model, P the parent, q0 the reference value at which the file
//! gives `X_PL`.

use super::drive::RobotDrive;
use super::finding::{Findings, RobotDefect};
use super::model::{Keyframe, Robot, RobotCoordinate, RobotJoint, RobotJointKind};
use super::reading::turned;
use glam::{DQuat, DVec3};
use polhode::spatial::{Pose, Rotation};
use std::collections::BTreeMap;

/// The robot with its free and ball joints as a keyframe has them, and the values of its other coordinates.
pub(super) fn at_keyframe(robot: &Robot, keyframe: &Keyframe) -> (Robot, BTreeMap<String, f64>) {
    let (mut keyed, mut values) = (robot.clone(), BTreeMap::new());
    let Some(numbers) = &keyframe.coordinates else { return (keyed, values) };
    for (joint, own) in keyed.joints.iter_mut().zip(parts(robot, 0, numbers)) {
        match (joint.kind, own.as_slice()) {
            (RobotJointKind::Free, [x, y, z, quaternion @ ..]) => {
                joint.origin = Pose::new(rotation(quaternion), DVec3::new(*x, *y, *z));
            }
            (RobotJointKind::Ball, quaternion) => {
                let turned = rotation(quaternion);
                joint.origin = joint.origin * Pose::new(turned, joint.anchor - turned.rotate(joint.anchor));
            }
            (_, [value]) => values.extend(joint.coordinates.first().map(|own| (own.name.clone(), *value))),
            _ => {}
        }
    }
    (keyed, values)
}

/// The numbers of each joint among those of all, which are as many as the joints have.
fn parts(robot: &Robot, which: usize, numbers: &[f64]) -> Vec<Vec<f64>> {
    let mut rest = numbers.iter().copied();
    robot.joints.iter().map(|joint| rest.by_ref().take(joint.kind.sizes()[which]).collect()).collect()
}

/// The rotation of a quaternion w, x, y, z of any length; none of one of zeros.
fn rotation(wxyz: &[f64]) -> Rotation {
    match *wxyz {
        [w, x, y, z] if wxyz.iter().any(|&number| number != 0.0) => {
            Rotation::renormalized(DQuat::from_xyzw(x, y, z, w))
        }
        _ => Rotation::IDENTITY,
    }
}

/// The rates of the joints at the start, in their order: those of prescribed motions, or else of a keyframe; `None`
/// when all are at rest.
pub(super) fn rates(
    robot: &Robot,
    keyframe: Option<&Keyframe>,
    drives: &BTreeMap<String, RobotDrive>,
) -> Option<Vec<Vec<f64>>> {
    let numbers = keyframe.and_then(|keyframe| keyframe.rates.as_deref()).unwrap_or_default();
    let mut rates = parts(robot, 1, numbers);
    for (joint, own) in robot.joints.iter().zip(&mut rates) {
        let drive = joint.coordinates.first().and_then(|coordinate| drives.get(&coordinate.name));
        if let Some(motion) = drive.and_then(|drive| drive.motion.as_ref()) {
            *own = vec![motion.rate_at_start()];
        }
    }
    let place = |name: &str| robot.joints.iter().position(|joint| joint.name == name);
    // As their values: a chain of all of them is done after so many rounds.
    for _ in 0..robot.followers.len() {
        for own in &robot.followers {
            let (Some(joint), Some(leader)) = (place(&own.name), place(&own.leader)) else { continue };
            let of_leader = rates[leader].first().copied().unwrap_or(0.0);
            rates[joint] = vec![if own.is_held() { 0.0 } else { own.multiplier * of_leader }];
        }
    }
    rates.iter().flatten().any(|&rate| rate != 0.0).then_some(rates)
}

/// Values of the coordinates at the start, in the order of joints and coordinates: what is given, that of a keyframe,
/// or the pose of the file, moved into the limits.
pub(super) fn start(
    robot: &Robot,
    (given, keyed): (&BTreeMap<String, f64>, &BTreeMap<String, f64>),
    findings: &mut Findings,
) -> Vec<f64> {
    let mut values = Vec::with_capacity(robot.joints.len());
    for joint in &robot.joints {
        // Only joints of one coordinate have a value.
        let value = joint.coordinates.first().map_or(0.0, |own| start_of(own, (given, keyed), findings));
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

fn start_of(
    coordinate: &RobotCoordinate,
    (given, keyed): (&BTreeMap<String, f64>, &BTreeMap<String, f64>),
    findings: &mut Findings,
) -> f64 {
    let asked = given.get(&coordinate.name).copied();
    let of_keyframe = keyed.get(&coordinate.name).copied().filter(|_| asked.is_none());
    let value = asked.or(of_keyframe).unwrap_or(coordinate.reference);
    let Some([lower, upper]) = coordinate.limits else { return value };
    let subject = || format!("joint `{}`", coordinate.name);
    match asked {
        Some(value) if !(lower..=upper).contains(&value) => {
            findings.add(&coordinate.place, subject(), RobotDefect::BeyondLimits { value, lower, upper });
            value
        }
        None if !(lower..=upper).contains(&value) => {
            let start = value.clamp(lower, upper);
            let defect = match of_keyframe {
                Some(value) => RobotDefect::KeyBeyond { value, lower, upper, start },
                None => RobotDefect::StartMoved { lower, upper, start },
            };
            findings.add(&coordinate.place, subject(), defect);
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
