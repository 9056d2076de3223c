//! Prescribed motions of the coordinates of joints.

use super::fault::{Fault, Faults, finite};
use super::{joint, motion};
use crate::document::KeyPath;
use crate::format::{CoordinateMotionEntry, CoordinateSineEntry, CoordinateTableEntry, SceneFile};
use polhode::JointId;
use polhode::scene::{Coordinate, CoordinateMotion, MotionError};

/// The motions of the file: which coordinate of which joint follows which.
pub(super) fn build(file: &SceneFile, faults: &mut Faults) -> Vec<(JointId, Coordinate, CoordinateMotion)> {
    let mut motions = Vec::new();
    for (index, entry) in file.joints.iter().enumerate() {
        for (coordinate, freedom, path) in joint::freedoms(&entry.kind, &KeyPath::element("joints", index).key("type"))
        {
            let built = freedom.motion.as_ref().map(|entry| of_entry(entry, &path.key("motion")));
            let built = built.and_then(|built| faults.note(built));
            motions.extend(built.map(|motion| (JointId::new(index), coordinate, motion)));
        }
    }
    motions
}

/// The motion of an entry.
pub(super) fn of_entry(entry: &CoordinateMotionEntry, path: &KeyPath) -> Result<CoordinateMotion, Fault> {
    match entry {
        CoordinateMotionEntry::Rate(rate) => {
            let path = path.key("rate");
            CoordinateMotion::rate(finite(*rate, &path)?).map_err(|error| (path, error.into()))
        }
        CoordinateMotionEntry::Sine(CoordinateSineEntry { amplitude, frequency, phase }) => {
            let path = path.key("sine");
            let amplitude = finite(*amplitude, &path.key("amplitude"))?;
            let frequency = finite(*frequency, &path.key("frequency"))?;
            let phase = finite(phase.unwrap_or(0.0), &path.key("phase"))?;
            CoordinateMotion::sine(amplitude, frequency, phase).map_err(|error| {
                let path = if matches!(error, MotionError::Frequency(_)) { path.key("frequency") } else { path };
                (path, error.into())
            })
        }
        CoordinateMotionEntry::Table(CoordinateTableEntry { times, values, interpolation }) => {
            let path = path.key("table");
            for (key, numbers) in [("times", times), ("values", values)] {
                for (index, &number) in numbers.iter().enumerate() {
                    finite(number, &path.key(key).index(index))?;
                }
            }
            let interpolation = motion::interpolation(*interpolation);
            CoordinateMotion::table(times.clone(), values, interpolation).map_err(|error| {
                let path = match &error {
                    MotionError::TooFewSamples(_) => path.key("times"),
                    MotionError::TimeOrder { index, .. } => path.key("times").index(*index),
                    _ => path.key("values"),
                };
                (path, error.into())
            })
        }
    }
}
