//! Queries at the present: the state of a body, the touching contacts, the groups that they form.

use super::engine::Engine;
use super::hold::Forces;
use super::island::Step;
use super::motions::{Mode, Motions, Track};
use super::present_crowds::StepKey;
use crate::collision::touch::{Hold, Touch};
use crate::collision::{contact_kinematics, contact_set};
use crate::error::SimulationError;
use crate::model::{prescribed, reported, tolerances};
use crate::report::frame::MotionKind;
use crate::report::observer::BodySample;
use crate::rows::groups::{coupled_groups, groups};
use crate::scene::effects::Effects;
use crate::tier::core::Core;
use polhode_dynamics::BodyState;

impl Motions {
    /// State of a body at the present; the states of others are not evaluated.
    pub(super) fn present_state(&self, core: &Core, body: usize) -> BodyState {
        let t = core.t;
        if let Some(state) = self.state_cache.at(t).and_then(|states| states.get(body)) {
            return *state;
        }
        if let Mode::Flight(flight) = &self.tracks[body].mode {
            return flight.state(t);
        }
        if let Some(state) = prescribed::prescribed_state(&core.model, body, t) {
            return state;
        }
        let start = self.states[body];
        let Some(island) = self.island_of(body).filter(|island| island.t != t) else { return start };
        let Ok(place) = island.bodies.binary_search(&body) else { return start };
        let present = match &island.step {
            Step::Constrained(step) => step.state_at(body, t),
            Step::Free(step) => step.present().get(place).copied(),
            Step::Crowd(step) => {
                let key = StepKey::new(island.first().unwrap_or(body), step.t, step.end);
                self.present_crowds.state((body, key), t, &self.states, |states| {
                    // As in `Engine::states`.
                    let _ = step.advance_to(&core.model, &island.bodies, t, states);
                })
            }
            Step::Waiting(_) => None,
        };
        present.unwrap_or(start)
    }

    /// A body at the present as it is reported. The flight record contains the body's mass properties, which are close
    /// in memory to the data just read.
    pub(super) fn present_sample(&self, core: &Core, body: usize) -> BodySample {
        self.sample_in(core, body, &self.present_state(core, body))
    }

    /// A body in this state as it is reported.
    pub(super) fn sample_in(&self, core: &Core, body: usize, state: &BodyState) -> BodySample {
        match &self.tracks[body].mode {
            Mode::Flight(flight) => reported::sample_of(&core.model, body, flight.body(), state),
            _ => reported::sample(&core.model, body, state),
        }
    }
}

impl Engine {
    /// The touching contacts of the last evaluation, evaluated in these states.
    pub(super) fn present_contacts(&self, core: &Core, states: &[BodyState]) -> Vec<Touch> {
        let present = |touch: &Touch| {
            Some(Touch { kinematics: contact_kinematics::kinematics(&core.model, states, touch.id)?, ..*touch })
        };
        self.schedule.contacts.all().filter_map(present).collect()
    }

    /// Bodies connected by contacts that neither approach nor separate, and those contacts.
    pub(super) fn present_groups(&self, core: &Core, states: &[BodyState]) -> Vec<(Vec<usize>, Vec<Touch>)> {
        let mut contacts = self.present_contacts(core, states);
        let scale_of = |touch: &Touch| {
            self.motions.tracks[touch.id.a].speed_scale.max(self.motions.tracks[touch.id.b].speed_scale)
        };
        if !self.begun {
            for touch in &mut contacts {
                touch.modes.friction = self.motions.slide_of(core, scale_of(touch), touch);
                touch.modes.rotation = self.motions.rotation_of(core, scale_of(touch), touch);
            }
        }
        let sustained = |touch: &Touch| {
            let scale = scale_of(touch);
            // Within the step of an island, its contacts are the held ones.
            if self.begun { touch.hold == Hold::Held } else { self.motions.is_sustained(core, scale, touch) }
        };
        let kept = contacts.iter().enumerate().filter(|(_, touch)| sustained(touch));
        let mut found: Vec<(Vec<usize>, Vec<Touch>)> =
            groups(&core.model, kept.map(|(index, touch)| (index, touch.id.a, touch.id.b)))
                .into_iter()
                .map(|group| (group.bodies, group.contacts.iter().map(|&i| contacts[i]).collect()))
                .collect();
        // A pivoted body without contacts is a group of its own, and so are jointed ones together.
        for &body in &core.model.joints.held_by_rows {
            if !found.iter().any(|(bodies, _)| bodies.binary_search(&body).is_ok()) {
                found.push((core.model.joints.with_jointed(vec![body]), Vec::new()));
            }
        }
        found
    }

