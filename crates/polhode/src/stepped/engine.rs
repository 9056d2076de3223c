//! A run by fixed time steps: one step, and queries at the present.

use super::instant_forces::{BodyAcceleration, PresentForces};
use super::island_steps::advance_islands;
use super::islands::{Island, IslandSearch, islands, joined};
use super::present_forces::STICKING_RELATIVE;
use super::rest::{Resting, may_rest, touching_groups};
use super::saved_loads::{restored_loads, saved_loads};
use super::track_ends::let_go_at_ends_of_tracks;
use super::unexpected::Unexpected;
use crate::accounting::books::Received;
use crate::accounting::long_steps::Movement;
use crate::accounting::time_step_report::TimeStepReport;
use crate::collision::touch::{FoundContact, Touch};
use crate::collision::{contact_kinematics, contact_set, contact_view};
use crate::error::SimulationError;
use crate::identity::body_id::BodyId;
use crate::identity::contact_id::{ContactId, Feature};
use crate::joints::{added, turns};
use crate::model::states_of::{set_states, states_of};
use crate::model::{Loads, prescribed, reported, tolerances};
use crate::report::acceleration::Acceleration;
use crate::report::event::{Event, EventKind};
use crate::report::frame::{ContactView, IslandView, JointView, MotionKind};
use crate::report::observer::Observer;
use crate::rows::assembly::free_acceleration;
use crate::scene::effects::Effects;
use crate::snapshot::numbers::{read_states, write_states};
use crate::snapshot::parts::{restored_flight, restored_forces, restored_id, save_contact, save_flight};
use crate::snapshot::{SnapshotError, content};
use crate::solve::contradiction::refuse_contradictions;
use crate::solve::held_at_rest::HeldAtRest;
use crate::tier::core::Core;
use crate::tier::sampling::emit_samples_before;
use crate::tier::{Reached, Tier};
use crate::time_stepping::{MOST_TIMES, NO_WORK_J, TimeStepper, given_by_gravity};
use polhode_dynamics::{BodyState, Flight};
use polhode_response::ResponseError;
use polhode_spatial::DVec3;
use std::collections::btree_map::Entry;
use std::collections::{BTreeMap, BTreeSet};
use std::sync::Arc;

/// Largest number of impacts at which the step of an island is split. The first impacts of a step are applied at
/// their times, further ones at the start of the last part of the step.
const MOST_IMPACTS_OF_STEP: u32 = 32;

/// When accelerations are asked for, a contact counts as resting if its rate of separation is at most the speed that
/// gravity gives a body in this many steps.
const RESTING_STEPS: f64 = 2.0;

/// In every so many steps bodies that hardly move come to rest.
const SETTLES_EVERY: u64 = 8;

/// The mean force of a contact over a step, on body A.
#[derive(Debug, Clone, Copy, Default)]
struct MeanForce {
    /// Along the normal, N.
    normal: f64,
    /// Of friction, world, N.
    friction: DVec3,
}

/// The islands of a step that has been made.
struct Advanced {
    /// Those that rest.
    resting: Vec<Island>,
    /// The others, and what they did.
    islands: Vec<Island>,
    reports: Vec<TimeStepReport>,
}

/// A run in progress.
#[derive(Debug)]
pub(crate) struct SteppedEngine {
    /// States of all bodies at the present.
    pub(super) states: Vec<BodyState>,
    /// Flight records of the bodies in free flight; none for bodies that were in an island in the last step.
    pub(super) flights: Vec<Option<Box<Flight>>>,
    pub(super) stepper: TimeStepper,
    search: IslandSearch,
    /// Pairs in contact after the last step.
    pub(super) touching: BTreeSet<(usize, usize)>,
    /// Mean forces of the contacts over the last step, N.
    forces: BTreeMap<ContactId, MeanForce>,
    /// Mean loads of the joints over the last step; none before the first one.
    pub(super) loads: Option<BTreeMap<usize, JointView>>,
    /// Bodies of each island of the last step.
    islands: Vec<Vec<usize>>,
    pub(super) resting: Resting,
    /// Index of the last step that ended on the grid of multiples of the step, and whether any step has been made.
    grid: u64,
    begun: bool,
}

