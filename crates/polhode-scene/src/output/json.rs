//! Trajectories as JSON: one object with the bodies' names, the columns and the samples.
//!
//! `{"scene": .., "bodies": [name, ..], "columns": ["px", .., "wz"], "samples": [{"t": .., "states": [[13 numbers],
//! ..]}, ..]}`; 15 numbers and columns up to `error_rad` where errors are estimated.

use super::{COLUMNS, ErrorColumns, Sink, TrajectoryFormat, cut_to_line, numbers};
use polhode::{BodyError, BodySample};
use serde_json::json;
use std::fs::File;
use std::io::{self, Read as _, Seek as _, SeekFrom, Write as _};

/// JSON, streamed sample by sample.
#[derive(Debug, Clone)]
pub(super) struct Json {
    scene: String,
    bodies: Vec<String>,
    error_columns: ErrorColumns,
    is_first: bool,
}

impl Json {
    pub(super) fn new(scene: &str, bodies: &[String], error_columns: ErrorColumns) -> Self {
        Self { scene: scene.to_owned(), bodies: bodies.to_vec(), error_columns, is_first: true }
    }
}

impl TrajectoryFormat for Json {
    fn begin(&mut self, out: &mut dyn Sink) -> io::Result<()> {
        let (scene, bodies) = (json!(self.scene), json!(self.bodies));
        let columns = json!([&COLUMNS[2..], self.error_columns.names()].concat());
        write!(out, "{{\"scene\":{scene},\n\"bodies\":{bodies},\n\"columns\":{columns},\n\"samples\":[")
    }

    fn sample(
        &mut self,
        out: &mut dyn Sink,
        t: f64,
        bodies: &[BodySample],
        errors: Option<&[BodyError]>,
    ) -> io::Result<()> {
        // JSON has null for what is not a number: an error that is not known.
        let row = |(number, body)| -> Vec<f64> {
            numbers(body).into_iter().chain(self.error_columns.numbers(errors, number)).collect()
        };
        let states: Vec<Vec<f64>> = bodies.iter().enumerate().map(row).collect();
        let comma = if std::mem::take(&mut self.is_first) { "" } else { "," };
        write!(out, "{comma}\n{{\"t\":{},\"states\":{}}}", json!(t), json!(states))
    }

    fn end(&mut self, out: &mut dyn Sink) -> io::Result<()> {
        writeln!(out, "\n]}}")
    }

    fn mend(&mut self, file: &mut File) -> io::Result<()> {
        // A line ends with the comma and the end of line that stand before the next sample: both make room for the end.
        cut_to_line(file)?;
        let end = file.seek(SeekFrom::End(0))?.saturating_sub(",\n".len() as u64);
        let mut last = [0; 2];
        file.seek(SeekFrom::Start(end))?;
        file.read_exact(&mut last)?;
        if last == *b",\n" {
            file.set_len(end)?;
        }
        file.seek(SeekFrom::End(0))?;
        file.write_all(b"\n]}\n")
    }

    fn mender(&self) -> Box<dyn TrajectoryFormat> {
        Box::new(self.clone())
    }
}
