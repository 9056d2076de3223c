//! The solver with its fallbacks and its certificate.

use super::active_set::{ActiveSet, NOISE_ALLOWED, Outcome, Problem};
use super::rank::{Image, Motion, Rank};
use super::{ContactSolution, WarmStart};
#[cfg(feature = "census")]
use crate::census::{self, Answer, Chain, Size};
use crate::certificate::{FACTOR_MARGIN, bilateral_residual, nan_max, power_bound, row_residual, row_scales};
use crate::delassus::Delassus;
use crate::dense::kernels::{axpy, largest};
use crate::dense::scalar::Scalar;
use crate::error::{ResponseError, check_finite, check_length};
use crate::method_set::MethodSet;
use crate::precise;
use crate::problem::ContactProblem;
use crate::report::{Method, SolverReport, SolverStatus};
use crate::settings::SolverSettings;
use crate::tolerances::LARGEST_RESIDUAL_ROUNDING;
use polhode_spatial::DoubleDouble;
use polhode_spatial::rounding;

/// A Schur complement in twice the precision below this fraction of its terms is rounding, whatever the settings say
/// (no unit): a hundred times the rounding unit.
const PRECISE_PIVOT_ROUNDING: f64 = 1e-29;

/// Bodies that are squeezed by less than this fraction of the terms of a row fit within the rounding of their data (no
/// unit): a hundred times what rows that count as dependent may differ by.
const SQUEEZE_ROUNDING: f64 = 1e-12;

/// An answer that holds only to the rounding of the constant terms is refused when the terms that cancel in its rows
/// exceed the largest constant by this factor (no unit): their own rounding then decides it.
const SOUND_AMPLIFICATION: f64 = 1e3;

/// Steps of refinement at large mass ratios: each leaves the rounding unit times the condition of the factor.
const REFINEMENTS: usize = 3;

/// Solves complementarity problems; keeps its memory from one problem to the next.
#[derive(Debug, Clone, Default)]
pub struct ComplementaritySolver {
    settings: SolverSettings,
    active_set: ActiveSet,
    precise: PreciseSet,
    solution: ContactSolution,
    best: Candidate,
    scales: Vec<f64>,
    matrix: Vec<f64>,
    /// Which methods the search has tried.
    tried: MethodSet<Method>,
}

/// The active set in twice the precision, with its problem.
#[derive(Debug, Clone, Default)]
struct PreciseSet {
    active_set: ActiveSet<DoubleDouble>,
    matrix: Vec<DoubleDouble>,
    constant: Vec<DoubleDouble>,
    forces: Vec<f64>,
    w: Vec<f64>,
}

/// The problem of one search.
#[derive(Debug, Clone, Copy)]
struct Data<'a> {
    problem: &'a ContactProblem,
    /// Which rows of the problem; all when `None`.
    rows: Option<&'a [usize]>,
    /// Which of them are bilateral; empty when none is.
    bilateral: &'a [bool],
    /// `G` of the rows, row-major.
    matrix: &'a [f64],
    b: &'a [f64],
}

impl Data<'_> {
    fn is_bilateral(&self, row: usize) -> bool {
        self.bilateral.get(row).copied().unwrap_or(false)
    }

    fn all_rows(&self) -> Vec<usize> {
        self.rows.map_or_else(|| (0..self.b.len()).collect(), <[usize]>::to_vec)
    }
}

/// An answer with its certificate.
#[derive(Debug, Clone, Default)]
struct Candidate {
    forces: Vec<f64>,
    w: Vec<f64>,
    squeeze: Vec<f64>,
    scales: Vec<f64>,
    rows: Vec<usize>,
    report: SolverReport,
}

