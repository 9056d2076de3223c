//! A run: of a scene from its start to its end, which Ctrl-C ends.

use crate::drawn::Drawn;
use crate::errors;
use crate::job::{self, Ended};
use crate::loaded::Loaded;
use crate::recorder::{Columns, Recorder, Shared};
use crate::recording::{Ending, Recording, Source};
use crate::telling::{self, Telling, Unread};
use polhode::{Body, Effects, RunReport, Simulation, SimulationError};
use polhode_scene::{LoadedScene, broken_json, certificate_json, scene_report_json};
use pyo3::exceptions::{PyKeyboardInterrupt, PyMemoryError};
use pyo3::prelude::*;
use std::sync::Arc;
use std::time::Instant;

/// What the thread of a run gives in the end.
struct Done {
    /// The report, and how long it took, s.
    ended: Result<(Box<RunReport>, f64), SimulationError>,
    /// What pages and plots tell, where that was kept.
    shown: Option<(Unread, Drawn)>,
}

/// Runs a scene from its start to its end; `told` is called with the time reached and the duration, s. With `keep` the
/// page with frames at least this far apart (s) and all plots are kept.
#[pyfunction]
pub(crate) fn run(
    py: Python<'_>,
    loaded: &Loaded,
    all_effects: bool,
    joints: bool,
    keep: Option<f64>,
    told: Option<Py<PyAny>>,
) -> PyResult<Recording> {
    let scene = Arc::clone(&loaded.scene);
    let has_joints = joints && !scene.scene.joints().is_empty();
    let shared = Shared::new(Columns::for_scene(&scene.scene, has_joints).map_err(|_| too_large(&scene))?);
    let effects = if all_effects { Effects::All } else { Effects::Planned };
    let (run, kept) = (Arc::clone(&scene), Arc::clone(&shared));
    let ended = job::work(py, told, move |watch| {
        // What cannot be shown is told when it is to be shown.
        let telling = keep.and_then(|least_s| Telling::of(&run, least_s).ok());
        let duration_s = run.scene.duration_s();
        compute(&run, effects, Recorder { shared: kept, has_joints, watch, duration_s, telling })
    })?;
    let body_names: Vec<String> = scene.scene.bodies().iter().map(|body: &Body| body.name().to_owned()).collect();
    let joint_names = if has_joints { scene.joint_names() } else { Vec::new() };
    let columns = shared.columns().close([body_names.len(), joint_names.len()]);
    let is_cut = matches!(ended, Ended::Raised(..));
    let (ending, shown) = ending(ended, py, &scene);
    let recording = Recording::new(columns, [body_names, joint_names], ending, Source { scene, effects, is_cut });
    if let Some((page, drawn)) = shown {
        recording.keep_page(page);
        recording.keep(drawn);
    }
    Ok(recording)
}

/// Computes it.
fn compute(loaded: &LoadedScene, effects: Effects, mut recorder: Recorder<'_>) -> Done {
    let begun = Instant::now();
    let mut simulation = match Simulation::with_effects(&loaded.scene, effects) {
        Ok(simulation) => simulation,
        Err(error) => return Done { ended: Err(error), shown: None },
    };
    let plan = simulation.plan().clone();
    let ended = simulation.run_observed(&mut recorder).map(Box::new);
    let wall_s = begun.elapsed().as_secs_f64();
    let shown = recorder.telling.and_then(|telling| {
        let told = match &ended {
            Ok(report) if report.simulated_s < report.duration_s => Err(telling::interrupted(report)),
            Ok(report) => Ok(report.clone()),
            Err(error) => Err(format!("{}: {error}", loaded.scene.name())),
        };
        telling.end(&plan, &told).ok()
    });
    Done { ended: ended.map(|report| (report, wall_s)), shown }
}

/// There is no memory for the samples.
fn too_large(loaded: &LoadedScene) -> PyErr {
    let scene = &loaded.scene;
    let samples = scene.duration_s() / scene.output_interval_s();
    PyMemoryError::new_err(format!(
        "{}: there is no memory for {samples:.0} samples of {} bodies: give a larger output.interval, or a shorter \
         duration",
        scene.name(),
        scene.bodies().len()
    ))
}

/// What is told of the end of a run.
fn ending(ended: Ended<Done>, py: Python<'_>, loaded: &LoadedScene) -> (Ending, Option<(Unread, Drawn)>) {
    let (done, raised) = match ended {
        Ended::Done(done) => (Some(done), None),
        Ended::Raised(raised, done) if raised.is_instance_of::<PyKeyboardInterrupt>(py) => {
            let said = format!("{}: interrupted; `run` of this exception has what was computed", loaded.scene.name());
            (done, Some(errors::plain(py, "Interrupted", &said)))
        }
        Ended::Raised(raised, done) => (done, Some(raised)),
    };
    let (ended, shown) = done.map_or((None, None), |done| (Some(done.ended), done.shown));
    let (report, failed) = match ended {
        Some(Ok(report)) => (Some(report), None),
        Some(Err(error)) => (None, Some(errors::simulation(py, loaded, error))),
        None => (None, None),
    };
    let failure = raised.or(failed).map(|error| error.into_value(py).into_any());
    let broken = report.as_ref().map_or_else(|| "[]".to_owned(), |(report, _)| broken_json(report).to_string());
    let certificate = report.as_ref().map(|(report, _)| certificate_json(report).to_string());
    let report = report.map(|(report, wall_s)| scene_report_json(loaded, &report, wall_s).to_string());
    (Ending { report, certificate, broken, failure }, shown)
}