impl SteppedEngine {
    /// Prepares a run: finds touching pairs, and the forces of resting contacts.
    ///
    /// # Errors
    /// When there are more bodies than the broad phase can number.
    pub(crate) fn new(core: &Core, states: Vec<BodyState>) -> Result<Self, SimulationError> {
        let mut engine = Self::unbegun(core, states);
        let model = &core.model;
        let pairs = engine.search.pairs(model, &engine.states, (core.t, 0.0)).map_err(SimulationError::BroadPhase)?;
        let all = islands(model, &pairs);
        for island in &all {
            engine.come_to_rest(core, island).map_err(|source| SimulationError::of_response(core.t, source))?;
        }
        engine.islands = all.into_iter().map(|island| island.bodies).collect();
        let moving = pairs.into_iter().filter(|&pair| !engine.resting.holds_pair(pair));
        let touches = engine.resting_touches(core, &moving.collect::<Vec<_>>());
        engine.touching.extend(touches.iter().map(|touch| (touch.id.a, touch.id.b)));
        for (bodies, contacts) in joined(model, &touches) {
            let found = PresentForces::solve(core, &engine.states, &bodies, &contacts).unwrap_or_default();
            for (index, touch) in contacts.iter().enumerate() {
                let normal = found.normal.get(index).copied().unwrap_or(f64::NAN);
                let friction = found.friction.get(index).copied().unwrap_or_default();
                engine.forces.insert(touch.id, MeanForce { normal, friction });
            }
        }
        Ok(engine)
    }

    /// The engine with these states, before contacts have been searched.
    fn unbegun(core: &Core, states: Vec<BodyState>) -> Self {
        let about = core.accounts.books.ledger.momentum.about;
        Self {
            resting: Resting::none(states.len()),
            flights: vec![None; states.len()],
            states,
            stepper: TimeStepper::new(core.settings.impact, about, MOST_IMPACTS_OF_STEP).for_heaps(),
            search: IslandSearch::new(&core.model, core.settings.broad_phase.build()),
            touching: BTreeSet::new(),
            forces: BTreeMap::new(),
            loads: None,
            islands: Vec::new(),
            grid: 0,
            begun: false,
        }
    }

    /// The engine of a snapshot.
    ///
    /// # Errors
    /// When the data are not of this scene.
    pub(crate) fn restored(core: &Core, saved: &content::Stepped) -> Result<Self, SnapshotError> {
        let model = &core.model;
        let bodies = model.bodies.len();
        let states = read_states(&saved.states, bodies)?;
        let mut engine = Self::unbegun(core, states);
        let refused = SnapshotError::Invalid("it does not say how each body moves");
        let are_bodies = |list: &Vec<usize>| list.iter().all(|&body| body < bodies);
        let are_pairs = saved.touching.iter().all(|&(a, b)| a <= b && b < bodies);
        if saved.flights.len() != bodies
            || saved.resting.len() != bodies
            || !saved.islands.iter().all(are_bodies)
            || !are_pairs
        {
            return Err(refused);
        }
        for (body, flight) in saved.flights.iter().enumerate() {
            let Some(flight) = flight else { continue };
            let rigid = model.bodies[body].rigid.as_ref().ok_or_else(|| refused.clone())?;
            engine.flights[body] = Some(Box::new(restored_flight(rigid, flight)?));
        }
        let carried = saved.carried.iter().map(|id| restored_id(model, id)).collect::<Result<Vec<_>, _>>()?;
        engine.stepper.carry(carried);
        engine.stepper.restore_last_forces(model, &saved.last_forces)?;
        engine.touching = saved.touching.iter().copied().collect();
        let normal = restored_forces(model, &saved.forces)?;
        if saved.friction.len() != normal.len() {
            return Err(SnapshotError::Invalid("it does not say the friction of each contact"));
        }
        let force = |((id, normal), friction): ((ContactId, f64), &[f64; 3])| {
            (id, MeanForce { normal, friction: DVec3::from_array(*friction) })
        };
        engine.forces = normal.into_iter().zip(&saved.friction).map(force).collect();
        engine.loads = saved.loads.as_ref().map(|loads| restored_loads(loads));
        engine.islands.clone_from(&saved.islands);
        engine.resting = Resting::restored(saved.resting.clone());
        (engine.grid, engine.begun) = (saved.grid, saved.begun);
        Ok(engine)
    }

