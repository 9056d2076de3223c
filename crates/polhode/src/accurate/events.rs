//! Processing of an event: the affected bodies, their states at that time, and their motion afterwards.
//!
//! An event affects the bodies it was found for. From there it spreads to every body that is connected to an affected
//! one (by held contacts or coupling forces) or touches it at that time. Their islands end with the states of that
//! time, the event is resolved (`resolve.rs`), and new islands are formed from the contacts that hold then. All other
//! bodies continue unchanged.

use super::agenda::Due;
use super::contact_change::ContactChange;
use super::engine::Engine;
use super::free_stepping::{FreeStep, free_end};
use super::impact_search::Search;
use super::instant::Instant;
use super::island::{Island, Step};
use super::motions::{Mode, Motions};
use super::pace::{NoAdvance, Pace, StepEnd};
use super::resolve::Resolution;
use crate::collision::active_contacts::ActiveContacts;
use crate::collision::touch::{FoundContact, Hold, Touch};
use crate::collision::{contact_kinematics, contact_set};
use crate::error::SimulationError;
use crate::identity::contact_id::ContactId;
use crate::joints::turns;
use crate::model::states_of::set_states;
use crate::model::{prescribed, tolerances};
use crate::rows::assembly::free_acceleration;
use crate::rows::groups::coupled_groups;
use crate::solve::projection::Projected;
use crate::tier::core::Core;
use polhode_contact::aabb_of;
use polhode_spatial::DVec3;
use std::collections::{BTreeMap, BTreeSet};

/// The tolerated problem that is counted when time steps replace the location of events.
const UNSOLVED: &str = "no forces were found that satisfy Coulomb's law for accelerations (a slip that presses its own \
                        contact has several answers or none): time steps answer by its law for velocities";

impl Engine {
    /// Resolves the event at `t` that was found for these bodies.
    ///
    /// # Errors
    /// When an impact or the contact forces cannot be solved, or time no longer advances.
    pub(super) fn resolve_event(
        &mut self,
        core: &mut Core,
        t: f64,
        found_for: &[usize],
    ) -> Result<(), SimulationError> {
        let affected = self.affected_bodies(core, t, found_for)?;
        let mut instant = self.end_islands(core, t, affected)?;
        if let Some(crowd) = self.motions.ongoing_stretch(&instant) {
            for &body in &instant.bodies {
                self.motions.scratch[body] = self.motions.states[body];
            }
            return self.crowd_step(core, instant, crowd);
        }
        match self.note_events(core, &instant, found_for)? {
            Some(stuck) => {
                for &body in &instant.bodies {
                    self.motions.scratch[body] = self.motions.states[body];
                }
                self.begin_stretch(core, instant, stuck)
            }
            None => match self.break_joints(core, &mut instant).and_then(|()| self.resolve(core, &mut instant)) {
                Ok(()) => self.continue_motion(core, instant),
                Err(error) => self.begin_stretch_if_unsolved(core, instant, error),
            },
        }
    }

    /// Resolves an instant.
    ///
    /// # Errors
    /// When an impact or the contact forces cannot be solved.
    pub(super) fn resolve(&mut self, core: &mut Core, instant: &mut Instant) -> Result<(), SimulationError> {
        Resolution { core, motions: &mut self.motions, schedule: &self.schedule, instant }.resolve()
    }

    /// Breaks the joints that break at an instant.
    fn break_joints(&mut self, core: &mut Core, instant: &mut Instant) -> Result<(), SimulationError> {
        let broken: Vec<usize> = std::mem::take(&mut instant.change.breaking).into_iter().collect();
        core.break_joints(instant.t, &self.motions.states, &broken)
    }

    /// If the contact forces could not be found, time steps advance the bodies of an instant; other errors are
    /// returned.
    pub(super) fn begin_stretch_if_unsolved(
        &mut self,
        core: &mut Core,
        instant: Instant,
        error: SimulationError,
    ) -> Result<(), SimulationError> {
        if !(matches!(error, SimulationError::ContactSolve { .. }) && core.settings.crowding.steps()) {
            return Err(error);
        }
        core.accounts.tolerate(instant.t, UNSOLVED);
        for &body in &instant.bodies {
            self.motions.scratch[body] = self.motions.states[body];
        }
        self.begin_stretch(core, instant, NoAdvance { steps: 0, advanced_s: 0.0 })
    }

