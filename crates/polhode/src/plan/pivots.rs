//! Pivots: bodies held at a point of the world, by constraint rows or by a reduction to rotation about the point.
//!
//! A pivot keeps the point Q of a body at a point of the world: three bilateral rows `p_Q = const`, with a constraint
//! force of any direction. With the arm `r` from the centre of mass to Q,
//!
//! `u = v + w x r`,  `a_Q = a + alpha x r + w x (w x r)`,
//!
//! the rows are `(e_k, r x e_k)` for the three axes of the world, with the constants `e_k . (w x (w x r))` (thesis 3.2,
//! equations 2 and 3 for a point of a body; Featherstone, chapter 8, for rows of joints). This is the general form: the
//! moving frame of the body has its origin at the centre of mass, as that of any other body, and the pivot is one more
//! [constraint](crate::constraint).
//!
//! If no contact can act on the body, its motion can be reduced to rotation about Q: in a frame with its origin at Q,
//! with the moments of inertia about Q and inverse mass zero ([`RigidBody::pivoted`]). Then no row is needed, and the
//! pivot does not drift. This reduction of the plan is exact and costs less; a test compares it with the rows.
//!
//! | form | when |
//! |---|---|
//! | rows | tier `accurate` with `dop853` or `rk4`, if the body may collide or all effects are asked for |
//! | reduced | otherwise |
//!
//! Assumption: the point is fixed in the world and in the body. Fails: never; the scene refuses a point that is not
//! finite.

use crate::model::Model;
use crate::model::pivot_form::HeldPoint;
use polhode_dynamics::{BodyState, RigidBody};
use polhode_spatial::{DVec3, Pose, Velocity};

/// The velocity that a body takes when a program gives it `velocity`: a body that constraint rows hold takes the
/// angular velocity, and the linear one that follows from it.
pub(crate) fn admitted_velocity(model: &Model, body: usize, pose: &Pose, velocity: Velocity) -> Velocity {
    model.bodies[body].held.map_or(velocity, |held| held.velocity_of_rotation(pose, velocity.angular))
}

/// Distance by which a pose (of the moving frame, world) would move a body away from its pivot, m; zero for a body
/// without a pivot.
pub(crate) fn leaves_pivot_by(model: &Model, body: usize, now: &BodyState, pose: &Pose) -> f64 {
    let own = &model.bodies[body];
    if let Some(held) = own.held {
        return (pose.transform_point(held.arm) - held.place).length();
    }
    let pivoted = own.rigid.as_ref().is_some_and(RigidBody::is_pivoted);
    if pivoted { (pose.translation - now.pose.translation).length() } else { 0.0 }
}

/// Applies the impulse at its pivot to a body that constraint rows hold, so that the held point has no velocity.
pub(crate) fn hold_velocity(model: &Model, body: usize, state: &mut BodyState) {
    let own = &model.bodies[body];
    let (Some(held), Some(free)) = (own.held, own.rigid) else { return };
    let Some(properties) = model.scene.bodies[body].mass_properties() else { return };
    let turning = RigidBody::pivoted(properties, own.origin + held.arm);
    let w = turning.angular_velocity(&to_pivot_frame(&free, &held, state));
    let velocity = admitted_velocity(model, body, &state.pose, Velocity::new(DVec3::ZERO, w));
    *state = free.at_velocity(state.pose, velocity);
}

/// The state in the frame at the pivot, from that in the frame at the centre of mass: `L_Q = L - r x m v`.
fn to_pivot_frame(free: &RigidBody, held: &HeldPoint, state: &BodyState) -> BodyState {
    let arm = state.pose.rotation.rotate(held.arm);
    BodyState {
        pose: Pose::new(state.pose.rotation, held.place),
        linear_velocity: DVec3::ZERO,
        angular_momentum: state.angular_momentum - arm.cross(state.linear_velocity * free.mass()),
    }
}