    /// One step to `t_next`.
    ///
    /// # Errors
    /// When the state or a contact problem is no longer finite.
    fn step(&mut self, core: &mut Core, t_next: f64, observer: &mut dyn Observer) -> Result<(), SimulationError> {
        let h = t_next - core.t;
        let interval = (core.t, h);
        if core.effects == Effects::Planned
            && core.model.prescribed.is_empty()
            && self.resting.is_everything(&core.model)
        {
            return self.rest_on(core, t_next, observer);
        }
        let pairs = self.search.pairs(&core.model, &self.states, interval).map_err(SimulationError::BroadPhase)?;
        let pairs = self.resting.without_idle_pairs(&core.model, &self.states, pairs, (&self.touching, h));
        self.resting.release_from_plane(&mut core.model, &mut self.flights, &pairs);
        let (_, islands) = self.divide(core, &pairs)?;
        self.emit_samples_within(core, &islands, t_next, observer)?;
        let begin = self.states.clone();
        let Advanced { resting, islands, reports } = self.advance_all(core, pairs, interval)?;
        // Islands that were advanced in copies have left them where they were.
        prescribed::prescribe(&core.model, t_next, &mut self.states);
        self.fly(core, t_next);
        if core.effects == Effects::All {
            self.repeat_rest(core, &resting, interval)?;
        }
        let mut touching: BTreeSet<_> =
            self.touching.iter().copied().filter(|&pair| self.resting.holds_pair(pair)).collect();
        self.forces.retain(|id, _| self.resting.holds_pair((id.a, id.b)));
        let (mut loads, mut breaking) = (BTreeMap::new(), BTreeMap::new());
        self.resting.book(&core.model, &self.states, &mut core.accounts.books, h);
        let start: Vec<Vec<BodyState>> = islands.iter().map(|own| states_of(&begin, &own.bodies)).collect();
        for ((island, start), report) in islands.iter().zip(&start).zip(&reports) {
            self.note(core, report, h);
            let [sustained, all] = report.told.means(h);
            breaking.extend(sustained);
            loads.extend(all);
            self.note_movement(core, island, start, h);
            self.resting.note(&core.model, island, report.at_rest);
            touching.extend(report.touching.iter().copied());
        }
        let_go_at_ends_of_tracks(core, &self.states, t_next)?;
        turns::count_all_turns(&mut core.model, &self.states)?;
        core.t = t_next;
        let before = std::mem::replace(&mut self.touching, touching);
        if core.accounts.steps().is_multiple_of(SETTLES_EVERY) {
            for (island, report) in islands.iter().zip(&reports).filter(|(_, report)| !report.at_rest) {
                let settled = self.settle(core, island, &report.touching, h);
                settled.map_err(|source| SimulationError::of_response(core.t, source))?;
            }
        }
        self.loads = Some(loads);
        self.break_overloaded(core, &breaking)?;
        core.accounts.count_step();
        self.report_pairs(core, &before);
        core.accounts.emit_events(core.t, observer);
        core.accounts.observe(&core.model, &self.states, core.t)?;
        Ok(())
    }

    /// The islands of these pairs: those that rest, and the others.
    ///
    /// # Errors
    /// When a number is not finite, or joints contradict each other.
    fn divide(&mut self, core: &Core, pairs: &[(usize, usize)]) -> Result<(Vec<Island>, Vec<Island>), SimulationError> {
        let all = islands(&core.model, pairs);
        self.islands = all.iter().map(|island| island.bodies.clone()).collect();
        for island in &all {
            self.come_to_rest(core, island).map_err(|source| SimulationError::of_response(core.t, source))?;
        }
        let (resting, islands): (Vec<_>, Vec<_>) = all.into_iter().partition(|own| self.resting.contains_all(own));
        for island in &islands {
            refuse_contradictions(&core.model, core.t, &self.states, &island.bodies)?;
        }
        Ok((resting, islands))
    }

    /// Advances the islands of these pairs over a step, again where a body has met one that was not expected in its
    /// way.
    ///
    /// # Errors
    /// When a number is not finite, or joints contradict each other.
    fn advance_all(
        &mut self,
        core: &mut Core,
        mut pairs: Vec<(usize, usize)>,
        interval: (f64, f64),
    ) -> Result<Advanced, SimulationError> {
        let begin = self.states.clone();
        let mut times = MOST_TIMES;
        loop {
            let (resting, islands) = self.divide(core, &pairs)?;
            let of = (&mut self.stepper, &mut self.states[..]);
            let reports = advance_islands(&core.model, &*core.executor, of, &islands, interval)?;
            let met = Unexpected { begin: &begin, end: &self.states, islands: &islands, pairs: &pairs, interval };
            let met = met.find(&core.model, &mut self.search).map_err(SimulationError::BroadPhase)?;
            if met.is_empty() || times == 0 {
                return Ok(Advanced { resting, islands, reports });
            }
            times -= 1;
            self.states.clone_from(&begin);
            pairs.extend(met);
            pairs.sort_unstable();
            self.resting.release_from_plane(&mut core.model, &mut self.flights, &pairs);
        }
    }

