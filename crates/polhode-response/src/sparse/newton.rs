//! Semismooth Newton with the slip inside: the end of a cold solve, and the whole of a warm one.
//!
//! Every block is linearised at its reaction and velocity (Alart and Curnier): open, stick or slide. What it then
//! asks for, `S du + (D + damping) y = right`, `dr = T y + shift`, is put into the equation of the bodies: one
//! factorisation a step, in the velocities of bodies, whatever the number of contacts. The damping makes steps exist
//! where contacts are redundant: it is that of an augmented Lagrangian with one step for each update of its
//! multipliers, whose penalty is one over it.
//!
//! Velocities are weighed against reactions by the load of each contact, or heavy bodies would hide light ones.
//! Sources: Alart and Curnier 1991; De Luca, Facchinei and Kanzow 1996; Grippo, Lampariello and Lucidi 1986 (steps
//! may rise a little); Rockafellar 1976 (augmented Lagrangian). Failure: steps that lead nowhere end the run; the
//! best point of all is kept, and its residual told.

use crate::dense::kernels::largest;
use crate::dense::small::solve_small;
use crate::friction::coulomb_cone::{BlockRows, filled_up};
use crate::friction::linearisation::{InverseMasses, Linearised, linearise};
use crate::law::{Law, MOST_ROWS, PARTS};
use crate::sparse::block6::{Vector6, WIDTH};
use crate::sparse::elimination::Elimination;
use crate::sparse::iterate::{Iterate, Measure};
use crate::sparse::problem::{BodyProblem, RowBlock};
use crate::sparse::system::{BodySystem, RowMatrix, Sides};
use crate::tolerances::DECREASE;
use crate::tolerances::DEPENDENT_COMPLIANCE;
use crate::tolerances::LEAST_DAMPING;
use crate::tolerances::MOST_HALVINGS;
use crate::tolerances::WENT_WELL;
use std::ops::Range;

/// The damping in units of the residual: at first and at the most, at the least, and what it is multiplied by after a
/// step that went well and after another whole one (no units).
const FIRST_SHARE: f64 = 3.0;
const LEAST_SHARE: f64 = 1e-3;
const SHARE_AFTER_WELL: f64 = 0.4;
const SHARE_AFTER_WHOLE: f64 = 0.7;

/// Times that rounding of the factors is solved for again.
const NEWTON_REFINEMENTS: usize = 1;

/// Steps whose largest function the next one may reach.
const MEMORY_OF_STEPS: usize = 6;

/// Limits of one run.
#[derive(Debug, Clone, Copy)]
pub(crate) struct NewtonLimits {
    /// Most steps.
    pub(crate) most: usize,
    /// Steps in which the residual must halve.
    pub(crate) patience: usize,
    /// The residual to reach.
    pub(crate) tolerance: f64,
}

/// The method for one problem.
#[derive(Debug)]
pub(crate) struct BodyNewton<'a> {
    problem: &'a BodyProblem,
    elimination: &'a Elimination,
    measure: &'a Measure,
    /// `1 / rho` along the normal and of the other parts of each block.
    inverse_masses: Vec<InverseMasses>,
    /// The same, at most a velocity per load.
    weights: Vec<InverseMasses>,
    laws: Vec<Linearised>,
    stiffness: Vec<RowMatrix>,
    dv: Vec<Vector6>,
    dr: Vec<f64>,
}

impl<'a> BodyNewton<'a> {
    /// For a problem.
    pub(crate) fn new(problem: &'a BodyProblem, elimination: &'a Elimination, measure: &'a Measure) -> Self {
        let parts = problem.blocks.iter().zip(&measure.inverse_masses);
        let inverse_masses: Vec<InverseMasses> =
            parts.map(|(block, normal)| inverse_masses_of(problem, block, *normal)).collect();
        Self {
            problem,
            elimination,
            measure,
            weights: inverse_masses.clone(),
            inverse_masses,
            laws: Vec::new(),
            stiffness: Vec::new(),
            dv: Vec::new(),
            dr: Vec::new(),
        }
    }

    /// Reactions that would hold all blocks still, whatever their laws: about the size of the answer. Rows of a heap
    /// contradict each other, and reactions that held them all the same would be far too large: what is held is the
    /// motion of the bodies that comes nearest to the rates.
    pub(crate) fn holding(&mut self, system: &mut BodySystem, without: &Iterate) -> &[f64] {
        self.weights.clone_from(&self.inverse_masses);
        self.ask_to_hold(&without.rates);
        self.factor(system, LEAST_DAMPING);
        self.solve(system);
        let mut nearest = vec![0.0; self.problem.rows()];
        for block in &self.problem.blocks {
            self.problem.add_rates(block, &self.dv, &mut nearest[block.rows.clone()]);
        }
        for rate in &mut nearest {
            *rate = -*rate;
        }
        self.ask_to_hold(&nearest);
        self.condense(LEAST_DAMPING);
        self.solve(system);
        &self.dr
    }

