//! A run by fixed time steps, and one step of it.

use super::islands::{Island, IslandSearch, islands};
use crate::books::{Books, Received};
use crate::event::{Event, EventKind};
use crate::interaction::assembly::{Assembly, free_acceleration};
use crate::interaction::contact_set::{ContactId, Touch};
use crate::interaction::groups::groups;
use crate::observer::Observer;
use crate::settings::Settings;
use crate::time_stepping::{ImpulseKind, TimeStepReport, TimeStepper, given_by_gravity};
use crate::world::World;
use crate::{Acceleration, Certificate, Effects, RunReport, SimulationError};
use polhode_dynamics::{BodyState, Flight};
use polhode_response::{ComplementaritySolver, ResponseError, WarmStart};
use polhode_spatial::DVec3;
use std::collections::{BTreeMap, BTreeSet};

/// Impacts that the step of an island is split at, at the most: the first few of a step are struck when they happen, further
/// ones of a crowd where the last part begins.
const MOST_SPLITS: u32 = 4;

/// A contact that approaches or parts more slowly than gravity moves a body within this many steps is at rest, when
/// accelerations are asked for.
const RESTING_STEPS: f64 = 2.0;

/// An island whose bodies stand, to the last bit, where they stood before their last steps, and what the last one did.
#[derive(Debug)]
struct Resting {
    island: Island,
    /// s.
    h: f64,
    report: TimeStepReport,
    /// How many such steps there have been, up to [`STEPS_OF_REST`].
    steps: u32,
}

/// Overlap that may be left after it has been moved out, relative to the size of a body: as far as touch. More is told.
const LEFT_RELATIVE: f64 = 1e-11;

/// Steps after which what rests is not computed again: the first finds the contacts that carry, the second starts from
/// them, and every further one would be that again.
const STEPS_OF_REST: u32 = 2;

/// A run in progress.
#[derive(Debug)]
pub(crate) struct SteppedEngine {
    world: World,
    settings: Settings,
    effects: Effects,
    t: f64,
    states: Vec<BodyState>,
    /// Records of the bodies that have met nothing since their last step in an island.
    flights: Vec<Option<Box<Flight>>>,
    stepper: TimeStepper,
    search: IslandSearch,
    /// Islands that the last step has left at rest, by their first bodies.
    resting: BTreeMap<usize, Resting>,
    /// Pairs in contact after the last step.
    touching: BTreeSet<(usize, usize)>,
    books: Books,
    certificate: Certificate,
    /// Largest overlap that was left after it had been moved out, m, when (s), and a body of the island.
    left: Option<(f64, f64, usize)>,
    event_count: u64,
    steps: u64,
    next_sample: u64,
}

impl SteppedEngine {
    pub(crate) fn new(world: World, states: Vec<BodyState>, settings: Settings, effects: Effects) -> Self {
        let books = Books::open(&world, &states);
        let stepper = TimeStepper::new(settings.impact, books.ledger.momentum.about, MOST_SPLITS);
        let search = IslandSearch::new(&world, settings.broad_phase.build());
        Self {
            flights: vec![None; world.bodies.len()],
            world,
            settings,
            effects,
            t: 0.0,
            states,
            stepper,
            search,
            resting: BTreeMap::new(),
            touching: BTreeSet::new(),
            books,
            certificate: Certificate::default(),
            left: None,
            event_count: 0,
            steps: 0,
            next_sample: 0,
        }
    }

    /// The bodies and their present states.
    pub(crate) fn bodies(&self) -> (&World, &[BodyState]) {
        (&self.world, &self.states)
    }

    /// Time reached, s.
    pub(crate) fn time(&self) -> f64 {
        self.t
    }