    /// Advances an island by time steps from `t`, because its contact forces or a step with them could not be found.
    ///
    /// # Errors
    /// When a time step is not possible.
    pub(super) fn begin_stretch_of_island(
        &mut self,
        core: &mut Core,
        first: usize,
        t: f64,
    ) -> Result<(), SimulationError> {
        let bodies = self.motions.island(first).map(|island| island.bodies.clone()).unwrap_or_default();
        let instant = self.end_islands(core, t, bodies)?;
        for &body in &instant.bodies {
            self.motions.scratch[body] = self.motions.states[body];
        }
        core.accounts.tolerate(t, UNSOLVED);
        self.begin_stretch(core, instant, NoAdvance { steps: 0, advanced_s: 0.0 })
    }

    /// Movable bodies that an event at `t` affects, ascending.
    pub(super) fn affected_bodies(
        &mut self,
        core: &Core,
        t: f64,
        found_for: &[usize],
    ) -> Result<Vec<usize>, SimulationError> {
        let mut affected = BTreeSet::new();
        let mut open: Vec<usize> = found_for.iter().copied().filter(|&b| core.model.bodies[b].moves()).collect();
        while let Some(body) = open.pop() {
            if !affected.insert(body) {
                continue;
            }
            if let Some(island) = self.motions.island_of(body) {
                open.extend(island.bodies.iter().copied());
            }
            for coupled in core.model.couplings_of(body) {
                open.extend(coupled.iter().copied());
            }
            let mut partners: Vec<usize> = self.schedule.partners(core, body).collect();
            partners.sort_unstable();
            partners.dedup();
            for other in partners {
                if !core.model.bodies[other].moves() || affected.contains(&other) {
                    continue;
                }
                let pair = (body.min(other), body.max(other));
                if self.schedule.contacts.are_held(pair) || self.motions.touch_at(core, pair, t)? {
                    open.push(other);
                }
            }
        }
        Ok(affected.into_iter().collect())
    }

    /// Ends the islands of these bodies at `t`: sets their states to those of that time and books their motion.
    pub(super) fn end_islands(
        &mut self,
        core: &mut Core,
        t: f64,
        bodies: Vec<usize>,
    ) -> Result<Instant, SimulationError> {
        prescribed::prescribe(&core.model, t, &mut self.motions.states);
        let mut change = ContactChange { t, ..ContactChange::default() };
        let firsts: BTreeSet<usize> = bodies.iter().filter_map(|&body| self.motions.tracks[body].island).collect();
        let mut ended = Vec::with_capacity(firsts.len());
        for first in firsts {
            let Some(mut island) = self.remove_island(first) else { continue };
            // Contacts break, stop and begin to slide at the time located for them, not at an earlier event.
            if island.changes && island.due <= t {
                change.include(&island.change);
            }
            let is_smooth = self.motions.end_motion(core, &mut island, t)?;
            ended.push((island, is_smooth));
        }
        for &body in &bodies {
            self.motions.tracks[body].island = None;
            if let Mode::Flight(flight) = &self.motions.tracks[body].mode {
                self.motions.states[body] = flight.state(t);
            }
            self.motions.book_rest(core, body, t);
        }
        // All bodies are at `t` now, so the projection can detect neighbours that it would push a body into.
        for (island, is_smooth) in ended {
            self.finish_step(core, &island, is_smooth, t)?;
        }
        let mut pairs = BTreeSet::new();
        let concerns = |other: usize| bodies.binary_search(&other).is_ok() || !core.model.bodies[other].moves();
        for &body in &bodies {
            let partners = self.schedule.partners(core, body);
            pairs.extend(partners.filter(|&other| concerns(other)).map(|o| (body.min(o), body.max(o))));
        }
        let known = pairs.iter().flat_map(|&pair| self.schedule.contacts.of_pair(pair)).copied();
        let touches = known.filter_map(|touch| {
            let kinematics = contact_kinematics::kinematics(&core.model, &self.motions.states, touch.id)?;
            Some(Touch { kinematics, is_defined: true, ..touch })
        });
        Ok(Instant {
            t,
            touches: touches.collect(),
            pairs: pairs.into_iter().collect(),
            change,
            woken: BTreeSet::new(),
            rest_times: BTreeMap::new(),
            slip_ends: BTreeMap::new(),
            speed_scale: bodies.iter().fold(0.0, |most, &body| self.motions.tracks[body].speed_scale.max(most)),
            bodies,
        })
    }

