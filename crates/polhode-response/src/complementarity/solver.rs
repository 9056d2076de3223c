//! The solver with its fallbacks and its certificate.

use super::active_set::{ActiveSet, Outcome, Problem};
use super::{ContactSolution, WarmStart};
use crate::certificate::{nan_max, power_bound, row_accelerations, row_residual, row_scales};
use crate::delassus::Delassus;
use crate::error::{ResponseError, check_finite, check_length};
use crate::interior_point;
use crate::precise;
use crate::problem::ContactProblem;
use crate::report::{Method, SolverReport, SolverStatus};
use crate::settings::{FallbackPolicy, SolverSettings};

/// Solves complementarity problems; keeps its memory from one problem to the next.
#[derive(Debug, Clone, Default)]
pub struct ComplementaritySolver {
    settings: SolverSettings,
    active_set: ActiveSet,
    solution: ContactSolution,
    best: Candidate,
    guess: Vec<usize>,
    scales: Vec<f64>,
    matrix: Vec<f64>,
}

/// An answer with its certificate.
#[derive(Debug, Clone, Default)]
struct Candidate {
    forces: Vec<f64>,
    w: Vec<f64>,
    scales: Vec<f64>,
    rows: Vec<usize>,
    report: SolverReport,
}

/// Solves one problem. [`ComplementaritySolver`] does the same without allocating each time.
///
/// # Errors
/// See [`ComplementaritySolver::solve`].
pub fn solve_complementarity(
    problem: &ContactProblem,
    delassus: &Delassus,
    b: &[f64],
    warm_start: Option<&WarmStart>,
    settings: &SolverSettings,
) -> Result<ContactSolution, ResponseError> {
    let mut solver = ComplementaritySolver::new(*settings);
    solver.solve(problem, delassus, b, warm_start)?;
    Ok(solver.solution)
}

impl ComplementaritySolver {
    /// A solver with these settings; they are checked by each solve.
    pub fn new(settings: SolverSettings) -> Self {
        Self { settings, ..Self::default() }
    }

    /// The settings.
    pub fn settings(&self) -> &SolverSettings {
        &self.settings
    }

    /// Replaces the settings.
    pub fn set_settings(&mut self, settings: SolverSettings) {
        self.settings = settings;
    }

    /// Finds forces with `0 <= f _|_ w = G f + b >= 0`. `delassus` must be that of `problem`, `b` has one number for
    /// each row (m/s^2, or m/s for impulses).
    ///
    /// A problem that is not solved is no error: see the status of the report.
    ///
    /// # Errors
    /// When lengths differ, a number is not finite, or a setting is out of range.
    pub fn solve(
        &mut self,
        problem: &ContactProblem,
        delassus: &Delassus,
        b: &[f64],
        warm_start: Option<&WarmStart>,
    ) -> Result<&ContactSolution, ResponseError> {
        check_length("Delassus matrix", problem.len(), delassus.len())?;
        check_length("constant terms", problem.len(), b.len())?;
        check_finite("constant terms", b)?;
        delassus.check_finite()?;
        self.settings.check()?;
        self.search(problem, None, delassus.entries(), b, warm_start);
        Ok(&self.solution)
    }

    /// The problem of the given rows alone, as if the others were not there; the solution is in the order of `rows`.
    /// The caller has checked the data.
    pub(crate) fn solve_rows(
        &mut self,
        problem: &ContactProblem,
        delassus: &Delassus,
        rows: &[usize],
        b: &[f64],
    ) -> &ContactSolution {
        let mut matrix = std::mem::take(&mut self.matrix);
        matrix.clear();
        for &row in rows {
            let line = delassus.row(row);
            matrix.extend(rows.iter().map(|&column| line[column]));
        }
        self.search(problem, Some(rows), &matrix, b, None);
        self.matrix = matrix;
        &self.solution
    }

