//! The state of a run and one step of it.

use super::hold::Forces;
use super::progress::Progress;
use super::projection;
use super::stepped::Stepper;
use super::trial::Trial;
use crate::books::{Books, Received, gravity_at};
use crate::free_stage::{self, Ends};
use crate::interaction::assembly::free_acceleration;
use crate::interaction::contact_set::{ContactId, Hold, Touch};
use crate::interaction::groups::{Group, coupled_groups, groups};
use crate::observer::Observer;
use crate::settings::Settings;
use crate::world::World;
use crate::{Acceleration, Certificate, Effects, Energy, Event, RunReport, SimulationError};
use polhode_contact::BroadPhase;
use polhode_dynamics::{BodyState, Flight};
use polhode_response::{ComplementaritySolver, ResponseError, SolverReport, SolverStatus};
use std::collections::{BTreeMap, BTreeSet};

/// An event that lets time advance by less than this fraction of the longest step is one of the same instant.
const STALL_RELATIVE: f64 = 1e-9;

/// Samples between two steps of bodies that all fly in closed form and meet nothing.
const SAMPLES_OF_FREE_FLIGHT: f64 = 256.0;

/// Events of the same instant after which what is still found wrong is put up with for a moment.
const PATIENCE: u32 = 16;

/// The first such moment lasts this many times as long as an instant, each further one this many times the one before.
const LEAP: f64 = 8.0;

/// How a body moves until the next event.
#[derive(Debug, Clone)]
pub(super) enum Mode {
    /// Never.
    Fixed,
    /// Freely, by its flight record.
    Flight(Box<Flight>),
    /// With held contacts, or under forces, integrated by DOP853.
    Constrained,
    /// By the integrator of free motion.
    Stepped,
    /// Not at all: its group is in certified equilibrium at zero velocity.
    Rest,
}

/// A run in progress.
#[derive(Debug)]
pub(crate) struct Engine {
    pub(super) world: World,
    pub(super) settings: Settings,
    effects: Effects,
    pub(super) t: f64,
    pub(super) stepper: Stepper,
    /// States at `t`.
    pub(super) states: Vec<BodyState>,
    pub(super) modes: Vec<Mode>,
    /// Contacts that touch at `t`, sorted by identity.
    pub(super) touches: Vec<Touch>,
    pub(super) solver: ComplementaritySolver,
    pub(super) broad_phase: Box<dyn BroadPhase>,
    /// Pairs whose boxes meet, as the broad phase left them.
    pub(super) box_pairs: Vec<(u32, u32)>,
    pub(super) books: Books,
    pub(super) certificate: Certificate,
    warnings: Vec<String>,
    /// Events of the current step, in order of time.
    pub(super) events: Vec<Event>,
    event_count: u64,
    /// Events since time last advanced by a whole step.
    events_in_step: u64,
    /// Step proposed by the error control of the contact phases, s.
    pub(super) proposed_step_s: f64,
    steps: u64,
    next_sample: u64,
    /// Largest speed of any body so far, or what gravity gives over a body's size, m/s.
    pub(super) speed_scale: f64,
    /// Contacts whose forces have been found to reach zero at the end of the present step.
    pub(super) departing: BTreeSet<ContactId>,
    /// How many events in a row have not let time advance.
    pub(super) stalls: u32,
    /// Bodies that the present instant has woken from rest.
    pub(super) woken: BTreeSet<usize>,
    /// Free rotations of bodies in integrated groups that nothing turns.
    pub(super) spins: BTreeMap<usize, Flight>,
    /// When bounces that were summed up at the present instant end, by body, s.
    pub(super) rest_times: BTreeMap<usize, f64>,
    /// Whether time still advances.
    pub(super) progress: Progress,
}

impl Engine {
    /// Prepares a run: finds what touches, moves touching bodies out of their round-off, decides which contacts hold.
    ///
    /// # Errors
    /// When bodies overlap at the start or the contact forces of the start cannot be found.
    pub(crate) fn new(
        world: World,
        states: Vec<BodyState>,
        settings: Settings,
        effects: Effects,
    ) -> Result<Self, SimulationError> {
        let books = Books::open(&world, &states);
        let modes = vec![Mode::Fixed; world.bodies.len()];
        let mut engine = Self {
            world,
            settings,
            effects,
            t: 0.0,
            stepper: Stepper::new(&settings),
            states,
            modes,
            touches: Vec::new(),
            solver: ComplementaritySolver::default(),
            broad_phase: settings.broad_phase.build(),
            box_pairs: Vec::new(),
            books,
            certificate: Certificate::default(),
            warnings: Vec::new(),
            events: Vec::new(),
            event_count: 0,
            events_in_step: 0,
            proposed_step_s: settings.step_s,
            steps: 0,
            next_sample: 0,
            speed_scale: 0.0,
            departing: BTreeSet::new(),
            stalls: 0,
            woken: BTreeSet::new(),
            spins: BTreeMap::new(),
            rest_times: BTreeMap::new(),
            progress: Progress::default(),
        };
        engine.find_initial_contacts()?;
        Ok(engine)
    }

