//! The chain of methods in the velocities of bodies, and one residual for all of them.
//!
//! Warm: semismooth Newton from the reactions given. Cold, or where that has not come down: loads that would hold
//! everything, the interior point from them, and Newton's method to the end; where the interior point jams or
//! Newton's method finds no end, smoothing Newton and Newton's method in turn. The best of all is returned, with its
//! residual and what became of it.

use crate::error::{ResponseError, check_finite, check_length};
use crate::report::SolverStatus;
use crate::sparse::cone_form::ConeForm;
use crate::sparse::elimination::Elimination;
use crate::sparse::interior_point::InteriorPoint;
use crate::sparse::iterate::{Iterate, Measure};
use crate::sparse::newton::{BodyNewton, NewtonLimits};
use crate::sparse::problem::BodyProblem;
use crate::sparse::settings::BodySettings;
use crate::sparse::smoothing::{InteriorEnd, Smoothing, SmoothingLimits};
use crate::sparse::solution::{BodyMethod, BodyReport, BodySolution};
use crate::sparse::system::BodySystem;

/// Steps of the interior point (20 to 40).
const MOST_INTERIOR_STEPS: usize = 25;

/// Steps of Newton's method right after the interior point: where it leads to the end it takes one to three.
const FIRST_NEWTON_STEPS: usize = 4;

/// Steps of the smoothing Newton method in one turn, and in one after so many factorisations that an accepted answer would be
/// enough; steps of Newton's method in one turn.
const SMOOTHING_STEPS: usize = 10;
const LATE_SMOOTHING_STEPS: usize = 20;
const NEWTON_STEPS: usize = 20;

/// Steps in which the residual must halve: where the smoothing method goes on otherwise, the same that late, and where nothing
/// does.
const PATIENCE: usize = 3;
const LATE_PATIENCE: usize = 6;
const LONG_PATIENCE: usize = 20;

/// Balanced residual of an answer that is enough, in units of what is accepted (no unit, 1 to 10).
const ENOUGH_BALANCED: f64 = 1.0;

/// A late step of Newton's method whose shortest trial leaves more than this of the largest function of the last ones is not
/// taken (no unit, 2 to 10): among rows that all but depend on each other it leads away from where the last ones came to.
const TOO_FAR: f64 = 4.0;

/// The solver, with the elimination of the last problem: it is kept as long as the same bodies are coupled by the
/// same rows.
///
/// ```
/// use polhode_response::sparse::{BodyMass, BodyProblem, BodyRows, BodySettings, BodySolver};
/// use polhode_response::{Law, SolverStatus};
/// // A ball of 2 kg, held from turning, that comes down with 3 m/s and along with 4 m/s slides on with 2.5 m/s.
/// let stiff = [1e12, 0.0, 0.0, 0.0, 1e12, 0.0, 0.0, 0.0, 1e12];
/// let ball = BodyMass::rigid(2.0, &stiff);
/// let mut problem = BodyProblem::new(&[ball], &[[4.0, 0.0, -3.0, 0.0, 0.0, 0.0]])?;
/// let mut jacobian = [0.0; 18];
/// (jacobian[2], jacobian[6], jacobian[13]) = (1.0, 1.0, 1.0);
/// let law = Law::Cone { rows: 3, friction: 0.5 };
/// problem.push(&BodyRows { law, bodies: &[(0, &jacobian)], bias: &[0.0; 3], compliance: &[] })?;
/// let solution = BodySolver::default().solve(&problem, None, &BodySettings::default())?;
/// assert_eq!(solution.report.status, SolverStatus::Solved);
/// assert!((solution.velocities[0][0] - 2.5).abs() < 1e-11);
/// # Ok::<(), polhode_response::ResponseError>(())
/// ```
#[derive(Debug, Clone, Default)]
pub struct BodySolver {
    elimination: Elimination,
    system: BodySystem,
}

impl BodySolver {
    /// Solves a problem. `start` are reactions of a similar problem, one for each row.
    ///
    /// A problem that is not solved is no error: see the status of the report.
    ///
    /// # Errors
    /// When the start has another length or a number that is not finite, or a setting is out of range.
    pub fn solve(
        &mut self,
        problem: &BodyProblem,
        start: Option<&[f64]>,
        settings: &BodySettings,
    ) -> Result<BodySolution, ResponseError> {
        settings.check()?;
        if let Some(start) = start {
            check_length("start", problem.rows(), start.len())?;
            check_finite("start", start)?;
        }
        let report = BodyReport { kept_elimination: self.elimination.fits(problem), ..BodyReport::default() };
        if !report.kept_elimination {
            self.elimination = Elimination::of(problem);
        }
        self.system.factorisations = 0;
        let measure = Measure::of(problem);
        let mut chain = Chain {
            problem,
            settings,
            measure: &measure,
            elimination: &self.elimination,
            newton: BodyNewton::new(problem, &self.elimination, &measure),
            system: &mut self.system,
            best: Iterate::default(),
            report,
        };
        chain.run(start);
        Ok(chain.finish())
    }

    /// The elimination of the last problem.
    pub fn elimination(&self) -> &Elimination {
        &self.elimination
    }
}

