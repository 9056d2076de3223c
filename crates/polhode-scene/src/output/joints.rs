//! Joints as CSV: one row per joint and sample.

use super::Sink;
use crate::csv::{write_field, write_number};
use polhode::scene::Coordinate;
use polhode::{JointId, JointSample};
use std::io;

/// Columns of the joints file: time (s), the joint, its coordinates with their rates (rad, rad/s, m, m/s; empty where
/// the joint has no such coordinate), the force (N) and the moment (N m) on its first body at its anchor in the world,
/// and the power that it gives to its bodies (W).
pub const JOINT_COLUMNS: [&str; 15] = [
    "t",
    "joint",
    "angle",
    "angle_rate",
    "displacement",
    "displacement_rate",
    "distance",
    "distance_rate",
    "fx",
    "fy",
    "fz",
    "mx",
    "my",
    "mz",
    "power",
];

/// Writes the first line.
pub(super) fn begin(out: &mut dyn Sink) -> io::Result<()> {
    writeln!(out, "{}", JOINT_COLUMNS.join(","))
}

/// Writes the joints at one time; `names` are theirs by their handles.
pub(super) fn rows(out: &mut dyn Sink, t_s: f64, joints: &[JointSample], names: &[String]) -> io::Result<()> {
    let name = |joint: JointId| names.get(joint.index()).map_or("", String::as_str);
    for joint in joints {
        write!(out, "{t_s:?},")?;
        write_field(out, name(joint.joint))?;
        for coordinate in Coordinate::ALL {
            let found = joint.coordinates.iter().find(|(own, _)| *own == coordinate).map(|(_, found)| found);
            for number in [found.map(|found| found.value), found.map(|found| found.rate)] {
                optional(out, number)?;
            }
        }
        let load = joint.load.map(|load| [load.force_n.to_array(), load.moment_n_m.to_array()]);
        for place in 0..6 {
            optional(out, load.map(|load| load.as_flattened()[place]))?;
        }
        optional(out, joint.power_w)?;
        out.write_all(b"\n")?;
    }
    Ok(())
}

/// A comma, and a number where there is one.
fn optional(out: &mut dyn Sink, number: Option<f64>) -> io::Result<()> {
    match number {
        Some(number) => write_number(out, number),
        None => out.write_all(b","),
    }
}