    /// One step.
    ///
    /// # Errors
    /// When the state is no longer finite or a contact problem is not.
    pub(crate) fn step(&mut self, observer: &mut dyn Observer) -> Result<(), SimulationError> {
        let duration = self.world.scene.duration_s();
        // Times are multiples of the step, so that rounding does not add up.
        let next = (self.steps + 1) as f64 * self.settings.step_s;
        let t_next = if next >= duration { duration } else { next };
        // Steps of the same bits, so that rest lasts.
        let h = if next >= duration { duration - self.t } else { self.settings.step_s };
        if self.steps == 0 {
            self.emit_sample(0.0, &self.states, observer);
            self.next_sample = 1;
        }
        let pairs = self.search.pairs(&self.world, &self.states, h).map_err(SimulationError::BroadPhase)?;
        let islands = islands(&self.world, &pairs);
        self.emit_samples_within(&islands, t_next, observer)?;
        self.fly(&islands, t_next);
        let mut events = Vec::new();
        let mut touching = BTreeSet::new();
        let mut resting = std::mem::take(&mut self.resting);
        for island in islands {
            let Some(&first) = island.bodies.first() else { continue };
            let report = self.advance(island, first, h, &mut resting)?;
            self.note(&report, first, &mut events);
            touching.extend(report.touching);
        }
        self.t = t_next;
        self.steps += 1;
        self.report_pairs(touching, &mut events);
        events.sort_by(|a, b| a.t.total_cmp(&b.t));
        self.event_count += events.len() as u64;
        for event in &events {
            observer.event(event);
        }
        self.audit()?;
        if self.t >= duration {
            self.emit_sample(self.t, &self.states, observer);
        }
        Ok(())
    }

    /// Advances an island by `h`. One that stands where it stood before its last steps, with nothing else near it, does again
    /// what it did then.
    fn advance(
        &mut self,
        island: Island,
        first: usize,
        h: f64,
        resting: &mut BTreeMap<usize, Resting>,
    ) -> Result<TimeStepReport, SimulationError> {
        let last = resting.remove(&first).filter(|last| last.island == island && last.h == h);
        let steps = last.as_ref().map_or(0, |last| last.steps);
        if let Some(last) = last.filter(|last| last.steps == STEPS_OF_REST && self.effects == Effects::Planned) {
            let report = last.report.clone();
            self.resting.insert(first, last);
            return Ok(report);
        }
        let before: Vec<BodyState> = island.bodies.iter().map(|&body| self.states[body]).collect();
        let report = self
            .stepper
            .advance(&self.world, &mut self.states, &island.bodies, &island.pairs, (self.t, h))
            .map_err(|source| SimulationError::ContactProblem { t: self.t, source })?;
        let unmoved = island.bodies.iter().zip(&before).all(|(&body, before)| self.states[body] == *before);
        if unmoved && report.at_rest && self.forces_last(&island) {
            let (report, steps) = (report.clone(), STEPS_OF_REST.min(steps + 1));
            self.resting.insert(first, Resting { island, h, report, steps });
        }
        Ok(report)
    }

    /// Whether the forces on an island stay as they are while it rests.
    fn forces_last(&self, island: &Island) -> bool {
        !island.bodies.iter().any(|&body| self.world.is_driven(body))
    }

    /// Moves all bodies that are in no island along their flights to `t_next`.
    fn fly(&mut self, islands: &[Island], t_next: f64) {
        let mut free = vec![true; self.world.bodies.len()];
        for &body in islands.iter().flat_map(|island| &island.bodies) {
            free[body] = false;
            self.flights[body] = None;
        }
        let about = self.books.ledger.momentum.about;
        let bodies: Vec<usize> = self.world.movable.iter().copied().filter(|&body| free[body]).collect();
        for body in bodies {
            let start = self.states[body];
            let Some(flight) = self.flight(body) else { continue };
            let mut end = flight.state(t_next);
            self.world.keep_in_plane(body, &mut end);
            let before = self.books.balance(&self.world, &self.states, &[body]);
            self.states[body] = end;
            let after = self.books.balance(&self.world, &self.states, &[body]);
            let mut received = Received::default();
            if self.world.carries_momentum(body) {
                received.gravity = given_by_gravity(&self.world, body, &start, t_next - self.t, about);
            }
            self.books.smooth_stage(before, after, received);
        }
    }

    /// The record of a body's flight, made now when there is none.
    fn flight(&mut self, body: usize) -> Option<&Flight> {
        let rigid = self.world.bodies[body].rigid.as_ref()?;
        let record = if self.world.plane.is_some() { Flight::steady } else { Flight::new };
        let (t, state) = (self.t, &self.states[body]);
        let acceleration = self.world.free_acceleration(body);
        Some(self.flights[body].get_or_insert_with(|| Box::new(record(rigid, t, state, acceleration))))
    }

