//! Whether a scene stands, up to which value of a key it does, and tables of boxes as scenes.

use crate::errors;
use crate::job::{self, Ended};
use crate::loaded::Loaded;
use polhode::Flow;
use polhode_scene::{Override, SceneFileError, boxes_json};
use polhode_study::stands::{Interval, Question, StandsError, bisection_json, standing_json};
use pyo3::exceptions::PyKeyboardInterrupt;
use pyo3::prelude::*;
use std::path::Path;

/// Whether a scene stands, with all margins, as JSON: as `polhode stands --json` prints it.
#[pyfunction]
pub(crate) fn stands(py: Python<'_>, loaded: &Loaded) -> PyResult<String> {
    let (reader, given) = loaded.reader();
    let answer = py.detach(|| {
        let load = |changes: &[Override]| reader.load(changes);
        let (own, standing) = Question { load: &load, given: &given }.standing()?;
        Ok(standing_json(&own.scene, &standing).to_string())
    });
    answer.map_err(|error| refused(py, error))
}

/// Up to which value of a key a scene stands, as JSON: as `polhode stands --bisect KEY=LOW..HIGH --json` prints it.
#[pyfunction]
pub(crate) fn standing_limit(py: Python<'_>, loaded: &Loaded, interval: &str, digits: u32) -> PyResult<String> {
    let (reader, given) = loaded.reader();
    let name = loaded.scene.scene.name().to_owned();
    let interval = Interval::parse(interval).map_err(|error| refused(py, error))?;
    let ended = job::work(py, None, move |watch| {
        let load = |changes: &[Override]| reader.load(changes);
        let asked = || if watch.reached(0.0, 1.0) == Flow::Stop { Err(StandsError::Stopped) } else { Ok(()) };
        let found = interval.bisect(&Question { load: &load, given: &given }, digits, asked)?;
        Ok(bisection_json(&name, &found).to_string())
    })?;
    match ended {
        Ended::Done(done) => done.map_err(|error| refused(py, error)),
        Ended::Raised(raised, _) if raised.is_instance_of::<PyKeyboardInterrupt>(py) => {
            Err(errors::plain(py, "Interrupted", &StandsError::Stopped.to_string()))
        }
        Ended::Raised(raised, _) => Err(raised),
    }
}

/// Why there is no answer, as an exception.
fn refused(py: Python<'_>, error: StandsError) -> PyErr {
    match error {
        StandsError::Scene(error) => errors::scene(py, &error),
        StandsError::Simulation { .. } => errors::plain(py, "SimulationError", &error.to_string()),
        error => errors::value(error),
    }
}

/// The keys of the scene of a table of boxes, as JSON. A table that is no file has rows, whose number is that of their
/// line without the one of names.
#[pyfunction]
#[pyo3(signature = (table, origin=None))]
pub(crate) fn boxes(table: &str, origin: Option<&str>) -> PyResult<String> {
    let document = boxes_json(Path::new(origin.unwrap_or_default()), table.as_bytes());
    document.map(|document| document.to_string()).map_err(|error| match (error, origin) {
        (SceneFileError::Boxes { line, what, accepted, .. }, None) => {
            // The first line has the names of the columns.
            let row = if line > 1 { format!("row {}: ", line - 1) } else { String::new() };
            errors::value(format!("{row}{what}; accepted: {accepted}"))
        }
        (error, _) => errors::value(error),
    })
}
