//! Which direction is up: the last rule where nothing else tells two bodies apart.

use glam::DVec3;

/// Directions whose components differ by less than this are the same when one of several equal axes is chosen.
pub(crate) const SAME_DIRECTION: f64 = 1e-9;

/// Whether a direction points up: by z, or else y, or else x.
pub(crate) fn is_upward(direction: DVec3) -> bool {
    [direction.z, direction.y, direction.x].into_iter().find(|c| c.abs() > SAME_DIRECTION).is_some_and(|c| c > 0.0)
}
