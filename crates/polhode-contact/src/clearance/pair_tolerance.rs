//! The tolerances of a pair of shapes.

use crate::Shape;
use crate::clearance::place_tolerance::{RESOLUTION_ULPS, smaller_size};
use polhode_spatial::Pose;

/// The smaller of the two sizes, m; that of the other shape when one has none (a half-space, a single point); 0 when
/// neither has one.
pub fn joint_size(shape_a: &Shape, shape_b: &Shape) -> f64 {
    smaller_size(shape_a.size(), shape_b.size())
}

/// The length that bounds the rounding of the pair's arithmetic, m: the sum of both sizes, both radii about the centres
/// of mass, and the distance of the centres of mass. A half-space contributes the distance of its plane from its
/// origin.
pub fn scale(shape_a: &Shape, pose_a: &Pose, shape_b: &Shape, pose_b: &Pose) -> f64 {
    let lengths = |shape: &Shape| match shape {
        Shape::HalfSpace(h) => h.offset().abs(),
        _ => shape.size() + shape.radius(),
    };
    lengths(shape_a) + lengths(shape_b) + (pose_a.translation - pose_b.translation).length()
}

/// Separations up to this are zero within rounding, m: `4 eps` times the scale.
pub fn resolution(shape_a: &Shape, pose_a: &Pose, shape_b: &Shape, pose_b: &Pose) -> f64 {
    RESOLUTION_ULPS * f64::EPSILON * scale(shape_a, pose_a, shape_b, pose_b)
}

/// Separations up to this count as touch, m: `relative` times the joint size, and no less than twice the resolution.
pub fn touch_tolerance(shape_a: &Shape, pose_a: &Pose, shape_b: &Shape, pose_b: &Pose, relative: f64) -> f64 {
    (relative * joint_size(shape_a, shape_b)).max(2.0 * resolution(shape_a, pose_a, shape_b, pose_b))
}
