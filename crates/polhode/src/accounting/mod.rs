//! Accounting: what a run has to show for itself.
//!
//! The ledger, the certificate, the warnings and the events of a run, whatever tier advances it. Events and samples reach
//! the observer from here alone, in order of time.

pub(crate) mod books;
mod saved;
mod warnings;

use crate::observer::Observer;
use crate::world::World;
use crate::{Certificate, Energy, Event, RunReport, SimulationError};
use books::Books;
use polhode_dynamics::BodyState;
use polhode_response::{SolverReport, SolverStatus};
use warnings::Warnings;

/// The accounts of a run in progress.
#[derive(Debug, Clone)]
pub(crate) struct Accounts {
    pub(crate) books: Books,
    pub(crate) certificate: Certificate,
    warnings: Warnings,
    /// Events that have not been told yet.
    events: Vec<Event>,
    event_count: u64,
    steps: u64,
    /// Number of the next sample of the output's grid.
    next_sample: u64,
    /// When the last sample was taken, s.
    last_sample_s: Option<f64>,
}

impl Accounts {
    /// Opens the accounts at the states given.
    pub(crate) fn open(world: &World, states: &[BodyState]) -> Self {
        Self {
            books: Books::open(world, states),
            certificate: Certificate::default(),
            warnings: Warnings::default(),
            events: Vec::new(),
            event_count: 0,
            steps: 0,
            next_sample: 0,
            last_sample_s: None,
        }
    }

    /// Gives a warning at time `t` (s); one that has been given before is counted.
    pub(crate) fn warn(&mut self, t: f64, what: impl Into<String>) {
        self.warnings.add(t, what.into());
    }

    /// Takes a solver's report into the certificate.
    ///
    /// # Errors
    /// When the problem was not solved to its tolerance.
    pub(crate) fn note_solve(&mut self, t: f64, report: &SolverReport) -> Result<(), SimulationError> {
        let certificate = &mut self.certificate;
        certificate.max_residual = certificate.max_residual.max(report.residual);
        certificate.max_acceleration_error_bound = certificate.max_acceleration_error_bound.max(report.bound);
        certificate.fallbacks += u64::from(report.method.is_fallback());
        if report.status == SolverStatus::Solved {
            Ok(())
        } else {
            Err(SimulationError::ContactSolve { t, residual: report.residual })
        }
    }

    /// Takes a depth of penetration (m) into the certificate.
    pub(crate) fn note_penetration(&mut self, depth_m: f64) {
        self.certificate.max_penetration_m = self.certificate.max_penetration_m.max(depth_m);
    }

    /// Checks that the states of all bodies at `t` (s) are finite, and takes note of their energies and momenta.
    ///
    /// # Errors
    /// When a state or the energy is not finite.
    pub(crate) fn observe(&mut self, world: &World, states: &[BodyState], t: f64) -> Result<Energy, SimulationError> {
        check_finite(world, states, t)?;
        let energy = self.books.observe(world, states);
        if energy.final_j.is_finite() { Ok(energy) } else { Err(SimulationError::EnergyOverflow { t }) }
    }

    /// A step has been made.
    pub(crate) fn count_step(&mut self) {
        self.steps += 1;
    }

    /// Steps made so far.
    pub(crate) fn steps(&self) -> u64 {
        self.steps
    }

    /// An event that will be told in its turn.
    pub(crate) fn add_event(&mut self, event: Event) {
        self.events.push(event);
    }

    /// Tells the observer all events up to `t` (s), in order of time. The end of bounces that have been summed up lies a
    /// little ahead, and waits.
    pub(crate) fn emit_events(&mut self, t: f64, observer: &mut dyn Observer) {
        self.events.sort_by(|x, y| x.t.total_cmp(&y.t));
        let due = self.events.partition_point(|event| event.t <= t);
        self.event_count += due as u64;
        for event in self.events.drain(..due) {
            observer.event(&event);
        }
    }

    /// Time of the next sample of the output's grid, s.
    pub(crate) fn next_sample_s(&self, world: &World) -> f64 {
        self.next_sample as f64 * world.scene.output_interval_s()
    }

    /// Tells the observer the states at `t` (s), unless it has had a sample of that time.
    pub(crate) fn emit_sample(&mut self, world: &World, states: &[BodyState], t: f64, observer: &mut dyn Observer) {
        while self.next_sample_s(world) <= t {
            self.next_sample += 1;
        }
        if self.last_sample_s == Some(t) {
            return;
        }
        self.last_sample_s = Some(t);
        let samples: Vec<_> = states.iter().enumerate().map(|(body, state)| world.sample(body, state)).collect();
        observer.sample(t, &samples);
    }

    /// Writes the accounts into the report of a run that ends with these states.
    pub(crate) fn fill(&mut self, world: &World, states: &[BodyState], report: &mut RunReport) {
        report.energy = self.books.observe(world, states);
        report.ledger = self.books.ledger;
        report.certificate = self.certificate;
        report.warnings = self.warnings.texts();
        report.steps = self.steps;
        report.events = self.event_count;
        report.bodies = world.named_samples(states);
    }
}

/// Checks that states are finite.
///
/// # Errors
/// When one is not.
pub(crate) fn check_finite(world: &World, states: &[BodyState], t: f64) -> Result<(), SimulationError> {
    match states.iter().position(|state| !state.is_finite()) {
        Some(body) => Err(SimulationError::Diverged { body: world.bodies[body].name.clone(), t }),
        None => Ok(()),
    }
}
