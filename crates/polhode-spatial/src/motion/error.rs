//! Why numbers make no motion.

use crate::{Pose, Velocity};
use glam::DVec3;
use thiserror::Error;

/// Why numbers make no motion: one of them is NaN or infinite.
#[derive(Debug, Clone, Copy, PartialEq, Error)]
pub enum MotionError {
    /// The time of the start.
    #[error("a motion cannot start at {0} s: the time must be a finite number of seconds")]
    Time(f64),
    /// The pose at the start.
    #[error(
        "a motion cannot start at {:?} m, [w, x, y, z] = {:?}: every component of the pose must be finite",
        .0.translation.to_array(), .0.rotation.to_wxyz()
    )]
    Pose(Pose),
    /// The velocity at the start.
    #[error(
        "a motion cannot start at {:?} m/s, {:?} rad/s: every component of the velocity must be finite",
        .0.linear.to_array(), .0.angular.to_array()
    )]
    Velocity(Velocity),
    /// The acceleration.
    #[error("a motion cannot accelerate by {:?} m/s^2: every component must be finite", .0.to_array())]
    Acceleration(DVec3),
}

/// Whether a motion can start in this state.
///
/// # Errors
/// When a number is not finite.
pub(super) fn check_start(t0: f64, start: &Pose, velocity: &Velocity) -> Result<(), MotionError> {
    if !t0.is_finite() {
        return Err(MotionError::Time(t0));
    }
    if !start.is_finite() {
        return Err(MotionError::Pose(*start));
    }
    if !velocity.is_finite() {
        return Err(MotionError::Velocity(*velocity));
    }
    Ok(())
}
