//! Newton's attraction between the bodies of a scene.
//!
//! `F_ij = G m_i m_j r/|r|^3` along the line between the centres of mass, `V = -sum over pairs G m_i m_j/|r|`; bodies are
//! taken as particles, as in [`super::point_gravity`]. Action equals reaction to the last bit, so momentum is conserved.
//! Singular where two centres of mass meet.

use super::error::not_negative;
use super::point_gravity::{GRAVITATION, attraction};
use super::{Account, Dependence, Field, FieldError, Wrench};
use crate::{BodyState, RigidBody};

/// Attraction of every pair of bodies.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MutualGravity {
    gravitation: f64,
}

impl MutualGravity {
    /// With a constant of gravitation (m^3/(kg s^2)) of one's own units.
    ///
    /// # Errors
    /// When it is negative or not finite.
    pub fn new(gravitation: f64) -> Result<Self, FieldError> {
        Ok(Self { gravitation: not_negative("the constant of gravitation", gravitation)? })
    }

    /// With nature's: [`GRAVITATION`].
    pub const fn newtonian() -> Self {
        Self { gravitation: GRAVITATION }
    }
}

impl Field for MutualGravity {
    fn dependence(&self) -> Dependence {
        Dependence::Poses
    }

    fn account(&self) -> Account {
        Account::Potential
    }

    fn turns(&self, _body: usize) -> bool {
        false
    }

    fn add_wrenches(&self, _t: f64, bodies: &[RigidBody], states: &[BodyState], wrenches: &mut [Wrench]) {
        for (i, (body, state)) in bodies.iter().zip(states).enumerate() {
            let position = body.center_of_mass_position(state);
            for (j, (other, other_state)) in bodies.iter().zip(states).enumerate().skip(i + 1) {
                let arm = other.center_of_mass_position(other_state) - position;
                let force = attraction(arm, self.gravitation * body.mass() * other.mass());
                if let Some(wrench) = wrenches.get_mut(i) {
                    wrench.force += force;
                }
                if let Some(wrench) = wrenches.get_mut(j) {
                    wrench.force -= force;
                }
            }
        }
    }

    fn potential_energy(&self, bodies: &[RigidBody], states: &[BodyState]) -> f64 {
        let mut energy = 0.0;
        for (i, (body, state)) in bodies.iter().zip(states).enumerate() {
            let position = body.center_of_mass_position(state);
            for (other, other_state) in bodies.iter().zip(states).skip(i + 1) {
                let distance = (other.center_of_mass_position(other_state) - position).length();
                energy -= self.gravitation * body.mass() * other.mass() / distance;
            }
        }
        energy
    }
}
