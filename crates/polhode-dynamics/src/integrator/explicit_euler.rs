//! The explicit Euler method: every rate taken at the start of the step.
//!
//! In body axes, with `p = R^T L`: `p+ = p + h p x w`, `q+ = q + h q (0, w)/2` (normalised), then in world axes
//! `L+ = R+ p+ + h torque`, `x+ = x + h v`, `v+ = v + h a`. Order 1; a free rotation gains energy and momentum at every
//! step. The method the thesis names first (3.3, "Simulating Motion when in Free Fall") and does not use.

use super::body_axes::{quaternion_rate, to_body, to_world};
use super::loads::Load;
use super::one_step::{OneStep, integrator_by_driver};
use super::single_evaluation::{BodyStep, SingleEvaluation};
use crate::{BodyState, RigidBody};
use polhode_spatial::{Pose, Rotation};

/// The method.
#[derive(Debug)]
pub struct ExplicitEuler(OneStep<SingleEvaluation<Step>>);

impl ExplicitEuler {
    /// Without bodies until it is started.
    pub fn new() -> Self {
        Self(OneStep::new(SingleEvaluation::default()))
    }
}

impl Default for ExplicitEuler {
    fn default() -> Self {
        Self::new()
    }
}

integrator_by_driver!(ExplicitEuler);

#[derive(Debug)]
struct Step;

impl BodyStep for Step {
    #[inline]
    fn step(body: &RigidBody, state: &BodyState, load: Load, h: f64) -> BodyState {
        let q = state.pose.rotation.quaternion();
        let p = to_body(q, state.angular_momentum);
        let w = body.inverse_inertia() * p;
        let next = Rotation::renormalized(q + quaternion_rate(q, w) * h);
        BodyState {
            pose: Pose::new(next, state.pose.translation + state.linear_velocity * h),
            linear_velocity: state.linear_velocity + load.acceleration * h,
            angular_momentum: to_world(next.quaternion(), p + p.cross(w) * h) + load.torque * h,
        }
    }
}
