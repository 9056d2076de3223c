//! A trajectory as CSV to any writer, such as stdout.

use super::csv::Csv;
use super::held_back::{HeldBack, Told};
use super::{ErrorColumns, TrajectoryFormat};
use polhode::{BodyError, BodySample, Flow, Observer, Scene};
use std::io::{self, Seek, SeekFrom, Write};

/// Writes every sample as CSV while the run goes on.
///
/// The first fault stops the run at the end of the step; [`CsvStream::finish`] returns it.
#[derive(Debug)]
pub struct CsvStream<W: Write> {
    csv: Csv,
    out: Forward<W>,
    /// Samples whose errors are not known yet; none where errors are not written.
    held: Option<HeldBack>,
    fault: Option<io::Error>,
}

impl<W: Write> CsvStream<W> {
    /// Writes the first line of a trajectory without errors.
    ///
    /// # Errors
    /// Those of writing.
    pub fn begin(scene: &Scene, out: W) -> io::Result<Self> {
        Self::begin_with(ErrorColumns::Absent, scene, out)
    }

    /// Writes the first line of a trajectory with the estimated errors of the bodies. A sample is written when its
    /// errors are known.
    ///
    /// # Errors
    /// Those of writing.
    pub fn begin_with_errors(scene: &Scene, out: W) -> io::Result<Self> {
        let stream = Self::begin_with(ErrorColumns::Written, scene, out)?;
        Ok(Self { held: Some(HeldBack::default()), ..stream })
    }

    fn begin_with(error_columns: ErrorColumns, scene: &Scene, out: W) -> io::Result<Self> {
        let names: Vec<String> = scene.bodies().iter().map(|body| body.name().to_owned()).collect();
        let (mut csv, mut out) = (Csv::new(&names, error_columns)?, Forward(out));
        csv.begin(&mut out)?;
        Ok(Self { csv, out, held: None, fault: None })
    }

    /// Writes what is left: samples whose errors have not become known too, without them.
    ///
    /// # Errors
    /// The first fault of writing.
    pub fn finish(mut self) -> io::Result<()> {
        self.release(f64::INFINITY, None);
        match self.fault.take() {
            Some(fault) => Err(fault),
            None => self.out.flush(),
        }
    }
}

impl<W: Write> CsvStream<W> {
    fn write(&mut self, t: f64, bodies: &[BodySample], errors: Option<&[BodyError]>) {
        if self.fault.is_none() {
            self.fault = self.csv.sample(&mut self.out, t, bodies, errors).err();
        }
    }

    /// Writes the samples until `t` (s), that at `t` with these errors.
    fn release(&mut self, t: f64, errors: Option<&[BodyError]>) {
        while let Some(told) = self.held.as_mut().and_then(|held| held.pop_until(t)) {
            if let Told::Sample(sample_s, bodies) = told {
                self.write(sample_s, &bodies, errors.filter(|_| sample_s == t));
            }
        }
    }
}

impl<W: Write> Observer for CsvStream<W> {
    fn sample(&mut self, t: f64, bodies: &[BodySample]) {
        let Some(held) = &mut self.held else {
            self.write(t, bodies, None);
            return;
        };
        held.push(Told::Sample(t, bodies.to_vec()));
        while let Some(first_s) = self.held.as_ref().and_then(HeldBack::overdue_s) {
            self.release(first_s, None);
        }
    }

    fn wants_errors(&self) -> bool {
        self.held.is_some()
    }

    fn errors(&mut self, t_s: f64, errors: Option<&[BodyError]>) {
        self.release(t_s, errors);
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
