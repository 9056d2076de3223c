//! The active set: a primal method for `0 <= f _|_ w = G f + b >= 0` with `G` positive semidefinite.
//!
//! State: the set `P` of rows that carry force, with `G_PP` nonsingular and `w_P = 0`, `f >= 0`. Starting from a guess
//! of `P`, one violated row `j` (`w_j < 0`) at a time is pushed: `f_j` grows, `f_P` follows so that `w_P` stays 0
//! (direction `d = -G_PP^-1 G_Pj`), until `w_j = 0` (`j` joins `P`) or a force of `P` reaches zero (it leaves, and the
//! push goes on). `w_j` rises with the rate of the Schur complement `s = G_jj - G_jP G_PP^-1 G_Pj`; where `s` is zero
//! to rounding the row depends on `P`, and only an exchange is possible: the factor stays well-conditioned and
//! singular `G` needs no regularisation. Each push lowers `1/2 f.G f + b.f`, so the method ends; pushes of length zero
//! (degenerate rows) fall back to the rule of least index.
//!
//! Source: Dantzig's and van de Panne and Whinston's principal pivoting in the form of Lawson and Hanson's NNLS;
//! Baraff 1994; least index: Chang 1979 in Cottle, Pang and Stone. Failure: a push that nothing stops shows that there
//! is no solution; a limit of pivots ends all loops, also for NaN.

use crate::certificate::row_accelerations;
use crate::dense::cholesky::GrowingCholesky;
use crate::dense::kernels::{dot, largest};
use crate::precise;
use crate::settings::SolverSettings;

/// A Schur complement above this fraction of the diagonal is independent without a closer look (no unit).
const CLEARLY_INDEPENDENT: f64 = 1e-6;

/// A row that cannot be held because bodies are squeezed, by less than this fraction of the largest terms, is taken
/// as rounding of the data (no unit); the residual reports it.
const SQUEEZE_ROUNDING: f64 = 1e-8;

/// A push below this fraction of the forces present makes no progress (no unit): 50 times the rounding unit.
const NO_PROGRESS: f64 = 1e-14;

/// Pivots that are allowed whatever the number of rows.
const FREE_PIVOTS: usize = 100;

/// How a run ended.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Outcome {
    /// No row is violated.
    Converged,
    /// A push that nothing stops.
    Infeasible,
    /// Too many pivots.
    PivotLimit,
}

/// What happened to a pushed row.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Push {
    Joined,
    Dropped,
    Infeasible,
    OverLimit,
}

/// The method with its memory; [`run`](Self::run) may be called again and again.
#[derive(Debug, Clone, Default)]
pub(crate) struct ActiveSet {
    factor: GrowingCholesky,
    /// `P` in the order of the factor.
    rows: Vec<usize>,
    member: Vec<bool>,
    /// Rows that are squeezed within rounding and left alone.
    ignored: Vec<bool>,
    pub(crate) forces: Vec<f64>,
    pub(crate) w: Vec<f64>,
    direction: Vec<f64>,
    line: Vec<f64>,
    weights: Vec<f64>,
    pub(crate) pivots: usize,
    stalled: usize,
}

/// The problem of one run.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Problem<'a> {
    /// `G`, row-major and symmetric.
    pub(crate) matrix: &'a [f64],
    /// `b`.
    pub(crate) constant: &'a [f64],
    /// Tolerances.
    pub(crate) settings: &'a SolverSettings,
}

impl Problem<'_> {
    fn size(&self) -> usize {
        self.constant.len()
    }

    fn at(&self, row: usize, column: usize) -> f64 {
        self.matrix[row * self.size() + column]
    }

    fn diagonal(&self, row: usize) -> f64 {
        self.at(row, row)
    }
}

impl ActiveSet {
    /// The rows that carry force, in the order in which they entered.
    pub(crate) fn rows(&self) -> &[usize] {
        &self.rows
    }

    /// Solves the problem, starting from the guess that `start` carries the forces.
    pub(crate) fn run(&mut self, problem: Problem<'_>, start: &[usize]) -> Outcome {
        let size = problem.size();
        self.prepare(problem);
        self.establish(problem, start);
        let limit = (problem.settings.pivots_per_row as usize).saturating_mul(size).saturating_add(FREE_PIVOTS);
        // Pushes in a row share one refinement: it is needed only before the end.
        let mut refined = false;
        loop {
            if let Some(row) = self.most_violated(problem) {
                refined = false;
                match self.push(problem, row, limit) {
                    Push::Infeasible => return Outcome::Infeasible,
                    Push::OverLimit => return Outcome::PivotLimit,
                    Push::Joined | Push::Dropped => {}
                }
            } else if refined {
                return Outcome::Converged;
            } else {
                self.refine(problem);
                refined = true;
            }
        }
    }

