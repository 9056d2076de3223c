//! Changes that a program makes to bodies between two steps.
//!
//! The islands of the affected bodies end at the present. The program changes states, forces or bodies. Then touching
//! contacts are found again, impacts are resolved, and islands are formed as after any event.

use super::engine::Engine;
use super::impact_search::Search;
use super::instant::Instant;
use super::motions::{Mode, Track};
use super::pace::Pace;
use crate::error::SimulationError;
use crate::identity::contact_id::ContactId;
use crate::joints::added;
use crate::model::{Model, prescribed, tolerances};
use crate::tier::core::Core;
use polhode_dynamics::BodyState;
use std::collections::BTreeSet;

impl Engine {
    /// Ends the motions of these bodies and of all bodies that they affect at the present.
    ///
    /// # Errors
    /// When their states cannot be evaluated.
    pub(super) fn interrupt_bodies(&mut self, core: &mut Core, bodies: &[usize]) -> Result<(), SimulationError> {
        if !self.begun {
            self.begin(core)?;
        }
        let mut found_for: BTreeSet<usize> = bodies.iter().copied().collect();
        // An immovable body affects the bodies it touches.
        for &body in bodies.iter().filter(|&&body| !core.model.bodies[body].moves()) {
            found_for.extend(self.schedule.contacts.partners(body));
            // Time steps of crowds were made with the motion that it had: it may come near any of them.
            if prescribed::trajectory(&core.model, body).is_some() {
                found_for.extend(
                    (0..self.motions.tracks.len())
                        .filter(|&other| matches!(self.motions.tracks[other].mode, Mode::Crowded(_))),
                );
            }
        }
        let t = core.t;
        let affected = self.affected_bodies(core, t, &found_for.into_iter().collect::<Vec<_>>())?;
        let mut instant = self.end_islands(core, t, affected)?;
        for &body in &instant.bodies {
            self.motions.book_flight(core, body, t);
            let mode = &mut self.motions.tracks[body].mode;
            if matches!(mode, Mode::Rest) {
                instant.woken.insert(body);
            }
            *mode = Mode::Constrained;
        }
        self.interrupted = Some(instant);
        Ok(())
    }

    /// Resolves the present instant of the interrupted bodies and continues their motion; the poses of `moved` are new.
    ///
    /// # Errors
    /// When an impact or the contact forces cannot be solved.
    pub(super) fn resume_bodies(&mut self, core: &mut Core, moved: &[usize]) -> Result<(), SimulationError> {
        let Some(mut instant) = self.interrupted.take() else { return Ok(()) };
        let gone = |body: usize| core.model.bodies[body].removed;
        instant.bodies.retain(|&body| core.model.bodies[body].moves());
        instant.pairs.retain(|&(a, b)| !gone(a) && !gone(b));
        instant.touches.retain(|touch| !gone(touch.id.a) && !gone(touch.id.b));
        for &body in &instant.bodies {
            self.motions.scratch[body] = self.motions.states[body];
            self.motions.tracks[body].pace = Pace::starting_at(instant.t);
            self.motions.tracks[body].proposed_step_s = core.settings.step_s;
            instant.speed_scale =
                instant.speed_scale.max(tolerances::point_speed(&core.model, &self.motions.states, body));
        }
        for &body in moved {
            self.find_touched(core, &mut instant, body)?;
        }
        self.resolve(core, &mut instant)?;
        let t = instant.t;
        self.continue_motion(core, instant)?;
        // A body that no force moves makes no step, but its box is new.
        let unmoved: Vec<usize> = moved.iter().copied().filter(|&body| !core.model.bodies[body].moves()).collect();
        for &body in &unmoved {
            self.schedule.expect_corner(core, body, t);
        }
        if !unmoved.is_empty() {
            self.schedule.begin_flight_boxes(core, t);
            self.schedule.renew_boxes(core, &self.motions, &unmoved, t)?;
            self.schedule.search_pairs(core, &self.motions, &unmoved, t, Search::All)?;
        }
        Ok(())
    }

    /// Adds the bodies that a body touches at its new pose to the instant.
    fn find_touched(&mut self, core: &mut Core, instant: &mut Instant, body: usize) -> Result<(), SimulationError> {
        let others = (0..core.model.bodies.len()).filter(|&other| core.model.scene.may_collide(body, other));
        let mut pairs: BTreeSet<(usize, usize)> = instant.pairs.iter().copied().collect();
        for other in others.collect::<Vec<_>>() {
            let pair = (body.min(other), body.max(other));
            if !self.motions.touch_at(core, pair, instant.t)? {
                continue;
            }
            pairs.insert(pair);
            if core.model.bodies[other].moves() && instant.bodies.binary_search(&other).is_err() {
                let mut more = self.affected_bodies(core, instant.t, &[other])?;
                more.retain(|body| instant.bodies.binary_search(body).is_err());
                let more = self.end_islands(core, instant.t, more)?;
                pairs.extend(more.pairs);
                instant.bodies.extend(more.bodies);
                instant.bodies.sort_unstable();
                instant.touches.extend(more.touches);
                instant.touches.sort_by_key(|touch| touch.id);
                instant.speed_scale = instant.speed_scale.max(more.speed_scale);
            }
        }
        instant.pairs = pairs.into_iter().collect();
        Ok(())
    }

    /// Makes room for a body that has been added to the world.
    pub(super) fn make_room(&mut self, core: &Core, state: BodyState) {
        let body = self.motions.states.len();
        self.motions.states.push(state);
        self.motions.scratch.push(state);
        let size = core.model.bodies[body].size;
        self.motions.tracks.push(Track::new(core, body));
        self.motions.tracks[body].speed_scale = tolerances::point_speed(&core.model, &self.motions.states, body)
            .max((core.model.gravity().length() * size).sqrt());
        self.schedule.contacts.make_room();
        self.schedule.near.make_room();
    }

    /// Forgets the contacts of a pair that are there no more, after a joint between its bodies was added or taken away.
    pub(super) fn change_contacts_of_joint(&mut self, model: &Model, pair: (usize, usize)) {
        let stays = |contact: ContactId| (contact.a, contact.b) != pair || added::may_have(model, contact);
        let touches = self.schedule.contacts.of_pair(pair).iter().filter(|touch| stays(touch.id)).copied().collect();
        self.schedule.contacts.set(pair, touches);
        if let Some(instant) = &mut self.interrupted {
            instant.touches.retain(|touch| stays(touch.id));
            instant.pairs.retain(|&own| own != pair || added::may_touch(model, own));
        }
    }

    /// Forgets a body that is about to be removed from the world.
    pub(super) fn forget_body(&mut self, body: usize) {
        self.schedule.remove_from_pairs(body);
        let partners: Vec<usize> = self.schedule.contacts.partners(body).collect();
        for other in partners {
            self.schedule.contacts.set((body.min(other), body.max(other)), Vec::new());
        }
        self.motions.tracks[body].mode = Mode::Fixed;
        self.motions.tracks[body].island = None;
    }
}
