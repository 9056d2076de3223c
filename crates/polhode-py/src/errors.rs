//! Errors of the library as Python's exceptions, which keep place and cure. The classes are in `polhode/_errors.py`.

use polhode::{SimulationError, SnapshotError};
use polhode_scene::robot::RobotFileError;
use polhode_scene::{LoadedScene, Refused, SceneFileError};
use pyo3::exceptions::PyOSError;
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

/// A scene that cannot be read or is refused.
pub(crate) fn scene(py: Python<'_>, error: &SceneFileError) -> PyErr {
    if error.is_input_output() {
        return PyOSError::new_err(error.to_string());
    }
    let place = match error {
        SceneFileError::Robot(RobotFileError::Refused(_)) | SceneFileError::Read { .. } => None,
        other => other.refused(),
    };
    made(py, "SceneError", &error.to_string(), |kept| {
        if let Some(refused) = place {
            keep_place(kept, refused)?;
            kept.set_item("cure", refused.cure())?;
        }
        let each = error.all_refused().iter().map(|refused| {
            let one = PyDict::new(py);
            keep_place(&one, refused)?;
            one.set_item("message", refused.cause.to_string())?;
            one.set_item("cure", refused.cure())?;
            Ok(one)
        });
        kept.set_item("errors", PyList::new(py, each.collect::<PyResult<Vec<_>>>()?)?)
    })
}

fn keep_place(kept: &Bound<'_, PyDict>, refused: &Refused) -> PyResult<()> {
    let place = &refused.place;
    kept.set_item("place", (&place.origin, place.line, place.column, &place.key))
}

/// A simulation that cannot be made or cannot go on.
pub(crate) fn simulation(py: Python<'_>, loaded: &LoadedScene, error: SimulationError) -> PyErr {
    match error {
        SimulationError::Scene(error) => scene(py, &loaded.explain(error)),
        SimulationError::Action(error) => plain(py, "ActionError", &error.to_string()),
        SimulationError::Snapshot(error) => snapshot(py, &error),
        SimulationError::TimeInThePast { .. } => plain(py, "ActionError", &error.to_string()),
        error => plain(py, "SimulationError", &format!("{}: {error}", loaded.scene.name())),
    }
}

/// Bytes that are no snapshot, or one that does not belong to the simulation.
pub(crate) fn snapshot(py: Python<'_>, error: &SnapshotError) -> PyErr {
    plain(py, "SnapshotError", &error.to_string())
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
