//! The steps that are compared with two of half their length: every [`EVERY`]-th, for those up to the next one, and
//! each that is divided at impacts or where slip ends, for itself (`crate::tier::error_estimate`).

use super::engine::SteppedEngine;
use super::island_steps::advance_islands;
use super::islands::Island;
use crate::accounting::time_step_report::TimeStepReport;
use crate::error::SimulationError;
use crate::tier::core::Core;
use crate::tier::error_estimate::EVERY;
use polhode_dynamics::BodyState;

impl SteppedEngine {
    /// Compares the steps of some islands, which began with these states, with the same in two halves. The present
    /// states are those after the steps.
    ///
    /// # Errors
    /// When the state or a contact problem of a half is no longer finite.
    pub(super) fn compare_with_halves(
        &mut self,
        core: &Core,
        begin: &[BodyState],
        (islands, reports): (&[Island], &[TimeStepReport]),
        (t, h): (f64, f64),
    ) -> Result<(), SimulationError> {
        let is_regular = core.accounts.steps().is_multiple_of(EVERY);
        let is_compared = |report: &TimeStepReport| is_regular || report.steps > 1;
        let compared = islands.iter().zip(reports).filter(|(_, report)| is_compared(report));
        let (compared, reports): (Vec<Island>, Vec<_>) = compared.map(|(own, report)| (own.clone(), report)).unzip();
        if compared.is_empty() {
            return Ok(());
        }
        let (mut states, mut stepper) = (begin.to_vec(), self.stepper.clone());
        for part in [(t, 0.5 * h), (t + 0.5 * h, 0.5 * h)] {
            advance_islands(&core.model, &*core.executor, (&mut stepper, &mut states), &compared, part)?;
        }
        for (island, report) in compared.iter().zip(reports) {
            let stands_for = if report.steps > 1 { 1 } else { EVERY };
            for &body in &island.bodies {
                self.errors.compare(&core.model, body, (&self.states[body], &states[body]), stands_for);
            }
        }
        Ok(())
    }
}
