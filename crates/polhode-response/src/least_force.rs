//! The contact forces of the thesis (section 3.4), its heuristic: a linear programme of least total force, and guesses
//! from it.
//!
//! 1. Guess that no contact vanishes: `G f = -b`, `f >= 0`.
//! 2. If there is none: `f_a = argmin sum f` subject to `G f >= -b`, `f >= 0`. Rows with `w_a = G f_a + b > 0` are
//!    guessed to vanish: their forces are zero and they stay inequalities (errata E12); the others become equalities.
//! 3. If there is none: `f_a` itself, which adds energy.
//!
//! Steps 1 and 2 give exact answers, step 3 in general a wrong one (errata E15; cases RC-08, RC-09); the report's bound
//! `sqrt(f.w)` says how wrong. Kept for history and comparison: [`ComplementaritySolver`](crate::ComplementaritySolver)
//! finds the exact answer always. Where `sum f` has several minima the interior point returns one inside the set.
//!
//! Source: thesis, section 3.4, Finding the Vanishing Contact Points, with the signs of errata E11.

#[cfg(feature = "census")]
use crate::census::{self, Chain, Size};
use crate::certificate::{nan_max, power_bound, row_accelerations, row_residual, row_scales};
use crate::delassus::Delassus;
use crate::dense::householder::PivotedQr;
use crate::dense::kernels::{dot, largest};
use crate::error::{ResponseError, check_finite, check_length};
use crate::interior_point::{LinearProgramme, least_sum};
use crate::report::{Method, SolverReport, SolverStatus};
use crate::settings::SolverSettings;
use crate::tolerances::DEPENDENT;
use crate::tolerances::ZERO_CUT;

/// Forces and accelerations of the linear programme count as zero below this multiple of its tolerance (no unit): the
/// interior point leaves zeros of about that size.
const ZERO_FACTOR: f64 = 1e3;

/// Rounding of forces and accelerations after they have been made exact (no unit).
const EXACT: f64 = 1e-12;

/// Which step gave the answer.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub enum LeastForceStage {
    /// No contact vanishes.
    NoneVanish,
    /// The guess from the forces of least sum.
    GuessOfVanishing,
    /// The forces of least sum themselves: in general wrong.
    LeastSum,
    /// There are no forces at all, or the linear programme was not solved: forces are zero.
    NoForces,
}

/// The answer of the thesis's method.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct LeastForceSolution {
    /// `f`, not negative.
    pub forces: Vec<f64>,
    /// `w = G f + b`.
    pub residual_accelerations: Vec<f64>,
    /// `f_a`, when step 2 was reached.
    pub least_sum: Option<Vec<f64>>,
    /// Which step answered.
    pub stage: LeastForceStage,
    /// The certificate: [`SolverStatus::Inaccurate`] with a bound for a wrong answer of step 3.
    pub report: SolverReport,
}

/// Contact forces by the method of the thesis.
///
/// All rows are taken for contacts: the matrix does not tell joints.
///
/// # Errors
/// When lengths differ, a number is not finite, or a setting is out of range.
#[cfg_attr(feature = "census", track_caller)]
pub fn least_force(
    delassus: &Delassus,
    b: &[f64],
    settings: &SolverSettings,
) -> Result<LeastForceSolution, ResponseError> {
    let found = by_programmes(delassus, b, settings)?;
    #[cfg(feature = "census")]
    {
        let stage = match found.stage {
            LeastForceStage::NoneVanish => "none vanish",
            LeastForceStage::GuessOfVanishing => "guess of vanishing",
            LeastForceStage::LeastSum => "least sum",
            LeastForceStage::NoForces => "no forces",
        };
        let size = Size { rows: b.len(), ..Size::default() };
        census::note_single(Chain::Thesis, size, stage, found.report.status, found.report.residual);
    }
    Ok(found)
}

