//! The interface of the tier: it advances to a time or to the first event before it, and reports the states at the
//! present.

use super::engine::Engine;
use super::free_stepping::free_end;
use super::hold::Forces;
use super::island::{Island, Step};
use super::motions::{Mode, Track, book_flight};
use crate::accounting::Accounts;
use crate::accounting::books::Received;
use crate::collision::contact_view;
use crate::error::SimulationError;
use crate::identity::body_id::BodyId;
use crate::model::{prescribed, reported, tolerances};
use crate::report::acceleration::Acceleration;
use crate::report::frame::{ContactView, IslandView, JointView, MotionKind, PivotView};
use crate::report::observer::{BodySample, Observer};
use crate::rows::assembly::free_acceleration;
use crate::scene::effects::Effects;
use crate::snapshot::content;
use crate::tier::core::Core;
use crate::tier::{Reached, Tier};
use polhode_dynamics::BodyState;
use polhode_response::Memory;
use polhode_spatial::DVec3;
use std::collections::BTreeMap;

/// Samples between two returns to the caller while all bodies are in free flight and cannot collide.
const SAMPLES_OF_FREE_FLIGHT: f64 = 256.0;

impl Tier for Engine {
    fn advance(
        &mut self,
        core: &mut Core,
        limit_s: f64,
        observer: &mut dyn Observer,
    ) -> Result<Reached, SimulationError> {
        if !self.begun {
            self.motions.state_cache.invalidate();
            self.begin(core)?;
        }
        self.refresh_resting_forces(core)?;
        if core.is_end_of_run(core.t) && limit_s > core.t {
            self.continue_after_end_of_run(core)?;
        }
        while let Some((t, due)) = self.schedule.agenda.first().filter(|&(t, _)| t <= limit_s) {
            self.emit_samples(core, t, observer)?;
            core.t = t;
            self.schedule.agenda.remove(t, due);
            let reached = self.process(core, t, due)?;
            if reached == Reached::Event {
                core.accounts.count_step();
            }
            self.motions.observe(core)?;
            let more = self.schedule.agenda.first().is_some_and(|(next, _)| next <= t);
            // Islands whose steps end at the same time are one step for the observer.
            if reached == Reached::Event || (reached == Reached::StepEnd && !more && t < limit_s) {
                self.motions.set_present(core)?;
                core.accounts.emit_events(core.t, observer);
                return Ok(reached);
            }
        }
        self.emit_samples(core, limit_s, observer)?;
        if self.motions.islands.is_empty() {
            core.accounts.count_step();
        }
        core.t = limit_s;
        self.motions.set_present(core)?;
        core.accounts.emit_events(core.t, observer);
        Ok(Reached::Limit)
    }

    /// Without events, islands end their own steps. Free flight needs no steps, but returns to the observer from time
    /// to time.
    fn stride(&self, core: &Core) -> f64 {
        let rests = |track: &Track| matches!(track.mode, Mode::Fixed | Mode::Rest);
        if core.effects == Effects::All {
            core.settings.step_s
        } else if self.motions.tracks.iter().all(rests) {
            f64::INFINITY
        } else if !core.model.surfaces.may_collide() {
            core.settings.step_s.max(SAMPLES_OF_FREE_FLIGHT * core.model.scene.output_interval_s())
        } else {
            core.settings.step_s
        }
    }

    fn states(&self, core: &Core) -> Vec<BodyState> {
        if let Some(states) = self.motions.state_cache.at(core.t) {
            return states.to_vec();
        }
        let mut states = Vec::with_capacity(self.motions.states.len());
        self.motions.write_flying_states(core, core.t, &mut states);
        for island in self.motions.islands.values().filter(|island| island.t != core.t) {
            match &island.step {
                Step::Constrained(step) => step.states_at(&core.model, core.t, &mut states),
                Step::Free(step) => {
                    for (&body, state) in island.bodies.iter().zip(step.present()) {
                        states[body] = *state;
                    }
                }
                Step::Crowd(step) => {
                    // A step that could be made to its end can be made to an instant within it. If rounding makes it
                    // fail, the states are those at its start.
                    let _ = step.advance_to(&core.model, &island.bodies, core.t, &mut states);
                }
                Step::Waiting(_) => {}
            }
        }
        states
    }

    fn state(&self, core: &Core, body: usize) -> BodyState {
        self.motions.present_state(core, body)
    }

    fn sample(&self, core: &Core, body: usize) -> BodySample {
        self.motions.present_sample(core, body)
    }

    fn samples(&self, core: &Core) -> Vec<BodySample> {
        let sample = |(body, state): (usize, &BodyState)| self.motions.sample_in(core, body, state);
        match self.motions.state_cache.at(core.t) {
            Some(states) => states.iter().enumerate().map(sample).collect(),
            None => self.states(core).iter().enumerate().map(sample).collect(),
        }
    }

