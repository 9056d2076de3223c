//! What the motions with a constant angular velocity share: the attitude, `R(s) = exp([w]x s) R_0` (Rodrigues), and
//! lengths that are never too small.

use crate::Rotation;
use crate::rounding;
use glam::DVec3;

/// The attitude `s` seconds after it was `start`, turning with `spin` (rad/s, world); exactly `start` at `s = 0` and
/// without spin. The angle's rounding, `|w| s` times 1e-16, is the error.
pub(super) fn turned(start: Rotation, spin: DVec3, s: f64) -> Rotation {
    if s == 0.0 || spin == DVec3::ZERO { start } else { Rotation::from_rotation_vector(spin * s) * start }
}

/// Length of a vector whose square may leave the range of f64.
pub(super) fn length(vector: DVec3) -> f64 {
    let largest = vector.abs().max_element();
    if largest == 0.0 { 0.0 } else { (vector / largest).length() * largest }
}

/// A length that the vector's true one does not exceed, and infinite when a component is not finite; zero only of the
/// zero vector.
pub(super) fn length_bound(vector: DVec3) -> f64 {
    if vector == DVec3::ZERO {
        0.0
    } else if vector.is_finite() {
        // Products of the smallest numbers round by more than a factor covers.
        length(vector) * (1.0 + rounding::DOZENS_OF_TERMS) + f64::MIN_POSITIVE
    } else {
        f64::INFINITY
    }
}
