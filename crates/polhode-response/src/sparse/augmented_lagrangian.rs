//! The augmented Lagrangian, for problems without friction.
//!
//! Rows that are held and contacts that only push ask for the velocities nearest to `v_free` (in the norm of masses)
//! that keep `H v + b >= 0`: a convex problem with one answer. With a penalty `sigma` of each row, `r' = P(r - sigma (H
//! v + b)) / (1 + sigma C)` are the reactions that a velocity `v` asks for, `P` the part that pushes, and
//!
//! `phi(v) = |v - v_free|^2 / 2 + sum (1 + sigma C) r'^2 / (2 sigma)`
//!
//! is convex and smooth. Each round finds its least value by Newton steps in the velocities of bodies, one
//! factorisation each (`I + H^T K H`, `K = sigma / (1 + sigma C)` where a row pushes), and takes `r'` for `r`. Nothing
//! is decided for good: rows that depend on each other, and contacts that touch without a force, do no harm.
//!
//! Steps are whole ones at first, although `phi` may grow: each decides anew for all rows, and comes to the end in
//! three to ten steps whatever the number of rows. A step that ends where `phi` is least lets few rows change at a
//! time; where whole ones go in circles such steps follow, which come to the end at last.
//!
//! Symbols: `v` (scaled by the roots of masses), `r` (N s), `sigma` (kg), `C` (1/kg). Sources: Rockafellar 1976;
//! Hintermüller, Ito and Kunisch 2002 (whole steps choose the rows that act). Assumption: no block has friction.
//! Failure: where the bodies cannot keep `H v + b >= 0`, or ratios of masses are beyond the penalty, rounds gain
//! little; they end, and the best point is kept.

use crate::law::{Law, MOST_ROWS};
use crate::sparse::block6::{Vector6, add_scaled, dot6};
use crate::sparse::elimination::Elimination;
use crate::sparse::iterate::{Iterate, Measure};
use crate::sparse::newton::NewtonLimits;
use crate::sparse::problem::BodyProblem;
use crate::sparse::system::{BodySystem, RowMatrix, Sides};

/// The penalty, in units of the mass that each row moves (no unit, 1e5 to 1e7). Rounding of a velocity times the
/// penalty is rounding of a reaction.
const PENALTY: f64 = 1e6;

/// Most Newton steps of a round, the first half of them whole ones.
const MOST_STEPS_OF_A_ROUND: usize = 20;

/// Times that rounding of the factors is solved for again.
const REFINEMENTS: usize = 1;

/// The method for one problem.
#[derive(Debug)]
pub(crate) struct AugmentedLagrangian<'a> {
    problem: &'a BodyProblem,
    elimination: &'a Elimination,
    measure: &'a Measure,
    /// `r`.
    reactions: Vec<f64>,
    v: Vec<Vector6>,
    /// `(r - sigma (H v + b)) / (1 + sigma C)`.
    wanted: Vec<f64>,
    /// Which rows push or are held.
    acts: Vec<bool>,
    stiffness: Vec<RowMatrix>,
    dv: Vec<Vector6>,
    /// What the bodies' equation is left with.
    rest: Vec<Vector6>,
}

/// Where along a step a row begins to push, or ends.
#[derive(Debug, Clone, Copy)]
struct Turn {
    at: f64,
    /// What the slope of `phi` along the step is more from there on, at the start of the step.
    slope: f64,
    /// By how much more it grows with the step.
    growth: f64,
}

impl<'a> AugmentedLagrangian<'a> {
    /// Whether it is a method for this problem: none of the blocks has friction.
    pub(crate) fn takes(problem: &BodyProblem) -> bool {
        problem.blocks.iter().all(|block| match block.law {
            Law::Hold { .. } | Law::Push => true,
            law => law.friction() == Some(0.0) && !law.resists_rotation(),
        })
    }

    /// For a problem without friction.
    pub(crate) const fn new(problem: &'a BodyProblem, elimination: &'a Elimination, measure: &'a Measure) -> Self {
        Self {
            problem,
            elimination,
            measure,
            reactions: Vec::new(),
            v: Vec::new(),
            wanted: Vec::new(),
            acts: Vec::new(),
            stiffness: Vec::new(),
            dv: Vec::new(),
            rest: Vec::new(),
        }
    }

