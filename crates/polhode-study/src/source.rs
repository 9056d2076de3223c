//! The scene under study: loaded anew with every candidate's changes, and run.

use crate::error::StudyError;
use crate::host::Host;
use polhode::{BodySample, Effects, ErrorEstimation, Flow, Observer, Outcome, Recorder, RunReport, Scene, Simulation};
use polhode_scene::{LoadedScene, Override, SceneFileError};
use std::fmt;
use std::time::{Duration, Instant};

/// Reads a scene with some of its values changed.
pub type Load<'a> = dyn Fn(&[Override]) -> Result<LoadedScene, SceneFileError> + 'a;

/// A scene that can be loaded many times, each time with other changes.
#[derive(Clone)]
pub struct Source<'a> {
    /// Reads it.
    pub load: &'a Load<'a>,
    /// Changes that are the same for all candidates.
    pub given: Vec<Override>,
    /// Effects that are simulated.
    pub effects: Effects,
    /// The program that asks.
    pub host: &'a dyn Host,
}

impl fmt::Debug for Source<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { given, effects, .. } = self;
        f.debug_struct("Source").field("given", given).field("effects", effects).finish_non_exhaustive()
    }
}

/// A run that came to its end.
#[derive(Debug)]
pub struct Completed {
    /// Its samples.
    pub record: Recorder,
    /// Its report.
    pub report: RunReport,
    /// The time it took.
    pub took: Duration,
}

impl Source<'_> {
    /// The scene as it is given.
    ///
    /// # Errors
    /// When it is refused.
    pub fn loaded(&self) -> Result<LoadedScene, StudyError> {
        Ok((self.load)(&self.given)?)
    }

    /// The scene with some values changed.
    ///
    /// # Errors
    /// Why the scene is refused, in a line.
    pub fn scene(&self, changes: &[Override]) -> Result<Scene, String> {
        let all: Vec<_> = self.given.iter().chain(changes).cloned().collect();
        Ok((self.load)(&all).map_err(|error| reason(&error))?.scene)
    }

    /// Runs a scene and keeps its samples; stops it after `limit`, where there is one.
    ///
    /// # Errors
    /// Why the run failed, in a line.
    pub fn record(&self, scene: &Scene, limit: Option<Duration>) -> Result<Completed, String> {
        self.record_estimating(scene, limit, ErrorEstimation::Off)
    }

    /// The same, with its error estimated so: it takes longer.
    ///
    /// # Errors
    /// Why the run failed, in a line.
    pub fn record_estimating(
        &self,
        scene: &Scene,
        limit: Option<Duration>,
        estimation: ErrorEstimation,
    ) -> Result<Completed, String> {
        let mut watch = Watch {
            record: Recorder::default(),
            until: limit.map(|limit| Instant::now() + limit),
            going: Going { host: self.host },
        };
        let (report, took) = self.timed(scene, estimation, &mut watch)?;
        match report.outcome {
            // A method that breaks its promise is shown with the error that it has.
            Outcome::Completed | Outcome::Degraded if report.simulated_s >= report.duration_s => {
                Ok(Completed { record: watch.record, report, took })
            }
            _ => {
                let (at, end, took) = (report.simulated_s, report.duration_s, took.as_secs_f64());
                Err(format!(
                    "left out: stopped at {at:.3} of {end} s after {took:.1} s; a list of values to vary lets it run"
                ))
            }
        }
    }

    /// Runs a scene and keeps nothing of it.
    ///
    /// # Errors
    /// Why the run failed, in a line.
    pub fn run(&self, scene: &Scene) -> Result<(RunReport, Duration), String> {
        self.timed(scene, ErrorEstimation::Off, &mut Going { host: self.host })
    }

    /// Runs a scene; the time does not count what is done before the first step: reading the scene, the plan, the
    /// search for what touches at the start.
    fn timed(
        &self,
        scene: &Scene,
        estimation: ErrorEstimation,
        observer: &mut dyn Observer,
    ) -> Result<(RunReport, Duration), String> {
        let mut simulation =
            Simulation::with_effects(scene, self.effects).map_err(|error| error.to_string())?.estimating(estimation);
        let started = Instant::now();
        let report = simulation.run_observed(observer).map_err(|error| error.to_string())?;
        Ok((report, started.elapsed()))
    }
}

/// Lets a run go on for as long as its host does.
struct Going<'a> {
    host: &'a dyn Host,
}

impl Observer for Going<'_> {
    fn sample(&mut self, _t: f64, _bodies: &[BodySample]) {}

    fn wants_samples(&self) -> bool {
        false
    }

    fn progress(&mut self, _t: f64) -> Flow {
        self.host.flow()
    }
}

/// Keeps samples until a time.
struct Watch<'a> {
    record: Recorder,
    until: Option<Instant>,
    going: Going<'a>,
}

impl Observer for Watch<'_> {
    fn sample(&mut self, t: f64, bodies: &[BodySample]) {
        self.record.sample(t, bodies);
    }

    fn progress(&mut self, t: f64) -> Flow {
        if self.until.is_some_and(|until| Instant::now() > until) { Flow::Stop } else { self.going.progress(t) }
    }
}

/// Why a scene is refused, without the line of the file.
fn reason(error: &SceneFileError) -> String {
    error.refused().map_or_else(|| error.to_string(), |refused| refused.cause.to_string())
}
