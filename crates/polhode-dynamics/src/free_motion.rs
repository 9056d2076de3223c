//! Bodies that move without contact, under uniform gravity and force fields: what the integrators integrate.
//!
//! `p' = v, q' = (0, w) q / 2, v' = g + F/m, L' = torque`, `w = R I^-1 R^T L` (thesis 3.3, equations 4, 5 and 9, in the
//! variables that conserve best). A pivoted body turns about its pivot: p is the pivot's and stays, v is zero, L and
//! the torque are about the pivot, and gravity adds the torque `r x m g`, r from the pivot to the centre of mass.
//!
//! As a [`System`] its state is flat, [`WIDTH`] numbers per body. Without fields and pivots the exact solution is
//! [`crate::Flight`].

use crate::energy::potential_energy;
use crate::field::{self, Account, Dependence, Field, Wrench};
use crate::state::{self, ANGULAR_MOMENTUM, LINEAR_VELOCITY, POSITION, QUATERNION, WIDTH, quaternion_rate};
use crate::{BodyState, RigidBody, System};
use glam::{DQuat, DVec3};
use std::convert::Infallible;

/// Bodies, gravity and fields; states are slices in the order of the bodies.
#[derive(Debug, Clone, Copy)]
pub struct FreeMotion<'a> {
    bodies: &'a [RigidBody],
    gravity: DVec3,
    fields: &'a [Box<dyn Field>],
}

impl<'a> FreeMotion<'a> {
    /// `gravity` in m/s^2, world.
    pub const fn new(bodies: &'a [RigidBody], gravity: DVec3, fields: &'a [Box<dyn Field>]) -> Self {
        Self { bodies, gravity, fields }
    }

    /// The bodies.
    pub const fn bodies(&self) -> &'a [RigidBody] {
        self.bodies
    }

    /// Acceleration of gravity, m/s^2.
    pub const fn gravity(&self) -> DVec3 {
        self.gravity
    }

    /// The force fields.
    pub const fn fields(&self) -> &'a [Box<dyn Field>] {
        self.fields
    }

    /// What gravity adds to the rate of a body's velocity, m/s^2: nothing for a pivoted body, whose pivot stays.
    pub fn free_acceleration(&self, body: &RigidBody) -> DVec3 {
        if body.is_pivoted() { DVec3::ZERO } else { self.gravity }
    }

    /// What the fields' forces depend on: the worst of them, [`Dependence::Poses`] when there are none.
    pub fn dependence(&self) -> Dependence {
        self.fields.iter().map(|field| field.dependence()).max().unwrap_or(Dependence::Poses)
    }

    /// The first time strictly between `from` and `to` (s) on the way from one to the other at which a field is not
    /// smooth in time.
    pub fn corner_between(&self, from: f64, to: f64) -> Option<f64> {
        field::corner_between(self.fields, from, to)
    }

    /// Whether a wrench of [`FreeMotion::wrenches`] can act on the body of this index: a field, or the torque of
    /// gravity on a pivoted body. Where none can, the body's motion is a [`crate::Flight`] (of a pivoted body: under no
    /// gravity).
    pub fn is_loaded(&self, index: usize) -> bool {
        let swings = |body: &RigidBody| body.arm() != DVec3::ZERO && self.gravity != DVec3::ZERO;
        self.bodies.get(index).is_some_and(swings) || self.fields.iter().any(|field| field.acts_on(index))
    }

    /// Whether anything can turn the body of this index: a field, or what acts on a pivoted body.
    pub fn is_turned(&self, index: usize) -> bool {
        self.bodies.get(index).is_some_and(RigidBody::is_pivoted)
            || self.fields.iter().any(|field| field.acts_on(index) && field.turns(index))
    }

    /// Whether a wrench can act on any body.
    pub fn has_loads(&self) -> bool {
        (0..self.bodies.len()).any(|index| self.is_loaded(index))
    }

    /// Writes the wrench on each body at `t` (s): the force of the fields, and the torque about the origin of the
    /// body's frame C, which is its centre of mass or its pivot. `v' = free_acceleration + inverse_mass force` and
    /// `L' = torque`: gravity is in the torque of a pivoted body and not in the force of a free one.
    /// Entries of `wrenches` beyond the shortest slice are zero.
    pub fn wrenches(&self, t: f64, states: &[BodyState], wrenches: &mut [Wrench]) {
        wrenches.fill(Wrench::default());
        let count = self.bodies.len().min(states.len()).min(wrenches.len());
        let (bodies, states, wrenches) = (&self.bodies[..count], &states[..count], &mut wrenches[..count]);
        for field in self.fields {
            field.add_wrenches(t, bodies, states, wrenches);
        }
        for ((body, state), wrench) in bodies.iter().zip(states).zip(wrenches) {
            self.add_swing(body, state, wrench);
        }
    }

    /// Adds the torque about the pivot of a pivoted body by its weight and the force on it, the last part of
    /// [`FreeMotion::wrenches`].
    pub fn add_swing(&self, body: &RigidBody, state: &BodyState, wrench: &mut Wrench) {
        if body.is_pivoted() {
            let lever = state.pose.rotation.rotate(body.arm());
            wrench.torque += lever.cross(wrench.force + self.gravity * body.mass());
        }
    }

    /// Kinetic energy, J.
    pub fn kinetic_energy(&self, states: &[BodyState]) -> f64 {
        self.bodies.iter().zip(states).map(|(body, state)| body.kinetic_energy(state)).sum()
    }

    /// Potential energy of gravity and of the conservative fields, J.
    pub fn potential_energy(&self, states: &[BodyState]) -> f64 {
        let count = self.bodies.len().min(states.len());
        let (bodies, states) = (&self.bodies[..count], &states[..count]);
        let of_gravity = |(body, state): (&RigidBody, &BodyState)| {
            potential_energy(body.mass(), self.gravity, body.center_of_mass_position(state))
        };
        let weight: f64 = bodies.iter().zip(states).map(of_gravity).sum();
        weight + self.fields.iter().map(|field| field.potential_energy(bodies, states)).sum::<f64>()
    }

    /// Kinetic and potential energy, J.
    pub fn total_energy(&self, states: &[BodyState]) -> f64 {
        self.kinetic_energy(states) + self.potential_energy(states)
    }

    /// Writes the wrenches of the fields of one account at `t` (s), torques about the centres of mass, for the ledgers
    /// of energy and momentum. Entries of `wrenches` beyond the shortest slice are zero.
    pub fn wrenches_of(&self, account: Account, t: f64, states: &[BodyState], wrenches: &mut [Wrench]) {
        wrenches.fill(Wrench::default());
        let count = self.bodies.len().min(states.len()).min(wrenches.len());
        for field in self.fields.iter().filter(|field| field.account() == account) {
            field.add_wrenches(t, &self.bodies[..count], &states[..count], &mut wrenches[..count]);
        }
    }

    /// Power of the fields of one account at `t` (s), W: `sum F . v_cm + torque . w`. Its integral over time is the
    /// work that the ledger books there; that of [`Account::Potential`] is minus the change of the fields' potential.
    pub fn power(&self, t: f64, states: &[BodyState], account: Account) -> f64 {
        let mut wrenches = vec![Wrench::default(); states.len()];
        self.wrenches_of(account, t, states, &mut wrenches);
        let of_body = |((body, state), wrench): ((&RigidBody, &BodyState), &Wrench)| {
            let velocity = body.center_of_mass_velocity(state);
            wrench.force.dot(velocity.linear) + wrench.torque.dot(velocity.angular)
        };
        self.bodies.iter().zip(states).zip(&wrenches).map(of_body).sum()
    }
}