    /// Projects the held contacts of an island whose motion has ended at `t` (s) after a smooth stage, and checks its
    /// bodies.
    fn finish_step(
        &mut self,
        core: &mut Core,
        island: &Island,
        is_smooth: bool,
        t: f64,
    ) -> Result<(), SimulationError> {
        if is_smooth {
            let held = island.active.held();
            // A contact that has just stopped sticks from now on, if at all.
            let sticking = island.active.sticking();
            let turns = island.active.held_turns();
            let projected = Projected { touching: held, held, sticking: &sticking, turns: &turns };
            // Taken now, and not where the stage was booked: the energy of force fields is that of all bodies, and
            // other islands have ended since.
            let balance = core.accounts.books.balance(&core.model, &self.motions.states, &island.bodies);
            self.motions.project_held_contacts(core, &self.schedule, &island.bodies, projected, t, balance)?;
        }
        self.motions.check(core, &island.bodies, island.active.held(), t)
    }

    /// Counts an event for all bodies it affects. Returns how little time has advanced, if it no longer does.
    fn note_events(
        &mut self,
        core: &mut Core,
        instant: &Instant,
        found_for: &[usize],
    ) -> Result<Option<NoAdvance>, SimulationError> {
        let longest = core.settings.step_s;
        let moving =
            instant.bodies.iter().copied().filter(|&body| !matches!(self.motions.tracks[body].mode, Mode::Rest));
        let moving: Vec<usize> = moving.collect();
        let mut pace = self.motions.pace_of(core, &moving);
        let end = match found_for {
            &[a, b]
                if core.model.scene.pair_material(a, b).restitution() >= 1.0
                    && !self.ends_unseen_bounce(core, (a, b), (instant.t, instant.t - pace.started_at())) =>
            {
                StepEnd::AtElasticImpact
            }
            _ => StepEnd::AtEvent,
        };
        let mut advance = pace.note_end(instant.t, end, longest);
        let may_crowd = core.settings.crowding.steps();
        if pace.is_backing_off() && may_crowd {
            // Steps that tolerate violations would break Coulomb's law; time steps keep it.
            advance = advance.and_then(|()| Err(pace.stalled(instant.t)));
        } else if pace.begins_to_back_off() {
            let what =
                "contact changes repeat at one instant: remaining violations are tolerated for a short time (backoff)";
            core.accounts.warn_of_tolerated(instant.t, what);
        }
        for &body in &instant.bodies {
            self.motions.tracks[body].pace = pace;
        }
        let limit = core.settings.max_events_per_step;
        if pace.events() > limit {
            return Err(SimulationError::TooManyEvents { limit, t_s: instant.t });
        }
        Ok(advance.err())
    }

    /// Whether an impact of two bodies at `t` (s) ends a bounce of this length (s) that is too low to be seen. Its
    /// height is `w T / 4`, w the speed of approach and T the length. Where a body rocks on its edge, or spins on it,
    /// such bounces follow each other without an end, whatever the restitution. One that never left the touch distance
    /// is not seen; nor is one below the error of a stretch of crowded events if forces have turned it round,
    /// `a T >= w` with the acceleration `a` towards each other. Bodies that go to and fro between others fly without
    /// one.
    fn ends_unseen_bounce(&self, core: &Core, (a, b): (usize, usize), (t, length_s): (f64, f64)) -> bool {
        let (model, states) = (&core.model, &self.motions.states);
        let touch = tolerances::touch_distance(model, states, a, b);
        let touches = contact_set::contacts_of_pair(model, states, a, b, touch);
        let approach = |touch: &FoundContact| -touch.kinematics.separation_rate;
        let Some(fastest) = touches.iter().max_by(|x, y| approach(x).total_cmp(&approach(y))) else { return true };
        let height = 0.25 * approach(fastest) * length_s;
        if height <= touch {
            return true;
        }
        let is_turned = || -self.free_separation_rate_change(core, t, fastest) * length_s >= approach(fastest);
        height <= core.settings.crowding_tolerance * tolerances::pair_size(model, a, b) && is_turned()
    }

