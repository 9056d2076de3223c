//! The augmented Lagrangian, for problems without friction.
//!
//! Rows that are held and contacts that only push ask for the velocities nearest to `v_free` (in the norm of masses)
//! that keep `H v + b >= 0`: a convex problem with one answer. With a penalty `sigma` of each row, `r' = P(r - sigma (H
//! v + b)) / (1 + sigma C)` are the reactions that a velocity `v` asks for, `P` the part that pushes, and
//!
//! `phi(v) = |v - v_free|^2 / 2 + sum (1 + sigma C) r'^2 / (2 sigma)`
//!
//! is convex and smooth. Each round finds its least value by Newton steps in the velocities of bodies, one
//! factorisation each (`I + H^T K H`, `K = sigma / (1 + sigma C)` where a row pushes), takes `r'` for `r`, and makes
//! the penalty larger where that has gained little. Nothing is decided for good: rows that depend on each other, and
//! contacts that touch without a force, do no harm.
//!
//! Symbols: `v` (scaled by the roots of masses), `r` (N s), `sigma` (kg), `C` (1/kg). Source: Rockafellar 1976.
//! Assumption: no block has friction. Failure: where the bodies cannot keep `H v + b >= 0`, or ratios of masses are
//! beyond the largest penalty, rounds gain little; they end, and the best point is kept.

use crate::law::{Law, MOST_ROWS};
use crate::sparse::block6::{Vector6, add_scaled, dot6};
use crate::sparse::elimination::Elimination;
use crate::sparse::iterate::{Iterate, Measure};
use crate::sparse::newton::NewtonLimits;
use crate::sparse::problem::{BodyProblem, RowBlock};
use crate::sparse::system::{BodySystem, RowMatrix, Sides};

/// The first penalty, and the largest one, in units of the mass that each row moves (no units, 1e4 to 1e6, and 1e6 to
/// 1e7). Rounding of a velocity times the penalty is rounding of a reaction.
const FIRST_PENALTY: f64 = 1e5;
const LARGEST_PENALTY: f64 = 1e6;

/// What a round must leave of the residual for the penalty to stay, and what it is multiplied by if not (no units).
const GAINED_ENOUGH: f64 = 0.1;
const PENALTY_GROWTH: f64 = 10.0;

/// Most Newton steps of a round.
const MOST_STEPS_OF_A_ROUND: usize = 25;

/// What a step leaves of the slope of `phi` along it: less is sought by halving (no unit).
const SLOPE_LEFT: f64 = 0.9;

/// Share of the decrease promised that a step must bring otherwise (no unit); the usual one of Armijo.
const SUFFICIENT: f64 = 1e-4;

/// Halvings of a step.
const MOST_HALVINGS: usize = 8;

/// Times that rounding of the factors is solved for again.
const REFINEMENTS: usize = 1;

/// The method for one problem.
#[derive(Debug)]
pub(crate) struct AugmentedLagrangian<'a> {
    problem: &'a BodyProblem,
    elimination: &'a Elimination,
    measure: &'a Measure,
    /// Of each block, in units of the mass that it moves.
    penalty: f64,
    /// `r`.
    reactions: Vec<f64>,
    at: Point,
    stiffness: Vec<RowMatrix>,
    dv: Vec<Vector6>,
    /// What the bodies' equation is left with.
    rest: Vec<Vector6>,
}

/// A velocity, and what it asks for.
#[derive(Debug, Clone, Default)]
struct Point {
    v: Vec<Vector6>,
    /// `r'`.
    asked: Vec<f64>,
    /// Which rows push or are held.
    acts: Vec<bool>,
    /// The slope of `phi`.
    slope: Vec<Vector6>,
    phi: f64,
}

impl<'a> AugmentedLagrangian<'a> {
    /// For a problem; none where a block has friction.
    pub(crate) fn new(problem: &'a BodyProblem, elimination: &'a Elimination, measure: &'a Measure) -> Option<Self> {
        let is_without_friction = |block: &RowBlock| match block.law {
            Law::Hold { .. } | Law::Push => true,
            law => law.friction() == Some(0.0) && !law.resists_rotation(),
        };
        let method = Self {
            problem,
            elimination,
            measure,
            penalty: FIRST_PENALTY,
            reactions: Vec::new(),
            at: Point::default(),
            stiffness: Vec::new(),
            dv: Vec::new(),
            rest: Vec::new(),
        };
        problem.blocks.iter().all(is_without_friction).then_some(method)
    }