    /// Tries the methods in turn until one is accepted, and keeps the best.
    fn search(
        &mut self,
        problem: &ContactProblem,
        rows: Option<&[usize]>,
        matrix: &[f64],
        b: &[f64],
        warm_start: Option<&WarmStart>,
    ) {
        self.best.report = SolverReport { status: SolverStatus::Inaccurate, residual: f64::NAN, ..Default::default() };
        self.best.rows.clear();
        let size = b.len();
        if size <= 1 {
            self.closed_form(matrix, b);
            return self.publish(b);
        }
        let first = match warm_start {
            Some(start) => self.attempt(matrix, b, start.rows(), Method::WarmStart),
            None => self.attempt(matrix, b, &[], Method::ActiveSet),
        };
        let accepted = first
            || (warm_start.is_some() && self.attempt(matrix, b, &[], Method::ColdStart))
            || self.attempt_all_held(matrix, b);
        let possible = self.best.report.status != SolverStatus::Infeasible;
        if !accepted && possible && self.settings.fallback == FallbackPolicy::InteriorPoint {
            self.interior_point(problem, rows, matrix, b);
        }
        self.refine_precisely(problem, rows, matrix, b);
        self.publish(b);
    }

    /// The thesis's first guess, no contact vanishes, as another way in; rows that separate without forces are left
    /// out. From nothing there are fewer pivots, so this comes second.
    fn attempt_all_held(&mut self, matrix: &[f64], b: &[f64]) -> bool {
        if self.best.report.status == SolverStatus::Infeasible {
            return false;
        }
        let mut guess = std::mem::take(&mut self.guess);
        guess.clear();
        guess.extend((0..b.len()).filter(|&row| b[row] <= 0.0));
        let accepted = self.attempt(matrix, b, &guess, Method::ColdStart);
        self.guess = guess;
        accepted
    }

    /// Equation (14) in complementarity form: `f = max(0, -b / G)`.
    fn closed_form(&mut self, matrix: &[f64], b: &[f64]) {
        let best = &mut self.best;
        best.forces.clear();
        best.w.clear();
        best.scales.clear();
        best.scales.extend(b.iter().map(|constant| constant.abs()));
        best.report = SolverReport::default();
        let (Some(&diagonal), Some(&constant)) = (matrix.first(), b.first()) else { return };
        if constant >= 0.0 {
            best.forces.push(0.0);
            best.w.push(constant);
        } else if diagonal > 0.0 && (-constant / diagonal).is_finite() {
            best.forces.push(-constant / diagonal);
            best.w.push(0.0);
            best.rows.push(0);
            best.report.rank = 1;
        } else {
            best.forces.push(0.0);
            best.w.push(constant);
            best.report.status = SolverStatus::Infeasible;
            best.report.residual = 1.0;
        }
    }

    /// One run of the active set; keeps the answer when it is better and says whether it is accepted.
    fn attempt(&mut self, matrix: &[f64], b: &[f64], start: &[usize], method: Method) -> bool {
        let outcome = self.active_set.run(Problem { matrix, constant: b, settings: &self.settings }, start);
        let warm = method == Method::WarmStart && self.active_set.pivots == 0;
        let mut report = SolverReport {
            status: if outcome == Outcome::Infeasible { SolverStatus::Infeasible } else { SolverStatus::Inaccurate },
            method: if method == Method::WarmStart && !warm { Method::ActiveSet } else { method },
            iterations: self.active_set.pivots,
            rank: self.active_set.rows().len(),
            ..SolverReport::default()
        };
        let active_set = std::mem::take(&mut self.active_set);
        self.certify(matrix, b, &active_set.forces, &active_set.w, &mut report);
        if outcome != Outcome::Infeasible && report.residual <= self.settings.acceptance {
            report.status = SolverStatus::Solved;
        }
        self.offer(&active_set.forces, &active_set.w, active_set.rows(), report);
        self.active_set = active_set;
        report.status == SolverStatus::Solved
    }

    fn interior_point(&mut self, problem: &ContactProblem, rows: Option<&[usize]>, matrix: &[f64], b: &[f64]) {
        let all: Vec<usize>;
        let rows = if let Some(rows) = rows {
            rows
        } else {
            all = (0..b.len()).collect();
            &all
        };
        let Some(answer) = interior_point::contact_forces(problem, rows, b) else { return };
        if self.attempt(matrix, b, &answer.active, Method::InteriorPointPolished) {
            self.best.report.iterations += answer.iterations;
            return;
        }
        let mut w = vec![0.0; b.len()];
        row_accelerations(matrix, b, &answer.forces, &mut w);
        let mut report = SolverReport {
            status: SolverStatus::Inaccurate,
            method: Method::InteriorPoint,
            iterations: answer.iterations,
            rank: answer.active.len(),
            ..SolverReport::default()
        };
        self.certify(matrix, b, &answer.forces, &w, &mut report);
        if report.residual <= self.settings.acceptance {
            report.status = SolverStatus::Solved;
        }
        self.offer(&answer.forces, &w, &answer.active, report);
    }

