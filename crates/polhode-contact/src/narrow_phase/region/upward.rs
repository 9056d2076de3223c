//! Which direction is up: the last rule for a choice between two bodies that are otherwise alike.

use glam::DVec3;

/// Components of unit vectors that differ by less than this count as equal when one of several equal axes is chosen.
pub(crate) const SAME_DIRECTION: f64 = 1e-9;

/// Whether the first component that is not zero, in the order z, y, x, is positive.
pub(crate) fn is_upward(direction: DVec3) -> bool {
    [direction.z, direction.y, direction.x].into_iter().find(|c| c.abs() > SAME_DIRECTION).is_some_and(|c| c > 0.0)
}
