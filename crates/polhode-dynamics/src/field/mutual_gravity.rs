//! Newton's attraction between the bodies of a scene.
//!
//! `F_ij = G m_i m_j r/|r|^3` along the line between the centres of mass, `V = -sum over pairs G m_i m_j/|r|`; bodies
//! are taken as particles, as in [`super::point_gravity`]. Action equals reaction to the last bit, so momentum is
//! conserved. Singular where two centres of mass meet.

use super::error::not_negative;
use super::point_gravity::{GRAVITATION, attraction};
use super::{Account, Dependence, Field, FieldError, Wrench};
use crate::{BodyState, RigidBody};

/// Attraction of every pair of bodies.
#[derive(Debug, Clone, PartialEq)]
pub struct MutualGravity {
    gravitation: f64,
    /// Bodies that neither attract nor are attracted, ascending.
    without: Vec<usize>,
}

impl MutualGravity {
    /// With a constant of gravitation (m^3/(kg s^2)) of one's own units.
    ///
    /// # Errors
    /// When it is negative or not finite.
    pub fn new(gravitation: f64) -> Result<Self, FieldError> {
        Ok(Self { gravitation: not_negative("the constant of gravitation", gravitation)?, without: Vec::new() })
    }

    /// With nature's: [`GRAVITATION`].
    pub const fn newtonian() -> Self {
        Self { gravitation: GRAVITATION, without: Vec::new() }
    }

    /// The same without the bodies of these indices, ascending: they neither attract nor are attracted.
    #[must_use]
    pub fn without(self, bodies: Vec<usize>) -> Self {
        Self { without: bodies, ..self }
    }

    /// Whether it acts on the body of this index.
    fn takes(&self, body: usize) -> bool {
        self.without.binary_search(&body).is_err()
    }
}

impl Field for MutualGravity {
    fn dependence(&self) -> Dependence {
        Dependence::Poses
    }

    fn account(&self) -> Account {
        Account::Potential
    }

    fn acts_on(&self, body: usize) -> bool {
        self.takes(body)
    }

    fn turns(&self, _body: usize) -> bool {
        false
    }

    fn add_wrenches(&self, _t: f64, bodies: &[RigidBody], states: &[BodyState], wrenches: &mut [Wrench]) {
        let there = || bodies.iter().zip(states).enumerate().filter(|(index, _)| self.takes(*index));
        for (i, (body, state)) in there() {
            let position = body.center_of_mass_position(state);
            for (j, (other, other_state)) in there().filter(|(j, _)| *j > i) {
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
        let there = || bodies.iter().zip(states).enumerate().filter(|(index, _)| self.takes(*index));
        for (i, (body, state)) in there() {
            let position = body.center_of_mass_position(state);
            for (_, (other, other_state)) in there().filter(|(j, _)| *j > i) {
                let distance = (other.center_of_mass_position(other_state) - position).length();
                energy -= self.gravitation * body.mass() * other.mass() / distance;
            }
        }
        energy
    }
}
