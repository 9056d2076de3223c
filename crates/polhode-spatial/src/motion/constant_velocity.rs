//! Constant linear and angular velocity.
//!
//! With `s = t - t0`: `p(t) = p_0 + v s`, `R(t) = exp([w]x s) R_0`; v the velocity of the centre of mass (m/s), w the
//! angular velocity (rad/s), both in world axes. It is how a body moves that no force acts on and that spins about a
//! principal axis; of any other body it is the motion's tangent at `t0`.
//!
//! Failure: at times so far away that `v s` or `w s` overflows the pose is not finite, which its users report.

use super::error::check_start;
use super::steady_spin::{length_bound, turned};
use super::{Motion, MotionBounds, MotionError};
use crate::{Pose, Velocity};

/// A motion whose linear and angular velocity do not change.
///
/// ```
/// use polhode_spatial::{ConstantVelocity, DVec3, Motion, Pose, Velocity};
/// let velocity = Velocity::new(DVec3::X * 2.0, DVec3::Z * std::f64::consts::FRAC_PI_2);
/// let rolling = ConstantVelocity::new(0.0, Pose::IDENTITY, velocity)?;
/// let pose = rolling.pose(3.0);
/// assert_eq!(pose.translation, DVec3::X * 6.0);
/// assert!((pose.rotation.rotate(DVec3::X) + DVec3::Y).length() < 1e-15);
/// # Ok::<(), polhode_spatial::MotionError>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ConstantVelocity {
    t0: f64,
    start: Pose,
    velocity: Velocity,
}

impl ConstantVelocity {
    /// The motion that passes `start` (`X_WC`) at `t0` (s) and always has `velocity`.
    ///
    /// # Errors
    /// When a number is not finite.
    pub fn new(t0: f64, start: Pose, velocity: Velocity) -> Result<Self, MotionError> {
        check_start(t0, &start, &velocity)?;
        Ok(Self { t0, start, velocity })
    }
}

impl Motion for ConstantVelocity {
    fn pose(&self, t: f64) -> Pose {
        let s = t - self.t0;
        let rotation = turned(self.start.rotation, self.velocity.angular, s);
        Pose::new(rotation, self.start.translation + self.velocity.linear * s)
    }

    fn velocity(&self, _t: f64) -> Velocity {
        self.velocity
    }

    fn bounds(&self, _t0: f64, _t1: f64) -> MotionBounds {
        MotionBounds {
            speed: length_bound(self.velocity.linear),
            acceleration: 0.0,
            angular_speed: length_bound(self.velocity.angular),
            angular_acceleration: 0.0,
        }
    }
}
