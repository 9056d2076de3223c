//! Tolerances and limits of the frictional contact solver.

use crate::error::ResponseError;
use crate::friction::solution::FrictionMethod;
use crate::method_set::MethodSet;

/// What a solve may do when Newton's method does not succeed.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
#[non_exhaustive]
pub enum FallbackPolicy {
    /// Contacts that yield, the convex programme over cones, and sweeps.
    #[default]
    SlowerMethods,
    /// Nothing: the status says so.
    Refuse,
}

/// Settings of [`solve_friction`](crate::friction::solve_friction).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FrictionSettings {
    /// The residual to reach: methods stop there.
    pub tolerance: f64,
    /// The largest residual that counts as solved, where the tolerance is not reached. What rounding of large reactions
    /// that cancel leaves counts as solved too.
    pub acceptance: f64,
    /// Sweeps of block Gauss-Seidel at a cold start, before Newton's method.
    pub sweeps: u32,
    /// Steps of Newton's method from one start.
    pub newton_steps: u32,
    /// Convex programmes, each with the correction of the last. A few show whether they lead anywhere; where bodies
    /// slide on each other in many places the answer may be some twenty away.
    pub corrections: u32,
    /// Sweeps of the last resort.
    pub last_sweeps: u32,
    /// What to do when Newton's method does not succeed.
    pub fallback: FallbackPolicy,
    /// Which reactions are taken where they are not unique.
    pub redundancy: Redundancy,
    /// Methods whose answers are not taken, to see what the others find; closed forms and starts always count.
    pub left_out: MethodSet<FrictionMethod>,
}

/// Which reactions are taken where contacts depend on each other (four corners of a box), so that they are not unique.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Redundancy {
    /// Those found first.
    #[default]
    Any,
    /// Those of contacts that yield alike, by less and less: none of a patch bears more than its share. They depend
    /// neither on the order of the contacts, nor on where in their planes the tangents lie, nor on the start. For
    /// problems of up to 120 rows; where they are not found, those to which steps of least norm lead from the start,
    /// and then those found first.
    LeastNorm,
}

impl Default for FrictionSettings {
    fn default() -> Self {
        Self {
            tolerance: 1e-13,
            acceptance: 1e-12,
            sweeps: 20,
            newton_steps: 60,
            corrections: 4,
            last_sweeps: 1000,
            fallback: FallbackPolicy::SlowerMethods,
            redundancy: Redundancy::Any,
            left_out: MethodSet::NONE,
        }
    }
}

impl FrictionSettings {
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
