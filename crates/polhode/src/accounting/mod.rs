//! Accounting: the record of a run from which its report is made.
//!
//! It holds the ledger, the certificate, the warnings and the events, for runs of every tier. All events and samples
//! pass through it to the observer, in order of time.
//!
//! | module | holds |
//! |---|---|
//! | `books` | every change of energy and momentum, entered where it happens |
//! | `measures` | measured values against the limits of the promise: the worst, with bodies and time |
//! | `numerical_loss` | energy that the integrator lost or gained between events |
//! | `last_sample` | the overlaps of the last sample, so that bodies at rest are measured once |
//! | `long_steps` | steps of a fixed length that are too long for what they move |
//! | `stretches` | stretches of crowded events |
//! | `time_step_report`, `told_loads` | what a time step tells: books, impulses, loads |
//! | `occurrences` | repeated messages: first time, last time, number |
//! | `saved` | the accounts as plain data of a snapshot |

pub(crate) mod books;
pub(crate) mod last_sample;
pub(crate) mod long_steps;
pub(crate) mod measures;
pub(crate) mod numerical_loss;
mod occurrences;
mod saved;
mod stretches;
pub(crate) mod time_step_report;
pub(crate) mod told_loads;

use crate::accounting::time_step_report::{ImpulseKind, TimeStepReport};
use crate::collision::contact_kinematics;
use crate::error::SimulationError;
use crate::identity::body_id::BodyId;
use crate::identity::contact_id::ContactId;
use crate::joints::joint_error::{self, JointError};
use crate::model::{Model, rates, reported, tolerances};
use crate::report::energy::Energy;
use crate::report::event::{Event, EventKind};
use crate::report::ledger::Ledger;
use crate::report::observer::Observer;
use crate::report::run_error::RunError;
use crate::report::run_report::{BrokenPromise, Certificate, Outcome, RunReport};
use crate::scene::{ImpactLaw, Promise};
use crate::solve::cone_violation::ConeViolation;
use crate::solve::impact::raised_energy;
use books::Books;
use measures::{Limits, Measure, Measures};
use occurrences::Occurrences;
use polhode_dynamics::BodyState;
use polhode_response::impact::{ImpactOutcome, ImpactStatus};
use polhode_response::{SolverReport, SolverStatus};
use std::collections::VecDeque;
use stretches::Stretches;

/// A sample of which the observer has not been told the errors.
#[derive(Debug, Clone, Copy)]
pub(crate) struct WithoutErrors {
    /// When it was taken, s.
    pub(crate) t_s: f64,
    /// Of how many bodies.
    pub(crate) bodies: usize,
}

/// The accounts of a run in progress.
#[derive(Debug, Clone)]
pub(crate) struct Accounts {
    pub(crate) books: Books,
    pub(crate) certificate: Certificate,
    /// What the run promises.
    promise: Promise,
    /// Measured values that are compared with the promised limits.
    pub(crate) measures: Measures,
    warnings: Occurrences,
    tolerated: Occurrences,
    choices: Occurrences,
    /// Events not yet sent to the observer.
    events: Vec<Event>,
    event_count: u64,
    steps: u64,
    /// Number of the next output sample; sample k is due at k output intervals.
    next_sample: u64,
    /// When the last sample was taken, s.
    last_sample_s: Option<f64>,
    /// Samples of which the observer has not been told the errors.
    without_errors: VecDeque<WithoutErrors>,
    /// Stretches of crowded events.
    pub(crate) crowded: Stretches,
    /// Estimated local errors of all steps under error control, in units of the tolerance of a step.
    pub(crate) step_errors: f64,
}

impl Accounts {
    /// Opens the accounts of a run with this promise at the states given.
    pub(crate) fn open(model: &Model, states: &[BodyState], promise: Promise) -> Self {
        Self {
            books: Books::open(model, states),
            certificate: Certificate::default(),
            promise,
            measures: Measures::default(),
            warnings: Occurrences::default(),
            tolerated: Occurrences::default(),
            choices: Occurrences::default(),
            events: Vec::new(),
            event_count: 0,
            steps: 0,
            next_sample: 0,
            last_sample_s: None,
            without_errors: VecDeque::new(),
            crowded: Stretches::default(),
            step_errors: 0.0,
        }
    }

    /// Notes the estimated error of a step under error control, in units of its tolerance; of the steps that springs of
    /// contacts take within one, the largest.
    pub(crate) fn note_step_error(&mut self, error: f64) {
        let worst = &mut self.certificate.max_step_error;
        *worst = Some(worst.unwrap_or(0.0).max(error));
        self.step_errors += error;
    }

    /// Gives a warning at time `t` (s); one that has been given before is counted.
    pub(crate) fn warn(&mut self, t: f64, what: impl Into<String>) {
        self.warnings.add(t, what.into());
    }

