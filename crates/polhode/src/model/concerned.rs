//! The names of the bodies that an error concerns.

use super::Model;
use crate::error::SimulationError;
use crate::scene::MOST_NAMES;

impl SimulationError {
    /// The same with the names of these bodies, where it tells whom it concerns and does not know; of many the first.
    pub(crate) fn among(mut self, model: &Model, of: &[usize]) -> Self {
        if let Self::ContactProblem { bodies, .. }
        | Self::ContactSolve { bodies, .. }
        | Self::StepTooSmall { bodies, .. } = &mut self
            && bodies.is_empty()
        {
            *bodies = of.iter().take(MOST_NAMES).map(|&body| model.bodies[body].name.clone()).collect();
        }
        self
    }

    /// The error of a problem of these bodies at a time (s) whose relative residual stays at this.
    pub(crate) fn not_solved(model: &Model, (t_s, residual): (f64, f64), of: &[usize]) -> Self {
        Self::ContactSolve { t_s, residual, bodies: Vec::new() }.among(model, of)
    }
}