/// Solves one problem. [`ComplementaritySolver`] does the same without allocating each time.
///
/// # Errors
/// See [`ComplementaritySolver::solve`].
#[cfg_attr(feature = "census", track_caller)]
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
    #[cfg_attr(feature = "census", track_caller)]
    pub fn solve(
        &mut self,
        problem: &ContactProblem,
        delassus: &Delassus,
        b: &[f64],
        warm_start: Option<&WarmStart>,
    ) -> Result<&ContactSolution, ResponseError> {
        problem.check_frictionless()?;
        check_length("Delassus matrix", problem.len(), delassus.len())?;
        check_length("constant terms", problem.len(), b.len())?;
        check_finite("constant terms", b)?;
        delassus.check_finite()?;
        self.settings.check()?;
        let bilateral = problem.bilateral_rows(None);
        let data = Data { problem, rows: None, bilateral: &bilateral, matrix: delassus.entries(), b };
        self.search(data, warm_start);
        #[cfg(feature = "census")]
        self.counted(data, warm_start);
        Ok(&self.solution)
    }

    /// The problem of the given rows alone, as if the others were not there; the solution is in the order of `rows`.
    /// The caller has checked the data.
    #[cfg_attr(feature = "census", track_caller)]
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
        let bilateral = problem.bilateral_rows(Some(rows));
        let data = Data { problem, rows: Some(rows), bilateral: &bilateral, matrix: &matrix, b };
        self.search(data, None);
        #[cfg(feature = "census")]
        self.counted(data, None);
        self.matrix = matrix;
        &self.solution
    }

    /// Tells the census of a solve, and of what the next methods would have found.
    #[cfg(feature = "census")]
    #[track_caller]
    fn counted(&self, data: Data<'_>, warm_start: Option<&WarmStart>) {
        let answer = |solver: &Self| {
            let report = &solver.solution.report;
            let method = report.answered_by(solver.settings.noise_floor);
            let answer = Answer {
                method: method.name(),
                tried: report.tried.iter().map(Method::name).collect(),
                status: report.status,
                residual: report.residual,
                cost: report.iterations,
                motion: solver.solution.residual_accelerations.clone(),
            };
            (answer, method)
        };
        let (first, _) = answer(self);
        let again = |without: &[&str]| {
            let left_out = MethodSet::of_names(without);
            let mut other = Self::new(SolverSettings { left_out, ..self.settings });
            other.search(data, warm_start);
            let (found, method) = answer(&other);
            let is_new = !left_out.contains(method) && found.tried.contains(&found.method);
            is_new.then_some(found)
        };
        let size = Size { bodies: data.problem.bodies(), rows: data.b.len(), cones: 0 };
        let text = || data.problem.text(data.rows, data.b);
        census::note(Chain::ActiveSet, size, &first, self.settings.acceptance, again, text);
    }

    /// Notes that a method is tried; whether it is.
    fn begins(&mut self, method: Method) -> bool {
        let is_tried = !self.settings.left_out.contains(method);
        if is_tried {
            self.tried.insert(method);
        }
        is_tried
    }

    /// Solves; where that does not succeed, once more with the rounding of the constant terms as noise: each of them is
    /// a sum of terms as large as the largest of all, and rows whose own terms vanish must not pass for bodies that are
    /// squeezed by a rounding.
    fn search(&mut self, data: Data<'_>, warm_start: Option<&WarmStart>) {
        self.tried = MethodSet::default();
        self.try_methods(data, warm_start);
        let noise_floor = rounding::DOZENS_OF_TERMS * largest(data.b);
        let is_solved = self.solution.report.status == SolverStatus::Solved;
        if is_solved || noise_floor <= self.settings.noise_floor || !self.begins(Method::RoundingAsNoise) {
            return;
        }
        let (settings, unsolved) = (self.settings, self.solution.clone());
        self.settings.noise_floor = noise_floor;
        self.try_methods(data, None);
        self.settings = settings;
        let is_sound = largest(&self.best.scales) <= SOUND_AMPLIFICATION * largest(data.b);
        if self.solution.report.status == SolverStatus::Solved && is_sound {
            // What is noise in one row may be motion in another: rows are held by what they are, not by the noise.
            self.publish(data.b);
            self.solution.report.iterations += unsolved.report.iterations;
            self.solution.report.noise_floor = noise_floor;
        } else {
            self.solution = unsolved;
            self.solution.report.tried = self.tried;
        }
    }

    /// Tries the methods in turn until one decides, and keeps the best answer.
    fn try_methods(&mut self, data: Data<'_>, warm_start: Option<&WarmStart>) {
        self.best.report = SolverReport { status: SolverStatus::Inaccurate, residual: f64::NAN, ..Default::default() };
        self.best.rows.clear();
        self.best.squeeze.clear();
        if data.b.len() <= 1 {
            self.begins(Method::ClosedForm);
            self.closed_form(data);
            return self.publish(data.b);
        }
        match warm_start.filter(|_| !self.settings.left_out.contains(Method::WarmStart)) {
            Some(start) => self.decide(data, start.rows(), Method::WarmStart),
            None => self.decide(data, &[], Method::ActiveSet),
        }
        self.refine_precisely(data);
        if self.best.report.status == SolverStatus::Solved && self.best.report.residual > SQUEEZE_ROUNDING {
            let rows = self.best.rows.clone();
            self.attempt_precisely(data, &rows);
        }
        self.sharpen_bound(data);
        self.refuse_rounding(data.b);
        self.publish(data.b);
    }

    /// Refuses forces that no active set certifies and whose rounding is larger than the terms that they should hold:
    /// rows that contradict each other by a rounding are exact with forces so large that more is left of their sum.
    fn refuse_rounding(&mut self, b: &[f64]) {
        let rounding = f64::EPSILON * largest(&self.best.scales);
        let size = largest(b).max(NOISE_ALLOWED * self.settings.noise_floor);
        let report = &mut self.best.report;
        let is_rounding = !report.certified && rounding > LARGEST_RESIDUAL_ROUNDING * size;
        if is_rounding && report.status == SolverStatus::Solved {
            report.status = SolverStatus::Inaccurate;
        }
    }

    /// The active set in working precision and, where that does not do, in twice the precision.
    fn decide(&mut self, data: Data<'_>, start: &[usize], method: Method) {
        if !self.begins(method) {
            return;
        }
        match self.attempt(data, start, method) {
            Outcome::Accepted => {}
            Outcome::PivotLimit => self.attempt_precisely(data, start),
            _ => {
                let rows = self.active_set.rows().to_vec();
                self.attempt_precisely(data, &rows);
            }
        }
    }

    /// Equation (14) in complementarity form: `f = max(0, -b / G)`.
    fn closed_form(&mut self, data: Data<'_>) {
        let Data { matrix, b, .. } = data;
        let best = &mut self.best;
        best.forces.clear();
        best.w.clear();
        best.scales.clear();
        best.scales.extend(b.iter().map(|constant| constant.abs()));
        best.report = SolverReport::default();
        let (Some(&diagonal), Some(&constant)) = (matrix.first(), b.first()) else { return };
        best.report.certified = true;
        if constant == 0.0 || (constant > 0.0 && !data.is_bilateral(0)) {
            best.forces.push(0.0);
            best.w.push(constant);
        } else if diagonal > 0.0 && (-constant / diagonal).is_finite() {
            best.forces.push(-constant / diagonal);
            best.w.push(0.0);
            best.rows.push(0);
            best.report.rank = 1;
            // The quotient, and the products and sums in `G`, are rounded.
            best.report.bound = rounding::DOZENS_OF_TERMS * constant.abs() / diagonal.sqrt();
        } else {
            best.forces.push(0.0);
            best.w.push(constant);
            best.squeeze.push(1.0);
            best.report.status = SolverStatus::Infeasible;
            best.report.residual = 1.0;
            best.report.certified = false;
        }
    }

    /// One run of the active set in working precision; keeps the answer when it is better.
    fn attempt(&mut self, data: Data<'_>, start: &[usize], method: Method) -> Outcome {
        let Data { problem, rows, bilateral, matrix, b } = data;
        let squeeze_rounding = SQUEEZE_ROUNDING;
        let rank = Rank::Motion(Motion { problem, rows, cut: self.settings.rank_cut });
        let mut outcome = self
            .active_set
            .run(Problem { matrix, constant: b, bilateral, rank, squeeze_rounding, settings: &self.settings }, start);
        let warm = method == Method::WarmStart && self.active_set.pivots == 0;
        let mut report = SolverReport {
            status: SolverStatus::Inaccurate,
            method: if method == Method::WarmStart && !warm { Method::ActiveSet } else { method },
            iterations: self.active_set.pivots,
            rank: self.active_set.rows().len(),
            ..SolverReport::default()
        };
        let active_set = std::mem::take(&mut self.active_set);
        self.certify(data, &active_set.forces, &active_set.w, &mut report);
        if outcome == Outcome::Converged && report.residual <= self.settings.acceptance {
            report.status = SolverStatus::Solved;
            outcome = Outcome::Accepted;
        }
        self.offer(&active_set.forces, &active_set.w, active_set.rows(), report);
        self.active_set = active_set;
        outcome
    }

    /// One run of the active set in twice the precision.
    fn attempt_precisely(&mut self, data: Data<'_>, start: &[usize]) {
        if !self.begins(Method::PreciseActiveSet) {
            return;
        }
        let mut precise = std::mem::take(&mut self.precise);
        precise::delassus(data.problem, &data.all_rows(), &mut precise.matrix);
        precise.constant.clear();
        precise.constant.extend(data.b.iter().map(|&constant| DoubleDouble::new(constant)));
        let cut = (self.settings.rank_cut * self.settings.rank_cut).max(PRECISE_PIVOT_ROUNDING);
        let (matrix, constant, rank) = (&precise.matrix[..], &precise.constant[..], Rank::Pivot(cut));
        let (squeeze_rounding, bilateral) = (SQUEEZE_ROUNDING, data.bilateral);
        let outcome = precise
            .active_set
            .run(Problem { matrix, constant, bilateral, rank, squeeze_rounding, settings: &self.settings }, start);
        for (rounded, exact) in
            [(&mut precise.forces, &precise.active_set.forces), (&mut precise.w, &precise.active_set.w)]
        {
            rounded.clear();
            rounded.extend(exact.iter().map(|value| value.to_f64()));
        }
        let mut report = SolverReport {
            status: SolverStatus::Inaccurate,
            method: Method::PreciseActiveSet,
            iterations: self.active_set.pivots + precise.active_set.pivots,
            rank: precise.active_set.rows().len(),
            ..SolverReport::default()
        };
        self.certify(data, &precise.forces, &precise.w, &mut report);
        if outcome == Outcome::Infeasible && self.is_squeeze(data, &precise.active_set.ray) {
            report.status = SolverStatus::Infeasible;
            self.best.squeeze.clone_from(&precise.active_set.ray);
        } else if outcome == Outcome::Converged && report.residual <= self.settings.acceptance {
            report.status = SolverStatus::Solved;
        }
        if report.status != SolverStatus::Inaccurate {
            self.best.report.residual = f64::NAN;
        }
        self.offer(&precise.forces, &precise.w, precise.active_set.rows(), report);
        self.precise = precise;
    }

    /// Whether forces move no body, to what rows that count as dependent may differ by.
    fn is_squeeze(&self, Data { problem, rows, matrix, b, .. }: Data<'_>, forces: &[f64]) -> bool {
        let motion = Motion { problem, rows, cut: self.settings.rank_cut };
        let distance = motion.distance(forces.iter().copied().enumerate(), &mut Image::default());
        let root = |row: usize| matrix[row * b.len() + row].sqrt();
        let terms: f64 = forces.iter().enumerate().map(|(row, force)| root(row) * force.abs()).sum();
        distance <= motion.cut.max(f64::ROUNDING) * terms
    }

    /// At large mass ratios: refinement with accelerations in twice the precision, if the answer is that of the active
    /// set in memory. One step does, unless the factor has few digits left.
    fn refine_precisely(&mut self, data: Data<'_>) {
        let Data { problem, matrix, b, .. } = data;
        let report = &self.best.report;
        let in_memory = report.status == SolverStatus::Solved
            && report.method != Method::PreciseActiveSet
            && self.best.rows == self.active_set.rows();
        if !in_memory || !self.active_set.wants_precision(matrix) || !self.begins(Method::Refinement) {
            return;
        }
        let all = data.all_rows();
        let mut active_set = std::mem::take(&mut self.active_set);
        let mut w = precise::accelerations(problem, &all, b, &active_set.forces);
        for round in 0..REFINEMENTS {
            if !active_set.correct(&w, data.bilateral) {
                break;
            }
            let mut report = self.best.report;
            w = precise::accelerations(problem, &all, b, &active_set.forces);
            self.certify(data, &active_set.forces, &w, &mut report);
            let better = round == 0 || report.residual < self.best.report.residual;
            if !better || report.residual > self.settings.acceptance {
                break;
            }
            // The residual before the first step is that of working precision, which does not see what is corrected.
            self.best.report.residual = f64::NAN;
            self.offer(&active_set.forces, &w, active_set.rows(), report);
            if report.residual <= self.settings.tolerance {
                break;
            }
        }
        self.active_set = active_set;
    }

    /// Replaces the bound by that of the active set, linear in the residual, where the best answer's set is right: its
    /// rows carry all forces, and the others stay above zero when the residual of these is taken away.
    fn sharpen_bound(&mut self, data: Data<'_>) {
        let Self { best, active_set, precise, settings, .. } = self;
        let size = data.b.len();
        let carried = best.rows.iter().filter(|&&row| best.forces[row] != 0.0).count();
        let carrying = best.forces.iter().filter(|&&force| force != 0.0).count();
        if best.report.status != SolverStatus::Solved || carried != carrying {
            return;
        }
        let residual = precise::residual(data.problem, &data.all_rows(), data.b, &best.forces, &best.rows);
        let (squeeze_rounding, bilateral) = (SQUEEZE_ROUNDING, data.bilateral);
        let rank = Rank::Pivot(0.0);
        // The factor in twice the precision is of this problem only when the answer is; that in working precision
        // always is.
        let absorbed = if best.report.method == Method::PreciseActiveSet {
            let (matrix, constant) = (&precise.matrix[..], &precise.constant[..]);
            let problem = Problem { matrix, constant, bilateral, rank, squeeze_rounding, settings };
            (best.rows == precise.active_set.rows()).then(|| precise.active_set.absorbed(problem, &residual))
        } else {
            let problem =
                Problem { matrix: data.matrix, constant: data.b, bilateral, rank, squeeze_rounding, settings };
            (best.rows == active_set.rows()).then(|| active_set.absorbed(problem, &residual))
        };
        let Some((absorbed, length)) = absorbed.flatten() else { return };
        let mut w = best.w.clone();
        for (&row, y) in best.rows.iter().zip(&absorbed) {
            axpy(-y, &data.matrix[row * size..(row + 1) * size], &mut w);
        }
        for &row in &best.rows {
            w[row] = 0.0;
        }
        let noise = NOISE_ALLOWED * settings.noise_floor;
        let stays = |row: usize| {
            let below = if data.is_bilateral(row) { w[row].abs() } else { -w[row] };
            below <= rounding::DOZENS_OF_TERMS * best.scales[row] + noise
        };
        if length.is_finite() && (0..size).all(stays) {
            best.report.bound = FACTOR_MARGIN * length;
            best.report.certified = true;
        }
    }

    /// Fills in residual and bound.
    fn certify(&mut self, data: Data<'_>, forces: &[f64], w: &[f64], report: &mut SolverReport) {
        let Data { matrix, b, .. } = data;
        let size = b.len();
        self.scales.clear();
        self.scales.resize(size, 0.0);
        row_scales(matrix, b, forces, &mut self.scales);
        // What the constant terms carry as noise is no fault of the answer.
        let noise = NOISE_ALLOWED * self.settings.noise_floor;
        let quiet = |w: f64| if w.abs() <= noise { 0.0 } else { w };
        report.residual = (0..size)
            .map(|i| {
                let scale = self.scales[i] + noise;
                if data.is_bilateral(i) {
                    bilateral_residual(quiet(w[i]), scale)
                } else {
                    row_residual(matrix[i * size + i], forces[i], quiet(w[i]), scale)
                }
            })
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
        let Self { solution, best, settings, tried, .. } = self;
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
        solution.squeeze.clone_from(&best.squeeze);
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
        solution.report = SolverReport { noise_floor: settings.noise_floor, tried: *tried, ..best.report };
    }
}
