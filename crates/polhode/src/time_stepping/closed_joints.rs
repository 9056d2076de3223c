//! Removal of what a step has left of gaps and rates of bilateral constraints, with its entry in the books.

use crate::accounting::time_step_report::TimeStepReport;
use crate::model::Model;
use crate::solve::projection::{Removal, project_positions, project_velocities};
use polhode_dynamics::BodyState;
use polhode_response::ResponseError;

/// Removes the gaps and rates of bilateral constraints.
///
/// # Errors
/// When a number is not finite.
pub(super) fn close_joints(
    model: &Model,
    states: &mut [BodyState],
    bodies: &[usize],
    report: &mut TimeStepReport,
) -> Result<(), ResponseError> {
    if model.joints.held_among(bodies).is_empty() {
        return Ok(());
    }
    let before = report.books.balance(model, states, bodies);
    let moved = project_positions(model, states, bodies, &[])?;
    let removed = project_velocities(model, states, bodies, (&[], &[], &[]), Removal::Complete)?;
    let after = report.books.balance(model, states, bodies);
    report.books.projection(before, after, removed.work_j);
    report.told.take(model, states, removed.reactions());
    report.max_projection_m = report.max_projection_m.max(moved.moved_m);
    Ok(())
}
