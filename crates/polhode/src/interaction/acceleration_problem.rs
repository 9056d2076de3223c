//! The complementarity problem of touching contacts at one instant.

use super::assembly::Assembly;
use crate::collision::contact_set::Touch;
use crate::world::{Loads, World};
use polhode_dynamics::BodyState;
use polhode_response::ResponseError;

/// `0 <= f _|_ G f + b >= 0` of the contacts of a group of bodies (thesis 3.4).
#[derive(Debug)]
pub(crate) struct AccelerationProblem {
    /// The rows, and the bodies they act on.
    pub(crate) assembly: Assembly,
    /// Generalised accelerations of the bodies without contact forces.
    pub(crate) free: Vec<f64>,
    /// `b`: `chi''` of each contact without contact forces, m/s^2.
    pub(crate) constants: Vec<f64>,
}

impl AccelerationProblem {
    /// That of `contacts` between `bodies` (movable, ascending) at time `t` (s) under `loads`.
    ///
    /// # Errors
    /// When a number is not finite.
    pub(crate) fn new(
        world: &World,
        t: f64,
        states: &[BodyState],
        bodies: &[usize],
        contacts: &[Touch],
        loads: &Loads,
    ) -> Result<Self, ResponseError> {
        let rows = contacts.iter().map(|touch| (touch.id, touch.kinematics.geometry));
        let assembly = Assembly::new(world, states, bodies, rows)?;
        let free = assembly.free_accelerations(world, states, loads);
        let kinematics = contacts.iter().map(|touch| (touch.id, &touch.kinematics));
        let constants = assembly.acceleration_constants(world, t, states, &free, kinematics)?;
        Ok(Self { assembly, free, constants })
    }
}
