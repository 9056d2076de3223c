//! Prescribed motions.

use super::fault::{Fault, finite, vector};
use crate::document::KeyPath;
use crate::error::Refusal;
use crate::format::{
    BodyEntry, ConstantMotionEntry, InterpolationEntry, MotionEntry, SineMotionEntry, TableMotionEntry, Vector,
};
use glam::DVec3;
use polhode::Body;
use polhode::scene::{Interpolation, MotionError, MotionTable, PrescribedMotion, SampledOrientations};
use polhode::spatial::{Pose, Rotation, UnitVector, Velocity};

/// For what keys of other bodies have no meaning.
const KINEMATIC: &str = "a body with a prescribed motion";

/// The kinematic body of an entry, with its motion at `path` (of the body), at its initial pose.
pub(super) fn body(entry: &BodyEntry, motion: &MotionEntry, pose: Pose, path: &KeyPath) -> Result<Body, Fault> {
    if entry.fixed {
        return Err((path.key("motion"), Refusal::Excludes { key: "motion", other: "fixed" }));
    }
    let meaningless = [
        (entry.mass.is_some(), "mass"),
        (entry.density.is_some(), "density"),
        (entry.inertia.is_some(), "inertia"),
        (entry.center_of_mass.is_some(), "center_of_mass"),
        (entry.hollow, "hollow"),
        (entry.pivot.is_some(), "pivot"),
        (entry.velocity.is_some(), "velocity"),
        (entry.angular_velocity.is_some(), "angular_velocity"),
    ];
    if let Some((_, key)) = meaningless.into_iter().find(|(given, _)| *given) {
        return Err((path.key(key), Refusal::Meaningless { key, what: KINEMATIC }));
    }
    let motion = build(motion, &path.key("motion"))?;
    let body = Body::kinematic(&entry.name, motion.clone());
    // What the file leaves out is as the motion has it at t = 0.
    let start = *body.initial_pose();
    let has_orientation = entry.orientation.is_some() || entry.rotation_vector.is_some();
    let pose = Pose {
        translation: if entry.position.is_some() { pose.translation } else { start.translation },
        rotation: if has_orientation { pose.rotation } else { start.rotation },
    };
    let key = |error: &MotionError| match error {
        MotionError::Start { quantity: "position", .. } => "position",
        _ if entry.rotation_vector.is_some() => "rotation_vector",
        _ => "orientation",
    };
    motion.check_start(&pose).map_err(|error| (path.key(key(&error)), error.into()))?;
    Ok(body.pose(pose))
}

fn build(entry: &MotionEntry, path: &KeyPath) -> Result<PrescribedMotion, Fault> {
    match entry {
        MotionEntry::Constant(entry) => constant(entry, &path.key("constant")),
        MotionEntry::Sine(entry) => sine(entry, &path.key("sine")),
        MotionEntry::Table(entry) => table(entry, &path.key("table")),
    }
}

fn constant(entry: &ConstantMotionEntry, path: &KeyPath) -> Result<PrescribedMotion, Fault> {
    if entry.velocity.is_none() && entry.angular_velocity.is_none() {
        let needed = "`velocity` or `angular_velocity`";
        return Err((path.clone(), Refusal::Needs { what: "a constant motion", needed }));
    }
    let linear = optional(entry.velocity.as_ref(), path, "velocity")?;
    let angular = optional(entry.angular_velocity.as_ref(), path, "angular_velocity")?;
    PrescribedMotion::constant_velocity(Velocity::new(linear, angular)).map_err(|error| (path.clone(), error.into()))
}

