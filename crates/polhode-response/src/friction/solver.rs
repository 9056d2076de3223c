//! The chain of methods for contacts with friction, and one residual for all of them.
//!
//! Newton's method from the start given; some sweeps of block Gauss-Seidel and Newton's method; the same with steps of least
//! norm; the convex cone programme and
//! Newton's method; many sweeps and Newton's method. What is best of all is returned, with its residual and what became of it.

use crate::error::{ResponseError, check_finite, check_length};
use crate::friction::block::FrictionBlock;
use crate::friction::cone_programme::LiftedForm;
use crate::friction::coulomb_cone::{project, rows_of};
use crate::friction::elimination_order::EliminationOrder;
use crate::friction::gauss_seidel::GaussSeidel;
use crate::friction::newton::{Damping, Iterate, Newton, NewtonLimits, NewtonSteps};
use crate::friction::problem::FrictionProblem;
use crate::friction::settings::{FrictionSettings, Redundancy};
use crate::friction::solution::{FrictionMethod, FrictionReport, FrictionSolution};
use crate::report::SolverStatus;
use crate::settings::FallbackPolicy;

/// Sweeps after which it shows whether more of them lead anywhere.
const FEW_SWEEPS: u32 = 4;

/// The residual that is promising by then, and the one from which Newton's method needs a step or two (no unit).
const PROMISING: f64 = 1e-2;
const NEARLY_SOLVED: f64 = 1e-4;

/// Most rows for Newton's method with steps of least norm, whose factorisation is dense.
const MOST_DENSE_ROWS: usize = 120;

/// Sweeps between two runs of Newton's method as the last resort.
const SWEEPS_BETWEEN: u32 = 50;

/// Solves a frictional contact problem. `start` are reactions of a similar problem, one for each row.
///
/// ```
/// use polhode_response::SolverStatus;
/// use polhode_response::friction::{ContactStatus, FrictionBlock, FrictionProblem, FrictionSettings, solve_friction};
/// // A point of 2 kg on a floor of friction 0.5 that comes down with 3 m/s and along with 4 m/s slides on with 2.5 m/s.
/// let contact = FrictionBlock::Contact { rows: 3, friction: 0.5 };
/// let matrix = [0.5, 0.0, 0.0, 0.0, 0.5, 0.0, 0.0, 0.0, 0.5];
/// let problem = FrictionProblem::from_dense(vec![contact], &matrix, vec![-3.0, 4.0, 0.0])?;
/// let solution = solve_friction(&problem, None, &FrictionSettings::default())?;
/// assert_eq!(solution.report.status, SolverStatus::Solved);
/// assert_eq!(solution.reactions, [6.0, -3.0, 0.0]);
/// assert_eq!(solution.velocities, [0.0, 2.5, 0.0]);
/// assert_eq!(solution.statuses, [ContactStatus::Slide]);
/// # Ok::<(), polhode_response::ResponseError>(())
/// ```
///
/// A problem that is not solved is no error: see the status of the report.
///
/// # Errors
/// When the start has another length or a number that is not finite, or a setting is out of range.
pub fn solve_friction(
    problem: &FrictionProblem,
    start: Option<&[f64]>,
    settings: &FrictionSettings,
) -> Result<FrictionSolution, ResponseError> {
    settings.check()?;
    if let Some(start) = start {
        check_length("start", problem.rows(), start.len())?;
        check_finite("start", start)?;
    }
    let order = EliminationOrder::of(problem.matrix());
    let mut solver = Solver {
        problem,
        settings,
        newton: Newton::new(problem, &order),
        gauss_seidel: GaussSeidel::new(problem),
        best: Iterate::default(),
        squeeze: Vec::new(),
        report: FrictionReport::default(),
    };
    solver.run(start);
    Ok(solver.finish())
}

/// The methods with the best answer so far.
#[derive(Debug)]
struct Solver<'a> {
    problem: &'a FrictionProblem,
    settings: &'a FrictionSettings,
    newton: Newton<'a>,
    gauss_seidel: GaussSeidel,
    best: Iterate,
    squeeze: Vec<f64>,
    report: FrictionReport,
}