    /// Bodies that move together, and those that rest together: each ascending, in the order of their first bodies.
    pub(super) fn present_islands(&self, core: &Core) -> Vec<Vec<usize>> {
        let model = &core.model;
        let joins = |contacts: &[&Touch], bodies: &[usize]| {
            let contacts = contacts.iter().enumerate().map(|(index, touch)| (index, touch.id.a, touch.id.b));
            coupled_groups(model, contacts, bodies).into_iter().map(|group| group.bodies).collect::<Vec<_>>()
        };
        if !self.begun {
            let held: Vec<Touch> =
                self.present_groups(core, &self.motions.states).into_iter().flat_map(|(_, held)| held).collect();
            let loaded =
                model.movable.iter().copied().filter(|&body| model.bodies[body].moves() && model.is_loaded(body));
            return joins(&held.iter().collect::<Vec<_>>(), &loaded.collect::<Vec<_>>());
        }
        let rests = |body: usize| matches!(self.motions.tracks[body].mode, Mode::Rest);
        let connects = |touch: &&Touch| touch.hold == Hold::Held && rests(touch.id.a) && rests(touch.id.b);
        let connecting: Vec<&Touch> = self.schedule.contacts.all().filter(connects).collect();
        let resting: Vec<usize> = model.movable.iter().copied().filter(|&body| rests(body)).collect();
        let mut found = joins(&connecting, &resting);
        found.extend(self.motions.islands.values().map(|island| island.bodies.clone()));
        found.sort_unstable();
        found
    }

    /// How each body moves; before the first instant, as its contacts and forces suggest.
    pub(super) fn present_motions(&self, core: &Core) -> Vec<MotionKind> {
        let kind = |track: &Track| match track.mode {
            Mode::Fixed | Mode::Prescribed => MotionKind::Given,
            Mode::Flight(_) => MotionKind::Flight,
            Mode::Constrained | Mode::Stepped | Mode::Crowded(_) => MotionKind::Integrated,
            Mode::Rest => MotionKind::Rest,
        };
        let mut kinds: Vec<MotionKind> = self.motions.tracks.iter().map(kind).collect();
        if !self.begun {
            for body in (0..kinds.len()).filter(|&body| core.model.bodies[body].moves()) {
                kinds[body] = MotionKind::Flight;
            }
            for body in self.present_islands(core).into_iter().flatten() {
                kinds[body] = MotionKind::Integrated;
            }
        }
        kinds
    }

    /// With all effects on, the forces of resting groups are computed at every step although nothing has changed.
    pub(super) fn refresh_resting_forces(&mut self, core: &mut Core) -> Result<(), SimulationError> {
        if core.effects == Effects::Planned {
            return Ok(());
        }
        let rest = |body: usize| matches!(self.motions.tracks[body].mode, Mode::Rest);
        let known: Vec<Touch> = self.schedule.contacts.all().copied().collect();
        let resting = known
            .iter()
            .enumerate()
            .filter(|(_, touch)| touch.hold == Hold::Held && (rest(touch.id.a) || rest(touch.id.b)))
            .map(|(index, touch)| (index, touch.id.a, touch.id.b));
        for group in groups(&core.model, resting) {
            let mut pairs: Vec<_> = group.contacts.iter().map(|&i| (known[i].id.a, known[i].id.b)).collect();
            pairs.dedup();
            let mut contacts = Vec::with_capacity(group.contacts.len());
            for (a, b) in pairs {
                let reach = tolerances::touch_distance(&core.model, &self.motions.states, a, b);
                contacts.extend(
                    contact_set::contacts_of_pair(&core.model, &self.motions.states, a, b, reach)
                        .into_iter()
                        .map(Touch::from),
                );
            }
            for touch in &mut contacts {
                // Contacts that were known keep their status as a warm start.
                if let Ok(index) = known.binary_search_by(|known| known.id.cmp(&touch.id)) {
                    touch.hold = known[index].hold;
                }
            }
            let forces =
                Forces::solve(&core.model, core.t, &self.motions.states, &group.bodies, &contacts, &mut core.memory)
                    .map_err(|source| SimulationError::of_response(core.t, source))?;
            core.accounts.note_solve(core.t, &forces.solution.report)?;
        }
        Ok(())
    }
}