impl System for FreeMotion<'_> {
    type Error = Infallible;

    fn dimension(&self) -> usize {
        WIDTH * self.bodies.len()
    }

    fn derivative(&mut self, t: f64, state: &[f64], rates: &mut [f64]) -> Result<(), Infallible> {
        BufferedMotion::new(*self).derivative(t, state, rates)
    }

    fn normalize(&self, state: &mut [f64]) {
        state::normalize(state);
    }
}

/// A [`FreeMotion`] as a system that keeps its buffers between evaluations: the same numbers without allocation.
#[derive(Debug, Clone)]
pub struct BufferedMotion<'a> {
    motion: FreeMotion<'a>,
    states: Vec<BodyState>,
    wrenches: Vec<Wrench>,
    loaded: bool,
}

impl<'a> BufferedMotion<'a> {
    /// For one motion.
    pub fn new(motion: FreeMotion<'a>) -> Self {
        let loaded = motion.has_loads();
        Self { motion, states: Vec::new(), wrenches: Vec::new(), loaded }
    }

    /// Wrenches at a flat state; none when nothing acts.
    fn evaluate_wrenches(&mut self, t: f64, state: &[f64]) {
        self.states.clear();
        self.wrenches.clear();
        if self.loaded {
            self.states.extend(state.as_chunks::<WIDTH>().0.iter().map(BodyState::from_array));
            self.wrenches.resize(self.states.len(), Wrench::default());
            self.motion.wrenches(t, &self.states, &mut self.wrenches);
        }
    }
}

impl System for BufferedMotion<'_> {
    type Error = Infallible;

    fn dimension(&self) -> usize {
        self.motion.dimension()
    }

    fn derivative(&mut self, t: f64, state: &[f64], rates: &mut [f64]) -> Result<(), Infallible> {
        self.evaluate_wrenches(t, state);
        let blocks = state.as_chunks::<WIDTH>().0.iter().zip(rates.as_chunks_mut::<WIDTH>().0);
        for (index, (body, (numbers, rates))) in self.motion.bodies.iter().zip(blocks).enumerate() {
            let wrench = self.wrenches.get(index).copied().unwrap_or_default();
            write_rates(body, self.motion.free_acceleration(body), wrench, numbers, rates);
        }
        Ok(())
    }

    fn normalize(&self, state: &mut [f64]) {
        state::normalize(state);
    }
}

/// Rates of one body in the flat layout.
fn write_rates(body: &RigidBody, gravity: DVec3, wrench: Wrench, numbers: &[f64; WIDTH], rates: &mut [f64; WIDTH]) {
    let state = BodyState::from_array(numbers);
    let [w, x, y, z] = [numbers[QUATERNION], numbers[QUATERNION + 1], numbers[QUATERNION + 2], numbers[QUATERNION + 3]];
    let turn = quaternion_rate(DQuat::from_xyzw(x, y, z, w), body.angular_velocity(&state));
    let acceleration = gravity + wrench.force * body.inverse_mass();
    rates[POSITION..QUATERNION].copy_from_slice(&state.linear_velocity.to_array());
    rates[QUATERNION..LINEAR_VELOCITY].copy_from_slice(&turn);
    rates[LINEAR_VELOCITY..ANGULAR_MOMENTUM].copy_from_slice(&acceleration.to_array());
    rates[ANGULAR_MOMENTUM..].copy_from_slice(&wrench.torque.to_array());
}