fn sine(entry: &SineMotionEntry, path: &KeyPath) -> Result<PrescribedMotion, Fault> {
    let needs = |what, needed| Err((path.clone(), Refusal::Needs { what, needed }));
    let amplitude = optional(entry.amplitude.as_ref(), path, "amplitude")?;
    let rotation = match (&entry.axis, entry.angle) {
        (Some(axis), Some(angle)) => {
            let path_of_axis = path.key("axis");
            let axis = vector(axis, &path_of_axis)?;
            let axis = UnitVector::new(axis).map_err(|error| (path_of_axis, error.into()))?;
            axis.get() * finite(angle, &path.key("angle"))?
        }
        (Some(_), None) => return needs("a sine with an axis", "`angle`"),
        (None, Some(_)) => return needs("a sine with an angle", "`axis`"),
        (None, None) if entry.amplitude.is_none() => return needs("a sine", "`amplitude`, or `axis` and `angle`"),
        (None, None) => DVec3::ZERO,
    };
    let frequency = finite(entry.frequency, &path.key("frequency"))?;
    let phase = finite(entry.phase.unwrap_or(0.0), &path.key("phase"))?;
    PrescribedMotion::sine(amplitude, rotation, frequency, phase).map_err(|error| {
        let path = if matches!(error, MotionError::Frequency(_)) { path.key("frequency") } else { path.clone() };
        (path, error.into())
    })
}

fn table(entry: &TableMotionEntry, path: &KeyPath) -> Result<PrescribedMotion, Fault> {
    for (index, &time) in entry.times.iter().enumerate() {
        finite(time, &path.key("times").index(index))?;
    }
    let positions = entry.positions.as_ref().map(|positions| vectors(positions, &path.key("positions")));
    let orientations = match (&entry.orientations, &entry.rotation_vectors) {
        (Some(_), Some(_)) => {
            let (key, other) = ("rotation_vectors", "orientations");
            return Err((path.key(key), Refusal::Excludes { key, other }));
        }
        (Some(quaternions), None) => {
            let path = path.key("orientations");
            let mut rotations = Vec::with_capacity(quaternions.len());
            for (index, quaternion) in quaternions.iter().enumerate() {
                let rotation = Rotation::from_wxyz(quaternion.0);
                rotations.push(rotation.map_err(|error| (path.index(index), error.into()))?);
            }
            Some(SampledOrientations::Rotations(rotations))
        }
        (None, Some(vectors)) => {
            Some(SampledOrientations::RotationVectors(self::vectors(vectors, &path.key("rotation_vectors"))?))
        }
        (None, None) => None,
    };
    let interpolation = interpolation(entry.interpolation);
    let (times_s, positions_m) = (entry.times.clone(), positions.transpose()?);
    let table = MotionTable { times_s, positions_m, orientations, interpolation };
    PrescribedMotion::table(&table).map_err(|error| {
        let turned = if entry.rotation_vectors.is_some() { "rotation_vectors" } else { "orientations" };
        let path = match &error {
            MotionError::TooFewSamples(_) => path.key("times"),
            MotionError::TimeOrder { index, .. } => path.key("times").index(*index),
            MotionError::Count { quantity: "positions", .. } => path.key("positions"),
            MotionError::Count { .. } => path.key(turned),
            MotionError::Turn { index, .. } => path.key(turned).index(*index),
            _ => path.clone(),
        };
        (path, error.into())
    })
}

/// What is between the samples of a table.
pub(super) fn interpolation(entry: Option<InterpolationEntry>) -> Interpolation {
    match entry {
        None => Interpolation::default(),
        Some(InterpolationEntry::Monotone) => Interpolation::Monotone,
        Some(InterpolationEntry::Spline) => Interpolation::Spline,
        Some(InterpolationEntry::Linear) => Interpolation::Linear,
    }
}

fn vectors(entries: &[Vector], path: &KeyPath) -> Result<Vec<DVec3>, Fault> {
    let mut vectors = Vec::with_capacity(entries.len());
    for (index, entry) in entries.iter().enumerate() {
        vectors.push(vector(entry, &path.index(index))?);
    }
    Ok(vectors)
}

/// A vector that is zero when absent.
fn optional(value: Option<&Vector>, path: &KeyPath, key: &'static str) -> Result<DVec3, Fault> {
    value.map_or(Ok(DVec3::ZERO), |value| vector(value, &path.key(key)))
}
