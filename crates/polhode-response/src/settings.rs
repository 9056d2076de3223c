//! Tolerances and limits of the contact solvers, each relative to the size of what it measures.

use crate::error::ResponseError;
use crate::method_set::MethodSet;
use crate::report::Method;

/// Settings of [`ComplementaritySolver`](crate::ComplementaritySolver) and of everything built on it.
///
/// The scale of row `i` is `W_i = |b_i| + sum_k |G_ik| f_k`: the size of the terms whose sum is `w_i`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SolverSettings {
    /// A row is violated when `w_i < -tolerance * W_i`. Rounding of a well-conditioned row is below 1e-14.
    pub tolerance: f64,
    /// Largest residual (natural map, relative) that counts as solved.
    pub acceptance: f64,
    /// A row counts as held (`w = 0`) when `w_i <= closed_cut * W_i`.
    pub closed_cut: f64,
    /// A row counts as dependent when what it adds to the rows that carry force, `|M^-1/2 J^T z|` with `z_j = 1` and
    /// the other `z` such that it is least, is below `rank_cut` times the terms that cancel in it. Contacts are told
    /// apart that are this fraction of the lever arm from each other; rounding of the rows stays below 1e-15.
    pub rank_cut: f64,
    /// Singular directions of `J` below this fraction of its columns count as zero when forces are chosen by least
    /// norm.
    pub null_space_cut: f64,
    /// Rounding error that the constant terms `b` already carry, in the unit of `b`: smaller `w` count as zero. Where
    /// no answer is found with it, 64 roundings of the largest `b` are tried.
    pub noise_floor: f64,
    /// Limit of pivots for each row before twice the precision is tried.
    pub pivots_per_row: u32,
    /// Methods whose answers are not taken, to see what the others find; closed forms and starts always count.
    pub left_out: MethodSet<Method>,
}

impl Default for SolverSettings {
    fn default() -> Self {
        Self {
            tolerance: 1e-13,
            acceptance: 1e-11,
            closed_cut: 1e-12,
            rank_cut: 1e-14,
            null_space_cut: 1e-11,
            noise_floor: 0.0,
            pivots_per_row: 20,
            left_out: MethodSet::NONE,
        }
    }
}

impl SolverSettings {
    /// Checks the range of every field.
    ///
    /// # Errors
    /// When a tolerance is not in `[0, 1)` or the noise floor is negative or not finite.
    pub fn check(&self) -> Result<(), ResponseError> {
        let fractions = [
            ("tolerance", self.tolerance),
            ("acceptance", self.acceptance),
            ("closed_cut", self.closed_cut),
            ("rank_cut", self.rank_cut),
            ("null_space_cut", self.null_space_cut),
        ];
        for (field, value) in fractions {
            if !(0.0..1.0).contains(&value) {
                return Err(ResponseError::Setting { field, accepted: "at least 0 and below 1", value });
            }
        }
        if !(self.noise_floor >= 0.0 && self.noise_floor.is_finite()) {
            let (field, accepted) = ("noise_floor", "at least 0 and finite");
            return Err(ResponseError::Setting { field, accepted, value: self.noise_floor });
        }
        Ok(())
    }
}
