//! Errors of the library as Python's exceptions, which keep place and cure. The classes are in `polhode/_errors.py`.

use polhode::{SimulationError, SnapshotError};
use polhode_scene::robot::Finding;
use polhode_scene::{LoadedScene, Refused, SceneFileError};
use polhode_view::ViewError;
use pyo3::exceptions::{PyOSError, PyValueError};
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyList};

/// The module of the exceptions.
const MODULE: &str = "polhode._errors";

/// An exception of this class; `keep` gives it what it keeps.
fn made(py: Python<'_>, class: &str, message: &str, keep: impl FnOnce(&Bound<'_, PyDict>) -> PyResult<()>) -> PyErr {
    let make = || {
        let kept = PyDict::new(py);
        keep(&kept)?;
        py.import(MODULE)?.getattr(class)?.call((message,), Some(&kept))
    };
    // Where the exception cannot be made, the reason is what is raised.
    make().map_or_else(|error| error, PyErr::from_value)
}

/// An exception of this class that keeps nothing but its message.
pub(crate) fn plain(py: Python<'_>, class: &str, message: &str) -> PyErr {
    made(py, class, message, |_| Ok(()))
}

/// A value that is refused.
pub(crate) fn value(reason: impl std::fmt::Display) -> PyErr {
    PyValueError::new_err(reason.to_string())
}

/// One thing that is refused: where (file or argument, line, column, key or part of a robot), why, and what mends it.
struct Told {
    place: (String, usize, usize, String),
    message: String,
    cure: Option<String>,
}

impl Told {
    fn of(error: &SceneFileError) -> Vec<Self> {
        if let SceneFileError::Robot(robot) = error {
            return robot.findings().iter().map(Self::of_finding).collect();
        }
        error.all_refused().iter().map(Self::of_refused).collect()
    }

    fn of_refused(refused: &Refused) -> Self {
        let place = &refused.place;
        let place = (place.origin.clone(), place.line, place.column, place.key.clone());
        Self { place, message: refused.cause.to_string(), cure: refused.cure() }
    }

    fn of_finding(finding: &Finding) -> Self {
        let (place, cure) = (&finding.place, finding.cure());
        let place = (place.file.display().to_string(), place.line, place.column, finding.subject.clone());
        Self { place, message: finding.defect.to_string(), cure: (!cure.is_empty()).then_some(cure) }
    }
}

/// A scene that cannot be read or is refused.
pub(crate) fn scene(py: Python<'_>, error: &SceneFileError) -> PyErr {
    if error.is_input_output() {
        return PyOSError::new_err(error.to_string());
    }
    made(py, "SceneError", &error.to_string(), |kept| {
        let told = Told::of(error);
        if let Some(first) = told.first() {
            kept.set_item("place", &first.place)?;
            kept.set_item("cure", &first.cure)?;
        }
        let each = told.into_iter().map(|Told { place, message, cure }| {
            let one = PyDict::new(py);
            one.set_item("place", place)?;
            one.set_item("message", message)?;
            one.set_item("cure", cure)?;
            Ok(one)
        });
        kept.set_item("errors", PyList::new(py, each.collect::<PyResult<Vec<_>>>()?)?)
    })
}

/// A simulation that cannot be made or cannot go on.
pub(crate) fn simulation(py: Python<'_>, loaded: &LoadedScene, error: SimulationError) -> PyErr {
    match error {
        SimulationError::Scene(error) => scene(py, &loaded.explain(error)),
        SimulationError::Action(error) => plain(py, "ActionError", &error.to_string()),
        SimulationError::Snapshot(error) => snapshot(py, &error),
        SimulationError::TimeInThePast { .. } => plain(py, "ActionError", &error.to_string()),
        error => made(py, "SimulationError", &format!("{}: {error}", loaded.scene.name()), |kept| {
            kept.set_item("time", error.time())?;
            kept.set_item("bodies", error.bodies())?;
            kept.set_item("cure", error.cure())
        }),
    }
}

/// Something that an action asks of a simulation is refused, also where a scene would refuse it: it is in no file.
pub(crate) fn action(py: Python<'_>, loaded: &LoadedScene, error: SimulationError) -> PyErr {
    match error {
        SimulationError::Scene(error) => plain(py, "ActionError", &error.to_string()),
        error => simulation(py, loaded, error),
    }
}

/// Bytes that are no snapshot, or one that does not belong to the simulation.
pub(crate) fn snapshot(py: Python<'_>, error: &SnapshotError) -> PyErr {
    plain(py, "SnapshotError", &error.to_string())
}

/// An accuracy that no method reaches.
pub(crate) fn not_reached(py: Python<'_>, message: &str, asked: f64) -> PyErr {
    made(py, "NotReached", message, |kept| kept.set_item("asked", asked))
}

/// A name that nothing bears.
pub(crate) fn unknown_name(py: Python<'_>, kind: &str, name: &str, known: &[&str]) -> PyErr {
    made(py, "UnknownName", name, |kept| {
        kept.set_item("kind", kind)?;
        kept.set_item("known", known)
    })
}

/// A simulation that another thread uses.
pub(crate) fn busy(py: Python<'_>) -> PyErr {
    plain(
        py,
        "Busy",
        "this simulation is computing for another thread: wait until it is done, or make a simulation for each thread \
         (snapshot and restore copy one)",
    )
}

/// What a handler of a signal raises: Ctrl-C, for example. Only the first thread of Python is ever told.
#[expect(clippy::redundant_closure_for_method_calls, reason = "the method is of one lifetime, and any is asked for")]
pub(crate) fn raised_by_signal() -> Option<PyErr> {
    Python::attach(|py| py.check_signals()).err()
}

/// A run that cannot be shown.
pub(crate) fn view(py: Python<'_>, loaded: &LoadedScene, error: &ViewError) -> PyErr {
    plain(py, "ViewError", &format!("{}: {error}", loaded.scene.name()))
}