    /// Goes on from `best`, which is then the best of all.
    pub(crate) fn run(&mut self, system: &mut BodySystem, best: &mut Iterate, limits: NewtonLimits) {
        self.reactions.clone_from(&best.reactions);
        self.v.clone_from(&best.velocities);
        let end = system.factorisations + limits.most;
        let mut iterate = best.clone();
        let (mut rounds, mut halved, mut half) = (0, 0, 0.5 * best.rank);
        while best.rank > limits.tolerance && rounds - halved < limits.patience && system.factorisations < end {
            self.minimise(system, end);
            for ((r, wanted), acts) in self.reactions.iter_mut().zip(&self.wanted).zip(&self.acts) {
                *r = if *acts { *wanted } else { 0.0 };
            }
            iterate.take(self.problem, self.measure, &self.reactions);
            best.keep(&iterate);
            rounds += 1;
            if iterate.rank <= half {
                (halved, half) = (rounds, 0.5 * iterate.rank);
            }
        }
    }

    /// Newton steps to the least `phi` with these reactions.
    fn minimise(&mut self, system: &mut BodySystem, end: usize) {
        // Which rows act by the masses that they move: the penalty would part those that touch by rounding.
        self.want(1.0);
        self.act();
        self.want(PENALTY);
        for step in 0..MOST_STEPS_OF_A_ROUND {
            if system.factorisations >= end {
                return;
            }
            self.step(system);
            let length = if 2 * step < MOST_STEPS_OF_A_ROUND { 1.0 } else { self.length() };
            // Written so that NaN ends it.
            let goes_on = length > 0.0;
            if !goes_on {
                return;
            }
            for (v, dv) in self.v.iter_mut().zip(&self.dv) {
                add_scaled(length, dv, v);
            }
            self.want(PENALTY);
            if !self.act() {
                return;
            }
        }
    }

    /// What the velocity asks for with this penalty.
    fn want(&mut self, penalty: f64) {
        let problem = self.problem;
        self.wanted.clear();
        self.wanted.extend_from_slice(&problem.bias);
        for (block, inverse_mass) in problem.blocks.iter().zip(&self.measure.inverse_masses) {
            let (own, sigma) = (&mut self.wanted[block.rows.clone()], penalty / inverse_mass);
            problem.add_rates(block, &self.v, own);
            for (row, own) in block.rows.clone().zip(own) {
                *own = (self.reactions[row] - sigma * *own) / (1.0 + sigma * problem.compliance[row]);
            }
        }
    }

    /// Lets the rows act that are held, and those that push. Returns whether they are others than before.
    fn act(&mut self) -> bool {
        let before = std::mem::take(&mut self.acts);
        for block in &self.problem.blocks {
            let is_held = matches!(block.law, Law::Hold { .. });
            let pushes = |row: usize| row == block.rows.start && self.wanted[row] > 0.0;
            self.acts.extend(block.rows.clone().map(|row| is_held || pushes(row)));
        }
        self.acts != before
    }

    /// One factorisation: the step to the least `phi` while the same rows act.
    fn step(&mut self, system: &mut BodySystem) {
        self.stiffness.clear();
        for (block, inverse_mass) in self.problem.blocks.iter().zip(&self.measure.inverse_masses) {
            let mut stiffness = [[0.0; MOST_ROWS]; MOST_ROWS];
            for (k, row) in block.rows.clone().enumerate().filter(|(_, row)| self.acts[*row]) {
                let sigma = PENALTY / inverse_mass;
                stiffness[k][k] = sigma / (1.0 + sigma * self.problem.compliance[row]);
            }
            self.stiffness.push(stiffness);
        }
        system.factor(self.problem, self.elimination, &self.stiffness);
        self.rest.clear();
        self.rest
            .extend(self.v.iter().zip(&self.problem.free).map(|(v, free)| std::array::from_fn(|k| free[k] - v[k])));
        let asked = self.wanted.iter().zip(&self.acts).map(|(wanted, acts)| if *acts { *wanted } else { 0.0 });
        let mut rows: Vec<f64> = asked.collect();
        let sides = Sides { bodies: &self.rest, rows: &mut rows };
        system.solve(self.problem, self.elimination, sides, REFINEMENTS, &mut self.dv);
    }

