//! Tolerances of coincident features, parallel directions and equal separations, all relative.

use glam::DVec3;

/// Features nearer to each other than this, relative to the joint size, coincide: a vertex on an edge, a vertex on a
/// vertex, an edge along an edge. Far above the rounding of computed coordinates, far below anything measurable.
pub const COINCIDENCE: f64 = 1e-12;

/// Two faces whose normals have a larger cosine lie flush, and two edges whose directions have it lie along each other.
pub(crate) const FLUSH_COSINE: f64 = 1.0 - 1e-12;

/// Two places of a circle that are nearer to each other than this angle (rad) are one: samples and Newton's method on
/// a minimum locate a place only to the square root of rounding.
pub(crate) const ONE_PLACE: f64 = 1e-6;

/// Bound of the rounding of a square or a distance, relative to the lengths that it is computed from, by which features
/// are told to be out of the question.
pub(crate) const SIEVE_SLACK: f64 = 1e-9;

/// Two edges, lines or axes whose directions differ by less than this (sine of the angle) are parallel: the direction
/// of their common perpendicular would be uncertain by more than the machine's epsilon over this, 2e-9.
pub const PARALLEL_SINE: f64 = 1e-7;

/// Rounding of a computed separation in units of epsilon times the scale.
pub const RESOLUTION_ULPS: f64 = 4.0;

/// Rounding of the position of a feature in units of epsilon times the scale: it takes a few more operations than a
/// separation.
const PLACE_ULPS: f64 = 16.0;

/// The smaller of the sizes of two bodies, m; that of the other body when one has none (0: a half-space, a point).
pub(crate) fn smaller_size(size_a: f64, size_b: f64) -> f64 {
    if size_a == 0.0 || size_b == 0.0 { size_a.max(size_b) } else { size_a.min(size_b) }
}

/// [`place_tolerance`] for bodies of which one may have no size.
pub(crate) fn place_tolerance_of_sizes(size_a: f64, size_b: f64, relative: DVec3) -> f64 {
    place_tolerance(smaller_size(size_a, size_b), size_a.max(size_b), relative)
}

/// The place tolerance: distance up to which two features coincide, m. It is [`COINCIDENCE`] times the joint size plus
/// the rounding of a position. `relative` is the position of one body in the frame of the other.
pub(crate) fn place_tolerance(size_a: f64, size_b: f64, relative: DVec3) -> f64 {
    COINCIDENCE * size_a.min(size_b) + PLACE_ULPS * f64::EPSILON * (size_a + size_b + relative.length())
}
