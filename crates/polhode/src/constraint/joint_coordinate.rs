//! The coordinates of a joint: how each is measured, and what acts along it.

use super::coordinate::Measured;
use super::track::Guide;
use crate::scene::{Coordinate, Freedom, Joint};
use polhode_spatial::Rotation;
use std::sync::Arc;

/// A coordinate of a joint.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct JointCoordinate {
    pub(super) coordinate: Coordinate,
    pub(super) measured: Measured,
    /// The length that makes displacements of its values: m of an angle, 1 otherwise.
    pub(super) unit: f64,
    /// The value near which an angle is known to be, rad.
    pub(super) near: f64,
    pub(super) freedom: Freedom,
}

/// The coordinates of a joint of bodies with these attitudes, on this track if it is one; `length` is that of its rows of rotation, m.
pub(super) fn coordinates(
    joint: &Joint,
    attitudes: (Rotation, Rotation),
    length: f64,
    guide: Option<&Arc<Guide>>,
) -> Vec<JointCoordinate> {
    let of_coordinate = |&coordinate: &Coordinate| {
        let freedom = joint.freedom(coordinate).unwrap_or_default();
        let (measured, unit) = match (coordinate, joint.kind().axis()) {
            (Coordinate::Displacement, None) => (Measured::Along(Arc::clone(guide?)), 1.0),
            (Coordinate::Angle, Some(axis)) => (Measured::angle(axis.get(), attitudes), length),
            (Coordinate::Displacement, Some(axis)) => (Measured::displacement(axis.get(), attitudes.1), 1.0),
            (Coordinate::Distance, _) => (Measured::Distance, 1.0),
            (Coordinate::Angle, None) => return None,
        };
        let near = freedom.limits().map_or(0.0, |limits| 0.5 * (limits.lower() + limits.upper()));
        Some(JointCoordinate { coordinate, measured, unit, near, freedom })
    };
    joint.kind().coordinates().iter().filter_map(of_coordinate).collect()
}
