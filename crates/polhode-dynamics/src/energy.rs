//! Energy of bodies under uniform gravity.
//!
//! `V = -m g . x` with x the centre of mass (m) and g the acceleration (m/s^2): zero at the world's origin. Kinetic
//! energy is [`RigidBody::kinetic_energy`] (thesis 3.3). In free flight `T + V` is constant, and the rotational part
//! of T by itself.

use crate::{BodyState, RigidBody};
use glam::DVec3;

/// Potential energy `-m g . x`, J, of a body of `mass` (kg) with its centre of mass at `position` (m, world).
pub fn potential_energy(mass: f64, gravity: DVec3, position: DVec3) -> f64 {
    -mass * gravity.dot(position)
}

/// Kinetic and potential energy of one body, J.
pub fn total_energy(body: &RigidBody, state: &BodyState, gravity: DVec3) -> f64 {
    body.kinetic_energy(state) + potential_energy(body.mass(), gravity, body.center_of_mass_position(state))
}
