//! Tolerances and limits of the solver in the velocities of bodies.

use crate::error::ResponseError;
use crate::method_set::MethodSet;
use crate::sparse::solution::BodyMethod;

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
    /// Whether a cold start takes its loads from sweeps over all contacts.
    pub sweeps_first: bool,
    /// Methods whose answers are not taken, to see what the others find; closed forms and starts always count.
    pub left_out: MethodSet<BodyMethod>,
}

impl Default for BodySettings {
    fn default() -> Self {
        Self {
            tolerance: 1e-12,
            acceptance: 1e-8,
            factorisations: 150,
            warm_steps: 8,
            sweeps_first: false,
            left_out: MethodSet::NONE,
        }
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