    /// The part of the step at which `phi` is least. Along it the slope of `phi` grows, linear between the places at
    /// which a row begins to push or ends.
    fn length(&self) -> f64 {
        let (mut slope, mut growth) = (0.0, 0.0);
        for ((v, free), dv) in self.v.iter().zip(&self.problem.free).zip(&self.dv) {
            slope += dot6(v, dv) - dot6(free, dv);
            growth += dot6(dv, dv);
        }
        let mut turns: Vec<Turn> = Vec::new();
        for (block, inverse_mass) in self.problem.blocks.iter().zip(&self.measure.inverse_masses) {
            let mut rates = [0.0; MOST_ROWS];
            self.problem.add_rates(block, &self.dv, &mut rates);
            let (is_held, sigma) = (matches!(block.law, Law::Hold { .. }), PENALTY / inverse_mass);
            for (row, rate) in block.rows.clone().zip(rates) {
                let (wanted, yields) = (self.wanted[row], sigma * rate / (1.0 + sigma * self.problem.compliance[row]));
                if self.acts[row] {
                    slope -= wanted * rate;
                    growth += yields * rate;
                }
                let (at, sign) = (wanted / yields, if self.acts[row] { -1.0 } else { 1.0 });
                if !is_held && row == block.rows.start && at > 0.0 {
                    turns.push(Turn { at, slope: -sign * wanted * rate, growth: sign * yields * rate });
                }
            }
        }
        turns.sort_unstable_by(|a, b| a.at.total_cmp(&b.at));
        for turn in turns {
            if slope + turn.at * growth >= 0.0 {
                break;
            }
            slope += turn.slope;
            growth += turn.growth;
        }
        -slope / growth
    }
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

    /// The answer from no reactions, and the factorisations that it took.
    fn solved(problem: &BodyProblem) -> (Iterate, usize) {
        let (elimination, measure) = (Elimination::of(problem), Measure::of(problem));
        let mut best = Iterate::default();
        best.take(problem, &measure, &vec![0.0; problem.rows()]);
        let mut system = BodySystem::default();
        let limits = NewtonLimits { most: 60, patience: 3, tolerance: 1e-9 };
        AugmentedLagrangian::new(problem, &elimination, &measure).run(&mut system, &mut best, limits);
        (best, system.factorisations)
    }

    #[test]
    fn what_pushes_does_not_move_and_what_parts_does_not_push() {
        for (boxes, gap) in [(1, 0.0), (10, 0.0), (40, 0.0), (10, 1e-3), (40, 0.3)] {
            let problem = column(boxes, gap);
            let (best, factorisations) = solved(&problem);
            assert!(best.rank <= 1e-9, "{boxes} boxes, {gap}: {:e} by {factorisations}", best.rank);
            let largest = best.reactions.iter().fold(0.0, |most: f64, r| most.max(*r));
            for (r, u) in best.reactions.iter().zip(&best.rates) {
                assert!(*r >= 0.0 && *u >= -1e-8 * largest && r * u <= 1e-8 * largest * largest, "{r} {u}");
            }
        }
    }

    #[test]
    fn steps_do_not_grow_with_the_rows() {
        for boxes in [10, 40, 160] {
            let problem = column(boxes, 0.3);
            let (best, factorisations) = solved(&problem);
            assert!(best.rank <= 1e-9 && factorisations <= 15, "{boxes}: {factorisations} steps");
        }
    }

    #[test]
    fn friction_is_not_taken() {
        let mass = BodyMass::rigid(1.0, &[1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0]);
        let mut problem = BodyProblem::new(&[mass], &[[0.0; 6]]).unwrap();
        let lines = [0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0];
        let law = Law::Cone { rows: 2, friction: 0.5 };
        problem.push(&BodyRows { law, bodies: &[(0, &lines)], bias: &[0.0; 2], compliance: &[] }).unwrap();
        assert!(!AugmentedLagrangian::takes(&problem));
    }
}