    /// Linearises all blocks as held, at these rates.
    fn ask_to_hold(&mut self, rates: &[f64]) {
        self.laws.clear();
        for (block, weights) in self.problem.blocks.iter().zip(&self.weights) {
            let rows = block.rows.clone();
            let hold = Law::Hold { rows: rows.len() };
            self.laws.push(linearise(hold, *weights, [0.0; MOST_ROWS], filled_up(&rates[rows])));
        }
    }

    /// Goes on from `best`, which is then the best of all.
    pub(crate) fn run(&mut self, system: &mut BodySystem, best: &mut Iterate, limits: NewtonLimits) {
        self.weigh(&best.reactions);
        let (mut current, mut trial) = (best.clone(), Iterate::default());
        let mut squares = vec![self.linearise(&current)];
        let mut share = FIRST_SHARE;
        let (mut halved, mut half) = (0, 0.5 * best.rank);
        for step in 0..limits.most {
            let balanced = self.balanced();
            if current.rank <= limits.tolerance || step - halved >= limits.patience {
                return;
            }
            self.step(system, (share * balanced).clamp(LEAST_DAMPING, 1.0));
            if !largest(&self.dr).is_finite() {
                return;
            }
            let last = squares.last().copied().unwrap_or(f64::INFINITY);
            let recent = squares.iter().rev().take(MEMORY_OF_STEPS).fold(0.0, |most: f64, square| most.max(*square));
            let (length, square) = self.search(&current, recent, &mut trial);
            if !square.is_finite() {
                return;
            }
            share *= match (square < WENT_WELL * last, length == 1.0) {
                (true, _) => SHARE_AFTER_WELL,
                (false, true) => SHARE_AFTER_WHOLE,
                (false, false) => 1.0,
            };
            share = share.max(LEAST_SHARE);
            squares.push(square);
            std::mem::swap(&mut current, &mut trial);
            best.keep(&current);
            if current.rank <= half {
                (halved, half) = (step + 1, 0.5 * current.rank);
            }
        }
    }

    /// Halves the step until the square is below the largest of the last ones; returns its length and the square.
    fn search(&mut self, current: &Iterate, recent: f64, trial: &mut Iterate) -> (f64, f64) {
        let (mut length, mut square) = (1.0, f64::INFINITY);
        let mut wanted = Vec::with_capacity(self.dr.len());
        for halving in 0..=MOST_HALVINGS {
            wanted.clear();
            wanted.extend(current.reactions.iter().zip(&self.dr).map(|(r, d)| r + length * d));
            trial.take(self.problem, self.measure, &wanted);
            square = self.linearise(trial);
            if square <= (1.0 - DECREASE * length) * recent || halving == MOST_HALVINGS {
                break;
            }
            length *= 0.5;
        }
        (length, square)
    }

    fn weigh(&mut self, reactions: &[f64]) {
        let scales = self.measure.scales(self.problem, reactions);
        for ((weights, own), scale) in self.weights.iter_mut().zip(&self.inverse_masses).zip(scales) {
            let factor = scale / own[0];
            *weights = own.map(|inverse_mass| inverse_mass * factor);
        }
    }

    /// What each block does at these reactions.
    pub(crate) fn laws_at(&mut self, iterate: &Iterate) -> &[Linearised] {
        self.weigh(&iterate.reactions);
        self.linearise(iterate);
        &self.laws
    }

    /// The largest function of a block, relative to the speed.
    fn balanced(&self) -> f64 {
        let most = self.laws.iter().fold(0.0, |most: f64, law| most.max(law.square));
        if most == 0.0 { 0.0 } else { most.sqrt() / self.measure.speed }
    }

    /// Linearises all blocks; returns the square of the function.
    fn linearise(&mut self, iterate: &Iterate) -> f64 {
        self.laws.clear();
        let mut sum = 0.0;
        for (block, weights) in self.problem.blocks.iter().zip(&self.weights) {
            let rows = block.rows.clone();
            let (r, u) = (filled_up(&iterate.reactions[rows.clone()]), filled_up(&iterate.rates[rows]));
            let law = linearise(block.law, *weights, r, u);
            sum += law.square;
            self.laws.push(law);
        }
        sum
    }

