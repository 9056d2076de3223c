//! Trajectories as CSV: one row per body and sample.

use super::{ErrorColumns, Sink, TrajectoryFormat, cut_to_line, numbers};
use crate::csv::{write_field, write_number};
use polhode::{BodyError, BodySample};
use std::fs::File;
use std::io::{self, Read as _, Seek as _, SeekFrom};

/// Columns of a trajectory: time (s), name of the body, position of its origin (m), orientation as a quaternion
/// body -> world, velocity of its centre of mass (m/s), angular velocity (rad/s), all in the world.
pub const COLUMNS: [&str; 15] =
    ["t", "body", "px", "py", "pz", "qw", "qx", "qy", "qz", "vx", "vy", "vz", "wx", "wy", "wz"];

/// CSV with full round-trip digits; all bodies of one sample bear the same text in `t`.
#[derive(Debug, Clone)]
pub(super) struct Csv {
    /// Names of the bodies as fields.
    names: Vec<Vec<u8>>,
    error_columns: ErrorColumns,
}

impl Csv {
    pub(super) fn new(bodies: &[String], error_columns: ErrorColumns) -> io::Result<Self> {
        let names = bodies.iter().map(|body| {
            let mut field = Vec::new();
            write_field(&mut field, body).map(|()| field)
        });
        Ok(Self { names: names.collect::<io::Result<_>>()?, error_columns })
    }
}

/// Bytes of a file's end that are looked at first for its last sample.
const FIRST_TAIL: u64 = 1 << 16;

impl Csv {
    /// Bytes of the last sample in the end of a file, when rows of it are missing; 0 when it is whole. None when the
    /// end of the file does not hold it all, and is not all of the file.
    fn part_of_a_sample(&self, tail: &[u8], is_all: bool) -> Option<u64> {
        let mut rows = tail.split_inclusive(|&byte| byte == b'\n').rev();
        let time = |row: &[u8]| row.iter().position(|&byte| byte == b',').map(|at| row[..at].to_vec());
        let Some(last) = rows.next() else { return Some(0) };
        let (mut count, mut length) = (1, last.len() as u64);
        for row in rows.by_ref() {
            if time(row) != time(last) {
                return Some(if count == self.names.len() || time(last)? == b"t" { 0 } else { length });
            }
            (count, length) = (count + 1, length + row.len() as u64);
        }
        is_all.then_some(0)
    }
}

impl TrajectoryFormat for Csv {
    fn begin(&mut self, out: &mut dyn Sink) -> io::Result<()> {
        writeln!(out, "{}", [&COLUMNS, self.error_columns.names()].concat().join(","))
    }

    fn sample(
        &mut self,
        out: &mut dyn Sink,
        t: f64,
        bodies: &[BodySample],
        errors: Option<&[BodyError]>,
    ) -> io::Result<()> {
        let time = format!("{t:?},");
        for (number, (name, body)) in self.names.iter().zip(bodies).enumerate() {
            out.write_all(time.as_bytes())?;
            out.write_all(name)?;
            for number in numbers(body) {
                write_number(out, number)?;
            }
            for error in self.error_columns.numbers(errors, number) {
                if error.is_nan() {
                    out.write_all(b",")?;
                } else {
                    write_number(out, error)?;
                }
            }
            out.write_all(b"\n")?;
        }
        Ok(())
    }

    fn end(&mut self, _out: &mut dyn Sink) -> io::Result<()> {
        Ok(())
    }

    fn mend(&mut self, file: &mut File) -> io::Result<()> {
        cut_to_line(file)?;
        let end = file.seek(SeekFrom::End(0))?;
        let mut length = FIRST_TAIL.min(end);
        loop {
            let mut tail = vec![0; length as usize];
            file.seek(SeekFrom::Start(end - length))?;
            file.read_exact(&mut tail)?;
            if let Some(part) = self.part_of_a_sample(&tail, length == end) {
                return file.set_len(end - part);
            }
            length = (2 * length).min(end);
        }
    }

    fn mender(&self) -> Box<dyn TrajectoryFormat> {
        Box::new(self.clone())
    }
}
