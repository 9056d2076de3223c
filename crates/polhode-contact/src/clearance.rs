//! The tolerances of a pair, each relative to its size.
//!
//! Two lengths decide: the *joint size*, the smaller of the two sizes, which says how finely features must be told
//! apart, and the *scale*, the largest length that enters the arithmetic, which says how finely they can be.
//! Of a compound the size of its smallest part counts for places (`compound_pair.rs`).

use crate::Shape;
use glam::DVec3;
use polhode_spatial::Pose;

/// Features nearer to each other than this, relative to the joint size, are in one place: a vertex on an edge, a vertex
/// on a vertex, an edge along an edge. Far above the rounding of computed coordinates, far below anything measurable.
pub const COINCIDENCE: f64 = 1e-12;

/// Two edges, lines or axes whose directions differ by less than this (sine of the angle) are parallel: the direction of
/// their common perpendicular would be uncertain by more than the machine's epsilon over this, 2e-9.
pub const PARALLEL_SINE: f64 = 1e-7;

/// Rounding of a computed separation in units of epsilon times the scale.
pub const RESOLUTION_ULPS: f64 = 4.0;

/// Rounding of a feature's place in units of epsilon times the scale: a few operations more than for a separation.
const PLACE_ULPS: f64 = 16.0;

/// The smaller size of the two, m; the other's when one has none (a half-space, a single point); 0 when neither has.
pub fn joint_size(shape_a: &Shape, shape_b: &Shape) -> f64 {
    let (a, b) = (shape_a.size(), shape_b.size());
    if a == 0.0 || b == 0.0 { a.max(b) } else { a.min(b) }
}

/// The largest length that enters the arithmetic of the pair, m: both sizes, both distances from the centre of mass and
/// the distance of the centres.
pub fn scale(shape_a: &Shape, pose_a: &Pose, shape_b: &Shape, pose_b: &Pose) -> f64 {
    let reach = |shape: &Shape| match shape {
        Shape::HalfSpace(h) => h.offset().abs(),
        _ => shape.size() + shape.radius(),
    };
    reach(shape_a) + reach(shape_b) + (pose_a.translation - pose_b.translation).length()
}

/// Separations up to this are zero to rounding, m: `4 eps` times the scale.
pub fn resolution(shape_a: &Shape, pose_a: &Pose, shape_b: &Shape, pose_b: &Pose) -> f64 {
    RESOLUTION_ULPS * f64::EPSILON * scale(shape_a, pose_a, shape_b, pose_b)
}

/// Separations up to this count as touch, m: `relative` times the joint size, and no less than twice the resolution.
pub fn touch_tolerance(shape_a: &Shape, pose_a: &Pose, shape_b: &Shape, pose_b: &Pose, relative: f64) -> f64 {
    (relative * joint_size(shape_a, shape_b)).max(2.0 * resolution(shape_a, pose_a, shape_b, pose_b))
}

/// Distance up to which two features are in one place, m: [`COINCIDENCE`] times the joint size and the rounding of a
/// place. `relative` is the position of one body in the frame of the other.
pub(crate) fn place_tolerance(size_a: f64, size_b: f64, relative: DVec3) -> f64 {
    COINCIDENCE * size_a.min(size_b) + PLACE_ULPS * f64::EPSILON * (size_a + size_b + relative.length())
}