    fn prepare(&mut self, problem: Problem<'_>) {
        let size = problem.size();
        self.factor.reset(size);
        self.rows.clear();
        self.member.clear();
        self.member.resize(size, false);
        self.ignored.clear();
        self.ignored.resize(size, false);
        self.forces.clear();
        self.forces.resize(size, 0.0);
        self.w.clear();
        self.w.resize(size, 0.0);
        self.weights.clear();
        // Violations are compared in the energy norm: w_i / sqrt(G_ii).
        self.weights.extend((0..size).map(|i| 1.0 / problem.diagonal(i).max(f64::MIN_POSITIVE).sqrt()));
        self.pivots = 0;
        self.stalled = 0;
    }

    /// Factorises the independent rows of a guess, drops those whose forces would pull, and sets the forces.
    fn establish(&mut self, problem: Problem<'_>, start: &[usize]) {
        let mut guess: Vec<usize> = start.iter().copied().filter(|&row| row < problem.size()).collect();
        loop {
            for &row in &guess {
                if !self.member[row] {
                    let pivot = self.schur_complement(problem, row);
                    let clear = pivot > CLEARLY_INDEPENDENT * problem.diagonal(row);
                    if !clear {
                        self.solve_direction();
                    }
                    if clear || self.is_independent(problem, row, pivot) {
                        self.join(row, pivot);
                    }
                }
            }
            self.direction.clear();
            self.direction.extend(self.rows.iter().map(|&row| -problem.constant[row]));
            self.factor.solve(&mut self.direction);
            if self.direction.iter().all(|&force| force >= 0.0) {
                for (&row, &force) in self.rows.iter().zip(&self.direction) {
                    self.forces[row] = force;
                }
                row_accelerations(problem.matrix, problem.constant, &self.forces, &mut self.w);
                return;
            }
            guess.clear();
            guess.extend(self.rows.iter().zip(&self.direction).filter(|(_, f)| **f >= 0.0).map(|(&row, _)| row));
            self.pivots += self.rows.len() - guess.len();
            self.factor.reset(problem.size());
            for &row in &self.rows {
                self.member[row] = false;
            }
            self.rows.clear();
        }
    }

    /// One step of iterative refinement of `w_P = 0`, then `w` of all rows afresh.
    fn refine(&mut self, problem: Problem<'_>) {
        self.direction.clear();
        self.direction.extend(self.rows.iter().map(|&row| -self.w[row]));
        self.factor.solve(&mut self.direction);
        for (&row, correction) in self.rows.iter().zip(&self.direction) {
            self.forces[row] = (self.forces[row] + correction).max(0.0);
        }
        row_accelerations(problem.matrix, problem.constant, &self.forces, &mut self.w);
    }

    /// Whether the factor asks for refinement in twice the working precision.
    pub(crate) fn wants_precision(&self, problem: Problem<'_>) -> bool {
        let largest_diagonal = self.rows.iter().map(|&row| problem.diagonal(row)).fold(0.0, f64::max);
        precise::is_worth_it(largest_diagonal, self.factor.smallest_pivot())
    }

    /// One step of iterative refinement with accelerations that the caller has found in twice the precision. `false`
    /// when a force would pull by more than rounding of zero: then nothing is changed.
    pub(crate) fn correct(&mut self, w: &[f64]) -> bool {
        self.direction.clear();
        self.direction.extend(self.rows.iter().map(|&row| -w[row]));
        self.factor.solve(&mut self.direction);
        let pushing = |(&row, change): (&usize, &f64)| self.forces[row] + change >= -NO_PROGRESS * self.forces[row];
        if !self.rows.iter().zip(&self.direction).all(pushing) {
            return false;
        }
        for (&row, change) in self.rows.iter().zip(&self.direction) {
            self.forces[row] = (self.forces[row] + change).max(0.0);
        }
        true
    }

    /// The row to push: the most violated in the energy norm, or the first violated one while there is no progress.
    fn most_violated(&self, problem: Problem<'_>) -> Option<usize> {
        let least_index = self.stalled > 2 * problem.size();
        let mut best: Option<(usize, f64)> = None;
        for row in 0..problem.size() {
            let violation = -self.w[row] * self.weights[row];
            let candidate = self.w[row] < 0.0 && !self.member[row] && !self.ignored[row];
            if candidate && best.is_none_or(|(_, most)| violation > most) && self.is_violated(problem, row) {
                if least_index {
                    return Some(row);
                }
                best = Some((row, violation));
            }
        }
        best.map(|(row, _)| row)
    }

    fn is_violated(&self, problem: Problem<'_>, row: usize) -> bool {
        let SolverSettings { tolerance, noise_floor, .. } = *problem.settings;
        let depth = -self.w[row] - noise_floor;
        depth > tolerance * problem.constant[row].abs() && depth > tolerance * self.scale(problem, row)
    }

