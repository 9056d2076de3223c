//! The rows of bodies behind the matrix of a problem with friction: what solves it in the velocities of bodies.

use crate::problem::ContactProblem;
use std::sync::Arc;

/// For each row of a problem with friction the row of a contact problem, and what its reaction is multiplied by.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct RowsBehind {
    pub(crate) problem: Arc<ContactProblem>,
    pub(crate) rows: Vec<usize>,
    /// No unit.
    pub(crate) scales: Vec<f64>,
}

impl RowsBehind {
    /// Those of some rows.
    pub(crate) fn of_rows(&self, chosen: impl Iterator<Item = usize> + Clone) -> Self {
        Self {
            problem: self.problem.clone(),
            rows: chosen.clone().map(|row| self.rows[row]).collect(),
            scales: chosen.map(|row| self.scales[row]).collect(),
        }
    }
}
