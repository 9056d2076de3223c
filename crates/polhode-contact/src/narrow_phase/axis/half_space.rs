//! The height of a shape above a half-space.

use crate::shape::round::support;
use crate::{HalfSpace, Shape};
use polhode_spatial::Pose;

/// Least height of a shape above a half-space; infinite for another half-space.
pub(crate) fn height_above(half_space: &HalfSpace, pose: &Pose, shape: &Shape, pose_of_shape: &Pose) -> f64 {
    let normal = pose.rotation.rotate(half_space.normal);
    let base = normal.dot(pose_of_shape.translation - pose.translation) - half_space.offset;
    // Directions are turned into the shape's frame once, instead of every point into the world.
    let normal = pose_of_shape.rotation.inverse_rotate(normal);
    base - support(shape, -normal)
}