    /// Number of pairs that touch.
    pub(crate) fn touching_pairs(&self) -> usize {
        let mut pairs: Vec<_> = self.touches.iter().map(|touch| (touch.id.a, touch.id.b)).collect();
        pairs.dedup();
        pairs.len()
    }

    /// The bodies and their present states.
    pub(crate) fn bodies(&self) -> (&World, &[BodyState]) {
        (&self.world, &self.states)
    }

    /// Time reached, s.
    pub(crate) fn time(&self) -> f64 {
        self.t
    }

    /// Advances to the end of one step, or to the first event in it.
    ///
    /// # Errors
    /// See [`SimulationError`].
    pub(crate) fn step(&mut self, observer: &mut dyn Observer) -> Result<(), SimulationError> {
        if self.steps == 0 {
            self.emit_sample(0.0, observer);
            self.next_sample = 1;
            self.resolve(&[])?;
        }
        self.refresh_resting_forces()?;
        let trial = self.integrate()?;
        let contact_change = self.locate_contact_change(&trial)?;
        let limit = contact_change.unwrap_or(trial.end());
        let near = self.near_pairs(&trial)?;
        let impact = self.first_impact(&trial, &near, limit)?;
        let t_next = impact.map_or(limit, |impact| impact.min(limit));
        if t_next < limit {
            self.departing.clear();
        }

        let event = contact_change.is_some() || impact.is_some();
        self.note_stall(t_next, event);
        self.emit_samples(&trial, t_next, observer)?;
        self.advance(&trial, t_next)?;
        if event {
            self.resolve(&near)?;
            self.count_events()?;
        } else {
            self.events_in_step = 0;
        }
        self.audit()?;
        self.note_progress()?;
        self.emit_events(observer);
        self.steps += 1;
        if self.t >= self.world.scene.duration_s() {
            self.emit_sample(self.t, observer);
        }
        Ok(())
    }

    /// Moving groups: bodies with held contacts that are not at rest, and bodies under forces, those together that
    /// forces couple.
    pub(super) fn constrained_groups(&self) -> Vec<Group> {
        let held = self.touches.iter().enumerate().filter(|(_, touch)| touch.hold == Hold::Held);
        let constrained = |body: usize| matches!(self.modes[body], Mode::Constrained);
        let contacts = held
            .filter(|(_, touch)| constrained(touch.id.a) || constrained(touch.id.b))
            .map(|(index, touch)| (index, touch.id.a, touch.id.b));
        let bodies: Vec<usize> = (0..self.modes.len()).filter(|&body| constrained(body)).collect();
        coupled_groups(&self.world, contacts, &bodies)
    }

    /// With all effects on, the forces of resting groups are computed at every step although nothing has changed.
    fn refresh_resting_forces(&mut self) -> Result<(), SimulationError> {
        if self.effects == Effects::Planned {
            return Ok(());
        }
        let rest = |body: usize| matches!(self.modes[body], Mode::Rest);
        let resting = groups(
            &self.world,
            self.touches
                .iter()
                .enumerate()
                .filter(|(_, touch)| touch.hold == Hold::Held && (rest(touch.id.a) || rest(touch.id.b)))
                .map(|(index, touch)| (index, touch.id.a, touch.id.b)),
        );
        for group in resting {
            let mut pairs: Vec<_> =
                group.contacts.iter().map(|&i| (self.touches[i].id.a, self.touches[i].id.b)).collect();
            pairs.dedup();
            let mut contacts = Vec::with_capacity(group.contacts.len());
            for (a, b) in pairs {
                let reach = self.world.touch_distance(&self.states, a, b);
                contacts.extend(self.world.contacts_of_pair(&self.states, a, b, reach));
            }
            for touch in &mut contacts {
                // The set was sorted by identity when it was made; its members keep their status as a warm start.
                if let Ok(index) = self.touches.binary_search_by(|known| known.id.cmp(&touch.id)) {
                    touch.hold = self.touches[index].hold;
                }
            }
            let forces = Forces::solve(&self.world, self.t, &self.states, &group.bodies, &contacts, &mut self.solver)
                .map_err(|source| self.response_error(source))?;
            self.note_solve(&forces.solution.report)?;
        }
        Ok(())
    }

