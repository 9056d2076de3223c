//! Momentum of bodies: `P = m v` and `L_Q = L_cm + (x - Q) x m v` about a point Q fixed in the world.
//!
//! Both are constant in free flight without gravity; contact forces between two bodies conserve their sums. For a
//! pivoted body, whose L is about its pivot at p, the second reads `L_Q = L + (p - Q) x m v_cm`.

use crate::{BodyState, RigidBody};
use glam::DVec3;

/// Linear momentum `m v_cm`, kg m/s.
pub fn linear_momentum(body: &RigidBody, state: &BodyState) -> DVec3 {
    body.center_of_mass_linear_velocity(state) * body.mass()
}

/// Angular momentum about the world's `point` (m), kg m^2/s. A point near the bodies keeps the digits that the lever
/// arm to a far origin would cost.
pub fn angular_momentum_about(point: DVec3, body: &RigidBody, state: &BodyState) -> DVec3 {
    state.angular_momentum + (state.pose.translation - point).cross(linear_momentum(body, state))
}
