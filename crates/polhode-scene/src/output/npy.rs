//! Trajectories as NPY: an array of doubles of shape (samples, bodies, 16), or (samples, bodies, 14).
//!
//! The last axis is `t`, the numbers of the CSV columns `px` to `wz`, and where they are estimated the errors `error_m`
//! and `error_rad`, which are not a number (NaN) where they are not known; bodies are in the order of the scene. Format
//! version 1.0 (docs/REFERENCES.md, NumPy enhancement proposal 1): a magic word, the length of the header, a Python
//! dictionary padded with spaces, little-endian data. The number of samples is not known before the end of a run, so
//! the header is written at the start with room to spare and again at the end.

use super::{ERROR_COLUMNS, ErrorColumns, Sink, TrajectoryFormat, numbers};
use polhode::{BodyError, BodySample};
use std::fs::File;
use std::io::{self, Seek as _, SeekFrom, Write as _};

/// Length of the last axis without errors.
pub const NPY_WIDTH: usize = 14;

/// Length of the last axis with errors.
pub const NPY_WIDTH_WITH_ERRORS: usize = NPY_WIDTH + ERROR_COLUMNS.len();

/// Length of everything before the data, bytes: a multiple of 64 with room for the largest numbers.
const HEADER_LENGTH: usize = 192;

/// Length of the magic word, the version and the header's own length, bytes.
const PREFIX_LENGTH: usize = 10;

/// NPY, double precision, little-endian, C order.
#[derive(Debug, Clone)]
pub(super) struct Npy {
    bodies: usize,
    error_columns: ErrorColumns,
    samples: u64,
}

impl Npy {
    pub(super) fn new(bodies: usize, error_columns: ErrorColumns) -> Self {
        Self { bodies, error_columns, samples: 0 }
    }

    /// Length of the last axis.
    fn width(&self) -> usize {
        NPY_WIDTH + self.error_columns.names().len()
    }

    fn header(&self) -> Vec<u8> {
        let shape = format!("({}, {}, {})", self.samples, self.bodies, self.width());
        let dictionary = format!("{{'descr': '<f8', 'fortran_order': False, 'shape': {shape}, }}");
        let length = HEADER_LENGTH - PREFIX_LENGTH;
        let mut header = b"\x93NUMPY\x01\x00".to_vec();
        header.extend_from_slice(&(length as u16).to_le_bytes());
        // The padding ends with a newline, as the format wants it.
        header.extend_from_slice(format!("{dictionary:<width$}\n", width = length - 1).as_bytes());
        header
    }
}

/// One row of the last axis without errors: `t` (s) and the numbers of a body.
pub fn npy_row(t: f64, body: &BodySample) -> [f64; NPY_WIDTH] {
    let mut row = [t; NPY_WIDTH];
    row[1..].copy_from_slice(&numbers(body));
    row
}

impl TrajectoryFormat for Npy {
    fn begin(&mut self, out: &mut dyn Sink) -> io::Result<()> {
        out.write_all(&self.header())
    }

    fn sample(
        &mut self,
        out: &mut dyn Sink,
        t: f64,
        bodies: &[BodySample],
        errors: Option<&[BodyError]>,
    ) -> io::Result<()> {
        for (place, body) in bodies.iter().enumerate() {
            for number in npy_row(t, body).into_iter().chain(self.error_columns.numbers(errors, place)) {
                out.write_all(&number.to_le_bytes())?;
            }
        }
        self.samples += 1;
        Ok(())
    }

    fn end(&mut self, out: &mut dyn Sink) -> io::Result<()> {
        out.seek(SeekFrom::Start(0))?;
        out.write_all(&self.header())?;
        out.seek(SeekFrom::End(0)).map(drop)
    }

    fn mend(&mut self, file: &mut File) -> io::Result<()> {
        let sample = (self.bodies * self.width() * size_of::<f64>()).max(1) as u64;
        let data = file.seek(SeekFrom::End(0))?.saturating_sub(HEADER_LENGTH as u64);
        self.samples = self.samples.min(data / sample);
        file.set_len(HEADER_LENGTH as u64 + self.samples * sample)?;
        file.seek(SeekFrom::Start(0))?;
        file.write_all(&self.header())
    }

    fn mender(&self) -> Box<dyn TrajectoryFormat> {
        // How many samples there are is for the length of the file to say.
        Box::new(Self { samples: u64::MAX, ..self.clone() })
    }
}