    /// `W_i = |b_i| + sum_k |G_ik| f_k`.
    fn scale(&self, problem: Problem<'_>, row: usize) -> f64 {
        let own = problem.constant[row].abs() + problem.diagonal(row) * self.forces[row];
        let others = self.rows.iter().filter(|&&k| k != row);
        own + others.map(|&k| (problem.at(row, k) * self.forces[k]).abs()).sum::<f64>()
    }

    /// Raises the force of `row` until it is held or its force is back at zero.
    fn push(&mut self, problem: Problem<'_>, row: usize, limit: usize) -> Push {
        loop {
            self.pivots += 1;
            if self.pivots > limit {
                return Push::OverLimit;
            }
            let pivot = self.schur_complement(problem, row);
            self.solve_direction();
            let independent = self.is_independent(problem, row, pivot);
            let full = if independent { (-self.w[row] / pivot).max(0.0) } else { f64::INFINITY };
            let (step, blocking) = self.longest_step(full);
            if !step.is_finite() {
                return self.unstoppable(problem, row);
            }
            let present = largest(&self.forces) + problem.constant[row].abs() / problem.diagonal(row);
            self.stalled = if step > NO_PROGRESS * present { 0 } else { self.stalled + 1 };
            self.forces[row] += step;
            for (&other, change) in self.rows.iter().zip(&self.direction) {
                self.forces[other] = (self.forces[other] + step * change).max(0.0);
            }
            let Some(position) = blocking else {
                self.join(row, pivot);
                row_accelerations(problem.matrix, problem.constant, &self.forces, &mut self.w);
                return Push::Joined;
            };
            self.leave(position);
            self.w[row] = problem.constant[row] + dot(&problem.matrix[row * problem.size()..], &self.forces);
            if self.forces[row] == 0.0 && !self.is_violated(problem, row) {
                row_accelerations(problem.matrix, problem.constant, &self.forces, &mut self.w);
                return Push::Dropped;
            }
        }
    }

    /// The longest step along the direction up to `full`, and the position in `P` of the force that stops it.
    fn longest_step(&self, full: f64) -> (f64, Option<usize>) {
        let least_index = self.stalled > 2 * self.forces.len();
        let steepest = NO_PROGRESS * largest(&self.direction);
        let mut best = (full, None);
        for (position, (&row, &rate)) in self.rows.iter().zip(&self.direction).enumerate() {
            if rate < -steepest {
                let step = self.forces[row] / -rate;
                let better = step < best.0
                    || (step == best.0
                        && best.1.is_some_and(|other: usize| {
                            if least_index { row < self.rows[other] } else { rate < self.direction[other] }
                        }));
                if better {
                    best = (step, Some(position));
                }
            }
        }
        best
    }

    /// Nothing stops the push of a dependent row: bodies are squeezed, truly or by rounding of the data.
    fn unstoppable(&mut self, problem: Problem<'_>, row: usize) -> Push {
        let size = self.scale(problem, row) + largest(problem.constant);
        if -self.w[row] <= SQUEEZE_ROUNDING * size {
            self.ignored[row] = true;
            Push::Dropped
        } else {
            Push::Infeasible
        }
    }

    /// Puts `L^-1 G_Pj` into `line` and returns the Schur complement of row `j`.
    fn schur_complement(&mut self, problem: Problem<'_>, row: usize) -> f64 {
        let column = &problem.matrix[row * problem.size()..(row + 1) * problem.size()];
        self.line.clear();
        self.line.extend(self.rows.iter().map(|&k| column[k]));
        self.factor.solve_lower(&mut self.line);
        problem.diagonal(row) - dot(&self.line, &self.line)
    }

    /// Whether the Schur complement stands out of the rounding of the terms that cancel in it, for the current
    /// direction.
    fn is_independent(&self, problem: Problem<'_>, row: usize, pivot: f64) -> bool {
        let diagonal = problem.diagonal(row);
        if pivot > CLEARLY_INDEPENDENT * diagonal {
            return true;
        }
        // s = z.G z with z = (d, 1): the rounding of G enters with the square of sum |z_i| sqrt(G_ii).
        let terms = self.rows.iter().zip(&self.direction).map(|(&k, d)| d.abs() * problem.diagonal(k).sqrt());
        let size = diagonal.sqrt() + terms.sum::<f64>();
        pivot > problem.settings.rank_cut * size * size
    }

    /// `d = -L^-T line = -G_PP^-1 G_Pj`.
    fn solve_direction(&mut self) {
        self.direction.clear();
        self.direction.extend(self.line.iter().map(|value| -value));
        self.factor.solve_upper(&mut self.direction);
    }

    fn join(&mut self, row: usize, pivot: f64) {
        self.factor.push(&self.line, pivot);
        self.rows.push(row);
        self.member[row] = true;
    }

    fn leave(&mut self, position: usize) {
        self.factor.remove(position);
        let row = self.rows.remove(position);
        self.member[row] = false;
        self.forces[row] = 0.0;
    }
}
