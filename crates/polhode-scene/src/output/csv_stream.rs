//! A trajectory as CSV to any writer, such as stdout.

use super::TrajectoryFormat;
use super::csv::Csv;
use polhode::{BodySample, Flow, Observer, Scene};
use std::io::{self, Seek, SeekFrom, Write};

/// Writes every sample as CSV while the run goes on.
///
/// The first fault stops the run at the end of the step; [`CsvStream::finish`] returns it.
#[derive(Debug)]
pub struct CsvStream<W: Write> {
    csv: Csv,
    out: Forward<W>,
    fault: Option<io::Error>,
}

impl<W: Write> CsvStream<W> {
    /// Writes the first line.
    ///
    /// # Errors
    /// Those of writing.
    pub fn begin(scene: &Scene, out: W) -> io::Result<Self> {
        let names: Vec<String> = scene.bodies().iter().map(|body| body.name().to_owned()).collect();
        let (mut csv, mut out) = (Csv::new(&names)?, Forward(out));
        csv.begin(&mut out)?;
        Ok(Self { csv, out, fault: None })
    }

    /// Writes what is left.
    ///
    /// # Errors
    /// The first fault of writing.
    pub fn finish(mut self) -> io::Result<()> {
        match self.fault.take() {
            Some(fault) => Err(fault),
            None => self.out.flush(),
        }
    }
}

impl<W: Write> Observer for CsvStream<W> {
    fn sample(&mut self, t: f64, bodies: &[BodySample]) {
        if self.fault.is_none() {
            self.fault = self.csv.sample(&mut self.out, t, bodies).err();
        }
    }

    fn progress(&mut self, _t: f64) -> Flow {
        if self.fault.is_some() { Flow::Stop } else { Flow::Continue }
    }
}

/// A writer that cannot go back; CSV never does.
#[derive(Debug)]
struct Forward<W>(W);

impl<W: Write> Write for Forward<W> {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.0.write(bytes)
    }

    fn flush(&mut self) -> io::Result<()> {
        self.0.flush()
    }
}

impl<W> Seek for Forward<W> {
    fn seek(&mut self, _position: SeekFrom) -> io::Result<u64> {
        Err(io::ErrorKind::Unsupported.into())
    }
}
