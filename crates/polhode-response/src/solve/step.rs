//! Blocks with friction over a time step: which unknowns they are solved for.
//!
//! | contacts | unknowns | start |
//! |---|---|---|
//! | without friction, few | the reactions: the active set | the rows that bore something in the last step |
//! | few | the reactions: the matrix of all rows is formed ([`friction`](crate::friction)) | none |
//! | few, beside trees of joints | the reactions beside the trees: the matrix of those rows | those of the last step |
//! | many | the velocities of bodies: no matrix of rows ([`sparse`](crate::sparse)) | those of the last step |
//!
//! All take the same rows, laws and constant terms. The order in which bodies are eliminated is kept while they stay
//! coupled, and follows from them: it changes no bit.
//!
//! Where one does not come to the residual asked for, the other is tried, unless the rows are too many for their
//! matrix, and the better answer is taken. What is left is told.

use super::answer::Answer;
use super::matrix;
use super::problem::{Memory, RowProblem};
use super::way::{self, STEP_MOST_ROWS};
use super::without_friction::active_set;
use crate::complementarity::ContactSolution;
use crate::delassus::Delassus;
use crate::error::ResponseError;
use crate::friction::{Blocks, BlocksSolution, FrictionSettings};
use crate::method_set::MethodSet;
use crate::problem::ContactProblem;
use crate::report::SolverStatus;
use crate::sparse::{BodySettings, BodySolver, HeldForest};
pub use crate::tolerances::EXACT_ENOUGH;
use std::collections::BTreeMap;

/// Most sweeps of block Gauss-Seidel after all other methods of the solver have failed. The error that remains is part
/// of the error estimate of a stretch of crowded events.
const LAST_SWEEPS: u32 = 100;

/// As exactly as rounding allows where that is found soon, else as exactly as is accepted.
const SETTINGS_IN_BODIES: BodySettings = BodySettings {
    tolerance: 1e-12,
    acceptance: EXACT_ENOUGH,
    factorisations: 150,
    warm_steps: 8,
    sweeps_first: false,
    left_out: MethodSet::NONE,
};

/// What the steps of a run keep: the solvers of their groups.
#[derive(Debug, Default)]
pub struct StepMemory {
    /// By the first body of the group.
    solvers: BTreeMap<usize, BodySolver>,
    /// Whether they are of heaps, whose problems begin with sweeps.
    are_of_heaps: bool,
    /// Of rows without friction.
    of_pushes: Memory,
}

impl Clone for StepMemory {
    /// Without the memory of the solvers, which changes no answer.
    fn clone(&self) -> Self {
        Self { are_of_heaps: self.are_of_heaps, ..Self::default() }
    }
}

/// The rows of a group of contacts and joints over a step.
#[derive(Debug, Clone)]
pub struct StepRows<'a> {
    /// Rows and rates without impulses, m/s; it starts from the contacts that bore an impulse in the last step.
    pub problem: RowProblem<'a>,
    /// Number of contacts.
    pub contacts: usize,
    /// The number, in the scene, of the first body: groups are told apart by it from step to step.
    pub group: Option<usize>,
}

impl StepMemory {
    /// Steps of heaps, whose problems begin with sweeps.
    pub fn of_heaps() -> Self {
        Self { are_of_heaps: true, ..Self::default() }
    }

    /// Forgets what it keeps.
    pub fn forget(&mut self) {
        self.solvers.clear();
    }

    /// The problem of some rows; `start` gives reactions of a similar problem, one for each row, where they are used.
    ///
    /// # Errors
    /// When rows that need their matrix are too many for it.
    pub fn problem<'a>(
        &'a mut self,
        of: StepRows<'a>,
        start: impl FnOnce() -> Option<Vec<f64>>,
    ) -> Result<StepProblem<'a>, ResponseError> {
        let StepRows { problem, contacts, group } = of;
        let (rows, constants) = (problem.rows, problem.known.constants);
        let in_bodies = way::is_in_bodies(rows, contacts) || (way::have_no_matrix(rows.len()) && way::is_plain(rows));
        let system = if let Some(first) = group.filter(|_| in_bodies) {
            System::Bodies { solver: self.solvers.entry(first).or_default(), start: start() }
        } else if rows.len() == contacts + problem.joints.len() {
            System::Pushes { problem, memory: &mut self.of_pushes }
        } else if let Some(forest) = way::trees(rows, problem.joints) {
            let of_others = |start: Vec<f64>| forest.others().iter().map(|&row| start[row]).collect();
            let start = start().map(of_others);
            System::Beside { delassus: forest.beside(rows).delassus, forest, start }
        } else {
            System::Rows(matrix::of(rows)?)
        };
        let settings = BodySettings { sweeps_first: self.are_of_heaps, ..SETTINGS_IN_BODIES };
        Ok(StepProblem { rows, constants, system, settings, factorisations: 0 })
    }
}

/// The problem of one group.
#[derive(Debug)]
pub struct StepProblem<'a> {
    rows: &'a ContactProblem,
    constants: &'a [f64],
    system: System<'a>,
    settings: BodySettings,
    factorisations: usize,
}

/// The unknowns of a problem.
#[derive(Debug)]
enum System<'a> {
    /// Reactions of rows without friction.
    Pushes { problem: RowProblem<'a>, memory: &'a mut Memory },
    /// Reactions; the matrix of all rows.
    Rows(Delassus),
    /// Reactions of the rows beside trees of joints; their matrix, and those of a similar problem.
    Beside { forest: HeldForest, delassus: Delassus, start: Option<Vec<f64>> },
    /// Velocities of bodies; reactions of a similar problem.
    Bodies { solver: &'a mut BodySolver, start: Option<Vec<f64>> },
}

