//! Linear damper between two points: `F = c d'` along the line between them, d' the rate of their distance.
//!
//! Its power `-c d'^2` is never positive. The force has no direction where the points coincide, and is none there.

use super::error::not_negative;
use super::link::Link;
use super::response::outer;
use super::{Account, Anchor, Dependence, Field, FieldError, ForceResponse, Wrench};
use crate::{BodyState, RigidBody};

/// A damper.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Damper {
    link: Link,
    damping: f64,
}

impl Damper {
    /// Between two bodies, or a body and the world; `damping` in N s/m.
    ///
    /// # Errors
    /// When both ends are on the same body or in the world, or a number is negative or not finite.
    pub fn new(a: Anchor, b: Anchor, damping: f64) -> Result<Self, FieldError> {
        let damping = not_negative("the damping", damping)?;
        Ok(Self { link: Link::new(a, b)?, damping })
    }
}

impl Field for Damper {
    fn dependence(&self) -> Dependence {
        Dependence::Velocities
    }

    fn account(&self) -> Account {
        Account::Damping
    }

    fn acts_on(&self, body: usize) -> bool {
        self.link.acts_on(body)
    }

    fn bodies(&self) -> Option<Vec<usize>> {
        Some(self.link.bodies())
    }

    fn add_wrenches(&self, _t: f64, bodies: &[RigidBody], states: &[BodyState], wrenches: &mut [Wrench]) {
        let Some((extent, rate)) = self.link.extent(bodies, states) else { return };
        let direction = extent.normalize_or_zero();
        self.link.pull(direction * (self.damping * rate.dot(direction)), bodies, states, wrenches);
    }

    fn responses(&self, bodies: &[RigidBody], states: &[BodyState]) -> Option<Vec<ForceResponse>> {
        let Some((extent, _)) = self.link.extent(bodies, states) else { return Some(Vec::new()) };
        let direction = extent.normalize_or_zero();
        let damping = outer(direction, direction) * self.damping;
        Some(vec![ForceResponse { damping, ..self.link.response(states) }])
    }

    fn potential_energy(&self, _bodies: &[RigidBody], _states: &[BodyState]) -> f64 {
        0.0
    }
}