    /// Notes a motion that the method has chosen at time `t` (s) among several that the laws allow.
    pub(crate) fn choose(&mut self, t: f64, what: impl Into<String>) {
        self.choices.add(t, what.into());
    }

    /// Counts something that is tolerated, skipped or approximated at time `t` (s), under its name.
    pub(crate) fn tolerate(&mut self, t: f64, what: impl Into<String>) {
        self.tolerated.add(t, what.into());
    }

    /// Counts a problem that was not solved to its tolerance at time `t` (s): the run is degraded.
    pub(crate) fn note_unsolved(&mut self, t: f64, what: impl Into<String>) {
        self.measures.unsolved.add(t, what.into());
    }

    /// Records the residual of the solution of a problem at `t` (s).
    pub(crate) fn note_residual(&mut self, t: f64, residual: f64) {
        let allowed = self.promise.residual.unwrap_or(f64::INFINITY);
        self.measures.residual.note(Measure { t, pair: (0, 0), value: residual, allowed });
    }

    /// Records the residual of the problems of a time step at `t` (s). Stretches of crowded events keep a promise of
    /// their own, and the report has their residual.
    fn note_residual_of_steps(&mut self, t: f64, residual: f64) {
        let promised = self.promise.residual.filter(|_| !self.has_crowded());
        let allowed = promised.unwrap_or(f64::INFINITY);
        self.measures.residual.note(Measure { t, pair: (0, 0), value: residual, allowed });
    }

    /// Records how far forces or impulses at `t` (s) are from Coulomb's law.
    pub(crate) fn note_friction(&mut self, t: f64, violation: Option<ConeViolation>) {
        if let Some(ConeViolation { value, pair }) = violation {
            let allowed = self.promise.friction.unwrap_or(f64::INFINITY);
            self.measures.friction.note(Measure { t, pair, value, allowed });
        }
    }

    /// Records how far the loads that are told of a step which ends at `t` (s) are from Newton's law of a body.
    fn note_loads(&mut self, t: f64, defect: f64) {
        let allowed = self.promise.loads.unwrap_or(f64::INFINITY);
        self.measures.loads.note(Measure { t, pair: (0, 0), value: defect, allowed });
    }

    /// Records how far the joints are from what they keep in these states at `t` (s).
    fn note_joints(&mut self, model: &Model, states: &[BodyState], t: f64) {
        let promised = self.promise.joint_gap.unwrap_or(f64::INFINITY);
        for JointError { pair, apart_m, turned_rad } in joint_error::joint_errors(model, states) {
            self.measures.has_joints = true;
            let (a, b) = pair;
            let allowed =
                promised * tolerances::pair_size(model, a, b) + tolerances::penetration_rounding(model, states, a, b);
            self.measures.joint_gap.note(Measure { t, pair, value: apart_m, allowed });
            self.measures.joint_rotation.note(Measure { t, pair, value: turned_rad, allowed: promised });
        }
    }

    /// Records a solver's report in the certificate: a residual that rounding alone leaves is within the promise. That
    /// of a problem that was not solved is in the error: nothing moves by its answer.
    ///
    /// # Errors
    /// When the problem was not solved to its tolerance.
    pub(crate) fn note_solve(&mut self, t: f64, report: &SolverReport) -> Result<(), SimulationError> {
        if report.status != SolverStatus::Solved {
            return Err(SimulationError::ContactSolve { t_s: t, residual: report.residual, bodies: Vec::new() });
        }
        let allowed = self.promise.residual.map_or(f64::INFINITY, |promised| promised.max(report.rounding));
        self.measures.residual.note(Measure { t, pair: (0, 0), value: report.residual, allowed });
        let certificate = &mut self.certificate;
        certificate.max_acceleration_error_bound =
            Some(certificate.max_acceleration_error_bound.unwrap_or(0.0).max(report.bound));
        Ok(())
    }

    /// Records a time step: its books, its certificate, and its impacts as events.
    pub(crate) fn note_time_step(&mut self, model: &Model, t: f64, states: &[BodyState], report: &TimeStepReport) {
        self.books.enter(&report.books);
        self.note_residual_of_steps(t, report.residual);
        self.certificate.factorisations += report.factorisations;
        self.note_friction(t, report.cone_violation);
        for _ in 0..report.fallbacks {
            self.tolerate(t, "a contact problem of a time step was solved approximately");
        }
        self.note_loads(t, report.newton_residual);
        if report.raises_energy {
            let law = model.scene.method().restitution_law.unwrap_or_default().name();
            self.warn(t, raised_energy(law));
        }
        for given in &report.impulses {
            let ImpulseKind::Impact { energy_change_j } = given.kind else { continue };
            let event = Event {
                t_s: given.t,
                kind: EventKind::Impact,
                body_a: BodyId::new(given.id.a),
                body_b: given.id.second().map(BodyId::new),
                point: given.geometry.point,
                normal: given.geometry.normal,
                impulse: given.impulse,
                energy_change_j,
            };
            self.add_contact_event(model, states, event, given.id);
        }
    }