/// The answer of the active set in the words of blocks, of which none has friction.
fn of_pushes(solved: ContactSolution) -> BlocksSolution {
    let ContactSolution { forces: reactions, residual_accelerations: velocities, report, .. } = solved;
    BlocksSolution { reactions, velocities, statuses: Vec::new(), parts: Vec::new(), report }
}

impl StepProblem<'_> {
    /// Solves it with these laws; `is_off` says whether reactions are too far from Coulomb's law to be taken, whatever
    /// the residual. A further solve starts from the answer of the one before.
    ///
    /// # Errors
    /// When a number is not finite.
    #[cfg_attr(feature = "census", track_caller)]
    pub fn solve(&mut self, blocks: &Blocks, is_off: impl Fn(&[f64]) -> bool) -> Result<BlocksSolution, ResponseError> {
        let constants = self.constants;
        match &mut self.system {
            System::Pushes { problem, memory } => Ok(of_pushes(active_set(problem, memory)?)),
            System::Rows(delassus) => {
                let mut best = solve_for_rows(blocks, (delassus, constants), None, is_off)?;
                let problem = self.rows;
                if best.report.residual > EXACT_ENOUGH && way::is_plain(problem) {
                    let system = (&mut BodySolver::default(), &self.settings);
                    let (other, effort) = blocks.solve_in_bodies(problem, constants, Some(&best.reactions), system)?;
                    self.factorisations += effort.factorisations;
                    take_better(&mut best, other);
                }
                if best.report.residual > EXACT_ENOUGH {
                    let other = blocks.solve(delassus, constants, Some(&best.reactions), &exact())?;
                    take_better(&mut best, other);
                }
                Ok(best)
            }
            System::Beside { forest, delassus, start } => {
                let problem = self.rows;
                let of_others = forest.constants_beside(problem, constants)?;
                let own = blocks.beside(forest);
                let in_rows = |of_others: &[f64]| {
                    let mut reactions = vec![0.0; problem.len()];
                    for (&row, &reaction) in forest.others().iter().zip(of_others) {
                        reactions[row] = reaction;
                    }
                    is_off(&reactions)
                };
                let mut best = solve_for_rows(&own, (delassus, &of_others), start.as_deref(), in_rows)?;
                if best.report.residual > EXACT_ENOUGH {
                    let other = own.solve(delassus, &of_others, Some(&best.reactions), &exact())?;
                    take_better(&mut best, other);
                }
                *start = Some(best.reactions.clone());
                blocks.with_forest((problem, forest), constants, &best)
            }
            System::Bodies { solver, start } => {
                let problem = self.rows;
                let (mut solved, effort) =
                    blocks.solve_in_bodies(problem, constants, start.as_deref(), (solver, &self.settings))?;
                self.factorisations += effort.factorisations;
                if solved.report.status != SolverStatus::Solved && problem.len() <= STEP_MOST_ROWS {
                    take_better(&mut solved, blocks.solve(&matrix::of(problem)?, constants, None, &exact())?);
                }
                *start = Some(solved.reactions.clone());
                Ok(solved)
            }
        }
    }

    /// Factorisations in the velocities of bodies so far.
    pub const fn factorisations(&self) -> usize {
        self.factorisations
    }

    /// Whether the next step starts from its answer.
    pub const fn is_started_from(&self) -> bool {
        matches!(self.system, System::Bodies { .. } | System::Beside { .. })
    }
}

/// Impulses of blocks with friction, of a step that knows of no other one.
///
/// # Errors
/// When a number is not finite.
#[cfg_attr(feature = "census", track_caller)]
pub(super) fn solve(problem: &RowProblem<'_>, blocks: &Blocks) -> Result<Answer, ResponseError> {
    let rows = StepRows { problem: problem.clone(), contacts: blocks.contacts(), group: Some(0) };
    Ok(StepMemory::default().problem(rows, || None)?.solve(blocks, |_| false)?.into())
}

/// Takes the other answer if its residual is smaller.
fn take_better(best: &mut BlocksSolution, other: BlocksSolution) {
    if other.report.residual < best.report.residual {
        *best = other;
    }
    let is_solved = best.report.residual <= EXACT_ENOUGH;
    best.report.status = if is_solved { SolverStatus::Solved } else { SolverStatus::Inaccurate };
}

/// Settings that ask for rounding.
fn exact() -> FrictionSettings {
    FrictionSettings { last_sweeps: LAST_SWEEPS, ..FrictionSettings::default() }
}

/// Solves for the reactions, with the matrix of all rows and their constant terms, from those of a similar problem.
#[cfg_attr(feature = "census", track_caller)]
fn solve_for_rows(
    blocks: &Blocks,
    (delassus, constants): (&Delassus, &[f64]),
    start: Option<&[f64]>,
    is_off: impl Fn(&[f64]) -> bool,
) -> Result<BlocksSolution, ResponseError> {
    let exact = exact();
    let settings = FrictionSettings { acceptance: EXACT_ENOUGH, ..exact };
    // A slip or a rate of turning that is much faster than contacts approach hides what is left of their reactions in
    // the residual.
    let has_rotations = blocks.laws().iter().any(|law| law.resists_rotation());
    let mut solved = blocks.solve(delassus, constants, start, if has_rotations { &exact } else { &settings })?;
    if !has_rotations && is_off(&solved.reactions) {
        solved = blocks.solve(delassus, constants, Some(&solved.reactions), &exact)?;
    }
    if solved.report.residual <= settings.acceptance {
        solved.report.status = SolverStatus::Solved;
    }
    Ok(solved)
}