    /// Longest step that may be tried now, s.
    pub(super) fn step_limit(&self) -> f64 {
        let remaining = self.horizon() - self.t;
        let needed = match self.effects {
            Effects::Planned => self.longest_step(),
            Effects::All => self.settings.step_s,
        };
        // A sum of equal steps may leave over what is no step: it is added to the last.
        if self.is_instant(remaining - needed) { remaining } else { needed }
    }

    /// Longest step that the planned effects need, s: motion in closed form in which no event can come needs none, but
    /// is stopped now and then for those who watch it.
    fn longest_step(&self) -> f64 {
        let is = |free: fn(&Mode) -> bool| self.modes.iter().all(free);
        if is(|mode| matches!(mode, Mode::Fixed | Mode::Rest)) {
            f64::INFINITY
        } else if !self.world.may_collide_at_all() && is(|mode| matches!(mode, Mode::Fixed | Mode::Flight(_))) {
            self.settings.step_s.max(SAMPLES_OF_FREE_FLIGHT * self.world.scene.output_interval_s())
        } else {
            self.settings.step_s
        }
    }

    /// Where a step must end at the latest, s: at the end of the run, or where a force is not smooth in time.
    pub(super) fn horizon(&self) -> f64 {
        let duration = self.world.scene.duration_s();
        self.world.free_motion().corner_between(self.t, duration).unwrap_or(duration)
    }

    /// Whether a time is too short to be a step, s.
    pub(super) fn is_instant(&self, dt: f64) -> bool {
        dt <= STALL_RELATIVE * self.settings.step_s
    }

    /// Whether an event at `t` comes without time having advanced.
    pub(super) fn is_stall(&self, t: f64) -> bool {
        self.is_instant(t - self.t)
    }

    /// Whether the present instant has been resolved so often that what is still found wrong with it is put up with
    /// until [`Self::looks_again`]: degenerate contacts can leave two answers that undo each other at the level of rounding.
    pub(super) fn puts_up(&self) -> bool {
        self.stalls >= PATIENCE
    }

    /// When what is put up with is looked at again, s: soon, for a contact that does close then sinks in.
    pub(super) fn looks_again(&self) -> f64 {
        self.t + self.settings.step_s * (STALL_RELATIVE * libm::pow(LEAP, f64::from(self.progress.leaps()))).min(1.0)
    }

    /// Counts the events of one instant before a step to `t_next`.
    fn note_stall(&mut self, t_next: f64, event: bool) {
        if self.puts_up() {
            self.progress.note_leap();
        }
        if !self.is_stall(t_next) {
            self.stalls = 0;
        } else if event {
            self.stalls += 1;
        }
        if self.stalls == PATIENCE && event {
            self.warn("contacts undo each other at one instant: what is still wrong is put up with for a moment");
        }
    }

    /// Brings all states to `t_next`; the smooth stage that ends there is booked.
    fn advance(&mut self, trial: &Trial, t_next: f64) -> Result<(), SimulationError> {
        let ends = self.states_at_end(trial, t_next)?;
        let dt = t_next - self.t;
        self.t = t_next;
        for (body, mode) in self.modes.iter().enumerate() {
            match mode {
                Mode::Flight(flight) => self.states[body] = flight.state(t_next),
                Mode::Rest => self.books.equilibrium(&self.world, &self.states, body, dt),
                Mode::Fixed | Mode::Constrained | Mode::Stepped => {}
            }
        }
        self.advance_stepped(trial, t_next)?;
        for (group, end) in trial.groups.iter().zip(ends) {
            let before = self.books.balance(&self.world, &self.states, &group.bodies);
            for (&body, mut state) in group.bodies.iter().zip(end.states) {
                self.world.keep_in_plane(body, &mut state);
                self.states[body] = state;
            }
            let integrated = self.books.balance(&self.world, &self.states, &group.bodies);
            self.books.smooth_stage(before, integrated, end.received);
            projection::project(&self.world, &mut self.states, &group.bodies, &group.held)
                .map_err(|source| self.response_error(source))?;
            let projected = self.books.balance(&self.world, &self.states, &group.bodies);
            self.books.projection(integrated, projected);
        }
        self.refresh_kinematics();
        Ok(())
    }

