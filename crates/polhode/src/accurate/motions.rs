//! The states of all bodies, and how each of them moves until the next event: who asks for a state at a time asks here.

use super::crowd_step::Crowd;
use super::free_stepping::FreeStep;
use super::island::{Island, Step};
use super::pace::Pace;
use super::present_crowds::PresentCrowds;
use super::state_cache::StateCache;
use crate::accounting::books::{Books, Received, gravity_at};
use crate::collision::active_contacts::ActiveContacts;
use crate::error::SimulationError;
use crate::model::{Model, prescribed};
use crate::scene::Integrator;
use crate::tier::core::Core;
use polhode_dynamics::integrator::IntegrationError;
use polhode_dynamics::{BodyState, Flight};
use std::collections::BTreeMap;
use std::sync::Arc;

/// How a body moves until the next event.
#[derive(Debug, Clone)]
pub(super) enum Mode {
    /// Never.
    Fixed,
    /// As prescribed, whatever acts on it.
    Prescribed,
    /// Free flight, by its flight record.
    Flight(Box<Flight>),
    /// Constrained motion, with held contacts or under forces: integrated by DOP853, or by RK4 if the scene names it.
    Constrained,
    /// By the integrator of free motion.
    Stepped,
    /// By time steps, in a stretch of crowded events.
    Crowded(Crowd),
    /// At rest: its group is in verified equilibrium at zero velocity.
    Rest,
}

/// How a body moves, with the history that its further motion needs.
#[derive(Debug, Clone)]
pub(super) struct Track {
    pub(super) mode: Mode,
    /// The island it moves in, by its first body.
    pub(super) island: Option<usize>,
    pub(super) pace: Pace,
    /// Step proposed by the error control, s.
    pub(super) proposed_step_s: f64,
    /// Largest speed so far of the body or of any it has been in contact with, at least that of a fall over its size,
    /// m/s.
    pub(super) speed_scale: f64,
    /// Time up to which its rest has been booked, s.
    pub(super) rest_booked_s: f64,
    /// Length of the last stretch of crowded events that it was in, s.
    pub(super) last_stretch_s: f64,
    /// Whether forces on it have grown too strong for the splitting that the plan has chosen.
    pub(super) gave_up_splitting: bool,
}

impl Track {
    /// A new body at the present.
    pub(super) fn new(core: &Core, body: usize) -> Self {
        Self {
            mode: if prescribed::trajectory(&core.model, body).is_some() { Mode::Prescribed } else { Mode::Fixed },
            island: None,
            pace: Pace::starting_at(core.t),
            proposed_step_s: core.settings.step_s,
            speed_scale: 0.0,
            rest_booked_s: core.t,
            last_stretch_s: 0.0,
            gave_up_splitting: false,
        }
    }
}

/// The states of all bodies, and how each of them moves.
#[derive(Debug)]
pub(super) struct Motions {
    /// Of bodies in an island the states at the start of its step, of bodies in flight those at the start of their
    /// record or at their last event, of kinematic bodies those at the event or step being processed.
    pub(super) states: Vec<BodyState>,
    /// A copy of `states`, used to evaluate other times.
    pub(super) scratch: Vec<BodyState>,
    pub(super) tracks: Vec<Track>,
    pub(super) islands: BTreeMap<usize, Island>,
    /// Free rotations of bodies in integrated islands on which no moment acts.
    pub(super) spins: BTreeMap<usize, Flight>,
    /// Time of the last observation of energies and momenta, s.
    pub(super) observed_s: f64,
    pub(super) state_cache: StateCache,
    pub(super) present_crowds: PresentCrowds,
}

impl Motions {
    /// Those of bodies in these states at the present, in no island yet.
    pub(super) fn new(core: &Core, states: Vec<BodyState>) -> Self {
        Self {
            scratch: states.clone(),
            tracks: (0..states.len()).map(|body| Track::new(core, body)).collect(),
            states,
            islands: BTreeMap::new(),
            spins: BTreeMap::new(),
            observed_s: core.t,
            state_cache: StateCache::default(),
            present_crowds: PresentCrowds::default(),
        }
    }

    /// Evaluates those present states whose evaluation changes an integrator.
    pub(super) fn set_present(&mut self, core: &Core) -> Result<(), SimulationError> {
        let work_before = core.model.work.total();
        for island in self.islands.values_mut() {
            if let Step::Free(step) = &mut island.step {
                step.set_present(&core.model, core.t)?;
            }
        }
        core.model.work.count_since(work_before, 0);
        Ok(())
    }

    /// Observes energies and momenta at the present, if a longest step has passed since the last observation.
    pub(super) fn observe(&mut self, core: &mut Core) -> Result<(), SimulationError> {
        if core.t - self.observed_s >= core.settings.step_s {
            self.observe_at(core, core.t)?;
        }
        Ok(())
    }

