//! Studies of a scene: which method reaches an accuracy, and what accuracy costs. They run in a thread that Ctrl-C
//! ends.

use crate::errors;
use crate::job::{self, Ended, Watch};
use crate::loaded::Loaded;
use polhode::{Effects, Flow};
use polhode_scene::Override;
use polhode_study::ladder::Range;
use polhode_study::timing::Effort;
use polhode_study::{Axis, Host, Options, Source, Study, StudyError, json};
use pyo3::exceptions::{PyKeyboardInterrupt, PyValueError};
use pyo3::prelude::*;
use std::cell::Cell;

/// Rounds of timing of a study whose table is asked for.
const ROUNDS: Effort = Effort { fewest_rounds: 3, most_rounds: 5, enough_s: 0.2 };

/// Phases of a study: the reference, errors and timing.
const PHASES: f64 = 3.0;

/// Lets a study go on until Ctrl-C, and tells how far it is.
struct Going<'a> {
    watch: &'a Watch,
    /// Phases that are over, and of the present one the parts that are done and all parts.
    over: Cell<f64>,
    parts: Cell<[f64; 2]>,
}

impl Host for Going<'_> {
    fn phase(&self, _what: &'static str, count: usize) {
        self.over.set(self.over.get() + 1.0);
        self.parts.set([0.0, count.max(1) as f64]);
    }

    fn part_done(&self) {
        let [done, all] = self.parts.get();
        self.parts.set([all.min(done + 1.0), all]);
    }

    fn flow(&self) -> Flow {
        let [done, all] = self.parts.get();
        self.watch.reached(self.over.get().clamp(0.0, PHASES - 1.0) + done / all, PHASES)
    }
}

/// The study of a scene as JSON, as `polhode cost --json` prints it. Without keys to vary, the search for `accuracy`
/// has the methods of the scene's law alone; the table without it has the other laws too. `told` is called with how
/// much of all is done.
#[pyfunction]
#[pyo3(signature = (loaded, all_effects, told, accuracy=None, vary=Vec::new(), budget_s=None))]
pub(crate) fn study(
    py: Python<'_>,
    loaded: &Loaded,
    all_effects: bool,
    told: Option<Py<PyAny>>,
    accuracy: Option<f64>,
    vary: Vec<String>,
    budget_s: Option<f64>,
) -> PyResult<String> {
    let (reader, given) = loaded.reader();
    let effects = if all_effects { Effects::All } else { Effects::Planned };
    let axes = vary.into_iter().map(|text| Axis::parse(&text)).collect::<Result<Vec<_>, _>>();
    let axes = axes.map_err(|fault| refused(py, StudyError::Axis(fault), loaded))?;
    let options = options(accuracy, budget_s);
    let ended = job::work(py, told, move |watch| {
        let going = Going { watch, over: Cell::new(-1.0), parts: Cell::new([0.0, 1.0]) };
        let load = |changes: &[Override]| reader.load(changes);
        let source = Source { load: &load, given, effects, host: &going };
        let study = Study::run(&source, &axes, &options)?;
        if let Some(target) = accuracy {
            study.answer(target)?;
        }
        Ok(json::value(&study, accuracy).to_string())
    })?;
    match ended {
        Ended::Done(done) => done.map_err(|error| refused(py, error, loaded)),
        Ended::Raised(raised, _) if raised.is_instance_of::<PyKeyboardInterrupt>(py) => {
            Err(refused(py, StudyError::Stopped, loaded))
        }
        Ended::Raised(raised, _) => Err(raised),
    }
}

/// What is asked of the study.
fn options(accuracy: Option<f64>, budget_s: Option<f64>) -> Options {
    let search = Options::for_accuracy(accuracy.unwrap_or(f64::NAN));
    let budget_s = budget_s.unwrap_or(search.budget_s);
    match accuracy {
        Some(_) => Options { budget_s, ..search },
        None => Options { target: None, range: Range::MethodsAndLaws, effort: ROUNDS, budget_s, ..search },
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