    fn book_present(&mut self, core: &Core, accounts: &mut Accounts) -> Result<(), SimulationError> {
        let (model, t) = (&core.model, core.t);
        let books = &mut accounts.books;
        let mut states = self.motions.states.clone();
        for (body, track) in self.motions.tracks.iter().enumerate() {
            match &track.mode {
                Mode::Flight(flight) => book_flight(model, books, (body, flight), t, &mut states),
                Mode::Rest => books.equilibrium(model, &states, body, t - track.rest_booked_s),
                Mode::Fixed | Mode::Prescribed | Mode::Constrained | Mode::Stepped | Mode::Crowded(_) => {}
            }
        }
        let crowds: Vec<usize> =
            self.motions.islands.iter().filter(|(_, own)| own.is_crowd()).map(|(&first, _)| first).collect();
        for first in crowds {
            let Some(island) = self.motions.islands.remove(&first) else { continue };
            if let Step::Crowd(step) = &island.step
                && island.t != t
            {
                let (_, report) = self.motions.crowd_end(core, step, &island.bodies, t)?;
                books.enter(&report.books);
            }
            self.motions.islands.insert(first, island);
        }
        let smooth = |island: &&mut Island| island.t != t && !island.is_crowd();
        for island in self.motions.islands.values_mut().filter(smooth) {
            let before = books.balance(model, &states, &island.bodies);
            let received = match &mut island.step {
                Step::Constrained(step) => {
                    step.states_at(model, t, &mut states);
                    step.received_until(t)
                }
                Step::Free(step) => {
                    let about = books.ledger.momentum.about;
                    let (ends, received) = free_end(model, step, &island.bodies, &states, about, t)?;
                    for (&body, state) in island.bodies.iter().zip(ends) {
                        states[body] = state;
                    }
                    received
                }
                Step::Crowd(_) | Step::Waiting(_) => Received::default(),
            };
            let after = books.balance(model, &states, &island.bodies);
            books.smooth_stage(before, after, received);
        }
        Ok(())
    }

    fn accelerations(&mut self, core: &mut Core) -> Result<Vec<Acceleration>, SimulationError> {
        let states = self.states(core);
        let model = &core.model;
        let loads = model.loads(core.t, &states);
        let mut out: Vec<_> = (0..model.bodies.len())
            .map(|body| {
                let (linear, angular) = if prescribed::trajectory(model, body).is_some() {
                    prescribed::prescribed_acceleration(model, body, core.t)
                } else {
                    free_acceleration(model, &states, &loads, body)
                };
                reported::reported_acceleration(model, body, &states[body], linear, angular)
            })
            .collect();
        for (group, members) in self.present_groups(core, &states) {
            let forces = Forces::solve(&core.model, core.t, &states, &group, &members, &mut core.memory)
                .map_err(|source| SimulationError::of_response(core.t, source))?;
            core.accounts.note_solve(core.t, &forces.solution.report)?;
            for (body, linear, angular) in forces.accelerations() {
                out[body] = reported::reported_acceleration(&core.model, body, &states[body], linear, angular);
            }
        }
        Ok(out)
    }

    fn contacts(&self, core: &Core, t: f64, states: &[BodyState]) -> Vec<ContactView> {
        let mut solver = Memory::default();
        let mut forces_by_id = BTreeMap::new();
        for (group, members) in self.present_groups(core, states) {
            let solved = Forces::solve(&core.model, t, states, &group, &members, &mut solver);
            forces_by_id.extend(members.iter().enumerate().map(|(index, touch)| match &solved {
                Ok(forces) => {
                    let normal = forces.solution.reactions.get(index).copied().unwrap_or(f64::NAN);
                    let friction = forces.friction(index).map_or(DVec3::ZERO, |friction| friction.force);
                    (touch.id, (normal, friction))
                }
                Err(_) => (touch.id, (f64::NAN, DVec3::NAN)),
            }));
        }
        let mut views = Vec::new();
        for touch in self.present_contacts(core, states) {
            let (id, geometry) = (touch.id, touch.kinematics.geometry);
            let force = forces_by_id.get(&id).copied();
            // A contact that has opened since its last evaluation no longer touches.
            if force.is_none() && geometry.separation > tolerances::touch_distance(&core.model, states, id.a, id.b) {
                continue;
            }
            contact_view::view_contact(&core.model, states, &touch, force.unwrap_or_default(), &mut views);
        }
        views
    }

    fn pivots(&self, core: &Core, t: f64, states: &[BodyState]) -> Vec<PivotView> {
        self.pivot_views(core, t, states)
    }

    fn joint_loads(&self, core: &Core, t: f64, states: &[BodyState]) -> Vec<JointView> {
        self.joint_views(core, t, states)
    }

    fn motions(&self, core: &Core) -> Vec<MotionKind> {
        self.present_motions(core)
    }

    fn islands(&self, core: &Core) -> Vec<IslandView> {
        let ids = |bodies: Vec<usize>| bodies.into_iter().map(BodyId::new).collect();
        self.present_islands(core).into_iter().map(|bodies| IslandView { bodies: ids(bodies) }).collect()
    }

    fn interrupt(&mut self, core: &mut Core, bodies: &[usize]) -> Result<(), SimulationError> {
        self.motions.state_cache.invalidate();
        self.motions.present_crowds.invalidate();
        self.interrupt_bodies(core, bodies)
    }

    fn states_mut(&mut self) -> &mut [BodyState] {
        self.motions.state_cache.invalidate();
        self.motions.present_crowds.invalidate();
        &mut self.motions.states
    }

    fn resume(&mut self, core: &mut Core, moved: &[usize]) -> Result<(), SimulationError> {
        self.motions.state_cache.invalidate();
        self.motions.present_crowds.invalidate();
        self.resume_bodies(core, moved)
    }

    fn add_body(&mut self, core: &Core, state: BodyState) {
        self.motions.state_cache.invalidate();
        self.make_room(core, state);
    }

    fn remove_body(&mut self, body: usize) {
        self.motions.state_cache.invalidate();
        self.forget_body(body);
    }

    fn change_joint(&mut self, core: &mut Core, pair: (usize, usize)) {
        self.change_contacts_of_joint(&core.model, pair);
    }

    fn touching_pairs(&self) -> usize {
        self.schedule.contacts.pairs()
    }

    fn save(&self) -> content::Tier {
        content::Tier::Accurate(self.saved())
    }
}
