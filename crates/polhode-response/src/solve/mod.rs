//! The one entry for all problems of rows: it chooses matrix, method and start.
//!
//! A caller says what must hold (rows, their laws, their constant terms) and what it asks for ([`Ask`]), and reads what
//! it took. Nobody else chooses.
//!
//! | module | holds |
//! |---|---|
//! | [`problem`] | [`Ask`], [`RowProblem`], [`Memory`] |
//! | [`way`] | which way a problem of a size goes: all thresholds |
//! | `without_friction` | rows that push and hold: the active set, beside trees of joints or with all rows |
//! | [`held`] | rows that hold, by the reactions of least norm |
//! | [`many`] | blocks of many contacts at an instant |
//! | [`step`] | blocks with friction over a time step |

pub mod held;
pub mod many;
pub mod problem;
pub mod step;
pub mod way;
mod without_friction;

pub use problem::{Ask, Memory, RowProblem};

use crate::complementarity::ContactSolution;
use crate::error::{ResponseError, check_length};
use crate::friction::{Blocks, FrictionSettings};

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
///     assert!((found.residual_accelerations[1] - acceleration).abs() < 1e-12);
/// }
/// # Ok::<(), polhode_response::ResponseError>(())
/// ```
///
/// A problem that is not solved is no error: see the status of the report.
///
/// # Errors
/// When a list has another length than the problem has rows, or a number is not finite.
#[cfg_attr(feature = "census", track_caller)]
pub fn solve(problem: &RowProblem<'_>, ask: Ask, memory: &mut Memory) -> Result<ContactSolution, ResponseError> {
    check_length("constant terms", problem.rows.len(), problem.constants.len())?;
    if problem.rows.has_friction() {
        let (delassus, settings) = (problem.rows.delassus(), FrictionSettings::default());
        let solved = Blocks::of(problem.rows).solve(&delassus, problem.constants, None, &settings)?;
        return Ok(ContactSolution {
            forces: solved.reactions,
            residual_accelerations: solved.velocities,
            report: solved.report,
            ..ContactSolution::default()
        });
    }
    if let Ask::Displacement { accuracy } = ask
        && let Some(found) = without_friction::displacements(problem, accuracy)?
    {
        return Ok(found);
    }
    without_friction::active_set(problem, memory)
}
