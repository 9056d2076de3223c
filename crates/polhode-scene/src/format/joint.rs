//! Joints.

use super::exactly::{Exactly, Vector};
use schemars::JsonSchema;
use serde::Deserialize;

/// Kinds of joint, for messages.
pub(crate) const JOINTS: &str = "ball, hinge, universal, fixed, slider, cylindrical or planar";

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
    Ball(PointJointEntry),
    /// A point and an axis of both bodies: the rotation about the axis is free.
    Hinge(AxisJointEntry),
    /// A point of both bodies, and an axis of each at right angles: the rotations about both are free.
    Universal(UniversalJointEntry),
    /// The bodies move as one.
    Fixed(PointJointEntry),
    /// A line of the second body, or of the world, on which a point of the first slides without a rotation.
    Slider(AxisJointEntry),
    /// An axis of both bodies: the rotation about it and the displacement along it are free.
    Cylindrical(AxisJointEntry),
    /// A plane of the second body, or of the world, in which a point of the first slides; both keep its normal.
    Planar(PlanarJointEntry),
}

/// A joint at a point.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct PointJointEntry {
    /// Names of the two bodies; of one that is held by the world.
    #[schemars(length(min = 1, max = 2))]
    pub bodies: Vec<String>,
    /// The point at t = 0, m, world.
    pub anchor: Vector,
}

/// A joint along an axis.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct AxisJointEntry {
    /// Names of the two bodies; of one that is held by the world.
    #[schemars(length(min = 1, max = 2))]
    pub bodies: Vec<String>,
    /// A point of the axis at t = 0, m, world.
    pub anchor: Vector,
    /// The direction of the axis at t = 0, world; of any length but zero.
    pub axis: Vector,
}

/// A universal joint.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct UniversalJointEntry {
    /// Names of the two bodies; of one that is held by the world.
    #[schemars(length(min = 1, max = 2))]
    pub bodies: Vec<String>,
    /// The point at t = 0, m, world.
    pub anchor: Vector,
    /// The directions of the axes at t = 0, world, at right angles: the first of the first body, the second of the other or of the
    /// world.
    pub axes: Exactly<Vector, 2>,
}

/// A planar joint.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct PlanarJointEntry {
    /// Names of the two bodies; of one that is held by the world.
    #[schemars(length(min = 1, max = 2))]
    pub bodies: Vec<String>,
    /// A point of the plane at t = 0, m, world.
    pub anchor: Vector,
    /// The normal of the plane at t = 0, world; of any length but zero.
    pub normal: Vector,
}