    /// Goes on from `best`, which is then the best of all.
    pub(crate) fn run(&mut self, system: &mut BodySystem, best: &mut Iterate, limits: NewtonLimits) {
        self.reactions.clone_from(&best.reactions);
        self.at.v.clone_from(&best.velocities);
        let end = system.factorisations + limits.most;
        let (mut iterate, mut last) = (best.clone(), best.rank);
        let (mut rounds, mut halved, mut half) = (0, 0, 0.5 * best.rank);
        while best.rank > limits.tolerance && rounds - halved < limits.patience && system.factorisations < end {
            self.minimise(system, end);
            self.reactions.clone_from(&self.at.asked);
            iterate.take(self.problem, self.measure, &self.reactions);
            best.keep(&iterate);
            rounds += 1;
            if iterate.rank <= half {
                (halved, half) = (rounds, 0.5 * iterate.rank);
            }
            if iterate.rank > GAINED_ENOUGH * last {
                self.penalty = (PENALTY_GROWTH * self.penalty).min(LARGEST_PENALTY);
            }
            last = iterate.rank;
        }
    }

    /// Newton steps to the least `phi` with these reactions.
    fn minimise(&mut self, system: &mut BodySystem, end: usize) {
        let mut next = Point::default();
        let v = std::mem::take(&mut self.at.v);
        self.at = self.point(v, Point::default());
        for _ in 0..MOST_STEPS_OF_A_ROUND {
            if system.factorisations >= end {
                return;
            }
            self.step(system);
            let slope = along(&self.at.slope, &self.dv);
            let mut length = 1.0;
            for _ in 0..=MOST_HALVINGS {
                let mut v = std::mem::take(&mut next.v);
                v.clone_from(&self.at.v);
                for (v, dv) in v.iter_mut().zip(&self.dv) {
                    add_scaled(length, dv, v);
                }
                next = self.point(v, next);
                let left = along(&next.slope, &self.dv);
                if left.abs() <= SLOPE_LEFT * slope.abs() || next.phi < self.at.phi + SUFFICIENT * length * slope {
                    break;
                }
                length *= 0.5;
            }
            let is_least = length == 1.0 && next.acts == self.at.acts;
            std::mem::swap(&mut self.at, &mut next);
            // Written so that NaN ends it.
            let goes_on = self.at.phi.is_finite() && !is_least;
            if !goes_on {
                return;
            }
        }
    }

    /// One factorisation: the step to the least `phi` while the same rows act.
    fn step(&mut self, system: &mut BodySystem) {
        self.stiffness.clear();
        for (block, inverse_mass) in self.problem.blocks.iter().zip(&self.measure.inverse_masses) {
            let mut stiffness = [[0.0; MOST_ROWS]; MOST_ROWS];
            for (k, row) in block.rows.clone().enumerate() {
                if self.at.acts[row] {
                    let sigma = self.penalty / inverse_mass;
                    stiffness[k][k] = sigma / (1.0 + sigma * self.problem.compliance[row]);
                }
            }
            self.stiffness.push(stiffness);
        }
        system.factor(self.problem, self.elimination, &self.stiffness);
        self.rest.clear();
        self.rest
            .extend(self.at.v.iter().zip(&self.problem.free).map(|(v, free)| std::array::from_fn(|k| free[k] - v[k])));
        let mut rows = self.at.asked.clone();
        let sides = Sides { bodies: &self.rest, rows: &mut rows };
        system.solve(self.problem, self.elimination, sides, REFINEMENTS, &mut self.dv);
    }

    /// What a velocity asks for; `memory` is used again.
    fn point(&self, v: Vec<Vector6>, memory: Point) -> Point {
        let Point { mut asked, mut acts, mut slope, .. } = memory;
        let problem = self.problem;
        asked.clear();
        asked.extend_from_slice(&problem.bias);
        acts.clear();
        acts.resize(asked.len(), false);
        slope.clear();
        slope.extend(
            v.iter().zip(&problem.free).map(|(v, free)| -> Vector6 { std::array::from_fn(|k| v[k] - free[k]) }),
        );
        let mut phi: f64 = slope.iter().map(|own| 0.5 * dot6(own, own)).sum();
        for (block, inverse_mass) in problem.blocks.iter().zip(&self.measure.inverse_masses) {
            let own = &mut asked[block.rows.clone()];
            problem.add_rates(block, &v, own);
            for (k, row) in block.rows.clone().enumerate() {
                let sigma = self.penalty / inverse_mass;
                let weight = 1.0 + sigma * problem.compliance[row];
                let wanted = (self.reactions[row] - sigma * own[k]) / weight;
                let is_held = matches!(block.law, Law::Hold { .. });
                acts[row] = is_held || (k == 0 && wanted > 0.0);
                own[k] = if acts[row] { wanted } else { 0.0 };
                phi += 0.5 * own[k] * own[k] * weight / sigma;
            }
            let mut against = [0.0; MOST_ROWS];
            against.iter_mut().zip(&*own).for_each(|(against, own)| *against = -own);
            problem.add_impulses(block, &against[..own.len()], &mut slope);
        }
        Point { v, asked, acts, slope, phi }
    }
}

