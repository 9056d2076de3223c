//! A contact of the pulse law: its rows, friction and restitution.

use super::plane::Tangent;

/// A contact of the springs.
#[derive(Debug, Clone, Copy)]
pub(crate) struct SpringContact {
    /// Its normal row; those of its tangents follow.
    pub(crate) row: usize,
    /// How many tangents: 0 to 2.
    pub(crate) tangents: usize,
    pub(crate) friction: f64,
    pub(crate) restitution: f64,
}

impl SpringContact {
    /// Its slip, of the velocities of all rows.
    pub(super) fn slip(&self, velocities: &[f64]) -> Tangent {
        let along = |k: usize| if k < self.tangents { velocities[self.row + 1 + k] } else { 0.0 };
        [along(0), along(1)]
    }

    /// Whether it has friction.
    pub(super) fn has_friction(&self) -> bool {
        self.tangents > 0 && self.friction > 0.0
    }
}
