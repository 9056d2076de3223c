//! Linear spring between two points: `F = k (d - d0)` along the line between them, `V = k (d - d0)^2/2`.
//!
//! d the distance, d0 the length at rest. The force has no direction where the points coincide; a spring with a length
//! at rest gives none there (its potential has a peak), one without is smooth. A spring with damping is a spring and a
//! [`super::Damper`], whose work is booked elsewhere.

use super::error::not_negative;
use super::link::Link;
use super::response::outer;
use super::{Account, Anchor, Dependence, Field, FieldError, ForceResponse, ResponseEnd, Wrench};
use crate::{BodyState, RigidBody};
use glam::{DMat3, DVec3};

/// A spring.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Spring {
    link: Link,
    stiffness: f64,
    rest_length: f64,
}

impl Spring {
    /// Between two bodies, or a body and the world; `stiffness` in N/m, `rest_length` in m.
    ///
    /// # Errors
    /// When both ends are on the same body or in the world, or a number is negative or not finite.
    pub fn new(a: Anchor, b: Anchor, stiffness: f64, rest_length: f64) -> Result<Self, FieldError> {
        let stiffness = not_negative("the stiffness", stiffness)?;
        let rest_length = not_negative("the rest length", rest_length)?;
        Ok(Self { link: Link::new(a, b)?, stiffness, rest_length })
    }
}

impl Field for Spring {
    fn dependence(&self) -> Dependence {
        Dependence::Poses
    }

    fn account(&self) -> Account {
        Account::Potential
    }

    fn acts_on(&self, body: usize) -> bool {
        self.link.acts_on(body)
    }

    fn bodies(&self) -> Option<Vec<usize>> {
        Some(self.link.bodies())
    }

    fn add_wrenches(&self, _t: f64, bodies: &[RigidBody], states: &[BodyState], wrenches: &mut [Wrench]) {
        let Some((extent, _)) = self.link.extent(bodies, states) else { return };
        let distance = extent.length();
        // Without a rest length the direction is not needed, and points that coincide are no special case.
        let per_length = if self.rest_length == 0.0 {
            self.stiffness
        } else if distance == 0.0 {
            0.0
        } else {
            self.stiffness * ((distance - self.rest_length) / distance)
        };
        self.link.pull(extent * per_length, bodies, states, wrenches);
    }

    fn responses(&self, bodies: &[RigidBody], states: &[BodyState]) -> Option<Vec<ForceResponse>> {
        let Some((extent, _)) = self.link.extent(bodies, states) else { return Some(Vec::new()) };
        let distance = extent.length();
        // Across the line the force turns with it: `k (d - d0)/d`. A spring that is compressed pushes aside.
        let across =
            if distance > self.rest_length { self.stiffness * (1.0 - self.rest_length / distance) } else { 0.0 };
        let direction = extent.normalize_or_zero();
        let along = outer(direction, direction) * (self.stiffness - across);
        let response = self.link.response(states);
        let pull = direction * (self.stiffness * (distance - self.rest_length));
        let turning = |end: Option<ResponseEnd>, force: DVec3| {
            end.map_or(0.0, |end| 0.5 * (end.arm.length() * force.length() + end.arm.dot(force)))
        };
        let rotational_stiffness = [turning(response.ends[0], pull), turning(response.ends[1], -pull)];
        Some(vec![ForceResponse { stiffness: DMat3::IDENTITY * across + along, rotational_stiffness, ..response }])
    }

    fn potential_energy(&self, bodies: &[RigidBody], states: &[BodyState]) -> f64 {
        self.link.extent(bodies, states).map_or(0.0, |(extent, _)| {
            let stretch = extent.length() - self.rest_length;
            0.5 * self.stiffness * stretch * stretch
        })
    }
}
