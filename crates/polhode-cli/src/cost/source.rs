//! The scene under study: loaded anew with every candidate's changes, and run.

use crate::args::ChangeArgs;
use crate::failure::Failure;
use crate::scene::{self, SceneText};
use polhode::{BodySample, Effects, Flow, Observer, Outcome, Recorder, RunReport, Scene, Simulation};
use polhode_scene::{LoadedScene, Override, SceneFileError};
use std::time::{Duration, Instant};

/// A scene file with the changes of the command line.
#[derive(Debug, Clone)]
pub(crate) struct Source<'a> {
    /// Where the scene's text is.
    pub(crate) text: SceneText<'a>,
    /// Changes of the command line, the same for all candidates.
    pub(crate) given: Vec<Override>,
    /// Effects that are simulated.
    pub(crate) effects: Effects,
}

/// A run that came to its end.
#[derive(Debug)]
pub(crate) struct Completed {
    /// Its samples.
    pub(crate) record: Recorder,
    /// Its report.
    pub(crate) report: RunReport,
    /// The time it took.
    pub(crate) took: Duration,
}

impl<'a> Source<'a> {
    /// A scene with the changes of a command.
    pub(crate) fn new(text: &SceneText<'a>, changes: &ChangeArgs) -> Result<Self, Failure> {
        let given = scene::overrides(changes)?;
        Ok(Self { text: text.clone(), given, effects: scene::effects(changes) })
    }

    /// The scene as it is given.
    pub(crate) fn load(&self) -> Result<LoadedScene, Failure> {
        Ok(self.text.load(&self.given)?)
    }

    /// The scene with some values changed.
    ///
    /// # Errors
    /// Why the scene is refused, in a line.
    pub(crate) fn scene(&self, changes: &[Override]) -> Result<Scene, String> {
        let all: Vec<_> = self.given.iter().chain(changes).cloned().collect();
        Ok(self.text.load(&all).map_err(|error| reason(&error))?.scene)
    }

    /// Runs a scene and keeps its samples; stops it after `limit`, where there is one.
    ///
    /// # Errors
    /// Why the run failed, in a line.
    pub(crate) fn record(&self, scene: &Scene, limit: Option<Duration>) -> Result<Completed, String> {
        let mut watch = Watch { record: Recorder::default(), until: limit.map(|limit| Instant::now() + limit) };
        let (report, took) = self.run(scene, &mut watch)?;
        match report.outcome {
            // A method that breaks its promise is shown with the error that it has.
            Outcome::Completed | Outcome::Degraded if report.simulated_s >= report.duration_s => {
                Ok(Completed { record: watch.record, report, took })
            }
            _ => {
                let (at, end, took) = (report.simulated_s, report.duration_s, took.as_secs_f64());
                Err(format!("left out: stopped at {at:.3} of {end} s after {took:.1} s; --vary lets it run"))
            }
        }
    }

    /// Runs a scene; the time does not count what is done before the first step: reading the scene, the plan, the
    /// search for what touches at the start.
    ///
    /// # Errors
    /// Why the run failed, in a line.
    pub(crate) fn run(&self, scene: &Scene, observer: &mut dyn Observer) -> Result<(RunReport, Duration), String> {
        let mut simulation = Simulation::with_effects(scene, self.effects).map_err(|error| error.to_string())?;
        let started = Instant::now();
        let report = simulation.run_observed(observer).map_err(|error| error.to_string())?;
        Ok((report, started.elapsed()))
    }
}

/// Keeps samples until a time.
struct Watch {
    record: Recorder,
    until: Option<Instant>,
}

impl Observer for Watch {
    fn sample(&mut self, t: f64, bodies: &[BodySample]) {
        self.record.sample(t, bodies);
    }

    fn progress(&mut self, _t: f64) -> Flow {
        if self.until.is_some_and(|until| Instant::now() > until) { Flow::Stop } else { Flow::Continue }
    }
}

/// Why a scene is refused, without the line of the file.
fn reason(error: &SceneFileError) -> String {
    error.refused().map_or_else(|| error.to_string(), |refused| refused.cause.to_string())
}