    /// Takes note of what the step of an island with this first body did.
    fn note(&mut self, report: &TimeStepReport, first: usize, events: &mut Vec<Event>) {
        self.books.enter(&report.books);
        let most = self.left.map_or(0.0, |(most, ..)| most);
        if report.left_penetration_m > most.max(LEFT_RELATIVE * self.world.bodies[first].size) {
            self.left = Some((report.left_penetration_m, self.t, first));
        }
        let certificate = &mut self.certificate;
        certificate.max_penetration_m = certificate.max_penetration_m.max(report.max_penetration_m);
        certificate.max_residual = certificate.max_residual.max(report.residual);
        certificate.fallbacks += report.fallbacks;
        for given in &report.impulses {
            if let ImpulseKind::Impact { energy_change_j } = given.kind {
                let event = Event {
                    t: given.t,
                    kind: EventKind::Impact,
                    body_a: given.id.a,
                    body_b: Some(given.id.b),
                    point: given.geometry.point,
                    normal: given.geometry.normal,
                    impulse: given.impulse,
                    energy_change_j,
                };
                self.push_contact_event(event, given.id, events);
            }
        }
    }

    /// Adds an event at a contact point; one that stands for its mirror image too is reported at both.
    fn push_contact_event(&self, event: Event, id: ContactId, events: &mut Vec<Event>) {
        let Some(aside) = self.world.mirrored(&self.states, id) else {
            events.push(event);
            return;
        };
        let (impulse, energy_change_j) = (0.5 * event.impulse, 0.5 * event.energy_change_j);
        for point in [event.point - aside, event.point + aside] {
            events.push(Event { point, impulse, energy_change_j, ..event });
        }
    }

    /// Reports pairs that have begun or ceased to press on each other; those of the first step were there before.
    fn report_pairs(&mut self, touching: BTreeSet<(usize, usize)>, events: &mut Vec<Event>) {
        let before = std::mem::replace(&mut self.touching, touching);
        if self.steps == 1 {
            return;
        }
        let event = |kind, &(a, b): &(usize, usize)| {
            let contacts = self.world.contacts_of_pair(&self.states, a, b, self.world.pair_size(a, b));
            let geometries = contacts.iter().map(|touch| &touch.kinematics.geometry);
            let nearest = geometries.min_by(|g, other| g.separation.total_cmp(&other.separation));
            let moving = if self.world.bodies[a].moves() { a } else { b };
            Event {
                t: self.t,
                kind,
                body_a: a,
                body_b: Some(b),
                point: nearest.map_or(self.states[moving].pose.translation, |geometry| geometry.point),
                normal: nearest.map_or(DVec3::ZERO, |geometry| geometry.normal),
                impulse: 0.0,
                energy_change_j: 0.0,
            }
        };
        events.extend(before.difference(&self.touching).map(|pair| event(EventKind::ContactEnd, pair)));
        events.extend(self.touching.difference(&before).map(|pair| event(EventKind::ContactBegin, pair)));
    }

    fn audit(&mut self) -> Result<(), SimulationError> {
        if let Some(body) = self.states.iter().position(|state| !state.is_finite()) {
            return Err(SimulationError::Diverged { body: self.world.bodies[body].name.clone(), t: self.t });
        }
        let energy = self.books.observe(&self.world, &self.states);
        if !energy.final_j.is_finite() {
            return Err(SimulationError::EnergyOverflow { t: self.t });
        }
        Ok(())
    }

    fn emit_sample(&self, t: f64, states: &[BodyState], observer: &mut dyn Observer) {
        let samples: Vec<_> = states.iter().enumerate().map(|(body, state)| self.world.sample(body, state)).collect();
        observer.sample(t, &samples);
    }

