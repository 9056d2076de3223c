//! Robots from files of their own.

use super::exactly::{Exactly, Vector};
use super::joint::{CoordinateMotionEntry, MotorEntry};
use schemars::JsonSchema;
use serde::Deserialize;
use std::collections::BTreeMap;

/// A robot from a URDF or an MJCF file.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ModelEntry {
    /// What the names of its bodies begin with, before a slash: NAME/LINK; when absent they are called as its links.
    pub name: Option<String>,
    /// URDF or MJCF file, relative to the scene file.
    pub file: String,
    /// Position of the frame of the file: that of the root link, or of the world of an MJCF file, m.
    pub position: Option<Vector>,
    /// Its orientation as a unit quaternion [w, x, y, z]; or rotation_vector.
    pub orientation: Option<Exactly<f64, 4>>,
    /// Its orientation as axis times angle, rad; or orientation.
    pub rotation_vector: Option<Vector>,
    /// What holds the root link; when absent, the world holds one that is named `world` or has no mass.
    pub base: Option<BaseName>,
    /// Values of joints at the start, rad or m, by their names; those of the file when absent, moved into the limits.
    #[serde(default)]
    pub configuration: BTreeMap<String, f64>,
    /// Name of the keyframe of an MJCF file in which it starts: its coordinates, their rates, and controls of
    /// actuators; what `configuration` and `controls` name comes before it.
    pub keyframe: Option<String>,
    /// Controls of actuators of an MJCF file, by their names; those of the keyframe, or 0, when absent.
    #[serde(default)]
    pub controls: BTreeMap<String, f64>,
    /// What drives joints, by their names; `*` in a name stands for any characters. It comes before actuators of the
    /// file.
    #[serde(default)]
    pub drives: BTreeMap<String, DriveEntry>,
    /// Its links collide with each other, but for those that a joint connects.
    #[serde(default)]
    pub self_collision: bool,
    /// What becomes of inertias that no body can have: the robot is refused, unless they are repaired.
    #[serde(default)]
    pub unphysical: UnphysicalName,
    /// Folders that hold the packages of `package://` names, relative to the scene file; the folders above the robot
    /// file are looked at too.
    #[serde(default)]
    pub packages: Vec<String>,
    /// Name of a material of all its bodies; without one friction and restitution are 0.
    pub material: Option<String>,
}

/// What drives a joint of a robot, along its coordinate as the robot file counts it: exactly one of the keys.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct DriveEntry {
    /// A motor; without `most` its effort is bounded as the robot file says.
    pub motor: Option<MotorEntry>,
    /// A motion that the joint follows from where it starts; its limits are not kept.
    pub motion: Option<CoordinateMotionEntry>,
}

/// What holds the root link of a robot.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum BaseName {
    /// Nothing.
    Free,
    /// The world.
    Fixed,
}

/// What becomes of inertias that no body can have.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum UnphysicalName {
    /// The robot is refused.
    #[default]
    Refuse,
    /// Each is replaced by the nearest one that a body can have.
    Repair,
}
