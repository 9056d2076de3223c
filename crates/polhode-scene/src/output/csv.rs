//! Trajectories as CSV: one row per body and sample.

use super::{Sink, TrajectoryFormat, numbers};
use crate::csv::{write_field, write_number};
use polhode::BodySample;
use std::io;

/// Columns of a trajectory: time (s), name of the body, position of its origin (m), orientation as a quaternion
/// body -> world, velocity of its centre of mass (m/s), angular velocity (rad/s), all in the world.
pub const COLUMNS: [&str; 15] =
    ["t", "body", "px", "py", "pz", "qw", "qx", "qy", "qz", "vx", "vy", "vz", "wx", "wy", "wz"];

/// CSV with full round-trip digits; all bodies of one sample bear the same text in `t`.
#[derive(Debug)]
pub(super) struct Csv {
    /// Names of the bodies as fields.
    names: Vec<Vec<u8>>,
}

impl Csv {
    pub(super) fn new(bodies: &[String]) -> io::Result<Self> {
        let names = bodies.iter().map(|body| {
            let mut field = Vec::new();
            write_field(&mut field, body).map(|()| field)
        });
        Ok(Self { names: names.collect::<io::Result<_>>()? })
    }
}

impl TrajectoryFormat for Csv {
    fn begin(&mut self, out: &mut dyn Sink) -> io::Result<()> {
        writeln!(out, "{}", COLUMNS.join(","))
    }

    fn sample(&mut self, out: &mut dyn Sink, t: f64, bodies: &[BodySample]) -> io::Result<()> {
        let time = format!("{t:?},");
        for (name, body) in self.names.iter().zip(bodies) {
            out.write_all(time.as_bytes())?;
            out.write_all(name)?;
            for number in numbers(body) {
                write_number(out, number)?;
            }
            out.write_all(b"\n")?;
        }
        Ok(())
    }

    fn end(&mut self, _out: &mut dyn Sink) -> io::Result<()> {
        Ok(())
    }
}
