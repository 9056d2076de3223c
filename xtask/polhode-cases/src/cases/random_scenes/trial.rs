//! One run of a random scene: it ends, or is ended after a number of steps.

use polhode::{
    BodySample, Effects, ErrorEstimation, Event, Flow, Observer, Outcome, RunReport, Scene, Simulation,
    SimulationError, Snapshot,
};
use polhode_oracles::judge::{Account, State, Track};
use polhode_oracles::random_scene::model::Model;
use std::error::Error;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::Path;
use std::time::Instant;

/// Steps and events after which a run is ended: it is slow on every machine.
const MOST_STEPS: u64 = 60_000;
/// A run that takes longer is ended, s.
const MOST_S: f64 = 20.0;

/// In a second.
const NANOSECONDS: f64 = 1e9;

/// How a run ended.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum Ending {
    /// At its duration, without a limit exceeded.
    Completed,
    /// With a limit exceeded; the first warning.
    Degraded(String),
    /// With an error.
    Failed(String),
    /// The scene was not taken.
    Refused(String),
    /// Ended after many steps.
    Slow(String),
    /// Ended after a long time.
    Late(String),
    /// A panic.
    Panicked,
}

/// A run.
#[derive(Debug)]
pub(super) struct Trial {
    pub(super) ending: Ending,
    pub(super) track: Track,
    /// Steps and events.
    pub(super) steps: u64,
    /// s
    pub(super) wall_s: f64,
}

/// Where a run is interrupted, kept and continued, s; nowhere if none.
pub(super) type Pause = Option<f64>;

struct Bounded {
    track: Track,
    steps: u64,
    start: Instant,
    computed_s: Option<f64>,
    pause_s: f64,
    is_paused: bool,
    is_stopped: bool,
}

impl Observer for Bounded {
    fn sample(&mut self, t: f64, bodies: &[BodySample]) {
        self.track.times.push(t);
        self.track.states.push(bodies.iter().map(state).collect());
    }

    fn event(&mut self, _event: &Event) {
        self.steps += 1;
    }

    fn progress(&mut self, t: f64) -> Flow {
        self.steps += 1;
        self.is_stopped = self.steps > MOST_STEPS || self.elapsed_s() > MOST_S;
        self.is_paused = t >= self.pause_s;
        if self.is_stopped || self.is_paused { Flow::Stop } else { Flow::Continue }
    }
}

/// Computing time of this thread, s; nothing where the system does not tell it.
fn computing_s() -> Option<f64> {
    let told = std::fs::read_to_string("/proc/thread-self/schedstat").ok()?;
    Some(told.split_whitespace().next()?.parse::<f64>().ok()? / NANOSECONDS)
}

impl Bounded {
    /// Computing time since the start, or the time passed where the system does not tell it, s.
    fn elapsed_s(&self) -> f64 {
        let passed_s = self.start.elapsed().as_secs_f64();
        self.computed_s.zip(computing_s()).map_or(passed_s, |(start_s, now_s)| now_s - start_s)
    }
}

fn state(sample: &BodySample) -> State {
    let [w, x, y, z] = sample.pose.rotation.to_wxyz();
    State {
        position: sample.pose.translation,
        orientation: glam::DQuat::from_xyzw(x, y, z, w),
        velocity: sample.velocity.linear,
        angular_velocity: sample.velocity.angular,
    }
}

impl Trial {
    /// Runs a scene, paused and continued by another simulation if asked.
    ///
    /// # Errors
    /// When its files cannot be written.
    pub(super) fn of(model: &Model, effects: Effects, pause: Pause) -> Result<Self, Box<dyn Error>> {
        let folder = tempfile::tempdir()?;
        let written = model.written("random");
        for (name, text) in &written.meshes {
            std::fs::write(folder.path().join(name), text)?;
        }
        let origin = folder.path().join("random.toml");
        Ok(Self::of_text(&origin, &written.text, effects, pause))
    }

    /// Runs a scene from the text of its file.
    pub(super) fn of_text(origin: &Path, text: &str, effects: Effects, pause: Pause) -> Self {
        let mut observer = Bounded {
            track: Track::default(),
            steps: 0,
            start: Instant::now(),
            computed_s: computing_s(),
            pause_s: pause.unwrap_or(f64::INFINITY),
            is_paused: false,
            is_stopped: false,
        };
        let ran = catch_unwind(AssertUnwindSafe(|| {
            match polhode_scene::load_text(&origin.display().to_string(), text, &[]) {
                Err(error) => Ending::Refused(error.to_string()),
                Ok(loaded) => match run(&loaded.scene, effects, &mut observer) {
                    Ok(report) => ending(&report, &mut observer),
                    Err(error @ SimulationError::Scene(_)) => Ending::Refused(error.to_string()),
                    Err(error) => Ending::Failed(error.to_string()),
                },
            }
        }));
        let wall_s = observer.elapsed_s();
        let Bounded { track, steps, .. } = observer;
        Self { ending: ran.unwrap_or(Ending::Panicked), track, steps, wall_s }
    }
}

fn run(scene: &Scene, effects: Effects, observer: &mut Bounded) -> Result<RunReport, SimulationError> {
    let mut simulation = Simulation::with_effects(scene, effects)?.estimating(ErrorEstimation::Off);
    let report = simulation.run_observed(observer)?;
    if !observer.is_paused || report.outcome == Outcome::Completed || observer.is_stopped {
        return Ok(report);
    }
    observer.pause_s = f64::INFINITY;
    let bytes = simulation.snapshot().to_bytes();
    let mut continued = Simulation::with_effects(scene, effects)?.estimating(ErrorEstimation::Off);
    if let Ok(snapshot) = Snapshot::from_bytes(&bytes) {
        continued.restore(&snapshot)?;
    }
    continued.run_observed(observer)
}

fn ending(report: &RunReport, observer: &mut Bounded) -> Ending {
    let ledger = &report.ledger;
    observer.track.account = Account {
        impact: ledger.impact.value(),
        friction: ledger.friction.value(),
        rest: ledger.rest.value(),
        damping: ledger.damping.value(),
        external: ledger.external.value(),
        projection: ledger.projection.value(),
        numerical: ledger.numerical.value(),
        initial: report.energy.initial_j,
        end: report.energy.final_j,
        is_crowded: !report.crowded.is_empty(),
        first_choice_s: report.choices.iter().map(|choice| choice.first_s).min_by(f64::total_cmp),
    };
    if observer.is_stopped {
        let place = format!("at t = {} s of {} s", report.simulated_s, report.duration_s);
        return if observer.steps > MOST_STEPS { Ending::Slow(place) } else { Ending::Late(place) };
    }
    match report.outcome {
        Outcome::Completed => Ending::Completed,
        _ => Ending::Degraded(report.warnings.first().cloned().unwrap_or_default()),
    }
}
