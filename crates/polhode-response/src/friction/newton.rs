//! A semismooth Newton method for contacts with friction.
//!
//! Each step linearises the law of every block ([`linearise`]), eliminates what is known of open and sliding contacts,
//! and solves the rest, `S (G + D) T y = right`, by sparse elimination. As in the method of Levenberg and Marquardt
//! 1963 a multiple of its diagonal is added to `G`, in proportion to the residual: far from the solution, where
//! contacts still change their status, it keeps reactions from running away along directions that move nothing
//! (redundant contacts make `G` singular), and with the residual it vanishes, so that convergence is fast at the end.
//! Reactions change as little as they can along such directions. The step is shortened until the function no longer
//! grows beyond its largest value of the last steps (Grippo, Lampariello and Lucidi 1986).
//!
//! Source: Alart and Curnier 1991; Qi and Sun 1993 (semismooth Newton). Converges quadratically once every contact has
//! its status; from afar it may cycle, and then says so.

use crate::dense::householder::PivotedQr;
use crate::dense::kernels::largest;
use crate::friction::block_matrix::{Block, BlockMatrix};
use crate::friction::coulomb_cone::{BlockRows, filled_up};
use crate::friction::elimination_order::EliminationOrder;
use crate::friction::linearisation::{ContactStatus, InverseMasses, Linearised, linearise};
use crate::friction::multifrontal::Multifrontal;
use crate::friction::node_laws::{LawsOfBlocks, NodeLaws, StepSystem};
use crate::friction::node_matrix::NodeMatrix;
use crate::friction::problem::FrictionProblem;
use crate::law::{Law, MOST_ROWS, PARTS};
use crate::tolerances::DECREASE;
use crate::tolerances::LEAST_DAMPING;
use crate::tolerances::MOST_HALVINGS;
use crate::tolerances::WENT_WELL;
use std::ops::Range;

/// Equations below this fraction of the largest depend on the others (no unit): quadratic in distances.
const DEPENDENT_EQUATION: f64 = 1e-9;

/// How the share of the diagonal, relative to the residual, changes from step to step (no units).
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Damping {
    /// At first, and at the most.
    first: f64,
    /// At the least.
    least: f64,
    /// What it is multiplied by after a whole step that went well.
    well: f64,
    /// After any other whole step.
    whole: f64,
    /// After a step that was cut short.
    cut: f64,
}

impl Damping {
    /// Changes little: measured on problems of other programs, where others cycle or take twice the steps.
    pub(crate) const STEADY: Self = Self { first: 3.0, least: 1e-3, well: 0.4, whole: 1.0, cut: 1.0 };

    /// Gives way a little with each whole step: where sweeps have sorted out what slides or parts.
    pub(crate) const SETTLING: Self = Self { whole: 0.7, ..Self::STEADY };

    /// Gives way quickly: at large mass ratios the steady one holds the heavy bodies back.
    pub(crate) const YIELDING: Self = Self { first: 3.0, least: 1e-6, well: 0.4, whole: 0.4, cut: 4.0 };

    /// The share after a step.
    fn next(self, share: f64, is_whole: bool, went_well: bool) -> f64 {
        let factor = match (is_whole, went_well) {
            (_, true) => self.well,
            (true, false) => self.whole,
            (false, false) => self.cut,
        };
        (factor * share).clamp(self.least, self.first)
    }
}

/// Steps after which a residual that is accepted and has not halved is rounding.
const IDLE_STEPS: usize = 4;

/// Steps of least norm in which the residual has not halved after which they lead nowhere (8 to 20): they take four on
/// the average, and where they do not converge they go round in a circle.
const STALLED_STEPS: usize = 12;

/// Steps whose largest function the next one may reach.
const MEMORY: usize = 6;

/// Where the method is.
#[derive(Debug, Clone, Default)]
pub(crate) struct Iterate {
    /// `r`.
    pub(crate) reactions: Vec<f64>,
    /// `u = G r + q`.
    pub(crate) velocities: Vec<f64>,
    /// Natural map, relative.
    pub(crate) residual: f64,
}

