//! A run in a thread of its own. The thread that asked for it waits, lets other threads of Python work, and looks for Ctrl-C.

use crate::errors;
use crate::loaded::Loaded;
use crate::recorder::{Columns, Recorder, Shared};
use crate::recording::{Ending, Recording};
use polhode::{Body, Effects, RunReport, Simulation, SimulationError};
use polhode_scene::{LoadedScene, broken_json, certificate_json, scene_report_json};
use pyo3::exceptions::{PyKeyboardInterrupt, PyMemoryError, PyRuntimeError};
use pyo3::prelude::*;
use std::sync::Arc;
use std::sync::mpsc::{Receiver, RecvTimeoutError, channel};
use std::time::{Duration, Instant};

/// How long Ctrl-C may go unseen.
const LOOK_EVERY: Duration = Duration::from_millis(50);
/// How long a step may take to end after Ctrl-C: what is left of two seconds is for handing over what was computed.
const PATIENCE: Duration = Duration::from_millis(1500);
/// Stack of the thread of a run, bytes: that of a program's first thread.
const STACK: usize = 8 << 20;

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
    let waited = Arc::clone(&shared);
    let given = start(Arc::clone(scene), effects, recorder)?;
    let ended = py.detach(move || wait(&given, &waited));
    let body_names: Vec<String> = scene.scene.bodies().iter().map(|body: &Body| body.name().to_owned()).collect();
    let joint_names = if has_joints { scene.joint_names() } else { Vec::new() };
    let columns = shared.columns().close([body_names.len(), joint_names.len()]);
    let ending = ended.ending(py, scene)?;
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

/// Starts the thread of a run.
fn start(loaded: Arc<LoadedScene>, effects: Effects, mut recorder: Recorder) -> PyResult<Receiver<Done>> {
    let (give, given) = channel();
    let compute = move || {
        let begun = Instant::now();
        let done = Simulation::with_effects(&loaded.scene, effects)
            .and_then(|mut simulation| simulation.run_observed(&mut recorder));
        // Nobody takes it when whoever waited has gone.
        let _ = give.send(done.map(|report| (Box::new(report), begun.elapsed().as_secs_f64())));
    };
    let thread = std::thread::Builder::new().name("polhode".to_owned()).stack_size(STACK).spawn(compute);
    thread.map_err(|error| PyRuntimeError::new_err(format!("no thread can be started for the run: {error}")))?;
    Ok(given)
}

/// How the wait for a run has ended.
enum Ended {
    Done(Done),
    /// What a handler of a signal has raised, and the run if it has ended in time.
    Signal(PyErr, Option<Done>),
    /// The thread has gone without a word.
    Lost,
}

/// Waits for the end of a run, and looks for signals meanwhile.
fn wait(given: &Receiver<Done>, shared: &Shared) -> Ended {
    loop {
        match given.recv_timeout(LOOK_EVERY) {
            Ok(done) => return Ended::Done(done),
            Err(RecvTimeoutError::Disconnected) => return Ended::Lost,
            Err(RecvTimeoutError::Timeout) => {}
        }
        if let Some(raised) = errors::raised_by_signal() {
            shared.stop();
            return Ended::Signal(raised, given.recv_timeout(PATIENCE).ok());
        }
    }
}

impl Ended {
    /// What is told of it.
    fn ending(self, py: Python<'_>, loaded: &LoadedScene) -> PyResult<Ending> {
        let (done, raised) = match self {
            Self::Lost => return Err(PyRuntimeError::new_err("the run broke off: a bug, whatever the scene was")),
            Self::Done(done) => (Some(done), None),
            Self::Signal(raised, done) if raised.is_instance_of::<PyKeyboardInterrupt>(py) => {
                let said =
                    format!("{}: interrupted; `run` of this exception has what was computed", loaded.scene.name());
                let _ = raised;
                (done, Some(errors::plain(py, "Interrupted", &said)))
            }
            Self::Signal(raised, done) => (done, Some(raised)),
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
}
