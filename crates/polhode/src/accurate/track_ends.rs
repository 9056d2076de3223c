//! Bodies that run off the ends of their tracks: the time within a step, and what becomes of their joints.

use super::contact_change::ContactChange;
use super::locate::PENETRATION_CHECKS;
use super::resolve::Resolution;
use super::step_search::StepSearch;
use crate::constraint::locator::{Side, close_in};
use crate::error::SimulationError;
use crate::identity::body_id::BodyId;
use crate::joints::released::{self, RunOff};
use crate::report::event::{Event, EventKind};
use std::convert::Infallible;

impl StepSearch<'_> {
    /// The first change of a step up to `limit` (s): this one, or a body that runs off the end of its track before it.
    pub(super) fn or_end_of_track(&mut self, limit: f64, change: Option<ContactChange>) -> Option<ContactChange> {
        if self.core.model.joints.ending_tracks == 0 {
            return change;
        }
        let last = change.as_ref().map_or(limit, |change| change.t.min(limit));
        let start = self.step.t;
        let mut before = start;
        for k in 1..=PENETRATION_CHECKS {
            let after = start + (last - start) * (f64::from(k) / f64::from(PENETRATION_CHECKS));
            if self.running_off(after).is_empty() {
                before = after;
                continue;
            }
            let side =
                |t: f64| Ok::<_, Infallible>(if self.running_off(t).is_empty() { Side::Before } else { Side::After });
            let Ok(bracket) = close_in((before, after), side);
            let running_off = self.running_off(bracket.after).iter().map(|off| off.joint).collect();
            return Some(ContactChange { t: bracket.after, running_off, ..ContactChange::default() });
        }
        change
    }

    fn running_off(&mut self, t: f64) -> Vec<RunOff> {
        self.step.states_at(&self.core.model, t, self.states);
        released::run_off(&self.core.model, self.states, &self.step.bodies)
    }
}

impl Resolution<'_> {
    /// Joints whose bodies have run off the ends of their tracks hold nothing any more.
    ///
    /// # Errors
    /// When the forces on the bodies cannot be made.
    pub(super) fn let_go_at_ends_of_tracks(&mut self) -> Result<(), SimulationError> {
        let joints = self.instant.change.running_off.clone();
        for joint in joints {
            let Some(RunOff { body, point, .. }) =
                released::place_on_track(&self.core.model, &self.motions.states, joint)
            else {
                continue;
            };
            released::release(&mut self.core.model, &[joint])?;
            let event = Event::new(self.instant.t, EventKind::Detach, BodyId::new(body));
            self.core.accounts.add_event(Event { point, ..event });
        }
        Ok(())
    }
}
