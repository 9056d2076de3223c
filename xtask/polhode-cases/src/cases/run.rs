//! Running scenes: one call that gives the report and everything that was observed.

use super::kept::Kept;
use polhode::{BodySample, Effects, ErrorEstimation, Event, EventKind, Recorder, RunReport, Scene, Simulation};
use std::error::Error;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::time::Instant;

/// A finished run.
#[derive(Debug)]
pub struct Run {
    /// The scene.
    pub scene: Scene,
    /// The report.
    pub report: RunReport,
    /// Samples and events.
    pub record: Recorder,
    /// Wall time of the run, s.
    pub wall_s: f64,
}

impl Run {
    /// Runs a scene to its end.
    ///
    /// # Errors
    /// When it is refused or the simulation fails.
    pub fn of(scene: &Scene, effects: Effects) -> Result<Self, Box<dyn Error>> {
        let mut record = Recorder::default();
        let start = Instant::now();
        let report =
            Simulation::with_effects(scene, effects)?.estimating(ErrorEstimation::Off).run_observed(&mut record)?;
        let wall_s = start.elapsed().as_secs_f64();
        Ok(Self { scene: scene.clone(), report, record, wall_s })
    }

    /// The last state of the body of this name.
    ///
    /// # Errors
    /// When there is none.
    pub(super) fn last(&self, name: &str) -> Result<BodySample, Box<dyn Error>> {
        let found = self.report.bodies.iter().find(|body| body.name == name);
        Ok(found.ok_or_else(|| format!("no body {name}"))?.state)
    }

    /// Events of one kind, in order.
    pub(super) fn events(&self, kind: EventKind) -> Vec<Event> {
        self.record.events.iter().filter(|event| event.kind == kind).copied().collect()
    }

    /// Largest distance of any point of any body from where it was at the start, m: displacement of the origin plus
    /// what the rotation does at the body's far end.
    pub(super) fn largest_movement_m(&self) -> f64 {
        let Some(first) = self.record.samples.first() else { return f64::NAN };
        self.record.samples.iter().map(|sample| movement_m(&self.scene, first, sample)).fold(0.0, f64::max)
    }
}

/// Largest distance of any point of any body between two samples, m.
pub(crate) fn movement_m(scene: &Scene, before: &[BodySample], after: &[BodySample]) -> f64 {
    let moved = scene.bodies().iter().zip(before.iter().zip(after)).map(|(body, (a, b))| {
        let displacement = (b.pose.translation - a.pose.translation).length();
        displacement + a.pose.rotation.angle_to(b.pose.rotation) * reach_m(body)
    });
    // A state that is not a number counts as infinitely far.
    moved.fold(0.0, |most: f64, distance| if distance.is_nan() { f64::INFINITY } else { most.max(distance) })
}

/// Distance of the farthest point of a body from its origin, m; zero for what is fixed or has no shape.
fn reach_m(body: &polhode::Body) -> f64 {
    match body.shape() {
        Some(polhode::Geometry::Shape(shape)) if !body.is_fixed() => shape.radius(),
        _ => 0.0,
    }
}

/// The scenes that the project ships, and their runs, each made when first asked for.
#[derive(Debug)]
pub struct ShippedScenes {
    folder: PathBuf,
    planned: Kept<Run>,
}

impl ShippedScenes {
    pub(super) fn new(folder: &Path) -> Self {
        Self { folder: folder.to_owned(), planned: Kept::default() }
    }

    /// Names of the scenes, in order.
    ///
    /// # Errors
    /// When the folder cannot be read.
    pub fn names(&self) -> Result<Vec<String>, Box<dyn Error>> {
        let entries = std::fs::read_dir(&self.folder).map_err(|error| format!("{}: {error}", self.folder.display()))?;
        let mut names = Vec::new();
        for entry in entries {
            let path = entry?.path();
            if path.extension().is_some_and(|extension| extension == "toml") {
                names.extend(path.file_stem().map(|stem| stem.to_string_lossy().into_owned()));
            }
        }
        names.sort();
        Ok(names)
    }

    /// The file of a scene.
    pub fn path(&self, name: &str) -> PathBuf {
        self.folder.join(format!("{name}.toml"))
    }

    /// The scene of this name.
    ///
    /// # Errors
    /// When there is none or it is refused.
    pub fn load(&self, name: &str) -> Result<Scene, Box<dyn Error>> {
        polhode_scene::load(&self.path(name)).map_err(|error| format!("{name}: {error}").into())
    }

    /// The run of this scene with the effects that the plan finds it to call for.
    ///
    /// # Errors
    /// When there is no such scene or it does not run to its end.
    pub fn run(&self, name: &str) -> Result<Arc<Run>, Box<dyn Error>> {
        self.planned.get(name, || Run::of(&self.load(name)?, Effects::Planned))
    }
}
