//! Changes that a program makes to bodies between two steps.
//!
//! The islands of the affected bodies end at the present. The program changes states, forces or bodies. Then touching
//! contacts are found again, impacts are resolved, and islands are formed as after any event.

use super::engine::{Engine, Mode, Track};
use super::impact_search::Search;
use super::instant::Instant;
use super::pace::Pace;
use crate::SimulationError;
use crate::core::Core;
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
        for &body in bodies.iter().filter(|&&body| !core.world.bodies[body].moves()) {
            found_for.extend(self.contacts.partners(body));
            // Time steps of crowds were made with the motion that it had: it may come near any of them.
            if core.world.trajectory(body).is_some() {
                found_for.extend(
                    (0..self.tracks.len()).filter(|&other| matches!(self.tracks[other].mode, Mode::Crowded(_))),
                );
            }
        }
        let t = core.t;
        let affected = self.affected_bodies(core, t, &found_for.into_iter().collect::<Vec<_>>())?;
        let mut instant = self.end_islands(core, t, affected)?;
        for &body in &instant.bodies {
            self.book_flight(core, body, t);
            let mode = &mut self.tracks[body].mode;
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
        let gone = |body: usize| core.world.bodies[body].removed;
        instant.bodies.retain(|&body| core.world.bodies[body].moves());
        instant.pairs.retain(|&(a, b)| !gone(a) && !gone(b));
        instant.touches.retain(|touch| !gone(touch.id.a) && !gone(touch.id.b));
        for &body in &instant.bodies {
            self.scratch[body] = self.states[body];
            self.tracks[body].pace = Pace::starting_at(instant.t);
            self.tracks[body].proposed_step_s = core.settings.step_s;
            instant.speed_scale = instant.speed_scale.max(core.world.point_speed(&self.states, body));
        }
        for &body in moved {
            self.find_touched(core, &mut instant, body)?;
        }
        self.resolve(core, &mut instant)?;
        let t = instant.t;
        self.continue_motion(core, instant)?;
        // A body that no force moves makes no step, but its box is new.
        let unmoved: Vec<usize> = moved.iter().copied().filter(|&body| !core.world.bodies[body].moves()).collect();
        for &body in &unmoved {
            self.expect_corner(core, body, t);
        }
        if !unmoved.is_empty() {
            self.begin_flight_boxes(core, t);
            self.renew_boxes(core, &unmoved, t)?;
            self.search_pairs(core, &unmoved, t, Search::All)?;
        }
        Ok(())
    }

    /// Adds the bodies that a body touches at its new pose to the instant.
    fn find_touched(&mut self, core: &mut Core, instant: &mut Instant, body: usize) -> Result<(), SimulationError> {
        let others = (0..core.world.bodies.len()).filter(|&other| core.world.scene.may_collide(body, other));
        let mut pairs: BTreeSet<(usize, usize)> = instant.pairs.iter().copied().collect();
        for other in others.collect::<Vec<_>>() {
            let pair = (body.min(other), body.max(other));
            if !self.touch_at(core, pair, instant.t)? {
                continue;
            }
            pairs.insert(pair);
            if core.world.bodies[other].moves() && instant.bodies.binary_search(&other).is_err() {
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
        let body = self.states.len();
        self.states.push(state);
        self.scratch.push(state);
        let size = core.world.bodies[body].size;
        self.tracks.push(Track::new(core, body));
        self.tracks[body].speed_scale =
            core.world.point_speed(&self.states, body).max((core.world.gravity().length() * size).sqrt());
        self.contacts.make_room();
        self.near.make_room();
    }

    /// Forgets a body that is about to be removed from the world.
    pub(super) fn forget_body(&mut self, body: usize) {
        self.remove_from_pairs(body);
        let partners: Vec<usize> = self.contacts.partners(body).collect();
        for other in partners {
            self.contacts.set((body.min(other), body.max(other)), Vec::new());
        }
        self.tracks[body].mode = Mode::Fixed;
        self.tracks[body].island = None;
    }
}