fn along(slope: &[Vector6], dv: &[Vector6]) -> f64 {
    slope.iter().zip(dv).map(|(slope, dv)| dot6(slope, dv)).sum()
}

#[cfg(test)]
mod tests {
    //! Columns of boxes under gravity, with four contacts between any two, whose gaps contradict each other or not. The
    //! answer of a convex problem is known by its conditions: what pushes does not move, what parts does not push.
    #![expect(clippy::unwrap_used, reason = "a test that cannot go on has failed")]
    use super::*;
    use crate::sparse::body::BodyMass;
    use crate::sparse::problem::BodyRows;

    /// A column of so many boxes of 1 kg and 1 m, whose gaps are of this size.
    fn column(boxes: usize, gap: f64) -> BodyProblem {
        let mass = BodyMass::rigid(1.0, &[1.0 / 6.0, 0.0, 0.0, 0.0, 1.0 / 6.0, 0.0, 0.0, 0.0, 1.0 / 6.0]);
        let mut problem = BodyProblem::new(&vec![mass; boxes], &vec![[0.0, 0.0, -1.0, 0.0, 0.0, 0.0]; boxes]).unwrap();
        for above in 0..boxes {
            for (corner, (x, y)) in [(-0.5, -0.5), (-0.5, 0.5), (0.5, -0.5), (0.5, 0.5)].into_iter().enumerate() {
                let upper = [0.0, 0.0, 1.0, y, -x, 0.0];
                let lower = upper.map(|entry: f64| -entry);
                let mut bodies: Vec<(usize, &[f64])> = vec![(above, &upper)];
                if above > 0 {
                    bodies.push((above - 1, &lower));
                }
                let bias = [gap * ((7 * above + 3 * corner) % 5) as f64];
                let rows = BodyRows { law: Law::Push, bodies: &bodies, bias: &bias, compliance: &[] };
                problem.push(&rows).unwrap();
            }
        }
        problem
    }

    #[test]
    fn what_pushes_does_not_move_and_what_parts_does_not_push() {
        for (boxes, gap) in [(1, 0.0), (10, 0.0), (40, 0.0), (10, 1e-3), (40, 0.3)] {
            let problem = column(boxes, gap);
            let (elimination, measure) = (Elimination::of(&problem), Measure::of(&problem));
            let mut best = Iterate::default();
            best.take(&problem, &measure, &vec![0.0; problem.rows()]);
            let mut system = BodySystem::default();
            let limits = NewtonLimits { most: 60, patience: 3, tolerance: 1e-9 };
            AugmentedLagrangian::new(&problem, &elimination, &measure).unwrap().run(&mut system, &mut best, limits);
            assert!(best.rank <= 1e-9, "{boxes} boxes, {gap}: {:e} by {}", best.rank, system.factorisations);
            let largest = best.reactions.iter().fold(0.0, |most: f64, r| most.max(*r));
            for (r, u) in best.reactions.iter().zip(&best.rates) {
                assert!(*r >= 0.0 && *u >= -1e-8 * largest && r * u <= 1e-8 * largest * largest, "{r} {u}");
            }
        }
    }

    #[test]
    fn friction_is_not_taken() {
        let mass = BodyMass::rigid(1.0, &[1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0]);
        let mut problem = BodyProblem::new(&[mass], &[[0.0; 6]]).unwrap();
        let lines = [0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0];
        let law = Law::Cone { rows: 2, friction: 0.5 };
        problem.push(&BodyRows { law, bodies: &[(0, &lines)], bias: &[0.0; 2], compliance: &[] }).unwrap();
        let (elimination, measure) = (Elimination::of(&problem), Measure::of(&problem));
        assert!(AugmentedLagrangian::new(&problem, &elimination, &measure).is_none());
    }
}