    /// Notes an island as resting whose bodies are at rest where forces of their contacts hold them so.
    ///
    /// # Errors
    /// When a number is not finite.
    fn come_to_rest(&mut self, core: &Core, island: &Island) -> Result<(), ResponseError> {
        let model = &core.model;
        let is_still = |&body: &usize| tolerances::point_speed(model, &self.states, body) == 0.0;
        if self.resting.contains_all(island) || !island.bodies.iter().all(is_still) || !may_rest(model, island) {
            return Ok(());
        }
        let touches = self.resting_touches(core, &island.pairs);
        let loads = Loads::default();
        let held = HeldAtRest::of(model, (core.t, &self.states), &island.bodies, &touches, &loads)?;
        let Some(held) = held else { return Ok(()) };
        let forces = touches.iter().zip(&held.normal).zip(&held.friction);
        let forces = forces.map(|((touch, &normal), &friction)| (touch.id, MeanForce { normal, friction }));
        self.forces.extend(forces.clone());
        self.stepper.start_from(forces.map(|(id, force)| (id, force.normal, force.friction)));
        self.touching.extend(touches.iter().map(|touch| (touch.id.a, touch.id.b)));
        self.resting.note(model, island, true);
        Ok(())
    }

    /// Ends the last of the motion of bodies that a step has left slower than it can tell from rest, where forces of
    /// their contacts hold them: each group of bodies that touch each other for itself. `pairs` touch.
    ///
    /// # Errors
    /// When a number is not finite.
    fn settle(
        &mut self,
        core: &mut Core,
        island: &Island,
        pairs: &[(usize, usize)],
        h: f64,
    ) -> Result<(), ResponseError> {
        let slow = STICKING_RELATIVE * core.model.gravity().length() * h;
        for group in touching_groups(&core.model, island, pairs) {
            let model = &core.model;
            let is_slow = |&body: &usize| tolerances::point_speed(model, &self.states, body) <= slow;
            if !group.bodies.iter().all(is_slow) || !may_rest(model, &group) {
                continue;
            }
            let moving = states_of(&self.states, &group.bodies);
            let before = core.accounts.books.balance(model, &self.states, &group.bodies);
            for &body in &group.bodies {
                self.states[body] = BodyState::at_rest(self.states[body].pose);
            }
            self.come_to_rest(core, &group)?;
            if self.resting.contains_all(&group) {
                let after = core.accounts.books.balance(&core.model, &self.states, &group.bodies);
                core.accounts.books.rest(before, after, NO_WORK_J);
            } else {
                set_states(&mut self.states, &group.bodies, &moving);
            }
        }
        Ok(())
    }

    /// A step to `t_next` in which nothing moves: its cost does not depend on the number of bodies.
    ///
    /// # Errors
    /// As an observer's sample.
    fn rest_on(&mut self, core: &mut Core, t_next: f64, observer: &mut dyn Observer) -> Result<(), SimulationError> {
        self.emit_samples_within(core, &[], t_next, observer)?;
        self.resting.book(&core.model, &self.states, &mut core.accounts.books, t_next - core.t);
        core.t = t_next;
        core.accounts.count_step();
        core.accounts.emit_events(core.t, observer);
        Ok(())
    }

    /// Makes the steps of islands that rest, which change nothing: with all effects their contacts and forces are found
    /// in each.
    fn repeat_rest(&self, core: &Core, resting: &[Island], interval: (f64, f64)) -> Result<(), SimulationError> {
        let (mut states, mut stepper) = (self.states.clone(), self.stepper.clone());
        let of = (&mut stepper, &mut states[..]);
        advance_islands(&core.model, &*core.executor, of, resting, interval)?;
        Ok(())
    }

