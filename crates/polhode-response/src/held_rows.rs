//! Rows that are held at `w = 0`, whatever the sign of their force.
//!
//! Given the set `H` of held rows, solves `G_HH f_H = -b_H` by a Cholesky factorisation with pivoting that reveals the
//! rank: dependent rows get no force and are held by the others. Between the stages of an integration step the set of
//! held rows is frozen, and so should be the choice of independent rows: [`HeldRows::factor`] chooses them,
//! [`HeldRows::factor_with_rows`] takes the choice over.
//!
//! Source: thesis, section 3.4 (non-vanishing contacts, as equalities); Golub and Van Loan, section 4.2 (pivoting);
//! Higham, Accuracy and Stability, section 10.3. Failure: rows that contradict each other show in
//! [`HeldForces::inconsistency`].

use crate::certificate::{nan_max, row_accelerations, row_scales};
use crate::complementarity::{ComplementaritySolver, ContactSolution};
use crate::delassus::Delassus;
use crate::dense::cholesky::GrowingCholesky;
use crate::dense::kernels::dot;
use crate::error::{ResponseError, check_finite, check_length};
use crate::precise;
use crate::problem::ContactProblem;
use crate::report::SolverStatus;

/// Default cut of the relative pivots (no unit). Pivots are quadratic in distances: 1e-10 takes contacts that are
/// 1e-5 of the lever arm apart as one; rounding of pivots is below 1e-14.
pub const RANK_CUT: f64 = 1e-10;

/// A factorised set of held rows.
#[derive(Debug, Clone)]
pub struct HeldRows {
    rows: usize,
    independent: Vec<usize>,
    dropped: Vec<usize>,
    factor: GrowingCholesky,
    smallest_kept: f64,
    largest_dropped: f64,
}

/// The forces that hold the rows.
#[derive(Debug, Clone, PartialEq)]
pub struct HeldForces {
    /// One force for each row of the problem; zero for rows that are not held or dependent.
    pub forces: Vec<f64>,
    /// Largest `|w|` among all held rows after the solve, relative to the terms of its row (no unit): rounding, unless
    /// dependent rows contradict the others.
    pub inconsistency: f64,
}

/// Whether non-negative forces can hold a set of rows.
#[derive(Debug, Clone, PartialEq)]
pub struct HoldCheck {
    /// Every row of the set has `w = 0` in the solution of the complementarity problem of the set.
    pub can_be_held: bool,
    /// That solution, in the order of the set.
    pub solution: ContactSolution,
}

impl HeldRows {
    /// Factorises the held rows; those whose relative pivot is below `cut` (see [`RANK_CUT`]) are dropped. The largest
    /// relative pivot comes first, the first row of equal ones.
    ///
    /// # Errors
    /// When a row does not exist, the matrix is not finite, or the cut is not in `[0, 1)`.
    pub fn factor(delassus: &Delassus, held: &[usize], cut: f64) -> Result<Self, ResponseError> {
        check(delassus, held, cut)?;
        let mut candidates = held.to_vec();
        candidates.sort_unstable();
        candidates.dedup();
        let diagonal = |row: usize| delassus.get(row, row);
        // Lines of the factor of every candidate, and what is left of its diagonal entry.
        let mut lines: Vec<Vec<f64>> = vec![Vec::new(); candidates.len()];
        let mut left: Vec<f64> = candidates.iter().map(|&row| diagonal(row)).collect();
        let mut result = Self::empty(delassus.len(), candidates.len());
        let mut open: Vec<usize> = (0..candidates.len()).filter(|&k| left[k] > 0.0).collect();
        loop {
            let relative = |k: usize| left[k] / diagonal(candidates[k]);
            let Some(position) =
                (0..open.len()).reduce(|best, k| if relative(open[k]) > relative(open[best]) { k } else { best })
            else {
                break;
            };
            let next = open[position];
            if relative(next) <= cut {
                result.largest_dropped = relative(next).max(0.0);
                break;
            }
            result.smallest_kept = result.smallest_kept.min(relative(next));
            open.remove(position);
            let (line, pivot) = (std::mem::take(&mut lines[next]), left[next].sqrt());
            for &k in &open {
                let entry = (delassus.get(candidates[k], candidates[next]) - dot(&lines[k], &line)) / pivot;
                lines[k].push(entry);
                left[k] -= entry * entry;
            }
            result.factor.push(&line, left[next]);
            result.independent.push(candidates[next]);
        }
        result.dropped = candidates.into_iter().filter(|row| !result.independent.contains(row)).collect();
        Ok(result)
    }

