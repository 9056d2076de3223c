//! The chain of methods in the velocities of bodies, and one residual for all of them.
//!
//! Warm: semismooth Newton from the reactions given, where there is friction. Where that was not enough, and where
//! sweeps are asked for, some of them. Without friction the augmented Lagrangian follows, with Newton's
//! method to the end. With friction: the interior point, from the loads that sweeps have found or from those that
//! would hold everything, and Newton's method; where these find no answer, the path of compliance from the best one;
//! where that turns back, smoothing Newton with Newton's method, and the path from no reactions at all. The best of all
//! is returned, with its residual and what became of it. (Further rounds of sweeps gave no answer that no other method
//! gives: docs/census.md.)

#[cfg(feature = "census")]
use crate::census::{self, Answer, Size};
use crate::error::{ResponseError, check_finite, check_length};
#[cfg(feature = "census")]
use crate::method_set::MethodSet;
use crate::report::SolverStatus;
use crate::sparse::augmented_lagrangian::AugmentedLagrangian;
use crate::sparse::compliance_path::{CompliancePath, PathLimits};
use crate::sparse::cone_form::ConeForm;
use crate::sparse::elimination::Elimination;
use crate::sparse::interior_point::InteriorPoint;
use crate::sparse::iterate::{Iterate, Measure};
use crate::sparse::newton::{BodyNewton, NewtonLimits};
use crate::sparse::problem::BodyProblem;
use crate::sparse::settings::BodySettings;
use crate::sparse::smoothing::{InteriorEnd, Smoothing, SmoothingLimits};
use crate::sparse::solution::{BodyMethod, BodyReport, BodySolution};
use crate::sparse::sweeps::Sweeps;
use crate::sparse::system::BodySystem;

/// Steps of the interior point (20 to 40).
const MOST_INTERIOR_STEPS: usize = 25;

/// Steps of Newton's method right after the interior point: where it leads to the end it takes one to six.
const FIRST_NEWTON_STEPS: usize = 8;

/// Steps of the smoothing Newton method, and those of Newton's method after it.
const SMOOTHING_STEPS: usize = 20;
const NEWTON_STEPS: usize = 20;

/// Its steps after the path of compliance, which has come to what is accepted: as exactly as rounding allows, so that
/// what rests stays at rest.
const LAST_NEWTON_STEPS: usize = 12;

/// Sweeps to and fro before a cold start (4 to 20).
const FIRST_SWEEPS: usize = 8;

/// Steps of Newton's method after the augmented Lagrangian.
const NEWTON_STEPS_AFTER_LAGRANGIAN: usize = 8;

/// Steps in which the residual must halve.
const PATIENCE: usize = 3;

/// The residual at which the path of compliance ends, in units of what is accepted (no unit, 0.1 to 0.5).
const WELL_WITHIN: f64 = 0.2;

/// The first compliance about an answer, in units of its residual (no unit, 10 to 100), and the least one; the one
/// about no reactions (no units).
const COMPLIANCE_PER_RESIDUAL: f64 = 30.0;
const LEAST_FIRST_COMPLIANCE: f64 = 1e-6;
const LARGEST_FIRST_COMPLIANCE: f64 = 1.0;

/// Factorisations of a path of compliance.
const FACTORISATIONS_OF_A_PATH: usize = 40;

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
    #[cfg_attr(feature = "census", track_caller)]
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
        let solution = self.run(problem, start, settings);
        #[cfg(feature = "census")]
        self.counted(problem, start, settings, &solution);
        Ok(solution)
    }

    /// The answer of the chain.
    fn run(&mut self, problem: &BodyProblem, start: Option<&[f64]>, settings: &BodySettings) -> BodySolution {
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
            stage: BodyMethod::Start,
            report,
        };
        chain.run(start);
        chain.finish()
    }

    /// Tells the census of a solve, and of what the next stages would have found.
    #[cfg(feature = "census")]
    #[track_caller]
    fn counted(&self, problem: &BodyProblem, start: Option<&[f64]>, settings: &BodySettings, solution: &BodySolution) {
        let answer = |solution: &BodySolution| {
            let report = &solution.report;
            Answer {
                method: report.stage.name(),
                tried: report.tried.iter().map(BodyMethod::name).collect(),
                status: report.status,
                residual: report.rank,
                cost: report.factorisations,
                motion: solution.rates.clone(),
            }
        };
        let mut solver = Self { elimination: self.elimination.clone(), system: BodySystem::default() };
        let again = |without: &[&str]| {
            let left_out = MethodSet::of_names(without);
            let other = solver.run(problem, start, &BodySettings { left_out, ..*settings });
            other.report.tried.contains(other.report.stage).then(|| answer(&other))
        };
        let cones = problem.blocks.iter().filter(|block| block.law.has_friction()).count();
        let size = Size { bodies: problem.movable_bodies(), rows: problem.rows(), cones };
        census::note(census::Chain::Bodies, size, &answer(solution), settings.tolerance, again, || problem.text(start));
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
    /// The stage that runs.
    stage: BodyMethod,
    report: BodyReport,
}

