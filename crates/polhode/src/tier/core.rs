//! What all tiers work on: the world, the settings, the present time and the accounts.

use crate::accounting::Accounts;
use crate::accounting::last_sample::LastSample;
use crate::error::SimulationError;
use crate::identity::body_id::BodyId;
use crate::joints::{joint_contacts, released};
use crate::model::Model;
use crate::report::event::{Event, EventKind};
use crate::scene::effects::Effects;
use crate::tier::executor::Executor;
use crate::tier::settings::Settings;
use polhode_dynamics::BodyState;
use polhode_response::Memory;
use std::sync::Arc;

/// The parts of a simulation that do not depend on its tier.
#[derive(Debug)]
pub(crate) struct Core {
    pub(crate) model: Model,
    pub(crate) settings: Settings,
    pub(crate) effects: Effects,
    /// The present, s.
    pub(crate) t: f64,
    pub(crate) accounts: Accounts,
    /// Solver of contact problems, with its buffers; its answers do not depend on what it solved before.
    pub(crate) memory: Memory,
    /// Who computes what does not depend on each other.
    pub(crate) executor: Arc<dyn Executor>,
    /// The overlap that springs or the collision envelope are made for, m; infinite in a run without them.
    pub(crate) stated_depth_m: f64,
    /// Units of work that the motion so far has cost (`crate::model::work`), without queries.
    pub(crate) work: u64,
    /// The overlaps of the last sample, as a cache.
    pub(crate) last_sample: LastSample,
}

impl Core {
    /// The time (s) at which a step from `t` (s) must end at the latest: the end of the run, or the first time at which
    /// a force is not smooth.
    pub(crate) fn horizon(&self, t: f64) -> f64 {
        let duration = self.model.scene.duration_s();
        // A program may advance beyond the end of the run.
        let end = if t < duration { duration } else { f64::INFINITY };
        self.model.free_motion().corner_between(t, end).unwrap_or(end)
    }

    /// Whether the run ends at `t` (s); a program may advance further.
    pub(crate) fn is_end_of_run(&self, t: f64) -> bool {
        t == self.model.scene.duration_s()
    }

    /// Breaks joints at `t` (s), where bodies have these states, and reports it.
    ///
    /// # Errors
    /// When the fields of the remaining joints cannot be made.
    pub(crate) fn break_joints(
        &mut self,
        t: f64,
        states: &[BodyState],
        joints: &[usize],
    ) -> Result<(), SimulationError> {
        if joints.is_empty() {
            return Ok(());
        }
        for joint in self.model.joints.list.iter().filter(|joint| joints.contains(&joint.number())) {
            let (first, second) = joint.pair();
            let body_b = (second != first).then(|| BodyId::new(second));
            let point = joint_contacts::anchor_of(&self.model, states, joint);
            let event = Event::new(t, EventKind::Break, BodyId::new(first));
            self.accounts.add_event(Event { body_b, point, ..event });
        }
        Ok(released::release(&mut self.model, joints)?)
    }
}
