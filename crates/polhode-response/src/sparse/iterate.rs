//! Reactions with the velocities that they give, and how far they are from the laws: one measure for all methods.
//!
//! The residual is the largest over all blocks of the natural map with De Saxce's correction in units of impulse,
//! `|r_i - P_K(r_i - rho_i (u_i + mu |u_t| n))|`, `rho_i = 1 / (H M^-1 H^T + C)_nn`, per unit of the largest
//! reaction, or of the largest that would stop an approach on its own (`rho_i |u_i|` without reactions) where that is
//! larger. No unit; the same when units change.
//!
//! Under heavy loads that alone says little of light bodies. The balanced residual has `1 / rho_i` no larger than a
//! velocity over the load of the contact, so that reactions and velocities count alike in each, and is in units of
//! the largest velocity `u` without reactions of a block that needs some. Answers are ranked by the residual, and by a
//! share of the balanced one
//! as far as that is no rounding.

use crate::certificate::nan_max;
use crate::dense::kernels::largest;
use crate::friction::coulomb_cone::natural_map;
use crate::law::{Law, MOST_ROWS};
use crate::sparse::block6::Vector6;
use crate::sparse::problem::{BodyProblem, RowBlock};
use crate::tolerances::LARGEST_RESIDUAL_ROUNDING;

/// Share of the balanced residual that counts (no unit, 1e-5 to 1e-2): that of light bodies has fewer digits. Where
/// 1e-8 is asked for, their velocities are right to 1e-5 of the fastest one.
const BALANCED_SHARE: f64 = 1e-3;

/// Rounding of a velocity, in units in the last place of the largest reaction over the least mass (4 to 16).
const ROUNDING_OF_RATES: f64 = 8.0;

/// Where a method is.
#[derive(Debug, Clone, Default)]
pub(crate) struct Iterate {
    /// `r`.
    pub(crate) reactions: Vec<f64>,
    /// `v_free + M^-1 H^T r`, scaled.
    pub(crate) velocities: Vec<Vector6>,
    /// `u`.
    pub(crate) rates: Vec<f64>,
    /// Natural map, relative.
    pub(crate) residual: f64,
    /// What answers are ranked by.
    pub(crate) rank: f64,
}

impl Iterate {
    /// Takes these reactions.
    pub(crate) fn take(&mut self, problem: &BodyProblem, measure: &Measure, reactions: &[f64]) {
        self.reactions.clear();
        self.reactions.extend_from_slice(reactions);
        problem.scaled_velocities(&self.reactions, &mut self.velocities);
        problem.rates(&self.velocities, &self.reactions, &mut self.rates);
        self.residual = measure.residual(problem, &self.reactions, &self.rates);
        let balanced = measure.balanced(problem, self) - measure.rounding(&self.reactions);
        self.rank = nan_max(self.residual, BALANCED_SHARE * balanced);
    }

    /// Takes the other one if it is better.
    pub(crate) fn keep(&mut self, other: &Self) {
        if other.rank < self.rank || self.rank.is_nan() {
            self.clone_from(other);
        }
    }
}

/// What residuals are measured by.
#[derive(Debug, Clone)]
pub(crate) struct Measure {
    /// `1 / rho` of each block.
    pub(crate) inverse_masses: Vec<f64>,
    /// The largest reaction that would stop an approach on its own.
    stopping: f64,
    /// The largest velocity `u` without reactions of a block that needs some (m/s).
    pub(crate) speed: f64,
}

impl Measure {
    /// Of a problem.
    pub(crate) fn of(problem: &BodyProblem) -> Self {
        let inverse_masses = problem.inverse_masses();
        let mut rates = Vec::new();
        problem.rates(&problem.free, &vec![0.0; problem.rows()], &mut rates);
        let stopping = |(block, inverse_mass): (&RowBlock, &f64)| {
            let own = &rates[block.rows.clone()];
            let speed = if let Law::Hold { .. } = block.law { largest(own) } else { (-own[0]).max(0.0) };
            speed / inverse_mass
        };
        let stopping = problem.blocks.iter().zip(&inverse_masses).map(stopping).fold(0.0, f64::max);
        // A contact that parts needs no reaction: its rate, however large, says nothing of the others.
        let asks = |(block, inverse_mass): &(&RowBlock, &f64)| {
            map_of(block.law, **inverse_mass, &[0.0; MOST_ROWS][..block.rows.len()], &rates[block.rows.clone()]) > 0.0
        };
        let asking = problem.blocks.iter().zip(&inverse_masses).filter(asks);
        let speed = asking.map(|(block, _)| largest(&rates[block.rows.clone()])).fold(0.0, f64::max);
        Self { inverse_masses, stopping, speed }
    }

    /// See the top.
    pub(crate) fn residual(&self, problem: &BodyProblem, reactions: &[f64], rates: &[f64]) -> f64 {
        let mut most = 0.0;
        for (block, &inverse_mass) in problem.blocks.iter().zip(&self.inverse_masses) {
            let rows = block.rows.clone();
            let map = map_of(block.law, inverse_mass, &reactions[rows.clone()], &rates[rows]);
            most = nan_max(most, map / inverse_mass);
        }
        if most == 0.0 { 0.0 } else { most / largest(reactions).max(self.stopping) }
    }

    /// Velocities per load of each block: the speed over its first reaction, at most its inverse mass (1/kg).
    pub(crate) fn scales(&self, problem: &BodyProblem, reactions: &[f64]) -> Vec<f64> {
        let of = |(block, inverse_mass): (&RowBlock, &f64)| self.scale(*inverse_mass, reactions[block.rows.start]);
        problem.blocks.iter().zip(&self.inverse_masses).map(of).collect()
    }

    fn scale(&self, inverse_mass: f64, reaction: f64) -> f64 {
        let load = reaction.abs();
        // Written so that nothing is divided by a load of zero.
        if load * inverse_mass > self.speed { self.speed / load } else { inverse_mass }
    }

    /// The balanced residual.
    pub(crate) fn balanced(&self, problem: &BodyProblem, iterate: &Iterate) -> f64 {
        let mut most = 0.0;
        for (block, &inverse_mass) in problem.blocks.iter().zip(&self.inverse_masses) {
            let (r, u) = (&iterate.reactions[block.rows.clone()], &iterate.rates[block.rows.clone()]);
            most = nan_max(most, map_of(block.law, self.scale(inverse_mass, r[0]), r, u));
        }
        if most == 0.0 { 0.0 } else { most / self.speed }
    }

    /// What rounding leaves of it under such reactions.
    fn rounding(&self, reactions: &[f64]) -> f64 {
        let most = self.inverse_masses.iter().fold(0.0, |most: f64, value| most.max(*value));
        if self.speed == 0.0 {
            return 0.0;
        }
        let rounding = ROUNDING_OF_RATES * f64::EPSILON * (most * largest(reactions)) / self.speed;
        rounding.min(LARGEST_RESIDUAL_ROUNDING)
    }
}

/// The natural map of a block in units of velocity, as for contacts with friction; `inverse_mass` is `1 / rho`.
fn map_of(law: Law, inverse_mass: f64, r: &[f64], u: &[f64]) -> f64 {
    // The cone of a contact without friction is a half line, onto which the projection is that of its normal alone.
    if law.pushes() && law.friction() == Some(0.0) && !law.resists_rotation() {
        let normal = inverse_mass * r[0] - (inverse_mass * r[0] - u[0]).max(0.0);
        return r[1..].iter().fold(normal * normal, |sum, r| sum + (inverse_mass * r) * (inverse_mass * r)).sqrt();
    }
    natural_map(law, inverse_mass, r, u)
}
