//! Forces and torques applied to one body from outside: thrusters, motors, pushes; constant or following a [`Signal`].
//!
//! `F = s(t) f` at the body's point Q, with `torque = R (p_CQ - p_CBcm) x F` about the centre of mass; `torque = s(t)
//! tau`. The direction is fixed in the world or turns with the body. Their work is external: also that of a constant
//! force fixed in the world, which has a potential.

use super::error::finite_vector;
use super::{Account, Dependence, Field, FieldError, Signal, Wrench};
use crate::{BodyState, RigidBody};
use glam::DVec3;

/// The axes that the components of a vector are along.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Frame {
    /// The world's.
    World,
    /// The body's: the vector turns with it.
    Body,
}

impl Frame {
    fn to_world(self, state: &BodyState, vector: DVec3) -> DVec3 {
        match self {
            Self::World => vector,
            Self::Body => state.pose.rotation.rotate(vector),
        }
    }
}

/// What a load depends on.
const fn dependence(signal: &Signal) -> Dependence {
    if signal.is_constant() { Dependence::Poses } else { Dependence::PosesAndTime }
}

/// A force at a point of a body.
#[derive(Debug, Clone)]
pub struct AppliedForce {
    body: usize,
    force: DVec3,
    frame: Frame,
    point: Option<DVec3>,
    signal: Signal,
}

impl AppliedForce {
    /// `force` (N, along the axes of `frame`) at the centre of mass of the body of this index.
    ///
    /// # Errors
    /// When the force is not finite.
    pub fn new(body: usize, force: DVec3, frame: Frame) -> Result<Self, FieldError> {
        Ok(Self { body, force: finite_vector("the force", force)?, frame, point: None, signal: Signal::ONE })
    }

    /// At the body's point `p_CQ` (m, body axes, from the origin of the moving frame: centre of mass or pivot).
    ///
    /// # Errors
    /// When the point is not finite.
    pub fn at_point(mut self, point: DVec3) -> Result<Self, FieldError> {
        self.point = Some(finite_vector("the point", point)?);
        Ok(self)
    }

    /// Multiplied by `signal`.
    pub fn following(mut self, signal: Signal) -> Self {
        self.signal = signal;
        self
    }
}

impl Field for AppliedForce {
    fn dependence(&self) -> Dependence {
        dependence(&self.signal)
    }

    fn account(&self) -> Account {
        Account::External
    }

    fn acts_on(&self, body: usize) -> bool {
        body == self.body
    }

    fn bodies(&self) -> Option<Vec<usize>> {
        Some(vec![self.body])
    }

    fn turns(&self, _body: usize) -> bool {
        self.point.is_some()
    }

    fn corner_between(&self, from: f64, to: f64) -> Option<f64> {
        self.signal.corner_between(from, to)
    }

    fn add_wrenches(&self, t: f64, bodies: &[RigidBody], states: &[BodyState], wrenches: &mut [Wrench]) {
        let (Some(body), Some(state)) = (bodies.get(self.body), states.get(self.body)) else { return };
        let Some(wrench) = wrenches.get_mut(self.body) else { return };
        let force = self.frame.to_world(state, self.force) * self.signal.at(t);
        wrench.force += force;
        if let Some(point) = self.point {
            wrench.torque += state.pose.rotation.rotate(point - body.arm()).cross(force);
        }
    }

    fn potential_energy(&self, _bodies: &[RigidBody], _states: &[BodyState]) -> f64 {
        0.0
    }
}

/// A torque on a body.
#[derive(Debug, Clone)]
pub struct AppliedTorque {
    body: usize,
    torque: DVec3,
    frame: Frame,
    signal: Signal,
}

impl AppliedTorque {
    /// `torque` (N m, along the axes of `frame`) on the body of this index.
    ///
    /// # Errors
    /// When the torque is not finite.
    pub fn new(body: usize, torque: DVec3, frame: Frame) -> Result<Self, FieldError> {
        Ok(Self { body, torque: finite_vector("the torque", torque)?, frame, signal: Signal::ONE })
    }

    /// Multiplied by `signal`.
    pub fn following(mut self, signal: Signal) -> Self {
        self.signal = signal;
        self
    }
}

impl Field for AppliedTorque {
    fn dependence(&self) -> Dependence {
        dependence(&self.signal)
    }

    fn account(&self) -> Account {
        Account::External
    }

    fn acts_on(&self, body: usize) -> bool {
        body == self.body
    }

    fn bodies(&self) -> Option<Vec<usize>> {
        Some(vec![self.body])
    }

    fn corner_between(&self, from: f64, to: f64) -> Option<f64> {
        self.signal.corner_between(from, to)
    }

    fn add_wrenches(&self, t: f64, _bodies: &[RigidBody], states: &[BodyState], wrenches: &mut [Wrench]) {
        if let (Some(state), Some(wrench)) = (states.get(self.body), wrenches.get_mut(self.body)) {
            wrench.torque += self.frame.to_world(state, self.torque) * self.signal.at(t);
        }
    }

    fn potential_energy(&self, _bodies: &[RigidBody], _states: &[BodyState]) -> f64 {
        0.0
    }
}