    /// Observes energies and momenta at `t` (s), a time within all present steps. Returns the states of all bodies
    /// there.
    ///
    /// # Errors
    /// When a state cannot be evaluated or is not finite.
    pub(super) fn observe_at(&mut self, core: &mut Core, t: f64) -> Result<Arc<Vec<BodyState>>, SimulationError> {
        if let Some(states) = self.state_cache.at(t) {
            return Ok(Arc::clone(states));
        }
        let work_before = core.model.work.total();
        let mut cache = std::mem::take(&mut self.state_cache);
        // The memory of the last states is reused, unless a caller still holds it.
        let states = Arc::make_mut(&mut cache.states);
        self.write_states_at(core, t, states)?;
        core.accounts.observe(&core.model, states, t)?;
        // What is evaluated between steps depends on what has been asked before.
        core.model.work.count_since(work_before, 0);
        self.observed_s = t;
        cache.t = self.islands.is_empty().then_some(t);
        self.state_cache = cache;
        Ok(Arc::clone(&self.state_cache.states))
    }

    /// The island of a body, if it is in one.
    pub(super) fn island_of(&self, body: usize) -> Option<&Island> {
        self.islands.get(&self.tracks[body].island?)
    }

    /// The island of this first body.
    pub(super) fn island(&self, first: usize) -> Option<&Island> {
        self.islands.get(&first)
    }

    /// Adds an island. Returns its first body.
    pub(super) fn insert_island(&mut self, island: Island) -> Option<usize> {
        let first = island.first()?;
        for &body in &island.bodies {
            self.tracks[body].island = Some(first);
        }
        self.islands.insert(first, island);
        Some(first)
    }

    /// The islands that have no step yet.
    pub(super) fn waiting_islands(&self) -> Vec<usize> {
        let waits = |island: &Island| matches!(island.step, Step::Waiting(_));
        self.islands.iter().filter(|(_, island)| waits(island)).map(|(&first, _)| first).collect()
    }

    /// Removes an island temporarily; its agenda entry remains.
    pub(super) fn take_island(&mut self, first: usize) -> Option<Island> {
        self.islands.remove(&first)
    }

    /// Restores the copy of the states after it was used for these bodies and for kinematic ones.
    pub(super) fn restore_scratch(&mut self, core: &Core, mut scratch: Vec<BodyState>, bodies: &[usize]) {
        for &body in bodies.iter().chain(&core.model.prescribed) {
            scratch[body] = self.states[body];
        }
        self.scratch = scratch;
    }

    /// State of a body at a time within its present step.
    ///
    /// # Errors
    /// When its integrator cannot evaluate it.
    pub(super) fn state_at(&mut self, core: &Core, body: usize, t: f64) -> Result<BodyState, SimulationError> {
        if let Mode::Flight(flight) = &self.tracks[body].mode {
            return Ok(flight.state(t));
        }
        if let Some(state) = prescribed::prescribed_state(&core.model, body, t) {
            return Ok(state);
        }
        let Some(first) = self.tracks[body].island else { return Ok(self.states[body]) };
        let Some(mut island) = self.islands.remove(&first) else { return Ok(self.states[body]) };
        let mut states = std::mem::take(&mut self.scratch);
        let written = write_states(core, &mut island, t, &mut states);
        let state = states[body];
        self.restore_scratch(core, states, &island.bodies);
        self.islands.insert(first, island);
        written.map(|()| state)
    }

    /// The states at `t` of a body and of all others of its island, which one evaluation gives.
    ///
    /// # Errors
    /// When an integrator cannot evaluate them.
    pub(super) fn states_with(
        &mut self,
        core: &Core,
        body: usize,
        t: f64,
    ) -> Result<Vec<(usize, BodyState)>, SimulationError> {
        let island = self.tracks[body].island.filter(|_| !matches!(self.tracks[body].mode, Mode::Flight(_)));
        let Some(mut island) = island.and_then(|first| self.islands.remove(&first)) else {
            return Ok(vec![(body, self.state_at(core, body, t)?)]);
        };
        let mut states = std::mem::take(&mut self.scratch);
        let written = write_states(core, &mut island, t, &mut states);
        let together = island.bodies.iter().map(|&member| (member, states[member])).collect();
        self.restore_scratch(core, states, &island.bodies);
        if let Some(&first) = island.bodies.first() {
            self.islands.insert(first, island);
        }
        written.map(|()| together)
    }

    /// Writes the states of all bodies at a time within all present steps.
    ///
    /// # Errors
    /// When an integrator cannot evaluate them.
    pub(super) fn write_states_at(
        &mut self,
        core: &Core,
        t: f64,
        states: &mut Vec<BodyState>,
    ) -> Result<(), SimulationError> {
        self.write_flying_states(core, t, states);
        for island in self.islands.values_mut().filter(|island| island.t != t) {
            write_states(core, island, t, states)?;
        }
        Ok(())
    }

    /// States of all bodies, those in flight and kinematic ones at `t`, the others at the start of their steps.
    pub(super) fn write_flying_states(&self, core: &Core, t: f64, states: &mut Vec<BodyState>) {
        states.clone_from(&self.states);
        let flights = self.tracks.iter().enumerate().filter_map(|(body, track)| match &track.mode {
            Mode::Flight(flight) => Some((body, &**flight)),
            _ => None,
        });
        Flight::write_states(flights, t, states);
        prescribed::prescribe(&core.model, t, states);
    }