    /// Factorises with the independent rows given, in their order; the other held rows are dropped.
    ///
    /// # Errors
    /// As [`factor`](Self::factor), and [`ResponseError::LostRank`] when a row has come to depend on those before it.
    pub fn factor_with_rows(
        delassus: &Delassus,
        held: &[usize],
        independent: &[usize],
        cut: f64,
    ) -> Result<Self, ResponseError> {
        check(delassus, held, cut)?;
        check(delassus, independent, cut)?;
        let mut result = Self::empty(delassus.len(), independent.len());
        let mut line = Vec::new();
        for &row in independent {
            line.clear();
            line.extend(result.independent.iter().map(|&k| delassus.get(row, k)));
            result.factor.solve_lower(&mut line);
            let left = delassus.get(row, row) - dot(&line, &line);
            let pivot = left / delassus.get(row, row);
            if pivot.is_nan() || pivot <= cut {
                return Err(ResponseError::LostRank { row, pivot });
            }
            result.smallest_kept = result.smallest_kept.min(pivot);
            result.factor.push(&line, left);
            result.independent.push(row);
        }
        let mut dropped: Vec<usize> = held.iter().copied().filter(|row| !independent.contains(row)).collect();
        dropped.sort_unstable();
        dropped.dedup();
        result.dropped = dropped;
        Ok(result)
    }

    /// The independent rows, in pivot order.
    pub fn independent_rows(&self) -> &[usize] {
        &self.independent
    }

    /// The rows that depend on them, in ascending order.
    pub fn dropped_rows(&self) -> &[usize] {
        &self.dropped
    }

    /// Smallest relative pivot kept and largest dropped: the gap that separates rank from rounding. Without dropped
    /// rows (or with rows taken over from another factorisation) the second is 0.
    pub fn pivot_gap(&self) -> (f64, f64) {
        (self.smallest_kept, self.largest_dropped)
    }

    /// Forces with `w = G f + b = 0` on all held rows, with one step of iterative refinement, at large mass ratios in
    /// twice the working precision. `delassus` must be that of `problem`.
    ///
    /// # Errors
    /// When `problem`, `delassus` or `b` has another number of rows, or `b` is not finite.
    pub fn solve(&self, problem: &ContactProblem, delassus: &Delassus, b: &[f64]) -> Result<HeldForces, ResponseError> {
        check_length("contact problem", self.rows, problem.len())?;
        check_length("Delassus matrix", self.rows, delassus.len())?;
        check_length("constant terms", self.rows, b.len())?;
        check_finite("constant terms", b)?;
        let largest_diagonal = self.independent.iter().map(|&row| delassus.get(row, row)).fold(0.0, f64::max);
        let precisely = precise::is_worth_it(largest_diagonal, self.factor.smallest_pivot());
        let all: Vec<usize> = (0..self.rows).collect();
        let accelerations = |forces: &[f64]| {
            if precisely {
                precise::accelerations(problem, &all, b, forces)
            } else {
                let mut w = vec![0.0; b.len()];
                row_accelerations(delassus.entries(), b, forces, &mut w);
                w
            }
        };
        let mut forces = vec![0.0; self.rows];
        let mut w = b.to_vec();
        for _ in 0..2 {
            let mut correction: Vec<f64> = self.independent.iter().map(|&row| -w[row]).collect();
            self.factor.solve(&mut correction);
            for (&row, change) in self.independent.iter().zip(&correction) {
                forces[row] += change;
            }
            w = accelerations(&forces);
        }
        let mut scales = vec![0.0; self.rows];
        row_scales(delassus.entries(), b, &forces, &mut scales);
        let held = self.independent.iter().chain(&self.dropped);
        let relative = held.filter(|&&row| scales[row] > 0.0).map(|&row| w[row].abs() / scales[row]);
        let inconsistency = relative.fold(0.0, nan_max);
        Ok(HeldForces { forces, inconsistency })
    }

    fn empty(rows: usize, capacity: usize) -> Self {
        let mut factor = GrowingCholesky::default();
        factor.reset(capacity);
        let (independent, dropped) = (Vec::with_capacity(capacity), Vec::new());
        Self { rows, independent, dropped, factor, smallest_kept: 1.0, largest_dropped: 0.0 }
    }
}

impl HoldCheck {
    /// Asks whether non-negative forces on the rows of `held` alone can hold all of them at `w = 0`.
    ///
    /// # Errors
    /// When lengths differ, a row does not exist, or a number is not finite.
    pub fn new(
        problem: &ContactProblem,
        delassus: &Delassus,
        b: &[f64],
        held: &[usize],
        solver: &mut ComplementaritySolver,
    ) -> Result<Self, ResponseError> {
        check_length("Delassus matrix", problem.len(), delassus.len())?;
        check_length("constant terms", problem.len(), b.len())?;
        check_finite("constant terms", b)?;
        check(delassus, held, 0.0)?;
        solver.settings().check()?;
        let constant: Vec<f64> = held.iter().map(|&row| b[row]).collect();
        let solution = solver.solve_rows(problem, delassus, held, &constant).clone();
        let solved = solution.report.status == SolverStatus::Solved;
        Ok(Self { can_be_held: solved && solution.held.iter().all(|held| *held), solution })
    }
}

fn check(delassus: &Delassus, rows: &[usize], cut: f64) -> Result<(), ResponseError> {
    delassus.check_finite()?;
    if !(0.0..1.0).contains(&cut) {
        return Err(ResponseError::Setting { field: "cut", accepted: "at least 0 and below 1", value: cut });
    }
    match rows.iter().find(|&&row| row >= delassus.len()) {
        Some(&row) => Err(ResponseError::UnknownRow { row, rows: delassus.len() }),
        None => Ok(()),
    }
}
