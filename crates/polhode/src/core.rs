//! What every tier works on: the world, the settings, the present time and the accounts.

use crate::accounting::Accounts;
use crate::settings::Settings;
use crate::world::World;
use crate::{Effects, SimulationError};
use polhode_response::{ComplementaritySolver, ResponseError};

/// The parts of a simulation that do not depend on its tier.
#[derive(Debug)]
pub(crate) struct Core {
    pub(crate) world: World,
    pub(crate) settings: Settings,
    pub(crate) effects: Effects,
    /// The present, s.
    pub(crate) t: f64,
    pub(crate) accounts: Accounts,
    /// Buffers of contact problems; the answers do not depend on what was solved before.
    pub(crate) solver: ComplementaritySolver,
}

impl Core {
    /// Where a step from `t` (s) must end at the latest: at the end of the run, or where a force is not smooth in time.
    pub(crate) fn horizon(&self, t: f64) -> f64 {
        let duration = self.world.scene.duration_s();
        // A program may go on after the end of the run.
        let end = if t < duration { duration } else { f64::INFINITY };
        self.world.free_motion().corner_between(t, end).unwrap_or(end)
    }

    /// Whether the run ends at `t` (s); a program may go on.
    pub(crate) fn is_end_of_run(&self, t: f64) -> bool {
        t == self.world.scene.duration_s()
    }

    /// A contact problem that was refused.
    pub(crate) fn response_error(t: f64, source: ResponseError) -> SimulationError {
        SimulationError::ContactProblem { t, source }
    }
}
