//! Which direction is up: the last rule for a choice between two bodies that are otherwise alike.

use glam::DVec3;
use polhode_spatial::unit_vector::SAME_DIRECTION;

/// Whether the first component that is not zero, in the order z, y, x, is positive.
pub(crate) fn is_upward(direction: DVec3) -> bool {
    [direction.z, direction.y, direction.x].into_iter().find(|c| c.abs() > SAME_DIRECTION).is_some_and(|c| c > 0.0)
}