impl Solver<'_> {
    fn run(&mut self, start: Option<&[f64]>) {
        self.best = self.iterate(vec![0.0; self.problem.rows()]);
        if let Some(start) = start {
            let iterate = self.iterate(start.to_vec());
            if self.keep(iterate, FrictionMethod::WarmNewton) {
                return;
            }
            let reactions = self.within_cones(start);
            let is_chosen = self.settings.redundancy == Redundancy::LeastNorm && start.len() <= MOST_DENSE_ROWS;
            if is_chosen && self.newton_from(reactions.clone(), FrictionMethod::LeastNormNewton) {
                return;
            }
            if self.newton_from(reactions, FrictionMethod::WarmNewton) || self.best.residual <= self.settings.acceptance
            {
                return;
            }
        }
        let zero = vec![0.0; self.problem.rows()];
        let began_at_zero = start.is_some_and(|start| start == zero);
        if self.first_sweeps(zero.clone()) || (!began_at_zero && self.newton_from(zero, FrictionMethod::Newton)) {
            return;
        }
        if self.problem.rows() <= MOST_DENSE_ROWS
            && self.best.residual > self.settings.acceptance
            && self.newton_from(vec![0.0; self.problem.rows()], FrictionMethod::LeastNormNewton)
        {
            return;
        }
        // What is accepted already is not worth the slower methods.
        if self.settings.fallback == FallbackPolicy::Refuse || self.best.residual <= self.settings.acceptance {
            return;
        }
        let zero = vec![0.0; self.problem.rows()];
        if self.newton_from(zero, FrictionMethod::YieldingNewton) || self.cone_programme() {
            return;
        }
        let mut reactions = self.best.reactions.clone();
        for _ in 0..self.settings.last_sweeps / SWEEPS_BETWEEN {
            self.sweep(&mut reactions, SWEEPS_BETWEEN);
            let iterate = self.iterate(reactions.clone());
            if self.keep(iterate, FrictionMethod::GaussSeidel)
                || self.newton_from(reactions.clone(), FrictionMethod::GaussSeidelNewton)
            {
                return;
            }
        }
    }

    /// Some sweeps; where they go well Newton's method ends what they began. Whether the tolerance is reached.
    fn first_sweeps(&mut self, mut reactions: Vec<f64>) -> bool {
        let mut done = 0;
        for (sweeps, enough) in [(1, f64::INFINITY), (FEW_SWEEPS, PROMISING), (self.settings.sweeps, NEARLY_SOLVED)] {
            self.sweep(&mut reactions, sweeps.saturating_sub(done));
            done = done.max(sweeps);
            let iterate = self.iterate(reactions.clone());
            let residual = iterate.residual;
            if self.keep(iterate, FrictionMethod::GaussSeidel) {
                return true;
            }
            if residual > enough {
                return false;
            }
        }
        self.newton_from(reactions, FrictionMethod::Newton)
    }

    /// The convex programme with the correction of its last answer, and Newton's method from each. Whether the tolerance is
    /// reached, or it is proven that there is no solution.
    fn cone_programme(&mut self) -> bool {
        let Some(lifted) = LiftedForm::of(self.problem) else { return false };
        if self.best.residual > self.settings.acceptance
            && let Some(squeeze) = lifted.squeeze()
        {
            self.squeeze = squeeze;
            return true;
        }
        let mut velocities = vec![0.0; self.problem.rows()];
        for _ in 0..self.settings.corrections {
            let Some((reactions, iterations)) = lifted.reactions(&velocities) else { return false };
            self.report.cone_iterations += iterations;
            self.problem.matrix().times_plus(&reactions, self.problem.constant(), &mut velocities);
            if self.newton_from(reactions, FrictionMethod::ConeProgrammeNewton) {
                return true;
            }
        }
        false
    }

    fn sweep(&mut self, reactions: &mut [f64], count: u32) {
        for _ in 0..count {
            self.gauss_seidel.sweep(self.problem, reactions);
            self.report.sweeps += 1;
        }
    }

    /// Newton's method; whether the tolerance is reached.
    fn newton_from(&mut self, reactions: Vec<f64>, method: FrictionMethod) -> bool {
        let mut iterate = self.iterate(reactions);
        let limits = self.limits(method);
        self.report.newton_steps += self.newton.run(&mut iterate, limits);
        self.keep(iterate, method)
    }

    fn limits(&self, method: FrictionMethod) -> NewtonLimits {
        let FrictionSettings { tolerance, acceptance, newton_steps, .. } = *self.settings;
        let damping = if method.is_fallback() { Damping::YIELDING } else { Damping::STEADY };
        let steps = match method {
            FrictionMethod::LeastNormNewton => NewtonSteps::LeastNorm,
            _ => NewtonSteps::Damped(damping),
        };
        NewtonLimits { most: newton_steps as usize, tolerance, acceptance, steps }
    }

    fn iterate(&self, reactions: Vec<f64>) -> Iterate {
        let mut velocities = Vec::new();
        self.problem.matrix().times_plus(&reactions, self.problem.constant(), &mut velocities);
        let residual = self.problem.residual_of(&reactions, &velocities);
        Iterate { reactions, velocities, residual }
    }

    /// Keeps an answer if it is the best; whether the tolerance is reached.
    fn keep(&mut self, iterate: Iterate, method: FrictionMethod) -> bool {
        if iterate.residual < self.best.residual || self.best.residual.is_nan() {
            self.best = iterate;
            self.report.method = method;
        }
        self.limits(method).are_reached(self.problem, &self.best)
    }

    /// Each reaction moved into its cone.
    fn within_cones(&self, start: &[f64]) -> Vec<f64> {
        let mut reactions = start.to_vec();
        for (block, kind) in self.problem.blocks().iter().enumerate() {
            let range = self.problem.range(block);
            let own = rows_of(&reactions[range.clone()]);
            let within = match *kind {
                FrictionBlock::Contact { friction, .. } => project(friction, own),
                FrictionBlock::Sliding { friction } => [own[0].max(0.0), -friction * own[0].max(0.0), 0.0],
                FrictionBlock::Bilateral { .. } => own,
            };
            let size = range.len();
            reactions[range].copy_from_slice(&within[..size]);
        }
        reactions
    }

    fn finish(mut self) -> FrictionSolution {
        self.newton.linearise(&self.best.reactions, &self.best.velocities);
        self.report.residual = self.best.residual;
        let rounding = self.problem.rounding_of(&self.best.reactions);
        let is_solved = self.best.residual <= self.settings.acceptance.max(rounding);
        self.report.status = match (is_solved, self.squeeze.is_empty()) {
            (true, _) => SolverStatus::Solved,
            (false, true) => SolverStatus::Inaccurate,
            (false, false) => SolverStatus::Infeasible,
        };
        FrictionSolution {
            statuses: self.newton.statuses(),
            reactions: self.best.reactions,
            velocities: self.best.velocities,
            squeeze: self.squeeze,
            report: self.report,
        }
    }
}