    /// `chi''` of a contact at `t` (s) without contact forces, m/s^2.
    fn free_separation_rate_change(&self, core: &Core, t: f64, contact: &FoundContact) -> f64 {
        let (model, states, id) = (&core.model, &self.motions.states, contact.id);
        let members = id.members().map(|(body, _)| body);
        let movable: Vec<usize> = members.filter(|&body| model.bodies[body].moves()).collect();
        let loads = model.loads_on(t, states, &movable);
        let geometry = &contact.kinematics.geometry;
        let at_point = |body: usize| {
            if !movable.contains(&body) {
                return DVec3::ZERO;
            }
            let (linear, angular) = free_acceleration(model, states, &loads, body);
            linear + angular.cross(geometry.point - states[body].pose.translation)
        };
        let driven = prescribed::prescribed_acceleration_of(model, t, states, id, geometry);
        geometry.normal.dot(id.relative(at_point)) + contact.kinematics.acceleration_bias + driven
    }

    /// Continues the motion of the bodies of a resolved instant.
    pub(super) fn continue_motion(&mut self, core: &mut Core, instant: Instant) -> Result<(), SimulationError> {
        let (t, bodies) = (instant.t, instant.bodies.clone());
        let firsts = self.form_islands(core, instant)?;
        self.look_ahead(core, &bodies, &firsts, t)
    }

    /// Stores the contacts of a resolved instant and forms the islands of its bodies. Returns the first body of each
    /// island.
    pub(super) fn form_islands(&mut self, core: &mut Core, instant: Instant) -> Result<Vec<usize>, SimulationError> {
        let Instant { t, bodies, pairs, touches, speed_scale, change, .. } = instant;
        for pair in pairs {
            self.schedule.contacts.set(pair, Vec::new());
        }
        for of_pair in touches.chunk_by(|x, y| (x.id.a, x.id.b) == (y.id.a, y.id.b)) {
            self.schedule.contacts.set((of_pair[0].id.a, of_pair[0].id.b), of_pair.to_vec());
        }
        for &body in &bodies {
            self.motions.scratch[body] = self.motions.states[body];
            self.motions.tracks[body].speed_scale =
                speed_scale.max(tolerances::point_speed(&core.model, &self.motions.states, body));
            if !self.motions.states[body].is_finite() {
                return Err(SimulationError::Diverged { body: core.model.bodies[body].name.clone(), t_s: t });
            }
        }
        let is = |mode: fn(&Mode) -> bool| -> Vec<usize> {
            bodies.iter().copied().filter(|&body| mode(&self.motions.tracks[body].mode)).collect()
        };
        let (constrained, stepped) = (is(|m| matches!(m, Mode::Constrained)), is(|m| matches!(m, Mode::Stepped)));
        let moved = |body: usize| constrained.binary_search(&body).is_ok();
        let held = touches.iter().enumerate().filter(|(_, touch)| touch.hold == Hold::Held);
        let held = held.filter(|(_, touch)| moved(touch.id.a) || moved(touch.id.b));
        let held = held.map(|(index, touch)| (index, touch.id.a, touch.id.b));
        let mut firsts = Vec::new();
        for group in coupled_groups(&core.model, held, &constrained) {
            let active: ActiveContacts = group.contacts.iter().map(|&i| &touches[i]).collect();
            // Slips that end take short steps, whose length says nothing about the motion afterwards.
            if !change.stopping.is_empty() && !active.slides() {
                for &body in &group.bodies {
                    self.motions.tracks[body].proposed_step_s = core.settings.step_s;
                }
            }
            firsts.extend(self.begin_island(core, group.bodies, active, t)?);
        }
        for group in coupled_groups(&core.model, std::iter::empty(), &stepped) {
            firsts.extend(self.begin_island(core, group.bodies, ActiveContacts::default(), t)?);
        }
        Ok(firsts)
    }

    /// Forms an island with its first step. Returns its first body.
    fn begin_island(
        &mut self,
        core: &mut Core,
        bodies: Vec<usize>,
        active: ActiveContacts,
        t: f64,
    ) -> Result<Option<usize>, SimulationError> {
        let pace = self.motions.pace_of(core, &bodies);
        for &body in &bodies {
            self.motions.tracks[body].pace = pace;
        }
        let step = self.first_step(core, &bodies, &active, t)?;
        Ok(self.motions.insert_island(Island::beginning(bodies, active, t, step)))
    }