/// The methods with the best answer so far.
#[derive(Debug)]
struct Chain<'a> {
    problem: &'a BodyProblem,
    settings: &'a BodySettings,
    measure: &'a Measure,
    elimination: &'a Elimination,
    newton: BodyNewton<'a>,
    system: &'a mut BodySystem,
    best: Iterate,
    report: BodyReport,
}

impl Chain<'_> {
    fn run(&mut self, start: Option<&[f64]>) {
        self.best.take(self.problem, self.measure, &vec![0.0; self.problem.rows()]);
        if self.is_reached() {
            return;
        }
        let without = self.best.clone();
        if let Some(start) = start {
            let mut warm = Iterate::default();
            warm.take(self.problem, self.measure, start);
            self.best.keep(&warm);
            if self.is_reached() {
                return;
            }
            let limits = self.newton_limits(self.settings.warm_steps);
            self.newton.run(self.system, &mut warm, limits);
            self.report.warm = self.system.factorisations;
            self.take(&warm, BodyMethod::Warm);
            if self.is_reached() {
                return;
            }
        }
        self.cold(&without);
    }

    /// From nothing.
    fn cold(&mut self, without: &Iterate) {
        let before = self.system.factorisations;
        let loads = self.newton.holding(self.system, without).to_vec();
        let mut point = InteriorPoint::new(self.problem, self.elimination, self.measure, &loads);
        let mut near = without.clone();
        point.run(self.system, &mut near, MOST_INTERIOR_STEPS.min(self.left()));
        self.report.interior = self.system.factorisations - before;
        self.take(&near, BodyMethod::InteriorPoint);
        self.finish_with_newton(near.clone(), FIRST_NEWTON_STEPS, PATIENCE);
        if self.is_reached() {
            return;
        }
        if self.problem.blocks.iter().any(|block| ConeForm::is_inner(block.law)) {
            self.finish_with_newton(near, self.left(), LONG_PATIENCE);
            return;
        }
        let end = InteriorEnd { ratios: point.ratios(), weights: point.weights(), gap: point.gap() };
        let mut smoothing = Smoothing::new(self.problem, self.elimination, self.measure, &loads, end, near.clone());
        while !self.is_reached() && !self.is_enough() && self.left() > 0 {
            let before = self.system.factorisations;
            let (steps, patience) =
                if self.is_late() { (LATE_SMOOTHING_STEPS, LATE_PATIENCE) } else { (SMOOTHING_STEPS, PATIENCE) };
            let limits = SmoothingLimits { most: steps.min(self.left()), tolerance: self.settings.tolerance };
            smoothing.run(self.system, &mut near, limits);
            self.report.smoothing += self.system.factorisations - before;
            self.take(&near, BodyMethod::Smoothing);
            if !self.is_reached() {
                self.finish_with_newton(near.clone(), NEWTON_STEPS, patience);
            }
        }
    }

    fn finish_with_newton(&mut self, mut from: Iterate, most: usize, patience: usize) {
        let before = self.system.factorisations;
        let limits = NewtonLimits { patience, ..self.newton_limits(most) };
        self.newton.run(self.system, &mut from, limits);
        self.report.newton += self.system.factorisations - before;
        self.take(&from, BodyMethod::Newton);
    }

    fn newton_limits(&self, most: usize) -> NewtonLimits {
        let too_far = if self.is_late() { TOO_FAR } else { f64::INFINITY };
        let (most, tolerance) = (most.min(self.left()), self.settings.tolerance);
        NewtonLimits { most, patience: PATIENCE, tolerance, too_far }
    }

    fn left(&self) -> usize {
        self.settings.factorisations.saturating_sub(self.system.factorisations)
    }

    fn is_reached(&self) -> bool {
        self.best.rank <= self.settings.tolerance
    }

    /// Whether the methods have had their turns.
    fn is_late(&self) -> bool {
        self.system.factorisations >= self.settings.enough
    }

    /// Whether they have, and the answer is accepted, its velocities included.
    fn is_enough(&self) -> bool {
        let is_accepted = self.best.rank <= self.settings.acceptance;
        self.is_late()
            && is_accepted
            && self.measure.balanced(self.problem, &self.best) <= ENOUGH_BALANCED * self.settings.acceptance
    }

    fn take(&mut self, iterate: &Iterate, method: BodyMethod) {
        if iterate.rank < self.best.rank || self.best.rank.is_nan() {
            self.best.clone_from(iterate);
            self.report.method = method;
        }
    }

    fn finish(mut self) -> BodySolution {
        self.report.balanced_residual = self.measure.balanced(self.problem, &self.best);
        self.report.residual = self.best.residual;
        self.report.factorisations = self.system.factorisations;
        let is_solved = self.best.rank <= self.settings.tolerance.max(self.settings.acceptance);
        self.report.status = if is_solved { SolverStatus::Solved } else { SolverStatus::Inaccurate };
        let laws = self.newton.laws_at(&self.best);
        BodySolution {
            statuses: self.problem.given().iter().map(|&block| laws[block].status).collect(),
            parts: self.problem.given().iter().map(|&block| laws[block].parts).collect(),
            velocities: self.problem.velocities_of_bodies(&self.best.velocities),
            reactions: self.best.reactions,
            rates: self.best.rates,
            report: self.report,
        }
    }
}
