//! The semi-implicit Euler method of game engines: first the velocities, then the pose by the new velocities.
//!
//! In body axes, with `p = R^T (L + h torque)`: `p+ = p + h p x I^-1 p`, `w+ = I^-1 p+`, `q+ = q + h q (0, w+)/2`
//! (normalised), `v+ = v + h a`, `x+ = x + h v+`. Order 1. The translation is symplectic; the rotation is not, because
//! the gyroscopic term `p x w` is taken explicitly: a fast spin gains energy until it blows up.
//! [`super::implicit_gyroscopic`] mends that.

use super::body_axes::{quaternion_rate, to_body, to_world};
use super::loads::Load;
use super::one_step::{OneStep, integrator_by_driver};
use super::single_evaluation::{BodyStep, SingleEvaluation};
use crate::{BodyState, RigidBody};
use polhode_spatial::{Pose, Rotation};

/// The method.
#[derive(Debug)]
pub struct SemiImplicitEuler(OneStep<SingleEvaluation<Step>>);

impl SemiImplicitEuler {
    /// Without bodies until it is started.
    pub fn new() -> Self {
        Self(OneStep::new(SingleEvaluation::default()))
    }
}

impl Default for SemiImplicitEuler {
    fn default() -> Self {
        Self::new()
    }
}

integrator_by_driver!(SemiImplicitEuler);

#[derive(Debug)]
struct Step;

impl BodyStep for Step {
    #[inline]
    fn step(body: &RigidBody, state: &BodyState, load: Load, h: f64) -> BodyState {
        let q = state.pose.rotation.quaternion();
        let p = to_body(q, state.angular_momentum + load.torque * h);
        let p_next = p + p.cross(body.inverse_inertia() * p) * h;
        let next = Rotation::renormalized(q + quaternion_rate(q, body.inverse_inertia() * p_next) * h);
        let linear_velocity = state.linear_velocity + load.acceleration * h;
        BodyState {
            pose: Pose::new(next, state.pose.translation + linear_velocity * h),
            linear_velocity,
            angular_momentum: to_world(next.quaternion(), p_next),
        }
    }
}
