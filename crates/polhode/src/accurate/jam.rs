//! Impacts without a collision: contacts that slide and jam.
//!
//! Where the friction of a sliding contact presses it more than its normal force lifts it (`G_nn - mu G_nt <= 0`), no
//! system of finite forces may satisfy Coulomb's law (Painleve 1895). The bodies are then driven into each other by an
//! impulse until the slip has stopped (`polhode_response::impact::friction`). Where the law leaves open whether the
//! contact jams, slides on or opens, it opens: that is the answer with the least forces.
//!
//! Fails where a jam has no impulse either: the caller then advances the bodies by time steps.

use super::hold::Forces;
use super::motions::Mode;
use super::resolve::Resolution;
use crate::collision::touch::Touch;
use crate::error::SimulationError;
use crate::report::event::EventKind;
use crate::rows::groups::Group;
use crate::solve::frictional_impact::Cause;
use crate::solve::impact::strike_with_friction;
use polhode_response::impact::ImpactStatus;

impl Resolution<'_> {
    /// [`Self::candidates`], after the jams of a group.
    pub(super) fn candidates_after_jams(
        &mut self,
        group: &Group,
    ) -> Result<(Vec<usize>, Forces, bool), SimulationError> {
        let mut found = self.candidates(group);
        // Each jam stops the slip of a contact at least.
        for _ in &group.contacts {
            let is_unsolved = matches!(found, Err(SimulationError::ContactSolve { .. }));
            if !(is_unsolved && self.strike_jam(group)?) {
                break;
            }
            found = self.candidates(group);
        }
        found
    }

    /// Applies the impulses of a jam, if the contacts of a group jam. Returns whether they do.
    fn strike_jam(&mut self, group: &Group) -> Result<bool, SimulationError> {
        let sustained =
            |&i: &usize| self.motions.is_sustained(self.core, self.instant.speed_scale, &self.instant.touches[i]);
        let members: Vec<usize> = group.contacts.iter().copied().filter(sustained).collect();
        let touches: Vec<Touch> = members.iter().map(|&i| self.with_friction_mode(&self.instant.touches[i])).collect();
        if touches.iter().all(|touch| touch.modes.friction.is_none()) {
            return Ok(false);
        }
        for &body in &group.bodies {
            self.motions.book_flight(self.core, body, self.instant.t);
        }
        let loads = self.core.model.loads_on(self.instant.t, &self.motions.states, &group.bodies);
        let law = (self.core.settings.impact, Cause::Jam(self.instant.t, &loads));
        let struck = strike_with_friction(&self.core.model, &mut self.motions.states, &group.bodies, &touches, law)
            .map_err(|source| SimulationError::of_response(self.instant.t, source))?;
        if matches!(struck.outcome.status, ImpactStatus::NoApproach | ImpactStatus::NotSolved) {
            return Ok(false);
        }
        for &body in &group.bodies {
            if matches!(self.motions.tracks[body].mode, Mode::Rest) {
                self.instant.woken.insert(body);
            }
            self.motions.tracks[body].mode = Mode::Constrained;
        }
        self.book_struck(&members, &struck, EventKind::Jam);
        self.refresh_kinematics();
        Ok(true)
    }
}
