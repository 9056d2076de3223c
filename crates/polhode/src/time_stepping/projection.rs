//! Removal of what a step has left of penetration, with its entry in the books.

use super::NO_WORK_J;
use super::made::Made;
use super::step::TimeStepper;
use crate::accounting::time_step_report::TimeStepReport;
use crate::model::Model;
use polhode_dynamics::BodyState;
use polhode_response::ResponseError;

impl TimeStepper {
    /// Removes the overlaps that a step has left, and gives its report.
    ///
    /// # Errors
    /// When a number is not finite.
    pub(super) fn remove_overlaps(
        &mut self,
        model: &Model,
        states: &mut [BodyState],
        bodies: &[usize],
        Made { mut report, pairs, overlaps, .. }: Made,
    ) -> Result<TimeStepReport, ResponseError> {
        if overlaps.deepest_m > report.max_penetration_m {
            (report.max_penetration_m, report.deepest) = (overlaps.deepest_m, overlaps.deepest);
        }
        report.left_penetration_m = overlaps.deepest_m;
        if overlaps.is_excess {
            let before = report.books.balance(model, states, bodies);
            let problem = &mut self.memory;
            let removed = overlaps.remove(model, states, (bodies, &pairs), problem)?;
            let after = report.books.balance(model, states, bodies);
            report.books.projection(before, after, NO_WORK_J);
            report.fallbacks += removed.fallbacks;
            report.max_projection_m = report.max_projection_m.max(removed.moved_m);
            report.left_penetration_m = removed.left_m;
        }
        Ok(report)
    }
}
