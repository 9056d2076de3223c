//! Joints as CSV: one row per joint and sample.

use super::Sink;
use crate::csv::{write_field, write_number};
pub use crate::quantity::JOINT_COLUMNS;
use crate::quantity::{EFFORTS, of_joint};
use polhode::scene::Coordinate;
use polhode::{JointId, JointSample};
use std::io;

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
        six(out, load)?;
        optional(out, joint.power_w)?;
        for (_, effort) in EFFORTS {
            optional(out, of_joint(joint, effort))?;
        }
        six(out, joint.reaction.map(|own| [own.force_n.to_array(), own.moment_n_m.to_array()]))?;
        out.write_all(b"\n")?;
    }
    Ok(())
}

/// A force and a moment, where they are known.
fn six(out: &mut dyn Sink, load: Option<[[f64; 3]; 2]>) -> io::Result<()> {
    for place in 0..6 {
        optional(out, load.map(|load| load.as_flattened()[place]))?;
    }
    Ok(())
}

/// A comma, and a number where there is one that is known.
fn optional(out: &mut dyn Sink, number: Option<f64>) -> io::Result<()> {
    match number {
        Some(number) if !number.is_nan() => write_number(out, number),
        _ => out.write_all(b","),
    }
}