    /// Moves all bodies that are in no island to `t_next` in free flight.
    fn fly(&mut self, core: &mut Core, t_next: f64) {
        let mut free = vec![true; self.states.len()];
        for &body in self.islands.iter().flatten() {
            free[body] = false;
            self.flights[body] = None;
        }
        let about = core.accounts.books.ledger.momentum.about;
        let bodies: Vec<usize> = core.model.movable.iter().copied().filter(|&body| free[body]).collect();
        for body in bodies.into_iter().filter(|&body| core.model.bodies[body].moves()) {
            let start = self.states[body];
            let Some(flight) = self.flight(core, body) else { continue };
            let mut end = flight.state(t_next);
            core.model.keep_in_plane(body, &mut end);
            let before = core.accounts.books.balance(&core.model, &self.states, &[body]);
            self.states[body] = end;
            let after = core.accounts.books.balance(&core.model, &self.states, &[body]);
            let mut received = Received::default();
            if core.model.carries_momentum(body) {
                received.gravity = given_by_gravity(&core.model, body, &start, t_next - core.t, about);
            }
            core.accounts.books.smooth_stage(before, after, received);
        }
    }

    /// The flight record of a body, which is made from its present state when there is none.
    fn flight(&mut self, core: &Core, body: usize) -> Option<&Flight> {
        let rigid = core.model.bodies[body].rigid.as_ref()?;
        let record = if core.model.planar.contains(body) { Flight::steady } else { Flight::new };
        let (t, state) = (core.t, &self.states[body]);
        let acceleration = core.model.free_acceleration(body);
        Some(self.flights[body].get_or_insert_with(|| Box::new(record(rigid, t, state, acceleration))))
    }

    /// Records the forces and problems of an island's step of length `h` (s).
    fn note(&mut self, core: &mut Core, report: &TimeStepReport, h: f64) {
        core.accounts.note_time_step(&core.model, core.t, &self.states, report);
        core.note_overlap_of_step(core.t + h, &self.states, report);
        for given in &report.impulses {
            let force = self.forces.entry(given.id).or_default();
            force.normal += given.impulse / h;
            force.friction += given.friction / h;
        }
    }

    /// Records how far the bodies of an island moved in a step of `h` (s), if they may touch another one.
    fn note_movement(&self, core: &mut Core, island: &Island, start: &[BodyState], h: f64) {
        if island.pairs.is_empty() {
            return;
        }
        for (&body, start) in island.bodies.iter().zip(start) {
            let movement = Movement::between(&core.model, body, (start, &self.states[body]), (core.t, h));
            core.accounts.measures.long_steps.note(movement);
        }
    }

    /// Adds an event for every pair that has begun or ceased to touch in this step. The pairs of the first step touched
    /// at the start and give no events.
    fn report_pairs(&mut self, core: &mut Core, before: &BTreeSet<(usize, usize)>) {
        if !std::mem::replace(&mut self.begun, true) {
            return;
        }
        let event = |kind, &(a, b): &(usize, usize)| {
            let contacts = contact_set::contacts_of_pair(
                &core.model,
                &self.states,
                a,
                b,
                tolerances::pair_size(&core.model, a, b),
            );
            let geometries = contacts.iter().map(|touch| &touch.kinematics.geometry);
            let nearest = geometries.min_by(|g, other| g.separation.total_cmp(&other.separation));
            let moving = if core.model.bodies[a].moves() { a } else { b };
            Event {
                t_s: core.t,
                kind,
                body_a: BodyId::new(a),
                body_b: (b != a).then(|| BodyId::new(b)),
                point: nearest.map_or(self.states[moving].pose.translation, |geometry| geometry.point),
                normal: nearest.map_or(DVec3::ZERO, |geometry| geometry.normal),
                impulse: 0.0,
                energy_change_j: 0.0,
            }
        };
        let ended = before.difference(&self.touching).map(|pair| event(EventKind::ContactEnd, pair));
        let begun = self.touching.difference(before).map(|pair| event(EventKind::ContactBegin, pair));
        for event in ended.chain(begun).collect::<Vec<_>>() {
            core.accounts.add_event(event);
        }
    }

    /// Gives the observer the samples within the step, each computed by a shorter step from the same states.
    fn emit_samples_within(
        &mut self,
        core: &mut Core,
        islands: &[Island],
        t_next: f64,
        observer: &mut dyn Observer,
    ) -> Result<(), SimulationError> {
        emit_samples_before(t_next, self, core, observer, |engine, core, t| {
            engine.states_within(core, islands, t).map(|states| Some(Arc::new(states)))
        })
    }

