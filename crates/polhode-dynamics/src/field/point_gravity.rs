//! Gravity of a point that does not move: a star, a planet far heavier than what falls towards it.
//!
//! `F = -mu m r/|r|^3`, `V = -mu m/|r|`, r from the point to the centre of mass, `mu = G M` (m^3/s^2). The body is
//! taken as a particle: no torque, so that a long body keeps its attitude (the gravity gradient is left out, relative
//! to the force of the order of the body's size over the distance). Singular at the point, where the force is not
//! finite.

use super::error::{finite_vector, not_negative};
use super::{Account, Dependence, Field, FieldError, Wrench};
use crate::{BodyState, RigidBody};
use glam::DVec3;
use polhode_spatial::Mass;

/// The constant of gravitation, m^3/(kg s^2). Source: CODATA 2018, which gives it to 2.2e-5.
pub const GRAVITATION: f64 = 6.67430e-11;

/// An attracting point; every body is attracted.
#[derive(Debug, Clone, PartialEq)]
pub struct PointGravity {
    mu: f64,
    position: DVec3,
    /// Bodies that it does not attract, ascending.
    without: Vec<usize>,
}

impl PointGravity {
    /// `mu = G M` (m^3/s^2) at `position` (m, world).
    ///
    /// # Errors
    /// When `mu` is negative or a number is not finite.
    pub fn new(mu: f64, position: DVec3) -> Result<Self, FieldError> {
        let mu = not_negative("the gravitational parameter", mu)?;
        Ok(Self { mu, position: finite_vector("the position", position)?, without: Vec::new() })
    }

    /// The same without the bodies of these indices, ascending: they are not attracted.
    #[must_use]
    pub fn without(self, bodies: Vec<usize>) -> Self {
        Self { without: bodies, ..self }
    }

    /// Of an attracting mass at `position` (m, world).
    ///
    /// # Errors
    /// When the position is not finite.
    pub fn of_mass(mass: Mass, position: DVec3) -> Result<Self, FieldError> {
        Self::new(GRAVITATION * mass.get(), position)
    }
}

impl Field for PointGravity {
    fn dependence(&self) -> Dependence {
        Dependence::Poses
    }

    fn account(&self) -> Account {
        Account::Potential
    }

    fn acts_on(&self, body: usize) -> bool {
        self.without.binary_search(&body).is_err()
    }

    fn couples(&self) -> bool {
        false
    }

    fn turns(&self, _body: usize) -> bool {
        false
    }

    fn add_wrenches(&self, _t: f64, bodies: &[RigidBody], states: &[BodyState], wrenches: &mut [Wrench]) {
        let there = bodies.iter().zip(states).zip(wrenches).enumerate().filter(|(index, _)| self.acts_on(*index));
        for (_, ((body, state), wrench)) in there {
            let arm = self.position - body.center_of_mass_position(state);
            wrench.force += attraction(arm, self.mu * body.mass());
        }
    }

    fn potential_energy(&self, bodies: &[RigidBody], states: &[BodyState]) -> f64 {
        let of_body = |(body, state): (&RigidBody, &BodyState)| {
            -self.mu * body.mass() / (body.center_of_mass_position(state) - self.position).length()
        };
        let there = bodies.iter().zip(states).enumerate().filter(|(index, _)| self.acts_on(*index));
        there.map(|(_, placed)| of_body(placed)).sum()
    }
}

/// `strength r/|r|^3`, by the direction first, whose square neither over- nor underflows before the length's own does.
pub(super) fn attraction(arm: DVec3, strength: f64) -> DVec3 {
    let distance = arm.length();
    arm / distance * (strength / distance / distance)
}
