//! Which of two points of a convex body is nearer to a given point, or which of two pairs of points of two bodies is
//! nearer.
//!
//! Around the nearest point `p` the distance grows with the square of the displacement from `p`: points within 1e-8 of
//! the distance are equally near to rounding, but the unit vectors `n` from them to the given point differ by 1e-8. So
//! near ties are decided by the direction: for the nearest point no point `q` of the body lies beyond the plane through
//! it, `n.(q - p) <= 0`, and the violation of this condition is linear in the displacement.

use glam::DVec3;

/// Rounding of a distance, in epsilons of the lengths it is computed from.
const ULPS: f64 = 8.0;

/// A distance (m) and its direction, the unit vector from the body to the point.
pub(crate) type DistanceAndDirection = (f64, DVec3);

/// Whether the first candidate is nearer than the second. `support` is the support function of the body relative to
/// the given point, m: minus the distance for the nearest point's direction, more for others. `lengths` is the largest
/// length that the distances are computed from, m. In a tie by distance and by direction neither is nearer.
pub(crate) fn is_nearer(
    found: DistanceAndDirection,
    other: DistanceAndDirection,
    lengths: f64,
    support: impl Fn(DVec3) -> f64,
) -> bool {
    let rounding = ULPS * f64::EPSILON * lengths;
    if (found.0 - other.0).abs() <= rounding {
        let beyond = |(distance, direction): DistanceAndDirection| support(direction) + distance;
        let (beyond, other_beyond) = (beyond(found), beyond(other));
        if (beyond - other_beyond).abs() > rounding {
            return beyond < other_beyond;
        }
    }
    found.0 < other.0
}