    /// States of all bodies at `t` (s) within the step of these islands.
    fn states_within(&mut self, core: &Core, islands: &[Island], t: f64) -> Result<Vec<BodyState>, SimulationError> {
        let mut states = self.states.clone();
        if t <= core.t {
            return Ok(states);
        }
        let mut in_island = vec![false; states.len()];
        for island in islands {
            island.bodies.iter().for_each(|&body| in_island[body] = true);
            let mut stepper = self.stepper.clone();
            stepper
                .advance(&core.model, &mut states, &island.bodies, &island.pairs, (core.t, t - core.t))
                .map_err(|source| SimulationError::of_response(core.t, source))?;
        }
        let flies = |body: usize| !in_island[body] && !self.resting.contains(body) && core.model.bodies[body].moves();
        let flying: Vec<usize> = (0..states.len()).filter(|&body| flies(body)).collect();
        for body in flying {
            if let Some(flight) = self.flight(core, body) {
                states[body] = flight.state(t);
                core.model.keep_in_plane(body, &mut states[body]);
            }
        }
        prescribed::prescribe(&core.model, t, &mut states);
        Ok(states)
    }

    /// The resting contacts of these pairs: they touch and neither approach nor separate.
    pub(super) fn resting_touches(&self, core: &Core, pairs: &[(usize, usize)]) -> Vec<Touch> {
        let model = &core.model;
        let slow = RESTING_STEPS * model.gravity().length() * core.settings.step_s;
        let of_pair = |&(a, b): &(usize, usize)| {
            contact_set::contacts_of_pair(
                model,
                &self.states,
                a,
                b,
                tolerances::touch_distance(model, &self.states, a, b),
            )
        };
        let touches = pairs.iter().flat_map(of_pair);
        touches.filter(|touch| touch.kinematics.separation_rate.abs() <= slow).map(Touch::from).collect()
    }
}

impl Tier for SteppedEngine {
    fn advance(
        &mut self,
        core: &mut Core,
        limit_s: f64,
        observer: &mut dyn Observer,
    ) -> Result<Reached, SimulationError> {
        // Times are multiples of the step, so that rounding does not accumulate; a program may shorten a step.
        let step = core.settings.step_s;
        while self.grid as f64 * step <= core.t {
            self.grid += 1;
        }
        let next = self.grid as f64 * step;
        let t_next = if next >= limit_s { limit_s } else { next };
        if t_next > core.t {
            self.step(core, t_next, observer)?;
        }
        Ok(if core.t >= limit_s { Reached::Limit } else { Reached::StepEnd })
    }

    fn stride(&self, core: &Core) -> f64 {
        // The step ends at the next multiple of its length at the latest. The present plus one length may miss that by
        // a rounding.
        2.0 * core.settings.step_s
    }

    fn states(&self, _core: &Core) -> Vec<BodyState> {
        self.states.clone()
    }

    fn state(&self, _core: &Core, body: usize) -> BodyState {
        self.states[body]
    }

    fn accelerations(&mut self, core: &mut Core) -> Result<Vec<Acceleration>, SimulationError> {
        let failed = |source| SimulationError::of_response(core.t, source);
        let model = &core.model;
        let pairs = self.search.pairs(model, &self.states, (core.t, 0.0)).map_err(SimulationError::BroadPhase)?;
        let touches = self.resting_touches(core, &pairs);
        let loads = model.loads(core.t, &self.states);
        let own_acceleration = |body: usize| {
            if prescribed::trajectory(model, body).is_some() {
                prescribed::prescribed_acceleration(model, body, core.t)
            } else {
                free_acceleration(model, &self.states, &loads, body)
            }
        };
        let mut found: Vec<(DVec3, DVec3)> = (0..self.states.len()).map(own_acceleration).collect();
        for (bodies, contacts) in joined(model, &touches) {
            let forces = PresentForces::solve(core, &self.states, &bodies, &contacts).map_err(failed)?;
            for BodyAcceleration { body, linear, angular } in forces.accelerations {
                found[body] = (linear, angular);
            }
        }
        let report = |(body, &(linear, angular)): (usize, &(DVec3, DVec3))| {
            reported::reported_acceleration(model, body, &self.states[body], linear, angular)
        };
        Ok(found.iter().enumerate().map(report).collect())
    }

