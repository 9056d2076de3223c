//! A run in a thread of its own, which Ctrl-C ends.

use crate::errors;
use crate::loaded::Loaded;
use crate::recorder::{Columns, Recorder, Shared};
use crate::recording::{Ending, Recording};
use crate::worker::{self, Ended, Worker};
use polhode::{Body, Effects, RunReport, Simulation, SimulationError};
use polhode_scene::{LoadedScene, broken_json, certificate_json, scene_report_json};
use pyo3::exceptions::{PyKeyboardInterrupt, PyMemoryError};
use pyo3::prelude::*;
use std::sync::Arc;
use std::time::Instant;

/// What the thread of a run gives in the end: the report, and how long it took, s.
type Done = Result<(Box<RunReport>, f64), SimulationError>;

/// Runs a scene from its start to its end.
#[pyfunction]
pub(crate) fn run(py: Python<'_>, loaded: &Loaded, all_effects: bool, joints: bool) -> PyResult<Recording> {
    let scene = &loaded.scene;
    let has_joints = joints && !scene.scene.joints().is_empty();
    let shared = Shared::new(Columns::for_scene(&scene.scene, has_joints).map_err(|_| too_large(scene))?);
    let effects = if all_effects { Effects::All } else { Effects::Planned };
    let recorder = Recorder { shared: Arc::clone(&shared), has_joints };
    let worker = Worker::start(computation(Arc::clone(scene), effects, recorder))?;
    let ended = worker.wait(py, || shared.stop());
    let body_names: Vec<String> = scene.scene.bodies().iter().map(|body: &Body| body.name().to_owned()).collect();
    let joint_names = if has_joints { scene.joint_names() } else { Vec::new() };
    let columns = shared.columns().close([body_names.len(), joint_names.len()]);
    let ending = ending(py, ended, scene)?;
    Ok(Recording::new(columns, [body_names, joint_names], ending))
}

/// There is no memory for the samples.
fn too_large(loaded: &LoadedScene) -> PyErr {
    let scene = &loaded.scene;
    let samples = scene.duration_s() / scene.output_interval_s();
    PyMemoryError::new_err(format!(
        "{}: there is no memory for {samples:.0} samples of {} bodies: give a larger output.interval, or a shorter duration",
        scene.name(),
        scene.bodies().len()
    ))
}

/// What the thread of a run computes.
fn computation(
    loaded: Arc<LoadedScene>,
    effects: Effects,
    mut recorder: Recorder,
) -> impl FnOnce() -> Done + Send + 'static {
    move || {
        let begun = Instant::now();
        let done = Simulation::with_effects(&loaded.scene, effects)
            .and_then(|mut simulation| simulation.run_observed(&mut recorder));
        done.map(|report| (Box::new(report), begun.elapsed().as_secs_f64()))
    }
}

/// What is told of the end of a run.
fn ending(py: Python<'_>, ended: Ended<Done>, loaded: &LoadedScene) -> PyResult<Ending> {
    let (done, raised) = match ended {
        Ended::Lost => return Err(worker::lost()),
        Ended::Done(done) => (Some(done), None),
        Ended::Signal(raised, done) if raised.is_instance_of::<PyKeyboardInterrupt>(py) => {
            let said = format!("{}: interrupted; `run` of this exception has what was computed", loaded.scene.name());
            let _ = raised;
            (done, Some(errors::plain(py, "Interrupted", &said)))
        }
        Ended::Signal(raised, done) => (done, Some(raised)),
    };
    let (report, failed) = match done {
        Some(Ok(report)) => (Some(report), None),
        Some(Err(error)) => (None, Some(errors::simulation(py, loaded, error))),
        None => (None, None),
    };
    let failure = raised.or(failed).map(|error| error.into_value(py).into_any());
    let broken = report.as_ref().map_or_else(|| "[]".to_owned(), |(report, _)| broken_json(report).to_string());
    let certificate = report.as_ref().map(|(report, _)| certificate_json(report).to_string());
    let report = report.map(|(report, wall_s)| scene_report_json(loaded, &report, wall_s).to_string());
    Ok(Ending { report, certificate, broken, failure })
}
