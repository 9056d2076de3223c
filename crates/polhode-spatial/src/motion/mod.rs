//! Motions: poses as functions of time, with bounds that hold over an interval.
//!
//! Collision detection takes motions and so needs no dynamics: a free flight, a step of an integrator and a body
//! that stands still all look the same to it. The frame that moves is the body's central frame C: axes of the body,
//! origin at the centre of mass.
//!
//! Motions in closed form, each from its state at a time `t0`; a rotation of a body without torque whose spin is not
//! steady is `Flight` of polhode-dynamics.
//!
//! | motion | centre of mass | rotation |
//! |---|---|---|
//! | [`Still`] | stays | stays |
//! | [`ConstantVelocity`] | along a line, at constant speed | steady |
//! | [`ConstantScrew`] | along a helix: about an axis that is fixed in the world, and along it | steady |
//! | [`SteadyFlight`] | along a parabola: constant acceleration | steady |
//!
//! | module | holds |
//! |---|---|
//! | `error` | why numbers make no motion |
//! | `steady_spin` | what the motions with a constant angular velocity share |

mod constant_screw;
mod constant_velocity;
mod error;
mod steady_flight;
mod steady_spin;

pub use constant_screw::ConstantScrew;
pub use constant_velocity::ConstantVelocity;
pub use error::MotionError;
pub use steady_flight::SteadyFlight;

use crate::{Pose, Velocity};
use glam::DVec3;

/// Upper bounds that hold at every time of an interval.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct MotionBounds {
    /// Speed of the centre of mass, m/s.
    pub speed: f64,
    /// Magnitude of the acceleration of the centre of mass, m/s^2.
    pub acceleration: f64,
    /// Magnitude of the angular velocity, rad/s.
    pub angular_speed: f64,
    /// Magnitude of the angular acceleration, rad/s^2.
    pub angular_acceleration: f64,
}

/// A rigid motion over time.
pub trait Motion {
    /// `X_WC` at time `t` (s).
    fn pose(&self, t: f64) -> Pose;

    /// `p_WCo` at time `t` (s), m: the translation of [`Motion::pose`], to the same bits. A motion whose rotation is
    /// dear to evaluate says it without.
    fn position(&self, t: f64) -> DVec3 {
        self.pose(t).translation
    }

    /// Velocity of the centre of mass and angular velocity at time `t` (s).
    fn velocity(&self, t: f64) -> Velocity;

    /// Bounds that hold for every time in `[t0, t1]`. They may be generous, never too small.
    fn bounds(&self, t0: f64, t1: f64) -> MotionBounds;

    /// What rounding takes from the position of [`Motion::pose`] at time `t` (s), m, world: the centre of mass is at
    /// the sum of both. Nothing where it is not known, as of motions that are interpolated.
    fn residue(&self, _t: f64) -> Option<DVec3> {
        None
    }
}

/// The motion of a body that does not move.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Still(pub Pose);

impl Motion for Still {
    fn pose(&self, _t: f64) -> Pose {
        self.0
    }

    fn velocity(&self, _t: f64) -> Velocity {
        Velocity::ZERO
    }

    fn bounds(&self, _t0: f64, _t1: f64) -> MotionBounds {
        MotionBounds::default()
    }

    fn residue(&self, _t: f64) -> Option<DVec3> {
        Some(DVec3::ZERO)
    }
}
