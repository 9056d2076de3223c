//! Trajectories: judged by the laws of a scene, and compared with each other. Both run in a thread that Ctrl-C ends.

use crate::errors;
use crate::job;
use crate::loaded::Loaded;
use polhode_scene::{Tolerance, compare as compared};
use polhode_study::judge::{Given, Question, judge as judged, truth_of};
use pyo3::prelude::*;
use serde_json::{Value, json};
use std::path::PathBuf;

/// What is found of a trajectory as JSON, as `polhode judge --json` prints it.
#[pyfunction]
pub(crate) fn judge(py: Python<'_>, path: PathBuf, loaded: &Loaded, tolerance: f64, truth: bool) -> PyResult<String> {
    let (reader, given) = loaded.reader();
    let ended = job::work(py, None, move |_| {
        let told = |error: &dyn std::fmt::Display| error.to_string();
        let own = reader.load(&given).map_err(|error| told(&error))?;
        let trajectory = Given::read(&path, &own.scene).map_err(|error| told(&error))?;
        let changes = [given, vec![truth_of(&own.scene)]].concat();
        let best = truth.then(|| reader.load(&changes)).transpose().map_err(|error| told(&error))?;
        let question = Question { tolerance, truth: best.as_ref().map(|own| &own.scene) };
        let found = judged(&trajectory, &own.scene, question).map_err(|error| told(&error))?;
        Ok::<String, String>(found.json().to_string())
    })?;
    ended.whole()?.map_err(errors::value)
}

/// The largest difference of every column of two trajectories as JSON.
#[pyfunction]
pub(crate) fn compare(py: Python<'_>, a: &str, b: &str, atol: f64, rtol: f64) -> PyResult<String> {
    let tolerance = Tolerance { absolute: atol, relative: rtol };
    let found = py.detach(move || compared(a.as_ref(), b.as_ref(), tolerance)).map_err(errors::value)?;
    let column = |own: &polhode_scene::compare::ColumnDifference| {
        let at = own.at.as_ref().map(|at| json!({ "t": at.t, "body": at.body, "a": at.a, "b": at.b }));
        json!({ "column": own.column, "largest": own.largest, "beyond": own.beyond, "at": at })
    };
    let mismatch: Option<Value> =
        found.mismatch.as_ref().map(|own| json!({ "line": own.line, "a": own.a, "b": own.b }));
    let columns: Vec<Value> = found.columns.iter().map(column).collect();
    Ok(json!({ "agrees": found.agrees(), "rows": found.rows, "mismatch": mismatch, "columns": columns }).to_string())
}
