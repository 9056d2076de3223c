//! The cone problem of a group of contacts with friction in a time step, and who solves it.
//!
//! | contacts | unknowns | start |
//! |---|---|---|
//! | fewer than [`LEAST_IN_BODIES`] | the reactions: the matrix of all rows is formed (`polhode_response::friction`) | none |
//! | as many, or more | the velocities of bodies: no matrix of rows (`polhode_response::sparse`) | the forces of the last step |
//!
//! Both take the same rows, laws and constant terms. With the velocities of bodies memory and time grow with bodies and
//! contacts, where the matrix of `n` rows takes `n^2` numbers and its factors `n^3` products; for a handful of contacts
//! the matrix is smaller than what it saves. The forces of the last step are part of the state of a run
//! (`last_forces.rs`); the order in which bodies are eliminated is kept while they stay coupled, and follows from
//! them: it changes no bit.
//!
//! Where the velocities of bodies do not come to the residual asked for, and the rows are not too many for their matrix, both
//! are tried, and the better answer is taken. What is left is told.

use super::last_forces::LastForces;
use crate::rows::assembly::Assembly;
use crate::solve::cone_violation::{CONE_LIMIT, ConeViolation};
use polhode_response::friction::FrictionSettings;
use polhode_response::sparse::{BodySettings, BodySolver};
use polhode_response::{Blocks, BlocksSolution, Delassus, ResponseError, SolverStatus};
use std::collections::BTreeMap;

/// From so many contacts in a group on the velocities of bodies are solved for (30 to 100).
pub(crate) const LEAST_IN_BODIES: usize = 48;

/// Most rows whose matrix is formed where the velocities of bodies were not solved for exactly enough (200 to 600).
const MOST_ROWS_IN_PLACE: usize = 400;

/// The largest residual of a step's problem that counts as solved (no unit, 1e-9 to 1e-5). The rows of contacts that
/// depend on each other, as the four corners of a box, contradict each other by about this fraction when the body turns
/// or the gaps differ. Reactions that satisfied Coulomb's law to rounding would let a corner slip or part, by this
/// fraction of the speed that gravity gives in a step: in a step of 1e-3 s by some 1e-11 m.
const ACCEPTED_RESIDUAL: f64 = 1e-6;

/// Reactions whose violation of Coulomb's law is beyond this part of its limit are solved for to rounding (no unit, 0.01 to 1).
const SHARE_OF_CONE_LIMIT: f64 = 0.1;

/// Most sweeps of block Gauss-Seidel after all other methods of the solver have failed. The error that remains is part
/// of the error estimate of a stretch of crowded events.
const LAST_SWEEPS: u32 = 100;

/// As exactly as rounding allows where that is found soon; else as exactly as the matrix of all rows is solved for, within
/// some hundred factorisations. Most groups take one or none, and heaps of boxes that tumble some dozens: many of their contacts
/// nearly depend on each other, and some are about to slip.
const SETTINGS_IN_BODIES: BodySettings =
    BodySettings { tolerance: 1e-12, acceptance: ACCEPTED_RESIDUAL, factorisations: 300, enough: 60, warm_steps: 8 };

/// The solvers of the groups of a run, and the forces that they start from.
#[derive(Debug, Default)]
pub(super) struct ConeSolvers {
    /// By the first body of the group.
    solvers: BTreeMap<usize, BodySolver>,
    pub(super) last: LastForces,
}

impl Clone for ConeSolvers {
    /// The state without the memory of the solvers, which changes no answer.
    fn clone(&self) -> Self {
        Self { solvers: BTreeMap::new(), last: self.last.clone() }
    }
}