    /// Brings the stepped bodies to `t_next`.
    fn advance_stepped(&mut self, trial: &Trial, t_next: f64) -> Result<(), SimulationError> {
        let bodies = self.stepped_bodies();
        if bodies.is_empty() {
            return Ok(());
        }
        let parts = self.stepped_parts(t_next)?;
        let Some((_, mut ends)) = parts.last().cloned() else { return Ok(()) };
        if t_next < trial.end() {
            self.stepper.interrupt();
        }
        for &body in &bodies {
            self.world.keep_in_plane(body, &mut ends[body]);
        }
        let before = self.books.balance(&self.world, &self.states, &bodies);
        let after = self.books.balance(&self.world, &ends, &bodies);
        let mut received = Received::default();
        for pair in parts.windows(2) {
            let [(t0, start), (t1, end)] = pair else { continue };
            let stage = Ends { t: [*t0, *t1], states: [start, end] };
            received += free_stage::received(&self.world, stage, &bodies, self.books.ledger.momentum.about);
        }
        self.books.smooth_stage(before, after, received);
        self.states = ends;
        Ok(())
    }

    /// Evaluates every touching contact at the current states; those that no longer exist are dropped.
    pub(super) fn refresh_kinematics(&mut self) {
        let (world, states) = (&self.world, &self.states);
        self.touches.retain_mut(|touch| match world.kinematics(states, touch.id) {
            Some(kinematics) => {
                touch.kinematics = kinematics;
                true
            }
            None => false,
        });
    }

    /// Puts a body on a new flight record from its present state.
    pub(super) fn take_off(&mut self, body: usize) {
        if let Some(mode) = self.free_mode(body) {
            if !matches!(mode, Mode::Constrained) || !matches!(self.modes[body], Mode::Constrained) {
                self.stepper.interrupt();
            }
            self.modes[body] = mode;
        }
    }

    /// Ends a body's flight record, if it has one: what the record lost or gained in energy is booked.
    pub(super) fn land(&mut self, body: usize) {
        if let Mode::Flight(flight) = &self.modes[body] {
            let (start, dt) = (*flight.start(), self.t - flight.t0());
            let mut states = std::mem::take(&mut self.states);
            states[body] = start;
            let before = self.books.balance(&self.world, &states, &[body]);
            // The mean place of the flight for the moment of the weight; what it falls adds nothing to it.
            let mut middle = start;
            middle.pose.translation += start.linear_velocity * (0.5 * dt);
            states[body] = middle;
            let gravity = gravity_at(&self.world, &states, body, self.books.ledger.momentum.about, dt);
            states[body] = flight.state(self.t);
            let after = self.books.balance(&self.world, &states, &[body]);
            self.states = states;
            self.books.smooth_stage(before, after, Received { gravity, ..Received::default() });
        }
    }

    /// Takes a solver's report into the certificate.
    ///
    /// # Errors
    /// When the problem was not solved to its tolerance.
    pub(super) fn note_solve(&mut self, report: &SolverReport) -> Result<(), SimulationError> {
        self.certificate.max_residual = self.certificate.max_residual.max(report.residual);
        self.certificate.max_acceleration_error_bound = self.certificate.max_acceleration_error_bound.max(report.bound);
        self.certificate.fallbacks += u64::from(report.method.is_fallback());
        if report.status == SolverStatus::Solved {
            Ok(())
        } else {
            Err(SimulationError::ContactSolve { t: self.t, residual: report.residual })
        }
    }

    pub(super) fn warn(&mut self, what: &str) {
        self.warnings.push(format!("t = {} s: {what}", self.t));
    }

    pub(super) fn response_error(&self, source: ResponseError) -> SimulationError {
        SimulationError::ContactProblem { t: self.t, source }
    }

    /// Checks that the states are finite, and measures energy and penetration.
    fn audit(&mut self) -> Result<(), SimulationError> {
        if let Some(body) = self.states.iter().position(|state| !state.is_finite()) {
            return Err(SimulationError::Diverged { body: self.world.bodies[body].name.clone(), t: self.t });
        }
        let energy = self.books.observe(&self.world, &self.states);
        if !energy.final_j.is_finite() {
            return Err(SimulationError::EnergyOverflow { t: self.t });
        }
        for body in 0..self.states.len() {
            self.speed_scale = self.speed_scale.max(self.speed(body));
        }
        // The separation of a contact point measures penetration only while the point lies on its features, as that of
        // held contacts does; others are measured when they are detected.
        let held = self.touches.iter().filter(|touch| touch.hold == Hold::Held);
        let deepest = held.fold(0.0f64, |depth, touch| depth.max(-touch.kinematics.geometry.separation));
        self.certificate.max_penetration_m = self.certificate.max_penetration_m.max(deepest);
        Ok(())
    }

