//! Studies of a scene: which method reaches an accuracy, and what accuracy costs. They run in a thread that Ctrl-C ends.

use crate::errors;
use crate::loaded::Loaded;
use crate::worker::{self, Ended, Worker};
use polhode::{Effects, Flow};
use polhode_scene::Override;
use polhode_study::ladder::Range;
use polhode_study::timing::Effort;
use polhode_study::{Axis, Counting, Host, Options, Source, Study, StudyError, json};
use pyo3::exceptions::{PyKeyboardInterrupt, PyValueError};
use pyo3::prelude::*;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

/// Rounds of timing of a study whose table is asked for.
const ROUNDS: Effort = Effort { fewest_rounds: 3, most_rounds: 5, enough_s: 0.2 };

/// Lets a study go on until Ctrl-C.
struct Going(Arc<AtomicBool>);

impl Host for Going {
    fn flow(&self) -> Flow {
        if self.0.load(Ordering::Relaxed) { Flow::Stop } else { Flow::Continue }
    }
}

/// The study of a scene as JSON, as `polhode cost --json` prints it. Without keys to vary, the search for `accuracy` has the methods
/// of the scene's law alone; the table without it has the other laws too.
#[pyfunction]
#[pyo3(signature = (loaded, all_effects, accuracy=None, vary=Vec::new(), budget_s=None))]
pub(crate) fn study(
    py: Python<'_>,
    loaded: &Loaded,
    all_effects: bool,
    accuracy: Option<f64>,
    vary: Vec<String>,
    budget_s: Option<f64>,
) -> PyResult<String> {
    let (reader, given) = loaded.reader();
    let effects = if all_effects { Effects::All } else { Effects::Planned };
    let axes = vary.into_iter().map(|text| Axis::parse(&text)).collect::<Result<Vec<_>, _>>();
    let axes = axes.map_err(|fault| refused(py, StudyError::Axis(fault), loaded))?;
    let options = options(accuracy, budget_s);
    let stop = Arc::new(AtomicBool::new(false));
    let going = Going(Arc::clone(&stop));
    let worker = Worker::start(move || {
        let load = |changes: &[Override]| reader.load(changes);
        let source = Source { load: &load, given, effects, host: &going };
        let study = Study::run(&source, &axes, &options)?;
        if let Some(target) = accuracy {
            study.answer(target)?;
        }
        Ok(json::value(&study, accuracy).to_string())
    })?;
    match worker.wait(py, || stop.store(true, Ordering::Relaxed)) {
        Ended::Done(done) => done.map_err(|error| refused(py, error, loaded)),
        Ended::Signal(raised, _) if raised.is_instance_of::<PyKeyboardInterrupt>(py) => {
            Err(refused(py, StudyError::Stopped, loaded))
        }
        Ended::Signal(raised, _) => Err(raised),
        Ended::Lost => Err(worker::lost()),
    }
}

/// What is asked of the study.
fn options(accuracy: Option<f64>, budget_s: Option<f64>) -> Options {
    let search = Options::for_accuracy(accuracy.unwrap_or(f64::NAN));
    let budget_s = budget_s.unwrap_or(search.budget_s);
    match accuracy {
        Some(_) => Options { budget_s, ..search },
        None => Options {
            target: None,
            range: Range::MethodsAndLaws,
            effort: ROUNDS,
            counting: Counting::Time,
            budget_s,
            ..search
        },
    }
}

/// Why there is no study, or no answer, as an exception.
fn refused(py: Python<'_>, error: StudyError, loaded: &Loaded) -> PyErr {
    let name = loaded.scene.scene.name();
    match error {
        StudyError::Scene(error) => errors::scene(py, &error),
        StudyError::Axis(fault) => PyValueError::new_err(format!("vary: {fault}")),
        StudyError::Accuracy { .. } => PyValueError::new_err(format!("accuracy={error}")),
        StudyError::NotReached { asked, .. } => errors::not_reached(py, &format!("{name}: {error}"), asked),
        StudyError::Stopped => {
            errors::plain(py, "Interrupted", &format!("{name}: the search for a method was interrupted"))
        }
        error => errors::plain(py, "SimulationError", &format!("{name}: {error}")),
    }
}
