//! Semi-implicit Euler with an implicit gyroscopic term (Catto): the spin of game engines that does not blow up.
//!
//! The torque first, `w <- w + h I^-1 R^T torque`; then one Newton step, from there, for the implicit equation
//! `I (w+ - w) + h w+ x I w+ = 0` in body axes:
//!
//! ```text
//! f = h w x I w,   J = I + h ([w]x I - [I w]x),   w+ = w - J^-1 f
//! ```
//!
//! and the pose by the new velocities: `q+ = q exp(h w+)`, `v+ = v + h a`, `x+ = x + h v+`. Order 1. A free rotation
//! loses energy at every step, up to steps of a radian and more, so that in the end it turns about the axis of its
//! largest moment. J can be singular where `h |w|` reaches some 1.7 rad about the axis of the middle moment.
//! Source: docs/REFERENCES.md, Catto 2015.

use super::body_axes::{exp, solve, to_body, to_world};
use super::loads::Load;
use super::one_step::{OneStep, integrator_by_driver};
use super::single_evaluation::{BodyStep, SingleEvaluation};
use crate::{BodyState, RigidBody};
use glam::DVec3;
use polhode_spatial::{Pose, Rotation};

/// The method.
#[derive(Debug)]
pub struct ImplicitGyroscopic(OneStep<SingleEvaluation<Step>>);

impl ImplicitGyroscopic {
    /// Without bodies until it is started.
    pub fn new() -> Self {
        Self(OneStep::new(SingleEvaluation::default()))
    }
}

impl Default for ImplicitGyroscopic {
    fn default() -> Self {
        Self::new()
    }
}

integrator_by_driver!(ImplicitGyroscopic);

#[derive(Debug)]
struct Step;

impl BodyStep for Step {
    #[inline]
    fn step(body: &RigidBody, state: &BodyState, load: Load, h: f64) -> BodyState {
        let (q, inertia) = (state.pose.rotation.quaternion(), body.inertia());
        let p = to_body(q, state.angular_momentum + load.torque * h);
        let w = body.inverse_inertia() * p;
        let gyroscopic = [
            w.cross(inertia.x_axis) - DVec3::new(0.0, p.z, -p.y),
            w.cross(inertia.y_axis) - DVec3::new(-p.z, 0.0, p.x),
            w.cross(inertia.z_axis) - DVec3::new(p.y, -p.x, 0.0),
        ];
        let columns = [
            inertia.x_axis + gyroscopic[0] * h,
            inertia.y_axis + gyroscopic[1] * h,
            inertia.z_axis + gyroscopic[2] * h,
        ];
        let w_next = w - solve(columns, w.cross(p) * h).0;
        let next = Rotation::renormalized(q * exp(w_next * h));
        let linear_velocity = state.linear_velocity + load.acceleration * h;
        BodyState {
            pose: Pose::new(next, state.pose.translation + linear_velocity * h),
            linear_velocity,
            angular_momentum: to_world(next.quaternion(), inertia * w_next),
        }
    }
}
