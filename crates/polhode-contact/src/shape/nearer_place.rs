//! Which of two places of a convex body is nearer to a point, or which of two pairs of places of two bodies are nearer to each
//! other.
//!
//! Close to the nearest place `p` the distance of a place grows with the square of the way there: within a way of 1e-8 of the
//! distance places are equally near to rounding, but the directions `n` from them to the point differ by that much. The nearest
//! one is told by its direction: no place `q` of the body lies beyond the plane through it, `n.(q - p) <= 0`. That is linear
//! in the way.

use glam::DVec3;

/// Rounding of a distance, in epsilons of the lengths it comes from.
const ULPS: f64 = 8.0;

/// A distance (m) and its direction, the unit vector from the body to the point.
pub(crate) type Way = (f64, DVec3);

/// Whether a way is shorter than another one. `reach` gives how far the body reaches along a direction, from the point, m: minus
/// the distance for the nearest place's direction, more for others. `lengths` is the largest length that enters the
/// distances, m. Of ways told apart neither by their directions nor by their lengths none is shorter.
pub(crate) fn is_nearer(way: Way, other: Way, lengths: f64, reach: impl Fn(DVec3) -> f64) -> bool {
    let rounding = ULPS * f64::EPSILON * lengths;
    if (way.0 - other.0).abs() <= rounding {
        let beyond = |(distance, direction): Way| reach(direction) + distance;
        let (beyond, other_beyond) = (beyond(way), beyond(other));
        if (beyond - other_beyond).abs() > rounding {
            return beyond < other_beyond;
        }
    }
    way.0 < other.0
}