fn by_programmes(
    delassus: &Delassus,
    b: &[f64],
    settings: &SolverSettings,
) -> Result<LeastForceSolution, ResponseError> {
    check_length("constant terms", delassus.len(), b.len())?;
    check_finite("constant terms", b)?;
    delassus.check_finite()?;
    settings.check()?;
    let mut programme = Programme::new(delassus, b);
    let all: Vec<usize> = (0..b.len()).collect();
    if let Some(forces) = programme.solve(&all, &[]) {
        return Ok(programme.answer(forces, None, LeastForceStage::NoneVanish, settings));
    }
    let Some(least) = programme.solve(&[], &all) else {
        return Ok(programme.answer(vec![0.0; b.len()], None, LeastForceStage::NoForces, settings));
    };
    let (w, scales) = programme.accelerations(&least);
    let (vanishing, staying): (Vec<usize>, Vec<usize>) = all.iter().partition(|&&row| w[row] > ZERO_CUT * scales[row]);
    Ok(match programme.solve(&staying, &vanishing) {
        Some(forces) => programme.answer(forces, Some(least), LeastForceStage::GuessOfVanishing, settings),
        None => programme.answer(least.clone(), Some(least), LeastForceStage::LeastSum, settings),
    })
}

/// The linear programmes of one problem.
#[derive(Debug)]
struct Programme<'a> {
    delassus: &'a Delassus,
    b: &'a [f64],
    iterations: usize,
    infeasible: bool,
}

impl<'a> Programme<'a> {
    fn new(delassus: &'a Delassus, b: &'a [f64]) -> Self {
        Self { delassus, b, iterations: 0, infeasible: false }
    }

    /// `min sum f` with `w = 0` on `equal`, `w >= 0` on `at_least`. When some rows are equal, only they carry force
    /// (the others vanish); otherwise all do. `None` when there are no such forces.
    fn solve(&mut self, equal: &[usize], at_least: &[usize]) -> Option<Vec<f64>> {
        let carrying = if equal.is_empty() { at_least } else { equal };
        let size = largest(self.b);
        let stiffness = (0..self.b.len()).map(|row| self.delassus.get(row, row)).fold(0.0, f64::max);
        if size == 0.0 {
            return Some(vec![0.0; self.b.len()]);
        }
        if stiffness == 0.0 {
            self.infeasible = self.b.iter().any(|b| *b < 0.0);
            return (!self.infeasible).then(|| vec![0.0; self.b.len()]);
        }
        let lines = |rows: &[usize]| -> (Vec<f64>, Vec<f64>) {
            let delassus = self.delassus;
            let entry = |&row: &usize| carrying.iter().map(move |&column| delassus.get(row, column) / stiffness);
            (rows.iter().flat_map(entry).collect(), rows.iter().map(|&row| -self.b[row] / size).collect())
        };
        // Equalities that depend on others are implied by them, and checked when the answer is made exact.
        let ((e, e_right), (a, a_right)) = (lines(&independent_rows(self.delassus, equal)), lines(at_least));
        match least_sum(carrying.len(), (&e, &e_right), (&a, &a_right)) {
            LinearProgramme::Solved { x, iterations, tolerance } => {
                self.iterations += iterations;
                let mut forces = vec![0.0; self.b.len()];
                for (&row, value) in carrying.iter().zip(&x) {
                    forces[row] = (value * size / stiffness).max(0.0);
                }
                self.make_exact(forces, equal, ZERO_FACTOR * tolerance)
            }
            LinearProgramme::Infeasible => {
                self.infeasible = equal.is_empty();
                None
            }
            LinearProgramme::Failed => None,
        }
    }

