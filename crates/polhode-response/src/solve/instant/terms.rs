//! What the methods at an instant share: their problem, and what of an acceleration is rounding.

use crate::delassus::Delassus;
use crate::friction::Blocks;
use crate::problem::ContactProblem;

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