/// Limits of one run.
#[derive(Debug, Clone, Copy)]
pub(crate) struct NewtonLimits {
    /// Most steps.
    pub(crate) most: usize,
    /// The residual to reach.
    pub(crate) tolerance: f64,
    /// The residual below which rounding may keep the method from reaching it.
    pub(crate) acceptance: f64,
    /// What the steps are.
    pub(crate) steps: NewtonSteps,
}

/// How redundant contacts, which make `G` singular, are dealt with.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum NewtonSteps {
    /// By damping; the factorisation is sparse.
    Damped(Damping),
    /// By the step of least norm among all that satisfy the independent equations; the factorisation is dense. It finds
    /// its way where damping holds back contacts of stacked boxes.
    LeastNorm,
}

impl NewtonLimits {
    /// Whether the residual is as small as wanted, or as rounding allows.
    pub(crate) fn are_reached(&self, problem: &FrictionProblem, iterate: &Iterate) -> bool {
        let residual = iterate.residual;
        // What cannot be rounding is not compared with it, which would cost as much as a product with the matrix.
        let may_be_rounding = residual <= problem.largest_rounding();
        residual <= self.tolerance || (may_be_rounding && residual <= problem.rounding_of(&iterate.reactions))
    }
}

/// The method for one problem.
#[derive(Debug)]
pub(crate) struct Newton<'a> {
    problem: &'a FrictionProblem,
    /// Rows of each block.
    sizes: Vec<usize>,
    /// `1 / rho` along the normal and of the other parts of each block.
    inverse_masses: Vec<InverseMasses>,
    laws: Vec<Linearised>,
    /// Formed when the first damped step needs it.
    elimination: Option<Elimination>,
    /// `dr`.
    change: Vec<f64>,
}

/// What damped steps are solved with, and its memory.
#[derive(Debug)]
struct Elimination {
    order: EliminationOrder,
    nodes: NodeMatrix,
    system: NodeLaws,
    factors: Multifrontal,
    /// Right sides, and then the unknowns.
    unknowns: Vec<f64>,
}

impl Elimination {
    fn of(matrix: &BlockMatrix) -> Self {
        let order = EliminationOrder::of(matrix);
        Self {
            nodes: NodeMatrix::of(matrix, &order),
            order,
            system: NodeLaws::default(),
            factors: Multifrontal::default(),
            unknowns: Vec::new(),
        }
    }
}

impl<'a> Newton<'a> {
    /// For a problem.
    pub(crate) fn new(problem: &'a FrictionProblem) -> Self {
        let matrix = problem.matrix();
        Self {
            problem,
            sizes: (0..matrix.len()).map(|block| matrix.size(block)).collect(),
            inverse_masses: (0..matrix.len()).map(|block| inverse_masses_of(problem, block)).collect(),
            laws: Vec::new(),
            elimination: None,
            change: vec![0.0; problem.rows()],
        }
    }