    /// Samples before the end of the step, each by a shorter step from the same states.
    fn emit_samples_within(
        &mut self,
        islands: &[Island],
        t_next: f64,
        observer: &mut dyn Observer,
    ) -> Result<(), SimulationError> {
        loop {
            let t = self.next_sample as f64 * self.world.scene.output_interval_s();
            if t >= t_next {
                return Ok(());
            }
            if t <= self.t {
                self.emit_sample(t, &self.states, observer);
                self.next_sample += 1;
                continue;
            }
            let mut states = self.states.clone();
            let mut in_island = vec![false; states.len()];
            for island in islands {
                island.bodies.iter().for_each(|&body| in_island[body] = true);
                let mut stepper = self.stepper.clone();
                stepper
                    .advance(&self.world, &mut states, &island.bodies, &island.pairs, (self.t, t - self.t))
                    .map_err(|source| SimulationError::ContactProblem { t: self.t, source })?;
            }
            for body in 0..states.len() {
                if !in_island[body]
                    && let Some(flight) = self.flight(body)
                {
                    states[body] = flight.state(t);
                    self.world.keep_in_plane(body, &mut states[body]);
                }
            }
            self.emit_sample(t, &states, observer);
            self.next_sample += 1;
        }
    }

    /// Accelerations now, with exact forces at the contacts that touch and neither approach nor part.
    ///
    /// # Errors
    /// When a contact problem is not finite.
    pub(crate) fn accelerations(&mut self) -> Result<Vec<Acceleration>, SimulationError> {
        let failed = |source| SimulationError::ContactProblem { t: self.t, source };
        let slow = RESTING_STEPS * self.world.gravity().length() * self.settings.step_s;
        let pairs = self.search.pairs(&self.world, &self.states, 0.0).map_err(SimulationError::BroadPhase)?;
        let mut touches = Vec::new();
        for (a, b) in pairs {
            let reach = self.world.touch_distance(&self.states, a, b);
            touches.extend(self.world.contacts_of_pair(&self.states, a, b, reach));
        }
        touches.retain(|touch| touch.kinematics.separation_rate.abs() <= slow);
        let loads = self.world.loads(self.t, &self.states);
        let mut found: Vec<(DVec3, DVec3)> =
            (0..self.states.len()).map(|body| free_acceleration(&self.world, &self.states, &loads, body)).collect();
        let all: Vec<_> = touches.iter().enumerate().map(|(index, touch)| (index, touch.id.a, touch.id.b)).collect();
        for group in groups(&self.world, all.into_iter()) {
            let members: Vec<Touch> = group.contacts.iter().map(|&index| touches[index]).collect();
            for (body, linear, angular) in self.constrained(&group.bodies, &members).map_err(failed)? {
                found[body].0 += linear;
                found[body].1 += angular;
            }
        }
        let report = |(body, &(linear, angular)): (usize, &(DVec3, DVec3))| {
            self.world.reported_acceleration(body, &self.states[body], linear, angular)
        };
        Ok(found.iter().enumerate().map(report).collect())
    }

    /// What the forces of contacts add to the accelerations of their bodies.
    fn constrained(&self, bodies: &[usize], contacts: &[Touch]) -> Result<Vec<(usize, DVec3, DVec3)>, ResponseError> {
        let rows = contacts.iter().map(|touch| (touch.id, touch.kinematics.geometry));
        let assembly = Assembly::new(&self.world, &self.states, bodies, rows)?;
        let loads = self.world.loads(self.t, &self.states);
        let free = assembly.free_accelerations(&self.world, &self.states, &loads);
        let b = assembly.acceleration_constants(&free, contacts.iter().map(|touch| &touch.kinematics))?;
        let mut solver = ComplementaritySolver::default();
        let delassus = assembly.problem.delassus();
        let solution = solver.solve(&assembly.problem, &delassus, &b, Some(&WarmStart::default()))?;
        Ok(assembly.split(&assembly.problem.response(&solution.forces)?).collect())
    }

    fn warning(&self, &(depth, t, body): &(f64, f64, usize)) -> String {
        let name = &self.world.bodies[body].name;
        format!(
            "t = {t} s: bodies about {name} could not be moved out of each other: they overlap by up to {depth:e} m"
        )
    }

    /// Writes the results of the run into its report.
    pub(crate) fn fill(&mut self, report: &mut RunReport) {
        report.energy = self.books.observe(&self.world, &self.states);
        report.ledger = self.books.ledger;
        report.certificate = self.certificate;
        report.warnings = self.left.iter().map(|left| self.warning(left)).collect();
        report.steps = self.steps;
        report.events = self.event_count;
        report.bodies = self.world.named_samples(&self.states);
    }
}