impl ConeSolvers {
    /// The problem of the rows of an assembly, the first of which are these contacts, in a step of `h` (s).
    pub(super) fn problem<'a>(
        &'a mut self,
        assembly: &'a Assembly,
        constants: &'a [f64],
        contacts: usize,
        h: f64,
    ) -> ConeProblem<'a> {
        let first = assembly.bodies().first().filter(|_| contacts >= LEAST_IN_BODIES);
        let system = first.map_or_else(
            || System::Rows(assembly.problem.delassus()),
            |&first| System::Bodies {
                solver: self.solvers.entry(first).or_default(),
                start: self.last.start(assembly, contacts, h),
            },
        );
        ConeProblem { assembly, constants, system, factorisations: 0 }
    }
}

/// The problem of one group.
#[derive(Debug)]
pub(super) struct ConeProblem<'a> {
    assembly: &'a Assembly,
    constants: &'a [f64],
    system: System<'a>,
    factorisations: usize,
}

/// The unknowns of a problem.
#[derive(Debug)]
enum System<'a> {
    /// Reactions; the matrix of all rows.
    Rows(Delassus),
    /// Velocities of bodies; reactions of a similar problem.
    Bodies { solver: &'a mut BodySolver, start: Option<Vec<f64>> },
}

impl ConeProblem<'_> {
    /// Solves it with these laws; `violation` is how far reactions are from Coulomb's law. A further solve starts from the answer of
    /// the one before.
    ///
    /// # Errors
    /// When a number is not finite.
    pub(super) fn solve(
        &mut self,
        blocks: &Blocks,
        violation: impl Fn(&[f64]) -> Option<ConeViolation>,
    ) -> Result<BlocksSolution, ResponseError> {
        let constants = self.constants;
        match &mut self.system {
            System::Rows(delassus) => solve_for_rows(blocks, (delassus, constants), violation),
            System::Bodies { solver, start } => {
                let problem = &self.assembly.problem;
                let (mut solved, effort) =
                    blocks.solve_in_bodies(problem, constants, start.as_deref(), (solver, &SETTINGS_IN_BODIES))?;
                self.factorisations += effort.factorisations;
                if solved.report.status != SolverStatus::Solved && problem.len() <= MOST_ROWS_IN_PLACE {
                    let other = blocks.solve(&problem.delassus(), constants, None, &exact())?;
                    if other.report.residual < solved.report.residual {
                        solved = other;
                    }
                }
                *start = Some(solved.reactions.clone());
                Ok(solved)
            }
        }
    }

    /// Factorisations in the velocities of bodies so far.
    pub(super) const fn factorisations(&self) -> usize {
        self.factorisations
    }

    /// Whether the velocities of bodies are solved for.
    pub(super) const fn is_in_bodies(&self) -> bool {
        matches!(self.system, System::Bodies { .. })
    }
}

/// Settings that ask for rounding.
fn exact() -> FrictionSettings {
    FrictionSettings { last_sweeps: LAST_SWEEPS, ..FrictionSettings::default() }
}

/// Solves for the reactions, with the matrix of all rows and their constant terms.
fn solve_for_rows(
    blocks: &Blocks,
    (delassus, constants): (&Delassus, &[f64]),
    violation: impl Fn(&[f64]) -> Option<ConeViolation>,
) -> Result<BlocksSolution, ResponseError> {
    let exact = exact();
    let settings = FrictionSettings { acceptance: ACCEPTED_RESIDUAL, ..exact };
    // A slip or a rate of turning that is much faster than contacts approach hides what is left of their reactions in the
    // residual.
    let has_rotations = blocks.laws().iter().any(|law| law.resists_rotation());
    let mut solved = blocks.solve(delassus, constants, None, if has_rotations { &exact } else { &settings })?;
    let is_off = violation(&solved.reactions).is_some_and(|found| found.value > SHARE_OF_CONE_LIMIT * CONE_LIMIT);
    if !has_rotations && is_off {
        solved = blocks.solve(delassus, constants, Some(&solved.reactions), &exact)?;
    }
    if solved.report.residual <= settings.acceptance {
        solved.report.status = SolverStatus::Solved;
    }
    Ok(solved)
}
