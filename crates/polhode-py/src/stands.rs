//! Whether a scene stands, and tables of boxes as scenes.

use crate::errors;
use crate::loaded::Loaded;
use polhode_scene::{Override, SceneFileError, boxes_json};
use polhode_study::stands::{Question, StandsError, standing_json};
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
    answer.map_err(|error: StandsError| match error {
        StandsError::Scene(error) => errors::scene(py, &error),
        error => errors::plain(py, "SimulationError", &error.to_string()),
    })
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