    /// Goes on from `iterate` until the tolerance is reached, steps lead nowhere or their number is used up; `iterate`
    /// is then the best of all. Returns the number of steps.
    pub(crate) fn run(&mut self, iterate: &mut Iterate, limits: NewtonLimits) -> usize {
        let (mut reactions, mut velocities) = (iterate.reactions.clone(), iterate.velocities.clone());
        let (mut trial, mut trial_velocities) = (Vec::new(), Vec::new());
        let mut squares = vec![self.linearise(&reactions, &velocities)];
        let damping = match limits.steps {
            NewtonSteps::Damped(damping) => damping,
            NewtonSteps::LeastNorm => Damping::STEADY,
        };
        let mut share = damping.first;
        let mut current = iterate.residual;
        let (mut halved, mut half) = (0, 0.5 * current);
        for step in 0..limits.most {
            let is_idle = step - halved >= IDLE_STEPS && iterate.residual <= limits.acceptance;
            let is_stalled = step - halved >= STALLED_STEPS && limits.steps == NewtonSteps::LeastNorm;
            if is_idle || is_stalled || limits.are_reached(self.problem, iterate) {
                return step;
            }
            match limits.steps {
                NewtonSteps::Damped(_) => self.damped_step((share * current).clamp(LEAST_DAMPING, 1.0)),
                NewtonSteps::LeastNorm => self.least_norm_step(),
            }
            if !largest(&self.change).is_finite() {
                self.change.fill(0.0);
            }
            let recent = squares.iter().rev().take(MEMORY).fold(0.0, |most: f64, square| most.max(*square));
            let mut length = 1.0;
            let mut square = f64::INFINITY;
            for _ in 0..=MOST_HALVINGS {
                trial.clear();
                trial.extend(reactions.iter().zip(&self.change).map(|(r, d)| r + length * d));
                self.problem.matrix().times_plus(&trial, self.problem.constant(), &mut trial_velocities);
                square = self.linearise(&trial, &trial_velocities);
                if square <= (1.0 - DECREASE * length) * recent {
                    break;
                }
                length *= 0.5;
            }
            if !square.is_finite() {
                return step + 1;
            }
            let went_well = squares.last().is_some_and(|last| square < WENT_WELL * last);
            share = damping.next(share, length == 1.0, went_well);
            std::mem::swap(&mut reactions, &mut trial);
            std::mem::swap(&mut velocities, &mut trial_velocities);
            squares.push(square);
            current = self.problem.residual_of(&reactions, &velocities);
            if current < iterate.residual {
                iterate.reactions.copy_from_slice(&reactions);
                iterate.velocities.copy_from_slice(&velocities);
                iterate.residual = current;
            }
            if current <= half {
                (halved, half) = (step + 1, 0.5 * current);
            }
        }
        limits.most
    }

    /// The status of every block at the last linearisation.
    pub(crate) fn statuses(&self) -> Vec<ContactStatus> {
        self.laws.iter().map(|law| law.status).collect()
    }

    /// That of each part of every block: slip, rolling, spinning.
    pub(crate) fn parts(&self) -> Vec<[ContactStatus; PARTS]> {
        self.laws.iter().map(|law| law.parts).collect()
    }

    /// Linearises all blocks; returns the square of the function.
    pub(crate) fn linearise(&mut self, reactions: &[f64], velocities: &[f64]) -> f64 {
        self.laws.clear();
        let mut sum = 0.0;
        for (block, &kind) in self.problem.blocks().iter().enumerate() {
            let range = self.problem.matrix().range(block);
            let (r, u) = (filled_up(&reactions[range.clone()]), filled_up(&velocities[range]));
            let law = linearise(kind, self.inverse_masses[block], r, u);
            sum += law.square;
            self.laws.push(law);
        }
        sum
    }

    /// The step `dr` of the linearised law with this share of the diagonal added.
    fn damped_step(&mut self, damping: f64) {
        let Self { problem, sizes, laws, change, .. } = self;
        let elimination = self.elimination.get_or_insert_with(|| Elimination::of(problem.matrix()));
        let Elimination { order, nodes, system, factors, unknowns } = elimination;
        let of = LawsOfBlocks { matrix: nodes, order, laws, sizes, damping };
        system.fill(of);
        factors.factor(order, nodes, &mut StepSystem { laws: system, matrix: nodes });
        system.right_sides(nodes, unknowns);
        factors.solve(order, unknowns);
        system.changes(of, |block| problem.matrix().range(block).start, unknowns, change);
    }

    /// Reactions that would hold all blocks still, whatever their laws, with this share of the diagonal added.
    pub(crate) fn holding(&mut self, damping: f64) -> &[f64] {
        self.laws.clear();
        for (block, &rows) in self.sizes.iter().enumerate() {
            let free = filled_up(&self.problem.constant()[self.problem.range(block)]);
            let hold = Law::Hold { rows };
            self.laws.push(linearise(hold, self.inverse_masses[block], BlockRows::default(), free));
        }
        self.damped_step(damping);
        &self.change
    }

