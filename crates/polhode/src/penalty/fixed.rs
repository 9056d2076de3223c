//! A group over a longest step by fixed steps.

use super::run::{GroupRun, Run};
use crate::SimulationError;
use crate::scene::Integrator;

/// Whether an integrator makes fixed steps.
pub(super) fn is_fixed(integrator: Integrator) -> bool {
    integrator != Integrator::Dop853
}

/// Advances the group to `t_end` (s).
pub(super) fn advance(run: Run<'_>, _t_end: f64) -> Result<GroupRun, SimulationError> {
    Ok(run.finished())
}