    /// Adds an event at a contact point. If the contact also represents its mirror image, the event is reported at both
    /// points.
    pub(crate) fn add_contact_event(&mut self, model: &Model, states: &[BodyState], event: Event, id: ContactId) {
        let Some(aside) = contact_kinematics::mirrored(model, states, id) else {
            self.add_event(event);
            return;
        };
        let (impulse, energy_change_j) = (0.5 * event.impulse, 0.5 * event.energy_change_j);
        for point in [event.point - aside, event.point + aside] {
            self.add_event(Event { point, impulse, energy_change_j, ..event });
        }
    }

    /// Begins a stretch of crowded events of this many bodies at `t` (s). Returns its number.
    pub(crate) fn begin_crowding(&mut self, t: f64, bodies: usize, warning: &str) -> usize {
        self.warn(t, warning);
        self.crowded.begin(t, bodies)
    }

    /// Whether a stretch of crowded events has begun.
    pub(crate) fn has_crowded(&self) -> bool {
        !self.crowded.0.is_empty()
    }

    /// Records the outcome of an impact of some bodies by a law in the certificate.
    pub(crate) fn note_impact(
        &mut self,
        model: &Model,
        t: f64,
        law: ImpactLaw,
        bodies: &[usize],
        outcome: &ImpactOutcome,
    ) {
        let law = law.name();
        // What is not solved is told below: where nothing approaches beyond rounding, a residual is a part of that
        // rounding.
        let (pair, value, allowed) = ((0, 0), outcome.residual, f64::INFINITY);
        self.measures.residual.note(Measure { t, pair, value, allowed });
        match outcome.status {
            ImpactStatus::NoApproach | ImpactStatus::Separated | ImpactStatus::StruckInOrder => {}
            ImpactStatus::StoppedAtThreshold => self.warn_of_tolerated(
                t,
                format!(
                    "an impact by {law} does not end: stopped when every speed of approach was below the threshold"
                ),
            ),
            ImpactStatus::RestitutionLowered => self.warn_of_tolerated(
                t,
                "an impact between contacts of different restitution would have gained energy: the smallest \
                 restitution was used",
            ),
            ImpactStatus::LimitReached => self.warn_of_tolerated(
                t,
                format!(
                    "an impact by {law} reached its limit of applications: the remaining approach was resolved without \
                     restitution"
                ),
            ),
            ImpactStatus::NotSolved => {
                let (names, residual) = (reported::names_of(model, bodies), outcome.residual);
                let what = format!("an impact of {names} by {law} was not solved: the residual stays at {residual:e}");
                self.note_unsolved(t, what);
            }
        }
    }

    /// Gives a warning and also counts it as tolerated.
    pub(crate) fn warn_of_tolerated(&mut self, t: f64, what: impl Into<String>) {
        let what = what.into();
        self.warn(t, what.clone());
        self.tolerate(t, what);
    }

    /// Checks that the states of all bodies at `t` (s) are finite, and records their energies and momenta.
    ///
    /// # Errors
    /// When a state or the energy is not finite.
    pub(crate) fn observe(&mut self, model: &Model, states: &[BodyState], t: f64) -> Result<Energy, SimulationError> {
        check_finite(model, states, t)?;
        let energy = self.books.observe(model, states);
        let ledger = &mut self.books.ledger;
        // Where hardly anything has moved yet, energies are compared with what forces would do: nearly no run asks for
        // it.
        if ledger.numerical.value().abs() > self.measures.numerical.relative() * ledger.scale_j {
            ledger.scale_j = ledger.scale_j.max(rates::pressing_energy_j(model, t, states));
        }
        self.measures.numerical.note(model, (t, states), ledger, self.promise.energy);
        self.note_joints(model, states, t);
        if energy.final_j.is_finite() { Ok(energy) } else { Err(SimulationError::EnergyOverflow { t_s: t }) }
    }

    /// Counts a step.
    pub(crate) fn count_step(&mut self) {
        self.steps += 1;
    }

    /// Steps counted.
    pub(crate) fn steps(&self) -> u64 {
        self.steps
    }

    /// What is certain so far, with energies relative to the scale of this ledger.
    pub(crate) fn certificate_now(&self, ledger: &Ledger) -> Certificate {
        let mut certificate = self.certificate;
        self.measures.fill(ledger, &mut certificate);
        certificate.fallbacks = self.tolerated.total();
        certificate
    }

    /// Adds an event, to be sent to the observer in order of time.
    pub(crate) fn add_event(&mut self, event: Event) {
        self.events.push(event);
    }

