//! Blocks of many contacts at an instant, or at rest: in the accelerations of bodies, without a matrix of rows.

use crate::error::ResponseError;
use crate::friction::{Blocks, BlocksSolution};
use crate::problem::ContactProblem;
use crate::sparse::{BodySettings, BodySolver};

/// The forces of blocks with these constant terms. That they are not found is no error: see the status of the report.
///
/// # Errors
/// When a number is not finite, and where rows are soft or of more than two bodies
/// ([`is_plain`](super::way::is_plain)).
#[cfg_attr(feature = "census", track_caller)]
pub(super) fn solve_many(
    rows: &ContactProblem,
    blocks: &Blocks,
    constants: &[f64],
) -> Result<BlocksSolution, ResponseError> {
    let system = (&mut BodySolver::default(), &BodySettings::default());
    Ok(blocks.solve_in_bodies(rows, constants, None, system)?.0)
}