    /// The step of least norm among those that satisfy the independent equations.
    fn least_norm_step(&mut self) {
        let matrix = self.problem.matrix();
        for (block, law) in self.laws.iter().enumerate() {
            self.change[matrix.range(block)].copy_from_slice(&law.shift[..matrix.size(block)]);
        }
        // What the shifts do to the velocities is known beforehand.
        let mut known = Vec::new();
        matrix.times_plus(&self.change, &vec![0.0; self.change.len()], &mut known);
        let mut places = Vec::with_capacity(self.laws.len());
        let mut size = 0;
        for law in &self.laws {
            places.push(size);
            size += law.unknowns;
        }
        // Row by row: the transposed matrix column by column.
        let (mut dense, mut right) = (vec![0.0; size * size], vec![0.0; size]);
        for (row, law) in self.laws.iter().enumerate().filter(|(_, law)| law.unknowns > 0) {
            let at = places[row];
            for block in matrix.blocks(row) {
                let place = places[block.column];
                self.write(row, block, size, &mut dense[at * size + place..]);
            }
            let shifted: BlockRows = filled_up(&known[matrix.range(row)]);
            for k in 0..law.unknowns {
                let line = (at + k) * size;
                dense[line + at + k] += law.diagonal[k];
                right[at + k] = law.right[k] - inner(law.rows[k], shifted);
                // The equation of a slip whose contact hardly bears would make all others count as dependent.
                if law.diagonal[k] > law.inverse_masses[k] {
                    let scale = law.inverse_masses[k] / law.diagonal[k];
                    dense[line..line + size].iter_mut().for_each(|entry| *entry *= scale);
                    right[at + k] *= scale;
                }
            }
        }
        let unknowns = PivotedQr::factor(size, size, dense, DEPENDENT_EQUATION).solve_transpose(&right);
        for (block, law) in self.laws.iter().enumerate() {
            let range = matrix.range(block);
            for (row, target) in self.change[range].iter_mut().enumerate() {
                *target += (0..law.unknowns).map(|k| law.columns[k][row] * unknowns[places[block] + k]).sum::<f64>();
            }
        }
    }

    /// Writes `S G T` of a block, row-major with `stride` numbers from row to row.
    fn write(&self, row: usize, block: Block<'_>, stride: usize, target: &mut [f64]) {
        let (row_law, column_law) = (&self.laws[row], &self.laws[block.column]);
        for k in 0..column_law.unknowns {
            let mut product = [0.0; MOST_ROWS];
            for (value, line) in product.iter_mut().zip(block.values.chunks_exact(self.sizes[block.column])) {
                *value = line.iter().zip(&column_law.columns[k]).map(|(a, b)| a * b).sum();
            }
            for i in 0..row_law.unknowns {
                target[i * stride + k] = inner(row_law.rows[i], product);
            }
        }
    }
}

/// `1 / rho` along the normal and of the other parts of a block.
fn inverse_masses_of(problem: &FrictionProblem, block: usize) -> InverseMasses {
    let normal = problem.inverse_mass(block);
    let of = |rows: Range<usize>| {
        let mean = problem.mean_inverse_mass(block, rows);
        if mean > 0.0 { mean } else { normal }
    };
    let law = problem.blocks()[block];
    if !law.resists_rotation() {
        let tangential = of(1..law.rows());
        return [normal, tangential, tangential, tangential];
    }
    let [slip, roll, spin] = law.parts().map(|(rows, _)| of(rows));
    [normal, slip, roll, spin]
}

fn inner(a: BlockRows, b: BlockRows) -> f64 {
    a.iter().zip(b).fold(0.0, |sum, (a, b)| sum + a * b)
}
