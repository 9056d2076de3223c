//! The state of a kinematic body, which holds the angular velocity in the place of the angular momentum
//! (`prescribed.rs`).

use crate::scene::Trajectory;
use polhode_dynamics::BodyState;
use polhode_spatial::{Motion, Velocity};

/// The state at `t` (s) of a body that follows a trajectory.
pub(crate) fn state_at(trajectory: &Trajectory, t: f64) -> BodyState {
    let velocity = trajectory.velocity(t);
    BodyState { pose: trajectory.pose(t), linear_velocity: velocity.linear, angular_momentum: velocity.angular }
}

/// The velocity that the state of a kinematic body holds.
pub(crate) const fn velocity_of(state: &BodyState) -> Velocity {
    Velocity::new(state.linear_velocity, state.angular_momentum)
}
