//! The one entry for all problems of rows: it chooses matrix, method and start.
//!
//! A caller says what must hold (rows, their laws, their constant terms) and what it asks for ([`Ask`]), and reads what
//! it took ([`Answer`]). Nobody else chooses.
//!
//! | module | holds |
//! |---|---|
//! | [`problem`] | [`Ask`], [`RowProblem`], [`Question`], [`Memory`] |
//! | [`answer`] | [`Answer`] |
//! | [`way`] | which way a problem of a size goes: all thresholds |
//! | `matrix` | the matrix of all rows, of those that are not too many |
//! | `without_friction` | rows that push and hold: the active set, beside trees of joints or with all rows |
//! | [`instant`] | blocks with friction at an instant, and at rest |
//! | `stage` | rows that hold while contacts slide as they are said to |
//! | [`impact`] | impulses of impacts, with friction or without |
//! | [`held`] | rows that hold, by the reactions of least norm |
//! | [`removal`] | what takes gaps and velocities out of rows that hold |
//! | [`step`] | blocks with friction over a time step |
//! | `text` | problems as text, made into rows and blocks |

pub mod answer;
pub mod held;
pub mod impact;
pub mod instant;
mod matrix;
pub mod problem;
pub mod removal;
mod stage;
pub mod step;
mod text;
pub mod way;
mod without_friction;

pub use answer::{Answer, Choice};
pub use problem::{Ask, Memory, Question, RowProblem, Rows};

use crate::error::{ResponseError, check_finite, check_length};
use crate::friction::Blocks;
use crate::guesses::guesses;
use crate::least_force::least_force;
use crate::settings::SolverSettings;

/// Solves for the reactions of rows: forces (N), impulses (N s), or what displaces bodies.
///
/// ```
/// use polhode_response::solve::{Ask, Memory, RowProblem, solve};
/// use polhode_response::{ContactProblem, Law};
/// // A block of 2 kg on a floor, pushed down with 20 N and along with 8 N: friction of 0.5 holds it, 0.3 does not.
/// for (friction, acceleration) in [(0.5, 0.0), (0.3, 1.0), (0.0, 4.0)] {
///     let mut rows = ContactProblem::new(2, vec![0.5, 0.0, 0.0, 0.5])?;
///     rows.push_block(Law::Cone { rows: 2, friction }, &[&[(0, &[0.0, 1.0])], &[(0, &[1.0, 0.0])]])?;
///     let found = solve(&RowProblem::new(&rows, &[-10.0, 4.0]), Ask::Instant, &mut Memory::default())?;
///     assert!((found.velocities[1] - acceleration).abs() < 1e-12);
/// }
/// # Ok::<(), polhode_response::ResponseError>(())
/// ```
///
/// A problem that is not solved is no error: see the status of the report.
///
/// # Errors
/// When a list has another length than the problem has rows, or a number is not finite.
#[cfg_attr(feature = "census", track_caller)]
pub fn solve(problem: &RowProblem<'_>, ask: Ask<'_>, memory: &mut Memory) -> Result<Answer, ResponseError> {
    let (rows, Question { blocks, constants, .. }) = (problem.rows.len(), problem.known);
    check_finite("constant terms", constants)?;
    if let Some(row) = problem.joints.end.checked_sub(1).filter(|row| *row >= rows) {
        return Err(ResponseError::UnknownRow { row, rows });
    }
    if let Some(blocks) = blocks {
        blocks.check(rows)?;
    }
    if let (Ask::Stage, Some(blocks)) = (ask, blocks) {
        return stage::solve(problem, blocks, memory);
    }
    check_length("constant terms", rows, constants.len())?;
    match (ask, blocks) {
        (Ask::Hold | Ask::HoldAll, _) => held::hold(problem, ask),
        (Ask::LeastForce | Ask::Guesses, _) => by_the_thesis(problem, ask, memory),
        (_, Some(blocks)) => {
            blocks.check_whole(rows)?;
            of_blocks(problem, blocks, ask, memory)
        }
        _ if problem.rows.has_friction() => of_blocks(problem, &Blocks::of(problem.rows), ask, memory),
        _ => of_rows(problem, ask, memory),
    }
}

/// The forces of rows that are all of contacts, by a method of the thesis.
#[cfg_attr(feature = "census", track_caller)]
fn by_the_thesis(problem: &RowProblem<'_>, ask: Ask<'_>, memory: &mut Memory) -> Result<Answer, ResponseError> {
    let (delassus, settings) = (&mut memory.delassus, SolverSettings::default());
    matrix::fill(delassus, problem.rows)?;
    Ok(match ask {
        Ask::Guesses => guesses(delassus, problem.known.constants, &settings)?.into(),
        _ => least_force(delassus, problem.known.constants, &settings)?.into(),
    })
}

/// The same of blocks.
#[cfg_attr(feature = "census", track_caller)]
fn of_blocks(
    problem: &RowProblem<'_>,
    blocks: &Blocks,
    ask: Ask<'_>,
    memory: &mut Memory,
) -> Result<Answer, ResponseError> {
    if let Some(found) = instant::solve_sparse(problem, blocks, ask)? {
        return Ok(found);
    }
    match ask {
        _ if !blocks.have_friction() => of_rows(problem, ask, memory),
        Ask::Step => step::solve(problem, blocks),
        _ => instant::solve(problem, blocks, ask),
    }
}

/// The same of rows that push and hold, without friction.
#[cfg_attr(feature = "census", track_caller)]
fn of_rows(problem: &RowProblem<'_>, ask: Ask<'_>, memory: &mut Memory) -> Result<Answer, ResponseError> {
    if let Ask::Displacement { accuracy } = ask
        && let Some(found) = without_friction::displacements(problem, accuracy)?
    {
        return Ok(found);
    }
    if !matches!(ask, Ask::Displacement { .. })
        && let Some(found) = without_friction::without_matrix(problem)?
    {
        return Ok(found);
    }
    Ok(without_friction::active_set(problem, memory)?.into())
}
