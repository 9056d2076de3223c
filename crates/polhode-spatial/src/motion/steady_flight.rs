//! Free flight under constant acceleration, with a steady spin.
//!
//! With `s = t - t0`: `p(t) = p_0 + v_0 s + a s^2 / 2`, `v(t) = v_0 + a s`, `R(t) = exp([w]x s) R_0`; p the centre of
//! mass (m), v its velocity (m/s), a its acceleration (m/s^2), w the angular velocity (rad/s), all in world axes.
//!
//! It is exact for a body under uniform gravity that does not turn, turns about a principal axis, or has a spherical
//! inertia. Any other body's angular velocity wanders while its angular momentum stays: `Flight` of polhode-dynamics is
//! exact for all.
//!
//! Failure: at times so far away that a product overflows the pose is not finite, which its users report.

use super::error::check_start;
use super::steady_spin::{length_bound, turned};
use super::{Motion, MotionBounds, MotionError};
use crate::rounding;
use crate::{Pose, Velocity};
use glam::DVec3;

/// The flight of a body under constant acceleration whose angular velocity does not change.
///
/// ```
/// use polhode_spatial::{DVec3, Motion, Pose, SteadyFlight, Velocity};
/// let thrown = Velocity::new(DVec3::new(3.0, 0.0, 4.0), DVec3::Y);
/// let flight = SteadyFlight::new(0.0, Pose::IDENTITY, thrown, DVec3::Z * -10.0)?;
/// assert!((flight.pose(0.4).translation - DVec3::new(1.2, 0.0, 0.8)).length() < 1e-15);
/// assert_eq!(flight.velocity(0.4).linear, DVec3::X * 3.0);
/// # Ok::<(), polhode_spatial::MotionError>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SteadyFlight {
    t0: f64,
    start: Pose,
    velocity: Velocity,
    acceleration: DVec3,
}

impl SteadyFlight {
    /// The flight that passes `start` (`X_WC`) at `t0` (s) with `velocity`, under `acceleration` (m/s^2, world: that of
    /// gravity).
    ///
    /// # Errors
    /// When a number is not finite.
    pub fn new(t0: f64, start: Pose, velocity: Velocity, acceleration: DVec3) -> Result<Self, MotionError> {
        check_start(t0, &start, &velocity)?;
        if !acceleration.is_finite() {
            return Err(MotionError::Acceleration(acceleration));
        }
        Ok(Self { t0, start, velocity, acceleration })
    }

    fn linear_velocity(&self, t: f64) -> DVec3 {
        self.velocity.linear + self.acceleration * (t - self.t0)
    }

    /// Bound of the speed at one time, with the rounding of what it is the sum of; infinite where it cannot be told.
    fn speed_bound(&self, t: f64) -> f64 {
        let summands = length_bound(self.velocity.linear) + length_bound(self.acceleration) * (t - self.t0).abs();
        let bound = length_bound(self.linear_velocity(t)) + rounding::FEW_TERMS * summands;
        if bound.is_nan() { f64::INFINITY } else { bound }
    }
}

impl Motion for SteadyFlight {
    fn pose(&self, t: f64) -> Pose {
        let s = t - self.t0;
        let path = (self.velocity.linear + self.acceleration * (0.5 * s)) * s;
        Pose::new(turned(self.start.rotation, self.velocity.angular, s), self.start.translation + path)
    }

    fn velocity(&self, t: f64) -> Velocity {
        Velocity::new(self.linear_velocity(t), self.velocity.angular)
    }

    fn bounds(&self, t0: f64, t1: f64) -> MotionBounds {
        MotionBounds {
            // The velocity runs along a segment, and the length of a vector is convex: its largest value is at an end.
            speed: self.speed_bound(t0).max(self.speed_bound(t1)),
            acceleration: length_bound(self.acceleration),
            angular_speed: length_bound(self.velocity.angular),
            angular_acceleration: 0.0,
        }
    }
}