    /// Mode of a body that no contact holds.
    pub(super) fn free_mode(&self, core: &Core, body: usize, t: f64) -> Option<Mode> {
        let model = &core.model;
        let rigid = model.bodies[body].rigid.as_ref()?;
        Some(match core.settings.integrator {
            _ if model.joints.is_held_by_rows(body) => Mode::Constrained,
            _ if core.settings.flies() && !model.is_loaded(body) => {
                // In planar motion the rotation is about a principal axis; rounding errors of the axis must not grow.
                let record = if model.planar.contains(body) { Flight::steady } else { Flight::new };
                Mode::Flight(Box::new(record(rigid, t, &self.states[body], model.free_acceleration(body))))
            }
            Integrator::Dop853 => Mode::Constrained,
            // Bodies coupled to bodies that may be in contact are integrated with them.
            _ if model.surfaces.may_collide() && model.is_coupled(body) => Mode::Constrained,
            _ if self.tracks[body].gave_up_splitting => Mode::Constrained,
            _ => Mode::Stepped,
        })
    }

    /// Begins free motion of a body from its state at `t`.
    pub(super) fn begin_free_motion(&mut self, core: &Core, body: usize, t: f64) {
        if let Some(mode) = self.free_mode(core, body, t) {
            self.tracks[body].mode = mode;
        }
    }

    /// The step of bodies that an integrator of free motion moves. If forces have become too strong for the splitting
    /// method that the plan has chosen, DOP853 continues from the present states.
    pub(super) fn free_or_constrained(
        &mut self,
        core: &mut Core,
        bodies: &[usize],
        t: f64,
        step: Result<FreeStep, SimulationError>,
    ) -> Result<Step, SimulationError> {
        let too_strong = |error: &SimulationError| {
            matches!(error, SimulationError::Integration { source: IntegrationError::StepTooSmall { .. }, .. })
        };
        match step {
            Ok(step) => Ok(Step::Free(Box::new(step))),
            Err(error) if core.settings.splits_by_choice() && too_strong(&error) => {
                let what = "forces have grown too strong for splitting: dop853 continues from here";
                core.accounts.warn_of_tolerated(t, what);
                for &body in bodies {
                    self.tracks[body].gave_up_splitting = true;
                    self.tracks[body].mode = Mode::Constrained;
                }
                let step = self.constrained_step(core, bodies, &ActiveContacts::default(), t)?;
                Ok(Step::Constrained(Box::new(step)))
            }
            Err(error) => Err(error),
        }
    }

    /// Books the flight of a body up to `t`, if it is in free flight.
    pub(super) fn book_flight(&mut self, core: &mut Core, body: usize, t: f64) {
        if let Mode::Flight(flight) = &self.tracks[body].mode {
            book_flight(&core.model, &mut core.accounts.books, (body, flight), t, &mut self.states);
        }
    }

    /// Books the rest of a body up to `t`, if it rests. The next interval of rest begins there.
    pub(super) fn book_rest(&mut self, core: &mut Core, body: usize, t: f64) {
        let track = &mut self.tracks[body];
        if matches!(track.mode, Mode::Rest) && t > track.rest_booked_s {
            core.accounts.books.equilibrium(&core.model, &self.states, body, t - track.rest_booked_s);
        }
        track.rest_booked_s = t;
    }
}

/// Books a flight up to `t`, with the energy error of its record. Sets the body's state to that at `t`.
pub(super) fn book_flight(
    model: &Model,
    books: &mut Books,
    (body, flight): (usize, &Flight),
    t: f64,
    states: &mut [BodyState],
) {
    let (start, dt) = (*flight.start(), t - flight.t0());
    states[body] = start;
    let before = books.balance(model, states, &[body]);
    // The mean position of the flight, for the moment of the weight. The fall along gravity does not change this
    // moment.
    states[body].pose.translation += start.linear_velocity * (0.5 * dt);
    let gravity = gravity_at(model, states, body, books.ledger.momentum.about, dt);
    states[body] = flight.state(t);
    let after = books.balance(model, states, &[body]);
    books.smooth_stage(before, after, Received { gravity, ..Received::default() });
}

/// Writes the states of an island's bodies at a time within its step over `states`.
pub(super) fn write_states(
    core: &Core,
    island: &mut Island,
    t: f64,
    states: &mut [BodyState],
) -> Result<(), SimulationError> {
    match &mut island.step {
        Step::Constrained(step) => step.states_at(&core.model, t, states),
        Step::Free(step) => {
            for (&body, state) in island.bodies.iter().zip(step.states_at(&core.model, t)?) {
                states[body] = state;
            }
        }
        Step::Crowd(step) => {
            step.advance_to(&core.model, &island.bodies, t, states)
                .map_err(|source| SimulationError::of_response(step.t, source))?;
        }
        Step::Waiting(_) => {}
    }
    Ok(())
}
