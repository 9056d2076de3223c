//! A constant screw: turning steadily about an axis that is fixed in the world while moving steadily along it.
//!
//! `X(t) = exp(T s) X_0` with `s = t - t0` and a twist T that does not change (Chasles: every rigid motion between two
//! poses is one). Given by the velocity of the body at `t0`, v of the centre of mass (m/s) and w (rad/s, world axes),
//! with u = w/|w|, `v_p = u (u.v)` along the axis, `v_n = v - v_p` across it and `h = |w| s / 2`:
//!
//! `R(t) = exp([w]x s) R_0`, `p(t) = p_0 + s (v_p + v_n cos h sin h / h) + s^2/2 (sin h / h)^2 w x v`,
//! `v(t) = exp([w]x s) v`.
//!
//! The axis passes through `p_0 + w x v / |w|^2`, at the distance `|v_n| / |w|` from the centre of mass, which runs
//! along a helix: a circle when v is perpendicular to w (a turntable), a line when it is parallel (a bullet), and a
//! line too when w is zero. Unlike [`ConstantVelocity`](super::ConstantVelocity), where v stays the same in world axes,
//! v stays the same in body axes here.
//!
//! Failure: at times so far away that a product overflows the pose is not finite, which its users report.

use super::error::check_start;
use super::steady_spin::{length, length_bound, turned};
use super::{Motion, MotionBounds, MotionError};
use crate::rounding;
use crate::{Pose, Rotation, UnitVector, Velocity};
use glam::DVec3;

/// Below this angle (rad) `sin h / h` is replaced by its Taylor series, whose first omitted term is below 1e-27.
const SMALL_ANGLE: f64 = 1e-4;

/// The motion of a body that turns steadily about a fixed axis while it moves steadily along it.
///
/// A box on a turntable about the z axis, 2 m off, half a turn per second:
///
/// ```
/// use polhode_spatial::{ConstantScrew, DVec3, Motion, Pose, Velocity};
/// let (start, spin) = (Pose::from_translation(DVec3::X * 2.0), DVec3::Z * std::f64::consts::PI);
/// let velocity = Velocity::new(spin.cross(start.translation), spin);
/// let turning = ConstantScrew::new(0.0, start, velocity)?;
/// assert!((turning.pose(0.5).translation - DVec3::Y * 2.0).length() < 1e-15);
/// # Ok::<(), polhode_spatial::MotionError>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ConstantScrew {
    t0: f64,
    start: Pose,
    velocity: Velocity,
    /// The part of the linear velocity along the axis, m/s.
    along: DVec3,
    /// `w x v`: the acceleration of the centre of mass at `t0`, m/s^2.
    towards_axis: DVec3,
}

impl ConstantScrew {
    /// The screw that passes `start` (`X_WC`) at `t0` (s) with `velocity`.
    ///
    /// # Errors
    /// When a number is not finite.
    pub fn new(t0: f64, start: Pose, velocity: Velocity) -> Result<Self, MotionError> {
        check_start(t0, &start, &velocity)?;
        let Velocity { linear, angular } = velocity;
        let along = UnitVector::new(angular).map_or(DVec3::ZERO, |axis| axis.get() * axis.get().dot(linear));
        Ok(Self { t0, start, velocity, along, towards_axis: angular.cross(linear) })
    }
}

/// `sin(angle) / angle`, angle in rad.
fn sine_quotient(angle: f64) -> f64 {
    if angle.abs() < SMALL_ANGLE {
        let square = angle * angle;
        1.0 - square / 6.0 + square * square / 120.0
    } else {
        libm::sin(angle) / angle
    }
}

impl Motion for ConstantScrew {
    fn pose(&self, t: f64) -> Pose {
        let s = t - self.t0;
        let half = 0.5 * s * length(self.velocity.angular);
        let quotient = sine_quotient(half);
        let across = (self.velocity.linear - self.along) * (quotient * libm::cos(half));
        let sideways = self.towards_axis * (0.5 * (s * quotient) * (s * quotient));
        let translation = self.start.translation + (self.along + across) * s + sideways;
        Pose::new(turned(self.start.rotation, self.velocity.angular, s), translation)
    }

    fn velocity(&self, t: f64) -> Velocity {
        let turn = turned(Rotation::IDENTITY, self.velocity.angular, t - self.t0);
        Velocity::new(turn.rotate(self.velocity.linear), self.velocity.angular)
    }

    fn bounds(&self, _t0: f64, _t1: f64) -> MotionBounds {
        let (speed, angular_speed) = (length_bound(self.velocity.linear), length_bound(self.velocity.angular));
        MotionBounds {
            speed,
            acceleration: length_bound(self.towards_axis) + rounding::FEW_TERMS * speed * angular_speed,
            angular_speed,
            angular_acceleration: 0.0,
        }
    }
}