    fn count_events(&mut self) -> Result<(), SimulationError> {
        self.events_in_step += 1;
        let limit = self.settings.max_events_per_step;
        if self.events_in_step > limit { Err(SimulationError::TooManyEvents { limit, t: self.t }) } else { Ok(()) }
    }

    fn emit_events(&mut self, observer: &mut dyn Observer) {
        // The end of bounces that have been summed up lies a little ahead; it is reported in its turn.
        self.events.sort_by(|x, y| x.t.total_cmp(&y.t));
        let due = self.events.partition_point(|event| event.t <= self.t);
        self.event_count += due as u64;
        for event in self.events.drain(..due) {
            observer.event(&event);
        }
    }

    /// Time of sample number `k`, s.
    fn sample_time(&self, k: u64) -> f64 {
        k as f64 * self.world.scene.output_interval_s()
    }

    /// Samples that fall before `t_next`, evaluated within the step.
    fn emit_samples(&mut self, trial: &Trial, t_next: f64, observer: &mut dyn Observer) -> Result<(), SimulationError> {
        while self.sample_time(self.next_sample) < t_next {
            let t = self.sample_time(self.next_sample);
            let mut states: Vec<_> =
                (0..self.world.bodies.len()).map(|body| self.state_within(trial, body, t)).collect();
            self.stepped_states(t, &mut states)?;
            let samples: Vec<_> =
                states.iter().enumerate().map(|(body, state)| self.world.sample(body, state)).collect();
            observer.sample(t, &samples);
            self.next_sample += 1;
        }
        Ok(())
    }

    /// A sample of the present states.
    fn emit_sample(&self, t: f64, observer: &mut dyn Observer) {
        let samples: Vec<_> =
            self.states.iter().enumerate().map(|(body, state)| self.world.sample(body, state)).collect();
        observer.sample(t, &samples);
    }

    /// Accelerations of all bodies now, under the contact forces of now.
    ///
    /// # Errors
    /// When the forces cannot be found.
    pub(crate) fn accelerations(&mut self) -> Result<Vec<Acceleration>, SimulationError> {
        let loads = self.world.loads(self.t, &self.states);
        let mut out: Vec<_> = (0..self.world.bodies.len())
            .map(|body| {
                let (linear, angular) = free_acceleration(&self.world, &self.states, &loads, body);
                self.world.reported_acceleration(body, &self.states[body], linear, angular)
            })
            .collect();
        for (bodies, members) in self.sustained_groups() {
            let forces = Forces::solve(&self.world, self.t, &self.states, &bodies, &members, &mut self.solver)
                .map_err(|source| self.response_error(source))?;
            self.note_solve(&forces.solution.report)?;
            for (body, linear, angular) in forces.accelerations() {
                out[body] = self.world.reported_acceleration(body, &self.states[body], linear, angular);
            }
        }
        Ok(out)
    }

    /// Bodies connected by contacts that neither approach nor part, and those contacts.
    fn sustained_groups(&self) -> Vec<(Vec<usize>, Vec<Touch>)> {
        let sustained = self.touches.iter().enumerate().filter(|(_, touch)| self.is_sustained(touch));
        groups(&self.world, sustained.map(|(index, touch)| (index, touch.id.a, touch.id.b)))
            .into_iter()
            .map(|group| (group.bodies, group.contacts.iter().map(|&i| self.touches[i]).collect()))
            .collect()
    }

    /// Writes the results of the run into its report.
    pub(crate) fn fill(&mut self, report: &mut RunReport) {
        report.energy = self.close_books();
        report.ledger = self.books.ledger;
        report.certificate = self.certificate;
        report.warnings.clone_from(&self.warnings);
        report.steps = self.steps;
        report.events = self.event_count;
        report.bodies = self.world.named_samples(&self.states);
    }

    /// Closes the books: flights still in the air are booked up to now.
    fn close_books(&mut self) -> Energy {
        for body in 0..self.modes.len() {
            if matches!(self.modes[body], Mode::Flight(_)) {
                self.land(body);
                self.take_off(body);
            }
        }
        self.books.observe(&self.world, &self.states)
    }
}
