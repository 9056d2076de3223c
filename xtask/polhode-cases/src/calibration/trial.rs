//! One run of a scene, with what it says of itself.

use super::told::{Told, told};
use polhode::spatial::Pose;
use polhode::{BodySample, ErrorEstimation, Event, Flow, Observer, Scene, Simulation, SimulationError};
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::time::{Duration, Instant};

/// Steps and events after which a run is ended: it is slow on every machine.
const MOST_STEPS: u64 = 20_000;
/// A run that takes longer is ended, s.
const MOST_S: Duration = Duration::from_secs(40);

/// Why there is no run to compare.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum NoTrial {
    /// The tier does not take the scene.
    Refused(String),
    /// It failed.
    Failed(String),
    /// It took many steps or a long time.
    Late,
}

/// A run.
#[derive(Debug, Clone, Default)]
pub(super) struct Trial {
    /// Times of the samples, s.
    pub(super) times_s: Vec<f64>,
    /// Poses of all bodies at each.
    pub(super) rows: Vec<Vec<Pose>>,
    /// What it tells of its error.
    pub(super) told: Told,
}

/// Keeps poses, and ends what is late.
struct Watch {
    trial: Trial,
    steps: u64,
    start: Instant,
    is_stopped: bool,
}

impl Observer for Watch {
    fn sample(&mut self, t_s: f64, bodies: &[BodySample]) {
        self.trial.times_s.push(t_s);
        self.trial.rows.push(bodies.iter().map(|body| body.pose).collect());
    }

    fn event(&mut self, _event: &Event) {
        self.steps += 1;
    }

    fn progress(&mut self, _t_s: f64) -> Flow {
        self.steps += 1;
        self.is_stopped = self.steps > MOST_STEPS || self.start.elapsed() > MOST_S;
        if self.is_stopped { Flow::Stop } else { Flow::Continue }
    }
}

impl Trial {
    /// Runs a scene, whose error is estimated so.
    ///
    /// # Errors
    /// When there is nothing to compare.
    pub(super) fn of(scene: &Scene, estimation: ErrorEstimation) -> Result<Self, NoTrial> {
        let mut watch = Watch { trial: Self::default(), steps: 0, start: Instant::now(), is_stopped: false };
        let ran = catch_unwind(AssertUnwindSafe(|| {
            let mut simulation = Simulation::new(scene).map_err(|error| match error {
                SimulationError::Scene(error) => NoTrial::Refused(error.to_string()),
                error => NoTrial::Failed(error.to_string()),
            })?;
            simulation.set_error_estimation(estimation);
            simulation.run_observed(&mut watch).map_err(|error| NoTrial::Failed(error.to_string()))
        }));
        let report = ran.unwrap_or_else(|_| Err(NoTrial::Failed("a panic".to_owned())))?;
        if watch.is_stopped {
            return Err(NoTrial::Late);
        }
        Ok(Self { told: told(&report), ..watch.trial })
    }
}
