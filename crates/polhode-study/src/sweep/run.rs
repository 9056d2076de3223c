//! The runs of a sweep: one, and all of them on several threads.

use super::error::SweepError;
use super::measure::Measured;
use super::plan::Sweep;
use super::scene::{IsStopped, SweepScene};
use super::uncertain::reason_of;
use crate::threads::in_order;
use polhode::{BodySample, ContactSample, Energy, Event, Flow, JointSample, Observer, RunReport, Simulation};
use polhode_scene::names;
use std::num::NonZeroUsize;
use std::ops::Range;

/// A run that is finished.
#[derive(Debug, Clone, PartialEq)]
pub struct Row {
    /// Its number.
    pub run: u64,
    /// In a sweep of what is uncertain what it is for; its values, as a scene has them.
    pub values: Vec<String>,
    /// How it ended.
    pub outcome: String,
    /// The error that it tells of itself, of a body's size; NaN where it is not known.
    pub error: f64,
    /// What was measured; NaN where there is none.
    pub measured: Vec<f64>,
    /// Why it failed or is degraded; else empty.
    pub reason: String,
}

impl Sweep {
    /// Computes these runs by so many workers. `take` is given each row in the order of the runs.
    ///
    /// # Errors
    /// Those of `take`; [`SweepError::Stopped`] where runs are to end, after the rows that are
    /// finished.
    pub fn compute(
        &self,
        scene: &SweepScene<'_>,
        runs: Range<u64>,
        workers: NonZeroUsize,
        mut take: impl FnMut(Row) -> Result<(), SweepError>,
    ) -> Result<(), SweepError> {
        let mut left = runs.end - runs.start;
        let made = |run| if (scene.is_stopped)() { None } else { self.row(scene, run) };
        in_order(runs, workers, made, |row| {
            left -= 1;
            take(row)
        })?;
        if left > 0 { Err(SweepError::Stopped) } else { Ok(()) }
    }

    /// A run; none where it was stopped.
    fn row(&self, scene: &SweepScene<'_>, run: u64) -> Option<Row> {
        let nothing = vec![f64::NAN; self.measures.len()];
        let failed = |reason: &str| {
            let (values, reason) = (self.leading_cells(run), on_one_line(reason));
            Row { run, values, outcome: "failed".to_owned(), error: f64::NAN, measured: nothing.clone(), reason }
        };
        let loaded = match scene.loaded(&self.changes(run)) {
            Ok(loaded) => loaded,
            Err(error) => return Some(failed(&reason_of(&error))),
        };
        let measured = match self.measured_of(&loaded) {
            Ok(measured) => measured,
            Err(error) => return Some(failed(&error.to_string())),
        };
        let mut gather = Gather { measured, is_stopped: scene.is_stopped };
        let report = Simulation::with_effects(&loaded.scene, scene.effects)
            .and_then(|mut simulation| simulation.run_observed(&mut gather));
        if (scene.is_stopped)() {
            return None;
        }
        Some(match report {
            Err(error) => failed(&error.to_string()),
            Ok(report) => self.finished(run, &report, &gather.measured),
        })
    }

    fn finished(&self, run: u64, report: &RunReport, measured: &[Measured]) -> Row {
        let reason = match report.outcome {
            polhode::Outcome::Completed => "",
            _ => report.warnings.first().map_or("", String::as_str),
        };
        Row {
            run,
            values: self.leading_cells(run),
            outcome: names::outcome(report.outcome).to_owned(),
            error: report.error.relative().unwrap_or(f64::NAN),
            measured: measured.iter().map(Measured::value).collect(),
            reason: on_one_line(reason),
        }
    }
}

/// A text without line breaks.
fn on_one_line(text: &str) -> String {
    text.split_whitespace().collect::<Vec<_>>().join(" ")
}

/// Measures a run while it goes on.
struct Gather<'a> {
    measured: Vec<Measured>,
    is_stopped: &'a IsStopped<'a>,
}

impl Observer for Gather<'_> {
    fn sample(&mut self, _t_s: f64, bodies: &[BodySample]) {
        self.measured.iter_mut().for_each(|own| own.sample(bodies));
    }

    fn event(&mut self, event: &Event) {
        self.measured.iter_mut().for_each(|own| own.event(event));
    }

    fn wants_joints(&self) -> bool {
        self.measured.iter().any(Measured::is_of_joints)
    }

    fn joints(&mut self, _t_s: f64, joints: &[JointSample]) {
        self.measured.iter_mut().for_each(|own| own.joints(joints));
    }

    fn wants_contacts(&self) -> bool {
        self.measured.iter().any(Measured::is_of_contacts)
    }

    fn contacts(&mut self, _t_s: f64, contacts: &[ContactSample]) {
        self.measured.iter_mut().for_each(|own| own.contacts(contacts));
    }

    fn wants_energies(&self) -> bool {
        self.measured.iter().any(Measured::is_of_energy)
    }

    fn energy(&mut self, _t_s: f64, energy: &Energy) {
        self.measured.iter_mut().for_each(|own| own.energy(energy));
    }

    fn progress(&mut self, _t_s: f64) -> Flow {
        if (self.is_stopped)() { Flow::Stop } else { Flow::Continue }
    }
}