    /// Sends the observer all events up to `t` (s), in order of time. The computed end of bounces may be later than
    /// `t`; its event waits.
    pub(crate) fn emit_events(&mut self, t: f64, observer: &mut dyn Observer) {
        self.events.sort_by(|x, y| x.t_s.total_cmp(&y.t_s));
        let due = self.events.partition_point(|event| event.t_s <= t);
        self.event_count += due as u64;
        for event in self.events.drain(..due) {
            observer.event(&event);
        }
    }

    /// Takes no samples from now on: a run that nobody observes.
    pub(crate) fn take_no_samples(&mut self) {
        self.next_sample = u64::MAX;
    }

    /// Time of the next output sample, s.
    pub(crate) fn next_sample_s(&self, model: &Model) -> f64 {
        self.next_sample as f64 * model.scene.output_interval_s()
    }

    /// Events so far.
    pub(crate) fn events(&self) -> u64 {
        self.event_count
    }

    /// Whether no sample has been sent yet.
    pub(crate) fn is_unsampled(&self) -> bool {
        self.last_sample_s.is_none()
    }

    /// Skips the next output sample, except every `every`-th one. Returns whether it was skipped.
    pub(crate) fn skips_sample(&mut self, every: u64) -> bool {
        let skips = !self.next_sample.is_multiple_of(every);
        self.next_sample += u64::from(skips);
        skips
    }

    /// Sends the observer the states at `t` (s), unless it has had a sample of that time. Returns whether it was sent.
    pub(crate) fn emit_sample(
        &mut self,
        model: &Model,
        states: &[BodyState],
        t: f64,
        observer: &mut dyn Observer,
    ) -> bool {
        while self.next_sample_s(model) <= t {
            self.next_sample += 1;
        }
        if self.last_sample_s == Some(t) {
            return false;
        }
        self.last_sample_s = Some(t);
        if !observer.wants_samples() {
            return true;
        }
        let shown = states.iter().take(model.shown()).enumerate();
        let samples: Vec<_> = shown.map(|(body, state)| reported::sample(model, body, state)).collect();
        observer.sample(t, &samples);
        if observer.wants_errors() {
            self.without_errors.push_back(WithoutErrors { t_s: t, bodies: samples.len() });
        }
        true
    }

    /// The first sample until `t` (s) of which the observer has not been told the errors. It is no longer owed to it.
    pub(crate) fn take_without_errors(&mut self, t: f64) -> Option<WithoutErrors> {
        self.without_errors.front().filter(|sample| sample.t_s <= t)?;
        self.without_errors.pop_front()
    }

    /// Writes the accounts into the report of a run that ends with these states, and compares them with these limits.
    pub(crate) fn fill(&mut self, model: &Model, states: &[BodyState], limits: &Limits, report: &mut RunReport) {
        report.energy = self.books.observe(model, states);
        report.ledger = self.books.ledger;
        self.measures.numerical.note(model, (report.simulated_s, states), &report.ledger, self.promise.energy);
        report.certificate = self.certificate_now(&report.ledger);
        report.tolerated = self.tolerated.list().to_vec();
        report.choices = self.choices.list().to_vec();
        report.broken = self.measures.exceeded(model, &report.ledger, limits);
        report.broken.extend(self.error_beyond_promise(model, &report.error, limits));
        if !report.broken.is_empty() {
            report.outcome = Outcome::Degraded;
        }
        report.warnings = report.broken.iter().map(BrokenPromise::to_string).collect();
        report.warnings.extend(self.measures.long_steps.warning(model));
        report.warnings.extend(self.warnings.texts());
        report.steps = self.steps;
        report.events = self.event_count;
        report.crowded.clone_from(&self.crowded.0);
        report.bodies = reported::named_samples(model, states);
    }
}

impl Accounts {
    /// What is wrong, where the estimated error of the run exceeds what is promised.
    fn error_beyond_promise(&self, model: &Model, error: &RunError, limits: &Limits) -> Option<BrokenPromise> {
        let (allowed, since_s, largest) = (self.promise.error, error.exceeds_s?, error.largest?);
        let (body, relative) = (largest.body.index(), largest.relative);
        let name = &model.bodies[body].name;
        let what = format!(
            "the estimated error of {name} is {relative:.2e} of its size, and beyond {allowed:e}, which is promised, \
             from t = {} s on",
            since_s as f32
        );
        Some(BrokenPromise::exceeding(what, relative, allowed).at(largest.t_s).of((body, body)).cured_by(limits.remedy))
    }
}

/// Checks that states are finite.
///
/// # Errors
/// When a state is not.
pub(crate) fn check_finite(model: &Model, states: &[BodyState], t: f64) -> Result<(), SimulationError> {
    match states.iter().position(|state| !state.is_finite()) {
        Some(body) => Err(SimulationError::Diverged { body: model.bodies[body].name.clone(), t_s: t }),
        None => Ok(()),
    }
}
