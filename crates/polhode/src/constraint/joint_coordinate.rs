//! The coordinates of a joint: how each is measured, and what acts along it.
//!
//! An angle is measured up to whole revolutions. One with limits, which are less than a revolution apart, lies within
//! half a revolution of their middle. Any other turns on: it lies within half a revolution of the multiple of a quarter
//! of one next to what it was at the end of the last step. That multiple is part of the state of a run, and all that
//! changes with the revolutions: the angle is `a + 2 pi k` with the same bits wherever `k` is known from. Springs,
//! servos and samples take the same angle.
//!
//! Assumption: an angle without limits turns by less than three eighths of a revolution in a step.

use super::coordinate::Measured;
use super::track::Guide;
use crate::scene::{Coordinate, Drive, Freedom, Joint, Motor};
use polhode_spatial::Rotation;
use std::f64::consts::FRAC_PI_2;
use std::sync::Arc;

/// A coordinate of a joint.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct JointCoordinate {
    pub(crate) coordinate: Coordinate,
    pub(crate) measured: Measured,
    /// The length that makes displacements of its values: m of an angle, 1 otherwise.
    pub(crate) unit: f64,
    /// The value near which an angle is known to be, rad.
    pub(crate) near: f64,
    /// Whether that follows the angle, because it turns on.
    pub(crate) turns_on: bool,
    pub(crate) freedom: Freedom,
}

/// The coordinates of a joint of bodies with these attitudes, on this track if it is one; `length` is that of its rows
/// of rotation, m.
pub(crate) fn coordinates(
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
        let turns_on = freedom.limits().is_none() && matches!(measured, Measured::Angle { .. });
        let near = freedom.limits().map_or(0.0, |limits| 0.5 * (limits.lower() + limits.upper()));
        Some(JointCoordinate { coordinate, measured, unit, near, turns_on, freedom })
    };
    joint.kind().coordinates().iter().filter_map(of_coordinate).collect()
}

impl JointCoordinate {
    /// What acts along it depends on its value, within its limits.
    pub(crate) fn is_sprung(&self) -> bool {
        let servo = |motor: Motor| matches!(motor.drive(), Drive::Position { .. });
        self.freedom.stiffness() > 0.0 || self.freedom.motor().is_some_and(servo)
    }
}

/// The multiple of a quarter of a revolution next to an angle, rad.
pub(crate) fn quarters_near(angle: f64) -> f64 {
    FRAC_PI_2 * libm::round(angle / FRAC_PI_2)
}
