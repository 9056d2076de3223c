//! A run goes on or says why it does not: steps that no longer advance time are counted.
//!
//! Steps become short for good reasons (an event at which forces jump is approached by some sixty steps, each a part of
//! the one before), but never thousands of them in a row. Where a contact cannot be followed, because its place jumps, or
//! bodies touch where no contact is found, a run would go on for ever: it ends with
//! [`SimulationError::NoProgress`], which says when, where and what may help.

use super::engine::Engine;
use crate::SimulationError;
use crate::interaction::contact_set::{Hold, Touch};
use polhode_spatial::DVec3;

/// Time has advanced when it has by this fraction of the longest step: far above what the approach to one event or its
/// resolution takes, and what a contact whose place jumps lets through in [`MOST_STEPS`] (some 1e-6).
const ADVANCE_RELATIVE: f64 = 1e-4;

/// Steps without an advance of time that end a run: many times those that approach an event.
const MOST_STEPS: u64 = 1024;

/// How far a run has come lately.
#[derive(Debug, Default)]
pub(super) struct Progress {
    /// When time last advanced, s.
    since: f64,
    /// Steps since then.
    steps: u64,
    /// How often something wrong has been put up with since then.
    leaps: u32,
}

impl Progress {
    /// Something wrong has been put up with for a moment.
    pub(super) fn note_leap(&mut self) {
        self.leaps += 1;
    }

    /// The number of that moment, from one on.
    pub(super) fn leaps(&self) -> u32 {
        self.leaps + 1
    }
}

impl Engine {
    /// Notes that a step has been made.
    ///
    /// # Errors
    /// When there have been too many that did not advance time.
    pub(super) fn note_progress(&mut self) -> Result<(), SimulationError> {
        let advanced_s = self.t - self.progress.since;
        if advanced_s >= ADVANCE_RELATIVE * self.settings.step_s {
            self.progress = Progress { since: self.t, steps: 0, leaps: 0 };
            return Ok(());
        }
        self.progress.steps += 1;
        if self.progress.steps < MOST_STEPS {
            return Ok(());
        }
        let name = |body: usize| self.world.bodies[body].name.clone();
        let held = |touch: &&Touch| touch.hold == Hold::Held;
        let touch = self.touches.iter().find(held).or(self.touches.first());
        let [body_a, body_b] = touch.map_or_else(Default::default, |touch| [name(touch.id.a), name(touch.id.b)]);
        let point = touch.map_or(DVec3::ZERO, |touch| touch.kinematics.geometry.point);
        Err(SimulationError::NoProgress { t: self.t, steps: MOST_STEPS, advanced_s, body_a, body_b, point })
    }
}
