//! Joints.

use super::exactly::Vector;
use schemars::JsonSchema;
use serde::Deserialize;

/// Kinds of joint, for messages.
pub(crate) const JOINTS: &str = "ball or hinge";

/// A joint: what holds two bodies, or a body and the world, together.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct JointEntry {
    /// What kind of joint.
    #[serde(rename = "type")]
    pub kind: JointKindEntry,
}

/// Kinds of joint.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum JointKindEntry {
    /// A point of both bodies: all rotations about it are free.
    Ball(BallJointEntry),
    /// A point and an axis of both bodies: the rotation about the axis is free.
    Hinge(HingeJointEntry),
}

/// A ball joint.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct BallJointEntry {
    /// Names of the two bodies; of one that is held by the world.
    #[schemars(length(min = 1, max = 2))]
    pub bodies: Vec<String>,
    /// The point at t = 0, m, world.
    pub anchor: Vector,
}

/// A hinge.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct HingeJointEntry {
    /// Names of the two bodies; of one that is held by the world.
    #[schemars(length(min = 1, max = 2))]
    pub bodies: Vec<String>,
    /// A point of the axis at t = 0, m, world.
    pub anchor: Vector,
    /// The direction of the axis at t = 0, world; of any length but zero.
    pub axis: Vector,
}