    /// The first step of an island.
    fn first_step(
        &mut self,
        core: &mut Core,
        bodies: &[usize],
        active: &ActiveContacts,
        t: f64,
    ) -> Result<Step, SimulationError> {
        if core.is_end_of_run(t) && !self.goes_on {
            return Ok(Step::Waiting(t));
        }
        if bodies.iter().all(|&body| matches!(self.motions.tracks[body].mode, Mode::Stepped)) {
            let first = FreeStep::first(core, bodies, &self.motions.states, t);
            return self.motions.free_or_constrained(core, bodies, t, first);
        }
        match self.motions.constrained_step(core, bodies, active, t) {
            // A contact point moves or jumps faster than any step can follow.
            Err(SimulationError::StepTooSmall { .. })
                if !active.held().is_empty() && core.settings.crowding.steps() =>
            {
                Ok(Step::Waiting(t))
            }
            step => Ok(Step::Constrained(Box::new(step?))),
        }
    }

    /// Begins steps of the islands that have none, because the run has ended.
    ///
    /// # Errors
    /// When no step is possible.
    pub(super) fn continue_after_end_of_run(&mut self, core: &mut Core) -> Result<(), SimulationError> {
        self.goes_on = true;
        for first in self.motions.waiting_islands() {
            let Some(island) = self.motions.take_island(first) else { continue };
            let (bodies, t) = (island.bodies.clone(), island.t);
            prescribed::prescribe(&core.model, t, &mut self.motions.states);
            let step = self.first_step(core, &bodies, &island.active, t)?;
            self.motions.insert_island(Island { step, ..island });
            self.look_ahead(core, &bodies, &[first], t)?;
        }
        Ok(())
    }

    /// Ends the step of an island at `t` without an event, and begins the next one.
    ///
    /// # Errors
    /// When no step is possible.
    pub(super) fn next_step(&mut self, core: &mut Core, first: usize, t: f64) -> Result<(), SimulationError> {
        let Some(mut island) = self.remove_island(first) else { return Ok(()) };
        prescribed::prescribe(&core.model, t, &mut self.motions.states);
        let balance = self.motions.end_motion(core, &mut island, t)?;
        self.finish_step(core, &island, balance, t)?;
        let Island { bodies, mut active, step, .. } = island;
        let mut pace = self.motions.pace_of(core, &bodies);
        let longest = core.settings.step_s;
        let slides = active.slides();
        let end = if slides { StepEnd::AsPlannedSliding } else { StepEnd::AsPlanned };
        let mut advance = pace.note_end(t, end, longest);
        if slides {
            advance = advance.and(pace.note_mean_sliding_step(t, longest));
        } else if !active.held().is_empty() {
            advance = advance.and(pace.note_mean_step(t, longest));
        }
        for &body in &bodies {
            self.motions.tracks[body].pace = pace;
            self.motions.scratch[body] = self.motions.states[body];
        }
        if let Err(stuck) = advance {
            let instant = self.end_islands(core, t, bodies)?;
            return self.begin_stretch(core, instant, stuck);
        }
        let step = match step {
            Step::Free(step) if !core.is_end_of_run(t) => {
                let next = step.next(core);
                self.motions.free_or_constrained(core, &bodies, t, next)?
            }
            _ => {
                active.renew_directions(&core.model, &self.motions.states);
                self.first_step(core, &bodies, &active, t)?
            }
        };
        let of_island = bodies.clone();
        let island = Island::beginning(bodies, active, t, step);
        let firsts: Vec<usize> = self.motions.insert_island(island).into_iter().collect();
        self.look_ahead(core, &of_island, &firsts, t)
    }

    /// Locates the next events after `t` of these bodies and of the islands that they form.
    pub(super) fn look_ahead(
        &mut self,
        core: &mut Core,
        bodies: &[usize],
        firsts: &[usize],
        t: f64,
    ) -> Result<(), SimulationError> {
        if bodies.iter().any(|&body| matches!(self.motions.tracks[body].mode, Mode::Flight(_))) {
            self.schedule.begin_flight_boxes(core, t);
        }
        self.schedule.renew_boxes(core, &self.motions, bodies, t)?;
        for &first in firsts {
            let Some(mut island) = self.motions.take_island(first) else { continue };
            island.due = island.end();
            if let Step::Waiting(_) = island.step {
                // No step was found before the end of the run: time steps advance the island.
                island.is_unsolved = self.goes_on || !core.is_end_of_run(t);
                island.due = if island.is_unsolved { t } else { f64::INFINITY };
            }
            if let Step::Constrained(step) = &island.step {
                let pace = self.motions.pace_of(core, &island.bodies);
                match self.motions.locate_contact_change(core, step, step.end, &pace) {
                    Ok(Some(change)) => {
                        (island.due, island.changes, island.change) = (change.t, true, change);
                    }
                    Ok(None) => {}
                    Err(SimulationError::ContactSolve { .. }) if core.settings.crowding.steps() => {
                        (island.due, island.is_unsolved) = (t, true);
                    }
                    Err(error) => return Err(error),
                }
            }
            self.schedule.agenda.add(island.due, Due::Island(first));
            self.motions.insert_island(island);
        }
        self.schedule.search_pairs(core, &self.motions, bodies, t, Search::All)
    }
}