impl Chain<'_> {
    fn run(&mut self, start: Option<&[f64]>) {
        self.best.take(self.problem, self.measure, &vec![0.0; self.problem.rows()]);
        if self.is_reached() {
            return;
        }
        let without = self.best.clone();
        if let Some(start) = start
            && self.begins(BodyMethod::Warm)
        {
            let mut warm = Iterate::default();
            warm.take(self.problem, self.measure, start);
            self.best.keep(&warm);
            if self.is_reached() {
                return;
            }
            if !AugmentedLagrangian::takes(self.problem) {
                self.run_newton(&mut warm, self.settings.warm_steps);
            }
            self.take(&warm, BodyMethod::Warm);
            self.report.warm = self.system.factorisations;
            if self.is_enough() {
                return;
            }
        }
        let swept = self.sweep(start);
        if self.minimise(swept.as_deref()) {
            return;
        }
        self.cold(&without, swept);
    }

    /// The reactions that some sweeps find, where they are asked for and no block resists rotations: about the size of
    /// the answer.
    fn sweep(&mut self, start: Option<&[f64]>) -> Option<Vec<f64>> {
        let mut sweeps = Sweeps::new(self.problem).filter(|_| self.settings.sweeps_first)?;
        if !self.begins(BodyMethod::Sweeps) {
            return None;
        }
        let mut reactions = start.map_or_else(|| vec![0.0; self.problem.rows()], <[f64]>::to_vec);
        sweeps.run(self.problem, &mut reactions, FIRST_SWEEPS);
        let mut iterate = Iterate::default();
        iterate.take(self.problem, self.measure, &reactions);
        self.take(&iterate, BodyMethod::Sweeps);
        Some(reactions)
    }

    /// The augmented Lagrangian where there is no friction. Returns whether the answer is found.
    fn minimise(&mut self, swept: Option<&[f64]>) -> bool {
        if !AugmentedLagrangian::takes(self.problem) || !self.begins(BodyMethod::Lagrangian) {
            return false;
        }
        let mut method = AugmentedLagrangian::new(self.problem, self.elimination, self.measure);
        let mut near = self.best.clone();
        if let Some(swept) = swept {
            near.take(self.problem, self.measure, swept);
        }
        let limits = NewtonLimits { most: self.left(), patience: PATIENCE, tolerance: self.enough() };
        method.run(self.system, &mut near, limits);
        self.take(&near, BodyMethod::Lagrangian);
        self.finish_with_newton(near, NEWTON_STEPS_AFTER_LAGRANGIAN);
        self.is_enough()
    }

    /// From nothing.
    fn cold(&mut self, without: &Iterate, swept: Option<Vec<f64>>) {
        let loads = swept.unwrap_or_else(|| self.newton.holding(self.system, without).to_vec());
        let mut point = InteriorPoint::new(self.problem, self.elimination, self.measure, &loads);
        if self.begins(BodyMethod::InteriorPoint) {
            let mut near = without.clone();
            point.run(self.system, &mut near, MOST_INTERIOR_STEPS.min(self.left()));
            self.take(&near, BodyMethod::InteriorPoint);
            self.finish_with_newton(near, FIRST_NEWTON_STEPS);
        }
        if self.is_reached() {
            return;
        }
        if !self.is_enough() && self.begins(BodyMethod::Compliance) {
            self.follow_paths(self.best.clone(), FACTORISATIONS_OF_A_PATH);
        }
        if !self.is_enough() {
            self.smooth(&point, &loads);
        }
        if !self.is_enough() && self.begins(BodyMethod::FarCompliance) {
            let mut far = without.clone();
            let mut path = self.path(&loads, vec![0.0; self.problem.rows()]);
            let limits = self.path_limits(LARGEST_FIRST_COMPLIANCE, self.left());
            path.run(self.system, &mut far, limits);
            self.take(&far, BodyMethod::Compliance);
            self.follow_paths(far, FACTORISATIONS_OF_A_PATH);
        }
        if self.begins(BodyMethod::LastNewton) {
            self.finish_with_newton(self.best.clone(), LAST_NEWTON_STEPS);
        }
    }

    /// Smoothing Newton from the best answer, with weights of where the interior point has ended.
    fn smooth(&mut self, point: &InteriorPoint<'_>, loads: &[f64]) {
        // Its cones are those of contacts that resist one motion alone.
        if self.problem.blocks.iter().any(|block| ConeForm::is_inner(block.law)) {
            return;
        }
        if !self.begins(BodyMethod::Smoothing) {
            return;
        }
        let mut near = self.best.clone();
        let end = InteriorEnd { ratios: point.ratios(), weights: point.weights(), gap: point.gap() };
        let mut smoothing = Smoothing::new(self.problem, self.elimination, self.measure, loads, end, near.clone());
        let limits = SmoothingLimits { most: SMOOTHING_STEPS.min(self.left()), tolerance: self.settings.tolerance };
        smoothing.run(self.system, &mut near, limits);
        self.take(&near, BodyMethod::Smoothing);
        self.finish_with_newton(near, NEWTON_STEPS);
    }

    /// Paths of compliance, each from the answer of the last one, as long as the residual halves.
    fn follow_paths(&mut self, mut from: Iterate, most: usize) {
        while !self.is_enough() && self.left() > 0 {
            let last = from.rank;
            let mut path = self.path(&from.reactions, from.reactions.clone());
            let first = COMPLIANCE_PER_RESIDUAL * self.measure.balanced(self.problem, &from);
            let first = first.clamp(LEAST_FIRST_COMPLIANCE, LARGEST_FIRST_COMPLIANCE);
            let limits = self.path_limits(first, most);
            path.run(self.system, &mut from, limits);
            self.take(&from, BodyMethod::Compliance);
            // Written so that NaN ends it.
            let goes_on = from.rank < 0.5 * last;
            if !goes_on {
                return;
            }
        }
    }

    fn path<'b>(&self, loads: &[f64], reference: Vec<f64>) -> CompliancePath<'b>
    where
        Self: 'b,
    {
        CompliancePath::new(self.problem, self.elimination, self.measure, loads, reference)
    }

    fn path_limits(&self, first: f64, most: usize) -> PathLimits {
        PathLimits { first, most: most.min(self.left()), tolerance: self.enough() }
    }

    fn finish_with_newton(&mut self, mut from: Iterate, most: usize) {
        self.run_newton(&mut from, most);
        self.take(&from, BodyMethod::Newton);
    }

    fn run_newton(&mut self, from: &mut Iterate, most: usize) {
        let limits =
            NewtonLimits { most: most.min(self.left()), patience: PATIENCE, tolerance: self.settings.tolerance };
        self.newton.run(self.system, from, limits);
    }

    /// Notes that a stage is tried; whether it is.
    fn begins(&mut self, stage: BodyMethod) -> bool {
        let is_tried = !self.settings.left_out.contains(stage);
        if is_tried {
            self.report.tried.insert(stage);
            self.stage = stage;
        }
        is_tried
    }

    fn left(&self) -> usize {
        self.settings.factorisations.saturating_sub(self.system.factorisations)
    }

    fn is_reached(&self) -> bool {
        self.best.rank <= self.settings.tolerance
    }

    /// The residual at which no other method begins.
    fn enough(&self) -> f64 {
        self.settings.tolerance.max(WELL_WITHIN * self.settings.acceptance)
    }

    fn is_enough(&self) -> bool {
        self.best.rank <= self.enough()
    }

    fn take(&mut self, iterate: &Iterate, method: BodyMethod) {
        if iterate.rank < self.best.rank || self.best.rank.is_nan() {
            self.best.clone_from(iterate);
            self.report.method = method;
            self.report.stage = self.stage;
        }
    }

    fn finish(mut self) -> BodySolution {
        self.report.balanced_residual = self.measure.balanced(self.problem, &self.best);
        self.report.residual = self.best.residual;
        self.report.rank = self.best.rank;
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