    /// The step `dr` of the linearised laws.
    fn step(&mut self, system: &mut BodySystem, damping: f64) {
        self.factor(system, damping);
        self.solve(system);
    }

    /// What the laws ask of each block, and the factors of that.
    fn factor(&mut self, system: &mut BodySystem, damping: f64) {
        self.condense(damping);
        system.factor(self.problem, self.elimination, &self.stiffness);
    }

    fn condense(&mut self, damping: f64) {
        self.stiffness.clear();
        self.dr.clear();
        for (block, law) in self.problem.blocks.iter().zip(&self.laws) {
            let rows = block.rows.clone();
            let compliance: BlockRows = filled_up(&self.problem.compliance[rows.clone()]);
            let (stiffness, constant) = condensed(law, compliance, damping);
            self.stiffness.push(stiffness);
            self.dr.extend_from_slice(&constant[..rows.len()]);
        }
    }

    fn solve(&mut self, system: &mut BodySystem) {
        let bodies = vec![[0.0; WIDTH]; self.problem.movable_bodies()];
        let sides = Sides { bodies: &bodies, rows: &mut self.dr };
        system.solve(self.problem, self.elimination, sides, NEWTON_REFINEMENTS, &mut self.dv);
    }
}

fn inverse_masses_of(problem: &BodyProblem, block: &RowBlock, normal: f64) -> InverseMasses {
    let first = block.rows.start;
    let of = |rows: Range<usize>| {
        let most = rows.map(|row| problem.diagonal(first + row)).fold(0.0, f64::max);
        if most > 0.0 { most } else { normal }
    };
    if block.law.resists_rotation() {
        let [slip, roll, spin] = block.law.parts().map(|(rows, _)| of(rows));
        return [normal, slip, roll, spin];
    }
    let tangential = of(1..block.rows.len());
    let mut inverse_masses = [tangential; 1 + PARTS];
    inverse_masses[0] = normal;
    inverse_masses
}

/// `K` and `k` with `dr = k - K H dv`, from `S (H dv + C dr) + (D + damping) y = right`, `dr = T y + shift`.
fn condensed(law: &Linearised, compliance: BlockRows, damping: f64) -> (RowMatrix, BlockRows) {
    let count = law.unknowns;
    let (mut stiffness, mut constant) = ([[0.0; MOST_ROWS]; MOST_ROWS], law.shift);
    if compliance.iter().any(|value| *value > 0.0) {
        return condensed_with_compliance(law, compliance, damping);
    }
    for k in 0..count {
        let over = 1.0 / (law.diagonal[k] + damping * law.inverse_masses[k]);
        for (i, line) in stiffness.iter_mut().enumerate() {
            let weight = law.columns[k][i] * over;
            for (target, row) in line.iter_mut().zip(law.rows[k]) {
                *target += weight * row;
            }
            constant[i] += weight * law.right[k];
        }
    }
    (stiffness, constant)
}

/// The same where the rows yield: `(D + damping + S C T) y = right - S C shift - S H dv`.
fn condensed_with_compliance(law: &Linearised, compliance: BlockRows, damping: f64) -> (RowMatrix, BlockRows) {
    let count = law.unknowns;
    let weighted = |row: &BlockRows, column: &BlockRows| -> f64 {
        (0..MOST_ROWS).map(|k| row[k] * compliance[k] * column[k]).sum()
    };
    let mut matrix = [0.0; MOST_ROWS * MOST_ROWS];
    for k in 0..count {
        for j in 0..count {
            matrix[k * count + j] = weighted(&law.rows[k], &law.columns[j]);
        }
        matrix[k * count + k] += law.diagonal[k] + damping * law.inverse_masses[k];
    }
    // T (D + damping + S C T)^-1 of any right side.
    let solved = |right: &dyn Fn(usize) -> f64| -> BlockRows {
        let mut y: BlockRows = std::array::from_fn(|k| if k < count { right(k) } else { 0.0 });
        let mut copy = matrix;
        solve_small(&mut copy[..count * count], &mut y[..count], DEPENDENT_COMPLIANCE);
        std::array::from_fn(|i| (0..count).map(|k| law.columns[k][i] * y[k]).sum())
    };
    let mut constant = solved(&|k| law.right[k] - weighted(&law.rows[k], &law.shift));
    for (target, shift) in constant.iter_mut().zip(law.shift) {
        *target += shift;
    }
    let columns: RowMatrix = std::array::from_fn(|j| solved(&|k| law.rows[k][j]));
    (std::array::from_fn(|i| std::array::from_fn(|j| columns[j][i])), constant)
}