impl Motions {
    /// Whether two bodies touch at `t`.
    pub(super) fn touch_at(&mut self, core: &Core, (a, b): (usize, usize), t: f64) -> Result<bool, SimulationError> {
        let Some((shape_a, shape_b)) = contact_kinematics::shapes(&core.model, a, b) else { return Ok(false) };
        let (state_a, state_b) = (self.state_at(core, a, t)?, self.state_at(core, b, t)?);
        let mut states = std::mem::take(&mut self.scratch);
        (states[a], states[b]) = (state_a, state_b);
        let reach = tolerances::touch_distance(&core.model, &states, a, b);
        let boxes = aabb_of(shape_a, &state_a.pose).and_then(|aabb| aabb.inflated(reach));
        // A shape without a bounding box may be anywhere.
        let apart = boxes.is_ok_and(|a| aabb_of(shape_b, &state_b.pose).is_ok_and(|b| !a.overlaps(&b)));
        let touch = !apart && !contact_set::contacts_of_pair(&core.model, &states, a, b, reach).is_empty();
        self.restore_scratch(core, states, &[a, b]);
        Ok(touch)
    }

    /// Advances the bodies of an island to `t`, within its step or at its end, and books the smooth motion up to there.
    /// Returns whether it was smooth: time steps project contacts themselves.
    fn end_motion(&mut self, core: &mut Core, island: &mut Island, t: f64) -> Result<bool, SimulationError> {
        let (states, received) = match &mut island.step {
            Step::Constrained(step) => {
                let mut end = self.constrained_end(core, step, t)?;
                if island.changes && island.due <= t && self.misses_ends(core, step, &island.change.stopping, &end) {
                    end = step.at(t);
                }
                (end.states, end.received)
            }
            Step::Free(step) => {
                let about = core.accounts.books.ledger.momentum.about;
                free_end(&core.model, step, &island.bodies, &self.states, about, t)?
            }
            Step::Crowd(step) => {
                let (states, report) = self.crowd_end(core, step, &island.bodies, t)?;
                set_states(&mut self.states, &island.bodies, &states);
                turns::count_turns(&mut core.model, &self.states, &island.bodies)?;
                core.note_crowd_step(t, &self.states, &report);
                return Ok(false);
            }
            Step::Waiting(_) => return Ok(false),
        };
        let before = core.accounts.books.balance(&core.model, &self.states, &island.bodies);
        for (&body, mut state) in island.bodies.iter().zip(states) {
            core.model.keep_in_plane(body, &mut state);
            self.states[body] = state;
        }
        turns::count_turns(&mut core.model, &self.states, &island.bodies)?;
        let integrated = core.accounts.books.balance(&core.model, &self.states, &island.bodies);
        core.accounts.books.smooth_stage(before, integrated, received);
        Ok(true)
    }

    /// Checks that the bodies of an island are finite, and measures penetration and speed.
    fn check(&mut self, core: &mut Core, bodies: &[usize], held: &[ContactId], t: f64) -> Result<(), SimulationError> {
        for &body in bodies {
            if !self.states[body].is_finite() {
                return Err(SimulationError::Diverged { body: core.model.bodies[body].name.clone(), t_s: t });
            }
            self.tracks[body].speed_scale =
                self.tracks[body].speed_scale.max(tolerances::point_speed(&core.model, &self.states, body));
        }
        // The separation of a contact point measures penetration only while the point lies on its features. Held
        // contacts satisfy this; other contacts are measured when they are detected.
        for &id in held {
            if let Some(kinematics) = contact_kinematics::kinematics(&core.model, &self.states, id) {
                core.note_contact(t, &self.states, (id.a, id.b), &kinematics);
            }
        }
        Ok(())
    }

    /// The pace of the slowest of some movable bodies.
    pub(super) fn pace_of(&self, core: &Core, bodies: &[usize]) -> Pace {
        let paces = bodies.iter().filter(|&&body| core.model.bodies[body].moves()).map(|&body| self.tracks[body].pace);
        paces.reduce(Pace::slower).unwrap_or_default()
    }
}