    /// Moves the forces of the interior point onto the vertex or face they stand next to: zero forces to zero, tight
    /// rows to `w = 0`. `None` when equalities cannot be met that way.
    fn make_exact(&self, mut forces: Vec<f64>, equal: &[usize], cut: f64) -> Option<Vec<f64>> {
        let present = largest(&forces);
        let original = forces.clone();
        let carrying: Vec<usize> = (0..forces.len()).filter(|&row| forces[row] > cut * present).collect();
        let (w, scales) = self.accelerations(&forces);
        let tight: Vec<usize> =
            (0..forces.len()).filter(|&row| equal.contains(&row) || w[row].abs() <= ZERO_CUT * scales[row]).collect();
        for (row, force) in forces.iter_mut().enumerate() {
            if !carrying.contains(&row) {
                *force = 0.0;
            }
        }
        let matrix: Vec<f64> =
            carrying.iter().flat_map(|&column| tight.iter().map(move |&row| self.delassus.get(row, column))).collect();
        if !carrying.is_empty() && !tight.is_empty() {
            let qr = PivotedQr::factor(tight.len(), carrying.len(), matrix, EXACT);
            for _ in 0..2 {
                let (w, _) = self.accelerations(&forces);
                let defect: Vec<f64> = tight.iter().map(|&row| -w[row]).collect();
                for (&row, correction) in carrying.iter().zip(qr.solve(&defect)) {
                    forces[row] += correction;
                }
            }
        }
        let (w, scales) = self.accelerations(&forces);
        let sound = forces.iter().all(|force| *force >= -EXACT * present)
            && (0..w.len()).all(|row| w[row] >= -EXACT * scales[row])
            && equal.iter().all(|&row| w[row].abs() <= EXACT * scales[row]);
        if sound {
            Some(forces.iter().map(|force| force.max(0.0)).collect())
        } else if equal.is_empty() {
            Some(original)
        } else {
            None
        }
    }

    /// `w` and the scales of the rows.
    fn accelerations(&self, forces: &[f64]) -> (Vec<f64>, Vec<f64>) {
        let (mut w, mut scales) = (vec![0.0; forces.len()], vec![0.0; forces.len()]);
        row_accelerations(self.delassus.entries(), self.b, forces, &mut w);
        row_scales(self.delassus.entries(), self.b, forces, &mut scales);
        (w, scales)
    }

    fn answer(
        &self,
        forces: Vec<f64>,
        least_sum: Option<Vec<f64>>,
        stage: LeastForceStage,
        settings: &SolverSettings,
    ) -> LeastForceSolution {
        let (w, scales) = self.accelerations(&forces);
        let residual = (0..w.len())
            .map(|row| row_residual(self.delassus.get(row, row), forces[row], w[row], scales[row]))
            .fold(0.0, nan_max);
        let status = match stage {
            LeastForceStage::NoForces if self.infeasible => SolverStatus::Infeasible,
            _ if residual <= settings.acceptance => SolverStatus::Solved,
            _ => SolverStatus::Inaccurate,
        };
        let report = SolverReport {
            status,
            method: Method::LinearProgramme,
            iterations: self.iterations,
            residual,
            bound: power_bound(&forces, &w),
            rank: forces.iter().filter(|force| **force > 0.0).count(),
            ..SolverReport::default()
        };
        LeastForceSolution { forces, residual_accelerations: w, least_sum, stage, report }
    }
}

/// Independent ones among `rows` (ascending), by a Cholesky factorisation with pivoting: the largest relative pivot
/// comes first, the first row of equal ones. Source: Golub and Van Loan, section 4.2.
fn independent_rows(delassus: &Delassus, rows: &[usize]) -> Vec<usize> {
    let diagonal = |row: usize| delassus.get(row, row);
    // Lines of the factor of every row, and what is left of its diagonal entry.
    let mut lines: Vec<Vec<f64>> = vec![Vec::new(); rows.len()];
    let mut left: Vec<f64> = rows.iter().map(|&row| diagonal(row)).collect();
    let mut open: Vec<usize> = (0..rows.len()).filter(|&k| left[k] > 0.0).collect();
    let mut independent = Vec::new();
    loop {
        let relative = |k: usize| left[k] / diagonal(rows[k]);
        let larger = |best, k| if relative(open[k]) > relative(open[best]) { k } else { best };
        let Some(position) = (0..open.len()).reduce(larger) else { break };
        let next = open[position];
        if relative(next) <= DEPENDENT {
            break;
        }
        open.remove(position);
        let (line, pivot) = (std::mem::take(&mut lines[next]), left[next].sqrt());
        for &k in &open {
            let entry = (delassus.get(rows[k], rows[next]) - dot(&lines[k], &line)) / pivot;
            lines[k].push(entry);
            left[k] -= entry * entry;
        }
        independent.push(rows[next]);
    }
    independent
}
