//! Drag of a medium on one body.
//!
//! | law | force | torque | regime |
//! |---|---|---|---|
//! | [`DragLaw::Linear`] | `-c (v - u)` | `-k w` | slow, in a viscous medium (Stokes) |
//! | [`DragLaw::Quadratic`] | `-c abs(v - u) (v - u)` | `-k abs(w) w` | fast (Newton): `c = rho C_d A/2` |
//!
//! v the velocity of the centre of mass and u that of the medium (m/s, world), w the angular velocity. The coefficients
//! are the same in all directions, and the force acts at the centre of mass: no lift, no spin from flow past a body's
//! sides. In a medium at rest the power is never positive and the work is damping; a wind also drives the body, so with
//! one all of the work is booked as external.

use super::error::{finite_vector, not_negative};
use super::response::outer;
use super::{Account, Decay, Dependence, Field, FieldError, ForceResponse, ResponseEnd, Wrench};
use crate::{BodyState, RigidBody};
use glam::{DMat3, DVec3};

/// How drag grows with speed.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum DragLaw {
    /// In proportion.
    Linear,
    /// With the square.
    Quadratic,
}

/// Drag on one body.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Drag {
    body: usize,
    law: DragLaw,
    translational: f64,
    rotational: f64,
    medium: DVec3,
}

impl Drag {
    /// On the body of this index, in a medium at rest. `translational` c in N s/m (linear) or N s^2/m^2 (quadratic),
    /// `rotational` k in N m s or N m s^2.
    ///
    /// # Errors
    /// When a coefficient is negative or not finite.
    pub fn new(body: usize, law: DragLaw, translational: f64, rotational: f64) -> Result<Self, FieldError> {
        let translational = not_negative("the translational drag coefficient", translational)?;
        let rotational = not_negative("the rotational drag coefficient", rotational)?;
        Ok(Self { body, law, translational, rotational, medium: DVec3::ZERO })
    }

    /// In a medium that moves with `velocity` (m/s, world).
    ///
    /// # Errors
    /// When the velocity is not finite.
    pub fn in_wind(mut self, velocity: DVec3) -> Result<Self, FieldError> {
        self.medium = finite_vector("the velocity of the medium", velocity)?;
        Ok(self)
    }

    /// The derivative of [`Drag::oppose`] with the velocity, with the other sign.
    fn slope(&self, coefficient: f64, velocity: DVec3) -> DMat3 {
        match self.law {
            DragLaw::Linear => DMat3::IDENTITY * coefficient,
            DragLaw::Quadratic => {
                let direction = velocity.normalize_or_zero();
                (DMat3::IDENTITY + outer(direction, direction)) * (coefficient * velocity.length())
            }
        }
    }

    /// What opposes a velocity.
    fn oppose(&self, coefficient: f64, velocity: DVec3) -> DVec3 {
        match self.law {
            DragLaw::Linear => velocity * -coefficient,
            DragLaw::Quadratic => velocity * (-coefficient * velocity.length()),
        }
    }
}

impl Field for Drag {
    fn dependence(&self) -> Dependence {
        Dependence::Velocities
    }

    fn account(&self) -> Account {
        if self.medium == DVec3::ZERO { Account::Damping } else { Account::External }
    }

    fn acts_on(&self, body: usize) -> bool {
        body == self.body
    }

    fn bodies(&self) -> Option<Vec<usize>> {
        Some(vec![self.body])
    }

    fn turns(&self, _body: usize) -> bool {
        self.rotational != 0.0
    }

    fn add_wrenches(&self, _t: f64, bodies: &[RigidBody], states: &[BodyState], wrenches: &mut [Wrench]) {
        let (Some(body), Some(state)) = (bodies.get(self.body), states.get(self.body)) else { return };
        let Some(wrench) = wrenches.get_mut(self.body) else { return };
        let velocity = body.center_of_mass_velocity(state);
        wrench.force += self.oppose(self.translational, velocity.linear - self.medium);
        wrench.torque += self.oppose(self.rotational, velocity.angular);
    }

    fn responses(&self, bodies: &[RigidBody], states: &[BodyState]) -> Option<Vec<ForceResponse>> {
        let (Some(body), Some(state)) = (bodies.get(self.body), states.get(self.body)) else { return Some(Vec::new()) };
        let velocity = body.center_of_mass_velocity(state);
        let arm = state.pose.rotation.rotate(body.arm());
        let end = ResponseEnd { body: self.body, arm };
        Some(vec![ForceResponse {
            damping: self.slope(self.translational, velocity.linear - self.medium),
            rotational_damping: self.slope(self.rotational, velocity.angular),
            decay: match self.law {
                DragLaw::Linear => Decay::Exponential,
                DragLaw::Quadratic => Decay::Hyperbolic,
            },
            ..ForceResponse::none([Some(end), None])
        }])
    }

    fn potential_energy(&self, _bodies: &[RigidBody], _states: &[BodyState]) -> f64 {
        0.0
    }
}