    /// At large mass ratios: one step of refinement with accelerations in twice the precision, if the answer is that
    /// of the active set in memory.
    fn refine_precisely(&mut self, problem: &ContactProblem, rows: Option<&[usize]>, matrix: &[f64], b: &[f64]) {
        let data = Problem { matrix, constant: b, settings: &self.settings };
        let in_memory = self.best.report.status == SolverStatus::Solved && self.best.rows == self.active_set.rows();
        if !in_memory || !self.active_set.wants_precision(data) {
            return;
        }
        let all: Vec<usize> = rows.map_or_else(|| (0..b.len()).collect(), <[usize]>::to_vec);
        let w = precise::accelerations(problem, &all, b, &self.active_set.forces);
        if self.active_set.correct(&w) {
            let mut report = self.best.report;
            let active_set = std::mem::take(&mut self.active_set);
            let w = precise::accelerations(problem, &all, b, &active_set.forces);
            self.certify(matrix, b, &active_set.forces, &w, &mut report);
            if report.residual <= self.settings.acceptance {
                self.best.report.residual = f64::NAN;
                self.offer(&active_set.forces, &w, active_set.rows(), report);
            }
            self.active_set = active_set;
        }
    }

    /// Fills in residual and bound.
    fn certify(&mut self, matrix: &[f64], b: &[f64], forces: &[f64], w: &[f64], report: &mut SolverReport) {
        let size = b.len();
        self.scales.clear();
        self.scales.resize(size, 0.0);
        row_scales(matrix, b, forces, &mut self.scales);
        let floor = self.settings.noise_floor;
        report.residual = (0..size)
            .map(|i| row_residual(matrix[i * size + i], forces[i], w[i], self.scales[i] + floor))
            .fold(0.0, nan_max);
        report.bound = power_bound(forces, w);
    }

    /// Keeps an answer when it is the first or better than the best.
    fn offer(&mut self, forces: &[f64], w: &[f64], rows: &[usize], report: SolverReport) {
        let best = &mut self.best;
        if report.residual < best.report.residual || best.report.residual.is_nan() {
            best.forces.clear();
            best.forces.extend_from_slice(forces);
            best.w.clear();
            best.w.extend_from_slice(w);
            best.scales.clone_from(&self.scales);
            best.rows.clear();
            best.rows.extend_from_slice(rows);
            best.report = report;
        }
    }

    /// Turns the best answer into the solution: held rows get `w = 0` exactly.
    fn publish(&mut self, b: &[f64]) {
        let Self { solution, best, settings, .. } = self;
        let size = b.len();
        if best.forces.len() != size || best.forces.iter().chain(&best.w).any(|value| !value.is_finite()) {
            // Overflow on the way: no answer at all, said by the status and a residual that is not finite.
            best.forces = vec![0.0; size];
            best.w = b.to_vec();
            best.scales = vec![0.0; size];
            best.rows.clear();
            best.report.status = SolverStatus::Inaccurate;
            best.report.residual = f64::INFINITY;
        }
        solution.forces.clone_from(&best.forces);
        solution.residual_accelerations.clone_from(&best.w);
        solution.held.clear();
        solution.held.resize(size, false);
        for row in 0..size {
            solution.held[row] = best.w[row].abs() <= settings.closed_cut * best.scales[row] + settings.noise_floor;
        }
        if best.report.status == SolverStatus::Solved {
            for &row in &best.rows {
                solution.held[row] = true;
            }
        }
        for (w, held) in solution.residual_accelerations.iter_mut().zip(&solution.held) {
            if *held {
                *w = 0.0;
            }
        }
        solution.warm_start.rows.clone_from(&best.rows);
        solution.report = best.report;
    }
}
