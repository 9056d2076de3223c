//! Rows that push and rows that hold.

use super::answer::Answer;
use super::matrix;
use super::problem::{Memory, Question, RowProblem};
use super::way::{self, DISPLACEMENT_IN_BODIES};
use crate::complementarity::ContactSolution;
use crate::error::ResponseError;
use crate::friction::Blocks;
use crate::law::Law;
use crate::report::SolverStatus;
use crate::settings::SolverSettings;
use crate::sparse::{BodySettings, BodySolver, are_movable};

/// By the active set: beside the trees of joints, or with the matrix of all rows.
#[cfg_attr(feature = "census", track_caller)]
pub(super) fn active_set(problem: &RowProblem<'_>, memory: &mut Memory) -> Result<ContactSolution, ResponseError> {
    let RowProblem { rows, joints, known: Question { constants, start, noise_floor, .. } } = problem;
    let Memory { active_set, delassus, .. } = memory;
    active_set.set_settings(SolverSettings { noise_floor: *noise_floor, ..SolverSettings::default() });
    let found = if let Some(forest) = way::trees(rows, joints.clone()) {
        active_set.solve_with_forest(rows, &forest, constants, *start)
    } else {
        matrix::fill(delassus, rows)?;
        active_set.solve(rows, delassus, constants, *start).cloned()
    };
    // The next problem has a noise of its own.
    active_set.set_settings(SolverSettings::default());
    found
}

/// What rows take that are too many for a matrix, in the velocities of bodies. None for others, and beside trees of
/// joints.
#[cfg_attr(feature = "census", track_caller)]
pub(super) fn without_matrix(problem: &RowProblem<'_>) -> Result<Option<Answer>, ResponseError> {
    let RowProblem { rows, joints, known: Question { constants, .. } } = problem;
    if !(way::have_no_matrix(rows.len()) && way::is_plain(rows)) || way::trees(rows, joints.clone()).is_some() {
        return Ok(None);
    }
    let system = (&mut BodySolver::default(), &BodySettings::default());
    let (solved, _) = Blocks::of(rows).solve_in_bodies(rows, constants, None, system)?;
    Ok(Some(Answer::from(solved)))
}

/// What removes many overlaps, found in the displacements of bodies: without a matrix of their rows, which grows with
/// the square of their number. None for few, or where it is not found.
#[cfg_attr(feature = "census", track_caller)]
pub(super) fn displacements(problem: &RowProblem<'_>, accuracy: f64) -> Result<Option<Answer>, ResponseError> {
    let (rows, joints) = (problem.rows, &problem.joints);
    let contacts = rows.len() - joints.len();
    if contacts < DISPLACEMENT_IN_BODIES || !rows.is_of_pairs() || !are_movable(rows) {
        return Ok(None);
    }
    let mut blocks = Blocks::default();
    for row in 0..contacts {
        blocks.push(Law::Push, [row]);
    }
    blocks.hold(contacts..rows.len());
    let settings =
        BodySettings { tolerance: accuracy, acceptance: accuracy, sweeps_first: true, ..BodySettings::default() };
    let system = (&mut BodySolver::default(), &settings);
    let (solved, _) = blocks.solve_in_bodies(rows, problem.known.constants, None, system)?;
    // Of too many rows the nearest displacements that were found are told as they are.
    let is_last = way::have_no_matrix(rows.len());
    Ok((is_last || solved.report.status == SolverStatus::Solved).then(|| Answer::from(solved)))
}
