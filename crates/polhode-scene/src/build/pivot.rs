//! Bodies on a pivot.
//!
//! The centre of mass of a body that only turns about a point p has the velocity `w x (x_cm - p)`. A velocity in the
//! file must be that one, zero included; the engine, which takes zero for "not given", is then told none and computes
//! it.

use super::fault::Fault;
use crate::document::KeyPath;
use glam::DVec3;
use polhode::{Body, SceneError};

/// How far the velocity given may be from that of the rotation, relative to `|w| |x_cm - p|`: the digits that a file
/// written by hand or by another program may have lost. The product of the lengths and not the velocity itself, which
/// is round-off where the centre of mass lies on the axis of rotation.
const VELOCITY_RELATIVE: f64 = 1e-9;

/// Checks that a velocity of the centre of mass (m/s, given at `path`) is that of the rotation of a body that moves.
pub(super) fn check_velocity(body: &Body, pivot: DVec3, velocity: DVec3, path: &KeyPath) -> Result<(), Fault> {
    let Some(properties) = body.mass_properties() else { return Ok(()) };
    let arm = body.initial_pose().transform_point(properties.center_of_mass()) - pivot;
    let angular = body.initial_velocity().angular;
    let needed = angular.cross(arm);
    let difference = (velocity - needed).length();
    if difference <= VELOCITY_RELATIVE * angular.length() * arm.length() {
        return Ok(());
    }
    let error = SceneError::PivotMoves { body: body.name().to_owned(), difference, needed: needed.to_array() };
    Err((path.clone(), error.into()))
}
