//! Tolerances and limits of the solver in the velocities of bodies.

use crate::error::ResponseError;

/// Settings of [`BodySolver`](crate::sparse::BodySolver).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BodySettings {
    /// The residual to reach: methods stop there, but for the path of compliance, which stops well within the
    /// acceptance.
    pub tolerance: f64,
    /// The largest residual that counts as solved, where the tolerance is not reached.
    pub acceptance: f64,
    /// Factorisations after which no method begins.
    pub factorisations: usize,
    /// Steps of a warm start, before a cold one: it takes one or two where little has changed, eight where a box is
    /// pushed.
    pub warm_steps: usize,
    /// Rounds of sweeps over all contacts: one before a cold start, which takes their loads, and the others after it,
    /// each with Newton's method. 0: none.
    pub rounds_of_sweeps: usize,
}

impl Default for BodySettings {
    fn default() -> Self {
        Self { tolerance: 1e-12, acceptance: 1e-8, factorisations: 150, warm_steps: 8, rounds_of_sweeps: 0 }
    }
}

impl BodySettings {
    /// Checks the range of every field.
    ///
    /// # Errors
    /// When a tolerance is not in `[0, 1)`.
    pub fn check(&self) -> Result<(), ResponseError> {
        for (field, value) in [("tolerance", self.tolerance), ("acceptance", self.acceptance)] {
            if !(0.0..1.0).contains(&value) {
                return Err(ResponseError::Setting { field, accepted: "at least 0 and below 1", value });
            }
        }
        Ok(())
    }
}
