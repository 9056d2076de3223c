//! The chain of methods for contacts with friction, and one residual for all of them.
//!
//! Newton's method from the start given; from what would hold all contacts, after some sweeps of block Gauss-Seidel;
//! from zero; the same with steps of least norm; the convex cone programme and Newton's method; many sweeps and
//! Newton's method. What is best of all is returned, with its residual and what became of it.

#[cfg(feature = "census")]
use crate::census::{self, Answer, Chain, Size};
use crate::error::{ResponseError, check_finite, check_length};
use crate::friction::cone_programme::LiftedForm;
use crate::friction::coulomb_cone::{project, put_parts_into_discs, rows_of};
use crate::friction::gauss_seidel::GaussSeidel;
use crate::friction::newton::{Damping, Iterate, Newton, NewtonLimits, NewtonSteps};
use crate::friction::problem::FrictionProblem;
use crate::friction::settings::FallbackPolicy;
use crate::friction::settings::{FrictionSettings, Redundancy};
use crate::friction::solution::{FrictionMethod, FrictionReport, FrictionSolution};
use crate::law::Law;
#[cfg(feature = "census")]
use crate::method_set::MethodSet;
use crate::report::SolverStatus;
use crate::solve::way::LEAST_NORM_MOST_ROWS;

/// Share of the diagonal that is added for the first guess (no unit, 0.03 to 0.3).
const HOLDING_DAMPING: f64 = 0.1;

/// Share of its inverse mass by which a contact yields where the reactions of redundant contacts are chosen (no unit,
/// 1e-5 to 1e-3): the choice is that of softer contacts to this share, and rounding moves it by the rounding unit over
/// it.
const YIELDING: f64 = 1e-4;

/// Sweeps between two runs of Newton's method as the last resort.
const SWEEPS_BETWEEN: u32 = 50;

/// Solves a frictional contact problem. `start` are reactions of a similar problem, one for each row.
///
/// ```
/// use polhode_response::friction::{ContactStatus, FrictionProblem, FrictionSettings, solve_friction};
/// use polhode_response::{Law, SolverStatus};
/// // A point of 2 kg on a floor of friction 0.5: it comes down with 3 m/s and along with 4 m/s, and slides with 2.5.
/// let contact = Law::Cone { rows: 3, friction: 0.5 };
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
#[cfg_attr(feature = "census", track_caller)]
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
    let solution = answer_of(problem, start, settings);
    #[cfg(feature = "census")]
    counted(problem, start, settings, &solution);
    Ok(solution)
}

/// The answer of the chain.
fn answer_of(problem: &FrictionProblem, start: Option<&[f64]>, settings: &FrictionSettings) -> FrictionSolution {
    let mut solver = Solver {
        problem,
        settings,
        newton: Newton::new(problem),
        gauss_seidel: GaussSeidel::new(problem),
        best: Iterate::default(),
        squeeze: Vec::new(),
        report: FrictionReport::default(),
    };
    solver.run(start);
    solver.finish()
}