    fn joint_loads(&self, core: &Core, _t: f64, states: &[BodyState]) -> Vec<JointView> {
        self.loads_of_joints(core, states).into_values().collect()
    }

    fn contacts(&self, core: &Core, _t: f64, states: &[BodyState]) -> Vec<ContactView> {
        // Those that the last step used, wherever it has left them, and those that touch without a force.
        let model = &core.model;
        let touching = |&(a, b): &(usize, usize)| {
            contact_set::contacts_of_pair(model, states, a, b, tolerances::touch_distance(model, states, a, b))
        };
        let mut found: BTreeMap<ContactId, FoundContact> =
            self.touching.iter().flat_map(touching).map(|touch| (touch.id, touch)).collect();
        let is_of_shapes = |id: &ContactId| matches!(id.feature, Feature::Shapes(_));
        for &id in self.forces.keys().filter(|id| is_of_shapes(id)) {
            if let Entry::Vacant(place) = found.entry(id)
                && let Some(kinematics) = contact_kinematics::kinematics(model, states, id)
            {
                place.insert(FoundContact { id, kinematics });
            }
        }
        let mut views = Vec::new();
        for (id, touch) in found {
            let MeanForce { normal, friction } = self.forces.get(&id).copied().unwrap_or_default();
            contact_view::view_contact(model, states, &Touch::from(touch), (normal, friction), &mut views);
        }
        views
    }

    fn motions(&self, _core: &Core) -> Vec<MotionKind> {
        let mut kinds = vec![MotionKind::Given; self.states.len()];
        for (kind, flight) in kinds.iter_mut().zip(&self.flights) {
            if flight.is_some() {
                *kind = MotionKind::Flight;
            }
        }
        for &body in self.islands.iter().flatten() {
            kinds[body] = if self.resting.contains(body) { MotionKind::Rest } else { MotionKind::Integrated };
        }
        kinds
    }

    fn islands(&self, _core: &Core) -> Vec<IslandView> {
        let view = |bodies: &Vec<usize>| IslandView { bodies: bodies.iter().map(|&body| BodyId::new(body)).collect() };
        self.islands.iter().map(view).collect()
    }

    fn interrupt(&mut self, _core: &mut Core, bodies: &[usize]) -> Result<(), SimulationError> {
        // All states are those of the present between two steps; bodies in free flight get new records.
        self.resting.wake_all();
        for &body in bodies {
            self.flights[body] = None;
        }
        Ok(())
    }

    fn states_mut(&mut self) -> &mut [BodyState] {
        &mut self.states
    }

    fn add_body(&mut self, core: &Core, state: BodyState) {
        self.states.push(state);
        self.flights.push(None);
        self.resting.add_body();
        self.search = IslandSearch::new(&core.model, core.settings.broad_phase.build());
    }

    fn remove_body(&mut self, body: usize) {
        self.flights[body] = None;
        self.resting.wake_all();
        self.search.forget(body);
        self.touching.retain(|&(a, b)| a != body && b != body);
    }

    fn change_joint(&mut self, core: &mut Core, pair: (usize, usize)) {
        self.resting.wake_all();
        self.touching.retain(|&own| own != pair || added::may_touch(&core.model, own));
        let stays = |contact: ContactId| (contact.a, contact.b) != pair || added::may_have(&core.model, contact);
        self.stepper.keep_contacts(stays);
        self.forces.retain(|&id, _| stays(id));
        self.loads = None;
    }

    fn touching_pairs(&self) -> usize {
        self.touching.len()
    }

    fn save(&self) -> content::Tier {
        content::Tier::Stepped(content::Stepped {
            states: write_states(&self.states),
            flights: self.flights.iter().map(|flight| flight.as_deref().map(save_flight)).collect(),
            carried: self.stepper.carried().map(save_contact).collect(),
            last_forces: self.stepper.save_last_forces(),
            touching: self.touching.iter().copied().collect(),
            forces: self.forces.iter().map(|(&id, force)| (save_contact(id), force.normal)).collect(),
            friction: self.forces.values().map(|force| force.friction.to_array()).collect(),
            loads: self.loads.as_ref().map(saved_loads),
            islands: self.islands.clone(),
            resting: self.resting.save(),
            grid: self.grid,
            begun: self.begun,
        })
    }
}
