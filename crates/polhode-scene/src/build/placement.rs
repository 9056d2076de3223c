//! Where a body or a part of one stands.

use super::fault::{Fault, vector};
use crate::document::KeyPath;
use crate::error::Refusal;
use crate::format::{Exactly, Vector};
use glam::DVec3;
use polhode::spatial::{Pose, Rotation};

/// The pose of the entry at `path`; what is absent is zero.
pub(super) fn pose(
    position: Option<&Vector>,
    orientation: Option<&Exactly<f64, 4>>,
    rotation_vector: Option<&Vector>,
    path: &KeyPath,
) -> Result<Pose, Fault> {
    let rotation = rotation(orientation, rotation_vector, path)?;
    let position = position.map_or(Ok(DVec3::ZERO), |value| vector(value, &path.key("position")))?;
    Ok(Pose::new(rotation, position))
}

fn rotation(
    orientation: Option<&Exactly<f64, 4>>,
    rotation_vector: Option<&Vector>,
    path: &KeyPath,
) -> Result<Rotation, Fault> {
    let path_of_vector = path.key("rotation_vector");
    match (orientation, rotation_vector) {
        (Some(_), Some(_)) => Err((path_of_vector, Refusal::Excludes { key: "rotation_vector", other: "orientation" })),
        (Some(wxyz), None) => Rotation::from_wxyz(wxyz.0).map_err(|error| (path.key("orientation"), error.into())),
        (None, Some(value)) => {
            let rotation = Rotation::from_rotation_vector(vector(value, &path_of_vector)?);
            // The length of a vector may overflow where its components do not.
            if rotation.is_finite() {
                Ok(rotation)
            } else {
                let largest = value.0.into_iter().fold(0.0_f64, |m, c| m.max(c.abs()));
                Err((path_of_vector, Refusal::Number { value: largest, accepted: "an angle whose square is finite" }))
            }
        }
        (None, None) => Ok(Rotation::IDENTITY),
    }
}
