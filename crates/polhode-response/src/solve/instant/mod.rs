//! Contacts with friction at an instant, or of bodies at rest: which hold, stick and slide.
//!
//! | module | holds |
//! |---|---|
//! | `contacts` | blocks as contacts that stick or slide, and whether forces obey Coulomb's law |
//! | `sticking` | forces of contacts of which none slides yet |
//! | `sliding` | the least forces with which all hold while some slide |
//! | `rest` | many contacts of bodies at rest |
//! | `terms` | the problem that they share, and what of an acceleration is rounding |

mod contacts;
mod rest;
mod sliding;
mod sticking;
mod terms;

pub use terms::{SLIDING_ROUNDING, STICKING_ACCELERATION};

use self::terms::{At, Terms, rounding_of};
use super::answer::{Answer, Choice};
use super::problem::{Ask, RowProblem};
use super::{matrix, way};
use crate::error::ResponseError;
use crate::friction::{Blocks, BlocksSolution, FrictionSettings};
use crate::report::{SolverReport, SolverStatus};

/// The residual that counts as solved where something slides (no unit, 1e-12 to 1e-9): errors of steps are larger.
/// Where nothing slides the answer may put bodies to rest for good, and is asked for to rounding.
const ACCEPTED_SLIDING: f64 = 1e-10;

/// Forces that are found without a matrix of rows, where no other ones are asked for: a certificate of rest, and
/// present forces of many contacts. None for what is left to the methods for few.
///
/// # Errors
/// When a number is not finite.
pub(super) fn solve_sparse(
    problem: &RowProblem<'_>,
    blocks: &Blocks,
    ask: Ask<'_>,
) -> Result<Option<Answer>, ResponseError> {
    let terms = Terms { rows: problem.rows, blocks, constants: problem.known.constants };
    if let Ask::Balance { free } = ask {
        let report = SolverReport { status: SolverStatus::Inaccurate, ..SolverReport::default() };
        let unknown = || Answer { report, ..Answer::default() };
        return Ok(Some(rest::standing(terms, free)?.map_or_else(unknown, Answer::from)));
    }
    let turns = blocks.laws().iter().any(|law| law.resists_rotation());
    if ask != Ask::Present || turns || !way::is_in_bodies(problem.rows, blocks.contacts()) {
        return Ok(None);
    }
    let solved = terms.in_bodies()?;
    Ok((solved.report.status == SolverStatus::Solved).then(|| Answer::from(solved)))
}

/// The forces of contacts with these laws, some of which have friction.
///
/// # Errors
/// When a number is not finite.
pub(super) fn solve(problem: &RowProblem<'_>, blocks: &Blocks, ask: Ask<'_>) -> Result<Answer, ResponseError> {
    let terms = Terms { rows: problem.rows, blocks, constants: problem.known.constants };
    let slides = blocks.laws().iter().any(|law| law.parts().iter().any(|(_, part)| part.slides));
    let free = if let Ask::Rest { free } = ask { Some(free) } else { None };
    if let Some(free) = free
        && !slides
        && way::is_many_at_rest(problem.rows, blocks.contacts())
        && let Some(held) = rest::standing(terms, free)?
    {
        return Ok(Answer::from(held));
    }
    if way::have_no_matrix(problem.rows.len()) && way::is_plain(problem.rows) {
        return Ok(Answer::from(terms.in_bodies()?));
    }
    let delassus = matrix::of(problem.rows)?;
    let rounded = |solved: BlocksSolution, choice: Option<Choice>| {
        let rounding = rounding_of(&delassus, &solved.reactions);
        Answer { choice, rounding, ..Answer::from(solved) }
    };
    if slides && let Some(held) = sliding::all_hold(terms)? {
        return Ok(rounded(held.solved, Some(held.choice)));
    }
    if !slides {
        let at = if free.is_some() { At::Rest } else { At::Motion };
        return Ok(rounded(sticking::of_no_slip(terms, &delassus, at)?, None));
    }
    let settings = FrictionSettings { acceptance: ACCEPTED_SLIDING, ..FrictionSettings::default() };
    Ok(rounded(blocks.solve(&delassus, problem.known.constants, problem.known.near, &settings)?, None))
}
