//! One run of a scene by one tier.

use super::subject::{Copy, Subject, Text};
use glam::DQuat;
use polhode::{
    BodySample, Certificate, ErrorEstimation, Event, Flow, Observer, Occurrence, Outcome, Simulation, SimulationError,
};
use polhode_oracles::judge::tiers::Poses;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::Path;
use std::time::{Duration, Instant};

/// Steps and events after which a run is ended: it is slow on every machine.
const MOST_STEPS: u64 = 20_000;
/// A run that takes longer is ended, s.
const MOST_S: Duration = Duration::from_secs(10);

/// How a run ended.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum Ending {
    /// Well.
    Completed,
    /// With a promise broken; the warning that says so first.
    Degraded(String),
    /// With an error.
    Failed(String),
    /// The scene was not taken by this tier.
    Refused(String),
    /// Ended after many steps or a long time.
    Late,
    /// A panic.
    Panicked,
}

/// A run.
#[derive(Debug)]
pub(super) struct Trial {
    pub(super) ending: Ending,
    pub(super) poses: Poses,
    pub(super) warnings: Vec<String>,
    /// Motions that it has chosen where the laws allow several.
    pub(super) choices: Vec<Occurrence>,
    pub(super) certificate: Certificate,
    /// Whether time steps have passed a stretch of crowded events.
    pub(super) is_crowded: bool,
    pub(super) seconds: f64,
}

struct Watch<'a> {
    subject: &'a Subject,
    copy: Copy,
    sizes: Vec<f64>,
    poses: Poses,
    steps: u64,
    start: Instant,
    is_stopped: bool,
}

impl Observer for Watch<'_> {
    fn sample(&mut self, _t: f64, bodies: &[BodySample]) {
        let mut row = Vec::with_capacity(bodies.len());
        for sample in bodies {
            let [w, x, y, z] = sample.pose.rotation.to_wxyz();
            row.push((sample.pose.translation, DQuat::from_xyzw(x, y, z, w)));
        }
        if self.copy != Copy::Placed {
            for (sample, size) in bodies.iter().zip(&self.sizes).filter(|(_, size)| size.is_finite()) {
                let rate = sample.velocity.linear.length() / size + sample.velocity.angular.length();
                self.poses.rate = self.poses.rate.max(rate);
            }
        }
        self.subject.undone(self.copy, &mut row);
        self.poses.rows.push(row);
    }

    fn event(&mut self, _event: &Event) {
        self.steps += 1;
    }

    fn progress(&mut self, _t: f64) -> Flow {
        self.steps += 1;
        self.is_stopped = self.steps > MOST_STEPS || self.start.elapsed() > MOST_S;
        if self.is_stopped { Flow::Stop } else { Flow::Continue }
    }
}

impl Trial {
    /// Runs a scene by a tier, at this step (none: as the plan has it), s.
    pub(super) fn of(subject: &Subject, copy: Copy, tier: &str, step_s: Option<f64>) -> Self {
        let text = subject.text(copy, tier, step_s);
        if text.meshes.is_empty() {
            return Self::of_text(subject, copy, &text, Path::new("random.toml"));
        }
        let folder = tempfile::tempdir().and_then(|folder| {
            for (name, mesh) in &text.meshes {
                std::fs::write(folder.path().join(name), mesh)?;
            }
            Ok(folder)
        });
        match folder {
            Ok(folder) => Self::of_text(subject, copy, &text, &folder.path().join("random.toml")),
            Err(error) => Self::ended(Ending::Refused(error.to_string())),
        }
    }

    fn ended(ending: Ending) -> Self {
        Self {
            ending,
            poses: Poses::default(),
            warnings: Vec::new(),
            choices: Vec::new(),
            certificate: Certificate::default(),
            is_crowded: false,
            seconds: 0.0,
        }
    }

    fn of_text(subject: &Subject, copy: Copy, text: &Text, origin: &Path) -> Self {
        let mut watch = Watch {
            subject,
            copy,
            sizes: subject.sizes(),
            poses: Poses::default(),
            steps: 0,
            start: Instant::now(),
            is_stopped: false,
        };
        let ran = catch_unwind(AssertUnwindSafe(|| {
            let loaded = polhode_scene::load_text(&origin.display().to_string(), &text.toml, &text.overrides)
                .map_err(|error| Ending::Refused(error.to_string()))?;
            let told = |error: SimulationError| match error {
                SimulationError::Scene(error) => Ending::Refused(error.to_string()),
                error => Ending::Failed(error.to_string()),
            };
            Simulation::new(&loaded.scene)
                .map_err(told)?
                .estimating(ErrorEstimation::Off)
                .run_observed(&mut watch)
                .map_err(told)
        }));
        let report = match ran {
            Err(_) => return Self::ended(Ending::Panicked),
            Ok(Err(ending)) => return Self::ended(ending),
            Ok(Ok(report)) => report,
        };
        let ending = match report.outcome {
            _ if watch.is_stopped => Ending::Late,
            Outcome::Completed => Ending::Completed,
            _ => Ending::Degraded(report.warnings.first().cloned().unwrap_or_default()),
        };
        Self {
            ending,
            poses: watch.poses,
            warnings: report.warnings,
            choices: report.choices,
            certificate: report.certificate,
            is_crowded: !report.crowded.is_empty(),
            seconds: watch.start.elapsed().as_secs_f64(),
        }
    }

    /// Whether it ended well.
    pub(super) fn is_well(&self) -> bool {
        self.ending == Ending::Completed
    }
}
