//! Bodies in free fall, as a system for the integrators.
//!
//! The thesis's equations (3.3, "Simulating Motion when in Free Fall") in the variables it integrates best: with the
//! angular momentum L constant, `p' = v, q' = (0, w) q / 2, v' = g, L' = 0` and `w = R I^-1 R^T L`. The exact
//! solution is [`crate::Flight`]; this system is for comparing methods, and the thesis's own method on it is
//! [`crate::rk4`].

use crate::state::{self, ANGULAR_MOMENTUM, LINEAR_VELOCITY, POSITION, QUATERNION, WIDTH};
use crate::{BodyState, RigidBody, System};
use glam::{DQuat, DVec3};
use std::convert::Infallible;

/// Bodies one after the other, [`WIDTH`] numbers each, under uniform gravity.
#[derive(Debug, Clone, Copy)]
pub struct FreeFall<'a> {
    bodies: &'a [RigidBody],
    gravity: DVec3,
}

impl<'a> FreeFall<'a> {
    /// `bodies` in the order of the flat state; `gravity` in m/s^2, world.
    pub const fn new(bodies: &'a [RigidBody], gravity: DVec3) -> Self {
        Self { bodies, gravity }
    }
}

impl System for FreeFall<'_> {
    type Error = Infallible;

    fn dimension(&self) -> usize {
        WIDTH * self.bodies.len()
    }

    fn derivative(&mut self, _t: f64, state: &[f64], rates: &mut [f64]) -> Result<(), Infallible> {
        let blocks = state.as_chunks::<WIDTH>().0.iter().zip(rates.as_chunks_mut::<WIDTH>().0);
        for (body, (numbers, rates)) in self.bodies.iter().zip(blocks) {
            let state = BodyState::from_array(numbers);
            let [w, x, y, z] =
                [numbers[QUATERNION], numbers[QUATERNION + 1], numbers[QUATERNION + 2], numbers[QUATERNION + 3]];
            let turn = quaternion_rate(DQuat::from_xyzw(x, y, z, w), body.angular_velocity(&state));
            rates[POSITION..QUATERNION].copy_from_slice(&state.linear_velocity.to_array());
            rates[QUATERNION..LINEAR_VELOCITY].copy_from_slice(&turn);
            rates[LINEAR_VELOCITY..ANGULAR_MOMENTUM].copy_from_slice(&self.gravity.to_array());
            rates[ANGULAR_MOMENTUM..].fill(0.0);
        }
        Ok(())
    }

    fn normalize(&self, state: &mut [f64]) {
        state::normalize(state);
    }
}

/// Rate of a quaternion (body to world, any length), `(0, w) q / 2`, as w, x, y, z, for the angular velocity `w`
/// (rad/s, world).
pub fn quaternion_rate(quaternion: DQuat, angular_velocity: DVec3) -> [f64; 4] {
    let half = angular_velocity * 0.5;
    let rate = DQuat::from_xyzw(half.x, half.y, half.z, 0.0) * quaternion;
    [rate.w, rate.x, rate.y, rate.z]
}
