//! What the methods at an instant share: their problem, and what of an acceleration is rounding.

use crate::delassus::Delassus;
use crate::error::ResponseError;
use crate::friction::{Blocks, BlocksSolution};
use crate::problem::ContactProblem;
use crate::sparse::{BodySettings, BodySolver};

/// A slip acceleration below this fraction of the largest relative acceleration without contact forces is rounding
/// (1e-13 to 1e-9).
pub const STICKING_ACCELERATION: f64 = 1e-11;

/// Accelerations of contacts that stick up to this many times the limit of rounding are the residual of the solver (10
/// to 1e4).
pub const SLIDING_ROUNDING: f64 = 1e3;

/// Rounding error of a sum of terms, in units in the last place of the sum of their magnitudes (4 to 64).
const FORCE_ROUNDING_UNITS: f64 = 16.0;

/// Rows, their laws, and their accelerations without forces.
#[derive(Debug, Clone, Copy)]
pub(super) struct Terms<'a> {
    pub(super) rows: &'a ContactProblem,
    pub(super) blocks: &'a Blocks,
    pub(super) constants: &'a [f64],
}

impl Terms<'_> {
    /// The largest acceleration of a row without forces, m/s^2.
    pub(super) fn scale(self) -> f64 {
        self.constants.iter().fold(0.0, |most: f64, value| most.max(value.abs()))
    }

    /// The forces of many contacts, found in the accelerations of bodies without a matrix of rows. That they are not
    /// found is no error: see the status of the report.
    ///
    /// # Errors
    /// When a number is not finite, and where rows are soft or of more than two bodies
    /// ([`is_plain`](crate::solve::way::is_plain)).
    #[cfg_attr(feature = "census", track_caller)]
    pub(super) fn in_bodies(self) -> Result<BlocksSolution, ResponseError> {
        let system = (&mut BodySolver::default(), &BodySettings::default());
        Ok(self.blocks.solve_in_bodies(self.rows, self.constants, None, system)?.0)
    }
}

/// Whether bodies are at rest.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum At {
    Rest,
    Motion,
}

/// Rounding of the accelerations by large forces that cancel, m/s^2: some rounding units of the terms of `G f`.
pub(super) fn rounding_of(delassus: &Delassus, forces: &[f64]) -> f64 {
    let terms = |row: usize| delassus.row(row).iter().zip(forces).map(|(g, f)| (g * f).abs()).sum::<f64>();
    FORCE_ROUNDING_UNITS * f64::EPSILON * (0..delassus.len()).map(terms).fold(0.0, f64::max)
}