/// Tells the census of a solve, and of what the next methods would have found.
#[cfg(feature = "census")]
#[track_caller]
fn counted(problem: &FrictionProblem, start: Option<&[f64]>, settings: &FrictionSettings, solution: &FrictionSolution) {
    let answer = |solution: &FrictionSolution| {
        let report = &solution.report;
        let is_zero = report.method == FrictionMethod::GaussSeidel && !report.tried.contains(report.method);
        Answer {
            method: if is_zero { "none needed" } else { report.method.name() },
            tried: report.tried.iter().map(FrictionMethod::name).collect(),
            status: report.status,
            residual: report.residual,
            cost: report.iterations(),
            motion: solution.velocities.clone(),
        }
    };
    let again = |without: &[&str]| {
        let left_out = MethodSet::of_names(without);
        let other = answer_of(problem, start, &FrictionSettings { left_out, ..*settings });
        // Nothing but zero is left, or no method at all.
        other.report.tried.contains(other.report.method).then(|| answer(&other))
    };
    let size = Size {
        bodies: 0,
        rows: problem.rows(),
        cones: problem.blocks().iter().filter(|law| law.has_friction()).count(),
    };
    census::note(Chain::Friction, size, &answer(solution), settings.tolerance, again, || problem.text(start));
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
        if let Some(start) = start
            && self.warm_newton(start)
        {
            return;
        }
        if self.cold_newton() || self.is_accepted() {
            return;
        }
        let began_at_zero = start.is_some_and(|start| start.iter().all(|reaction| *reaction == 0.0));
        if !began_at_zero && self.newton_from(vec![0.0; self.problem.rows()], FrictionMethod::NewtonFromZero) {
            return;
        }
        if self.problem.rows() <= LEAST_NORM_MOST_ROWS
            && !self.is_accepted()
            && self.newton_from(vec![0.0; self.problem.rows()], FrictionMethod::LeastNormFromZero)
        {
            return;
        }
        // What is accepted already is not worth the slower methods.
        if self.settings.fallback == FallbackPolicy::Refuse || self.is_accepted() {
            return;
        }
        let zero = vec![0.0; self.problem.rows()];
        if self.newton_from(zero, FrictionMethod::YieldingNewton) || self.cone_programme() {
            return;
        }
        if !self.begins(FrictionMethod::GaussSeidelNewton) {
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

    /// Newton's method from reactions of a similar problem, or from zero. Nothing here depends on the order of the
    /// contacts: where they are redundant, alike ones share a load alike. Whether the tolerance is reached, or what is
    /// accepted.
    fn warm_newton(&mut self, start: &[f64]) -> bool {
        self.begins(FrictionMethod::WarmNewton);
        let iterate = self.iterate(start.to_vec());
        if self.keep(iterate, FrictionMethod::WarmNewton) || (self.problem.len() == 1 && self.one_sweep()) {
            return true;
        }
        let mut reactions = start.to_vec();
        self.move_into_cones(&mut reactions);
        let is_chosen = self.settings.redundancy == Redundancy::LeastNorm && start.len() <= LEAST_NORM_MOST_ROWS;
        if is_chosen
            && (self.proximal_newton(&reactions)
                || self.newton_from(reactions.clone(), FrictionMethod::LeastNormNewton))
        {
            return true;
        }
        self.newton_from(reactions, FrictionMethod::WarmNewton) || self.is_accepted()
    }

    /// The proximal point method from zero: contacts yield a little to what their reactions exceed those of the round
    /// before, and Newton's method, which begins at `start`, solves each round. Reactions of contacts that yield are
    /// unique, whereas those of rigid contacts of one flat patch are a curve along which slips, and with them the
    /// motion, differ: which point of it another method comes upon depends on its path, on ties that rounding decides,
    /// and on the start. Each further round leaves some [`YIELDING`] of the residual, and moves no reaction along the
    /// curve. Source: Rockafellar 1976. Whether the tolerance is reached.
    fn proximal_newton(&mut self, start: &[f64]) -> bool {
        if !self.begins(FrictionMethod::ProximalNewton) {
            return false;
        }
        let mut around = vec![0.0; start.len()];
        let mut reactions = start.to_vec();
        let mut before = f64::INFINITY;
        loop {
            let problem = self.problem.yielding(YIELDING, &around);
            let mut velocities = Vec::new();
            problem.matrix().times_plus(&reactions, problem.constant(), &mut velocities);
            let residual = problem.residual_of(&reactions, &velocities);
            let mut round = Iterate { reactions, velocities, residual };
            // To rounding: the rest of a residual moves reactions along the curve by as much as the contacts are stiff.
            let limits = NewtonLimits { tolerance: 0.0, ..self.limits(FrictionMethod::LeastNormNewton) };
            self.report.newton_steps += Newton::new(&problem).run(&mut round, limits);
            let iterate = self.iterate(round.reactions.clone());
            let is_nearer = iterate.residual <= 0.5 * before;
            before = iterate.residual;
            if self.keep(iterate, FrictionMethod::ProximalNewton) {
                return true;
            }
            if round.residual > limits.acceptance || !is_nearer {
                return false;
            }
            around.clone_from(&round.reactions);
            reactions = round.reactions;
        }
    }

    /// One sweep from zero: it solves a contact on its own, and those that do not move each other.
    fn one_sweep(&mut self) -> bool {
        if !self.begins(FrictionMethod::GaussSeidel) {
            return false;
        }
        let mut reactions = vec![0.0; self.problem.rows()];
        self.sweep(&mut reactions, 1);
        let iterate = self.iterate(reactions);
        self.keep(iterate, FrictionMethod::GaussSeidel)
    }

    /// Newton's method from what some sweeps say. They begin with the reactions that would hold all contacts, within
    /// their cones: these tell which of them bear a load, far from where bodies touch what is fixed, too, and the
    /// sweeps sort out what slides or parts. Whether the tolerance is reached.
    fn cold_newton(&mut self) -> bool {
        if self.one_sweep() {
            return true;
        }
        let mut reactions = self.newton.holding(HOLDING_DAMPING).to_vec();
        self.report.newton_steps += 1;
        self.move_into_cones(&mut reactions);
        self.sweep(&mut reactions, self.settings.sweeps);
        let iterate = self.iterate(reactions.clone());
        self.keep(iterate, FrictionMethod::GaussSeidel) || self.newton_from(reactions, FrictionMethod::Newton)
    }

    /// The convex programme with the correction of its last answer, and Newton's method from each. Whether the
    /// tolerance is reached, or it is proven that there is no solution.
    fn cone_programme(&mut self) -> bool {
        if !self.begins(FrictionMethod::ConeProgrammeNewton) {
            return false;
        }
        let Some(lifted) = LiftedForm::of(self.problem) else { return false };
        if !self.is_accepted()
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
        if !self.begins(method) {
            return false;
        }
        let mut iterate = self.iterate(reactions);
        let limits = self.limits(method);
        self.report.newton_steps += self.newton.run(&mut iterate, limits);
        self.keep(iterate, method)
    }

    /// Notes that a method is tried; whether it is.
    fn begins(&mut self, method: FrictionMethod) -> bool {
        let is_tried = !self.settings.left_out.contains(method);
        if is_tried {
            self.report.tried.insert(method);
        }
        is_tried
    }

    fn is_accepted(&self) -> bool {
        self.best.residual <= self.settings.acceptance
    }

    fn limits(&self, method: FrictionMethod) -> NewtonLimits {
        let FrictionSettings { tolerance, acceptance, newton_steps, .. } = *self.settings;
        let damping = match method {
            FrictionMethod::Newton | FrictionMethod::NewtonFromZero => Damping::SETTLING,
            _ if method.is_fallback() => Damping::YIELDING,
            _ => Damping::STEADY,
        };
        let steps = match method {
            FrictionMethod::LeastNormNewton | FrictionMethod::LeastNormFromZero => NewtonSteps::LeastNorm,
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
        let is_better = iterate.residual < self.best.residual || self.best.residual.is_nan();
        if is_better && !self.settings.left_out.contains(method) {
            self.best = iterate;
            self.report.method = method;
        }
        self.limits(method).are_reached(self.problem, &self.best)
    }

    /// Moves each reaction into its cone.
    fn move_into_cones(&self, reactions: &mut [f64]) {
        for (block, kind) in self.problem.blocks().iter().enumerate() {
            let range = self.problem.range(block);
            let own = &mut reactions[range];
            let first = rows_of(own);
            let within = match *kind {
                Law::Push => project(0.0, first),
                Law::Cone { friction, .. } => project(friction, first),
                Law::Slide { friction } => [first[0].max(0.0), -friction * first[0].max(0.0), 0.0],
                Law::Hold { .. } => first,
                Law::Resist { .. } => {
                    put_parts_into_discs(*kind, own);
                    continue;
                }
            };
            let size = own.len();
            own.copy_from_slice(&within[..size]);
        }
    }

    fn finish(mut self) -> FrictionSolution {
        self.newton.linearise(&self.best.reactions, &self.best.velocities);
        self.report.residual = self.best.residual;
        self.report.rounding = self.problem.rounding_of(&self.best.reactions);
        let is_solved = self.is_accepted() || self.best.residual <= self.report.rounding;
        self.report.status = match (is_solved, self.squeeze.is_empty()) {
            (true, _) => SolverStatus::Solved,
            (false, true) => SolverStatus::Inaccurate,
            (false, false) => SolverStatus::Infeasible,
        };
        FrictionSolution {
            statuses: self.newton.statuses(),
            parts: self.newton.parts(),
            reactions: self.best.reactions,
            velocities: self.best.velocities,
            squeeze: self.squeeze,
            report: self.report,
        }
    }
}
