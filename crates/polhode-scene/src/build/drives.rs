//! What drives the joints of a robot: drives of the scene by names of joints, and the names of its file.

use super::fault::Fault;
use super::{coordinate_motion, joint};
use crate::document::KeyPath;
use crate::error::{Refusal, nearest};
use crate::format::{DriveEntry, ModelEntry};
use crate::robot::{MotorBound, NamedJoint, Placement, Robot, RobotDrive};

/// What stands for any characters in the name of a joint.
const ANY: char = '*';

/// Adds the drives of an entry to the placement of its robot, and checks the names that it gives of the robot's file.
pub(super) fn add(entry: &ModelEntry, robot: &Robot, placement: &mut Placement, path: &KeyPath) -> Result<(), Fault> {
    if let Some(name) = &entry.keyframe {
        let names: Vec<&str> = robot.keyframes.iter().map(|own| own.name.as_str()).collect();
        known(name, &names, ("keyframe", "none, the file has no keyframes"), &path.key("keyframe"))?;
    }
    let names: Vec<&str> = robot.actuators.iter().map(|own| own.name.as_str()).collect();
    for name in entry.controls.keys() {
        let of_name = path.key("controls").key(name.clone());
        known(name, &names, ("actuator", "none, the file has no actuators that are simulated"), &of_name)?;
    }
    let joints = robot.coordinate_names();
    let path = path.key("drives");
    // Names come before patterns.
    let is_pattern = |name: &str| name.contains(ANY);
    for (name, own) in entry.drives.iter().filter(|(name, _)| !is_pattern(name)) {
        let path = path.key(name.clone());
        known(name, &joints, NO_JOINTS, &path)?;
        placement.drives.insert(name.clone(), drive(own, &path)?);
    }
    let mut matched = std::collections::BTreeMap::new();
    for (pattern, own) in entry.drives.iter().filter(|(name, _)| is_pattern(name)) {
        let path = path.key(pattern.clone());
        let made = drive(own, &path)?;
        let mut found = joints.iter().filter(|name| is_match(pattern, name)).peekable();
        if found.peek().is_none() {
            known(pattern, &joints, NO_JOINTS, &path)?;
        }
        for &name in found {
            if let Some(other) = matched.insert(name, pattern).filter(|_| !entry.drives.contains_key(name)) {
                let (joint, other) = (name.to_owned(), other.clone());
                return Err((path, Refusal::DrivenTwice { joint, other }));
            }
            placement.drives.entry(name.to_owned()).or_insert_with(|| made.clone());
        }
    }
    Ok(())
}

/// What messages call a joint that can be driven, and that there is none.
const NO_JOINTS: (&str, &str) = ("hinge or slider", "none, the file has no hinges and no sliders");

/// Checks that a joint that is driven is one of the scene.
pub(super) fn check(placement: &Placement, joints: &[NamedJoint], path: &KeyPath) -> Result<(), Fault> {
    let prefix = if placement.prefix.is_empty() { String::new() } else { format!("{}/", placement.prefix) };
    let driven = joints.iter().filter(|own| own.coordinate.is_some());
    let names: Vec<&str> = driven.filter_map(|own| own.name.strip_prefix(&prefix)).collect();
    for name in placement.drives.keys().filter(|name| !names.contains(&name.as_str())) {
        let none = "none: joints of several axes and parts without mass have no coordinate along which drives act";
        known(name, &names, ("joint of one coordinate in the scene", none), &path.key("drives").key(name.clone()))?;
    }
    Ok(())
}

fn known(name: &str, names: &[&str], (kind, none): (&'static str, &str), path: &KeyPath) -> Result<(), Fault> {
    if names.contains(&name) {
        return Ok(());
    }
    let known = nearest(name, names, none);
    Err((path.clone(), Refusal::UnknownName { kind, name: name.to_owned(), known }))
}

fn drive(entry: &DriveEntry, path: &KeyPath) -> Result<RobotDrive, Fault> {
    let motor = entry.motor.as_ref().map(|own| joint::motor(own, &path.key("motor"))).transpose()?;
    let motion = entry.motion.as_ref().map(|own| coordinate_motion::of_entry(own, &path.key("motion"))).transpose()?;
    let bound = match entry.motor.as_ref().and_then(|own| own.most) {
        Some(_) => MotorBound::Given,
        None => MotorBound::OfFile,
    };
    match (&motor, &motion) {
        (None, None) => Err((path.clone(), Refusal::Needs { what: "a drive", needed: "`motor` or `motion`" })),
        (Some(_), Some(_)) => Err((path.key("motion"), Refusal::Excludes { key: "motion", other: "motor" })),
        _ => Ok(RobotDrive { motor, bound, motion }),
    }
}

/// Whether a name is what a pattern with `*` for any characters stands for.
fn is_match(pattern: &str, name: &str) -> bool {
    let Some((first, rest)) = pattern.split_once(ANY) else { return pattern == name };
    let Some(name) = name.strip_prefix(first) else { return false };
    let starts = name.char_indices().map(|(at, _)| at).chain([name.len()]);
    starts.into_iter().any(|at| name.get(at..).is_some_and(|tail| is_match(rest, tail)))
}
