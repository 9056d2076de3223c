//! How the surface of a body is sampled beside a contact point.
//!
//! Whether a contact of one part is a contact of the whole body depends on the surface right beside it. A point at a
//! short distance from the contact, the probe, is tested against all parts nearby.

/// Length of a probe relative to the part or the edge: far above the tolerance of places (1e-12), far below a part.
const PROBE: f64 = 1e-6;

/// The shortest probe, in tolerances.
pub(super) const LEAST_PROBE: f64 = 32.0;

/// Length of a probe on a part or an edge of this size, m.
pub(super) fn probe_length(size: f64, tolerance: f64) -> f64 {
    (PROBE * size).max(LEAST_PROBE * tolerance)
}
