//! Prescribed motion: the pose and velocity of a kinematic body as functions of time.
//!
//! No force changes such a motion: a shaker, a turntable, a pusher, a lift. Position is that of the body's own origin,
//! which is also the point that it turns about; velocities and accelerations are those of that origin, in the world. With the
//! initial pose `(R0, p0)` and time t in s from the start of the run:
//!
//! | kind | pose at t |
//! |---|---|
//! | constant velocity v, w | `p = p0 + v t`, `R = exp(w t) R0`: w is constant in the world |
//! | sine | `p = p0 + A s`, `R = exp(B s) R0` with `s = sin(2 pi f t + phase)`: the initial pose is the centre of the oscillation, and the pose at t = 0 is the one moved by `sin(phase)` |
//! | table | samples joined by a curve whose velocity and acceleration are continuous ([`MotionTable`]); before the first and after the last sample the body stands still |
//!
//! A constant velocity moves the body itself. A conveyor whose belt runs while its frame stands acts by friction alone:
//! without friction a belt is a fixed body.
//!
//! | module | holds |
//! |---|---|
//! | `displacement` | where a motion has moved a body to |
//! | `error` | what numbers are accepted, and [`MotionError`] |
//! | `polynomial` | polynomials of degree five, their bounds, and the clamped cubic spline |
//! | `sine` | oscillation |
//! | `table` | [`MotionTable`]: motion through samples |
//! | `turning` | angular velocity and acceleration of rotations that are given by rotation vectors |
//!
//! **Limits.** No number, speed or acceleration may exceed [`LARGEST`]. Far from t = 0 the pose is as accurate as the
//! time is a number: a time of 1e6 s is known to 1e-10 s.

mod displacement;
mod error;
mod polynomial;
mod sine;
mod table;
mod turning;

pub use error::{LARGEST, LARGEST_TURN, MotionError};
pub use table::{MotionTable, SampledOrientations};

use crate::acceleration::Acceleration;
use polhode_spatial::{DVec3, Motion, MotionBounds, Pose, Rotation, Velocity};
use sine::Sine;
use std::sync::Arc;
use table::Spline;

/// How far a pose given for the start may be from that of a table at t = 0: in rad, and relative to the largest coordinate.
/// The digits that a file may have lost.
const START_TOLERANCE: f64 = 1e-6;

/// Factor that covers the rounding of a bound's own evaluation: a handful of operations, each good to 1.1e-16 relative.
const ROUNDING: f64 = 1.0 + 16.0 * f64::EPSILON;

/// How a kinematic body moves, from its initial pose.
#[derive(Debug, Clone, PartialEq)]
pub struct PrescribedMotion(Kind);

#[derive(Debug, Clone, PartialEq)]
enum Kind {
    Constant(Velocity),
    Sine(Sine),
    Table(Arc<Spline>),
}

impl PrescribedMotion {
    /// With this velocity of the body's own origin and this angular velocity, both constant in the world.
    ///
    /// # Errors
    /// When a component is not finite or exceeds [`LARGEST`].
    pub fn constant_velocity(velocity: Velocity) -> Result<Self, MotionError> {
        error::vector("the velocity", velocity.linear)?;
        error::vector("the angular velocity", velocity.angular)?;
        Ok(Self(Kind::Constant(velocity)))
    }

    /// An oscillation about the initial pose: with `s = sin(2 pi frequency_hz t + phase)` the body's own origin is moved by
    /// `amplitude s` (m, world) and the body turned about it by the rotation vector `rotation s` (rad, world: axis times
    /// largest angle).
    ///
    /// # Errors
    /// When a number is not finite, the frequency is not positive, or a number, the largest speed or the largest
    /// acceleration exceeds [`LARGEST`].
    pub fn sine(amplitude: DVec3, rotation: DVec3, frequency_hz: f64, phase: f64) -> Result<Self, MotionError> {
        Sine::new(amplitude, rotation, frequency_hz, phase).map(|sine| Self(Kind::Sine(sine)))
    }

    /// A motion through samples, which stands still before the first and after the last one.
    ///
    /// # Errors
    /// When there are fewer than two samples, positions or orientations are not one for each time, both are absent, a
    /// time is not above the one before, the body turns by more than [`LARGEST_TURN`] from one sample to the next, or a
    /// number, a speed or an acceleration is not finite or exceeds [`LARGEST`].
    pub fn table(table: &MotionTable) -> Result<Self, MotionError> {
        Spline::new(table).map(|spline| Self(Kind::Table(Arc::new(spline))))
    }

    /// The motion of a body with this initial pose. What a table gives does not depend on it.
    pub fn from_pose(&self, initial: &Pose) -> Trajectory {
        Trajectory { motion: self.clone(), initial: *initial }
    }

    /// The first time strictly between `from` and `to` (s, in either order), on the way from one to the other, at which the
    /// motion is not smooth: a sample of a table, where its third derivatives jump. The other motions are smooth.
    pub fn corner_between(&self, from: f64, to: f64) -> Option<f64> {
        match &self.0 {
            Kind::Constant(_) | Kind::Sine(_) => None,
            Kind::Table(spline) => spline.corner_between(from, to),
        }
    }

    /// The initial pose of a body for which `given` is asked: what a table gives comes from the table at t = 0.
    pub fn initial_pose(&self, given: &Pose) -> Pose {
        match &self.0 {
            Kind::Constant(_) | Kind::Sine(_) => *given,
            Kind::Table(_) => self.from_pose(given).pose(0.0),
        }
    }

    /// Checks that a pose given for the start is the one that a table has there.
    ///
    /// # Errors
    /// When it is not.
    pub fn check_start(&self, given: &Pose) -> Result<(), MotionError> {
        let start = self.initial_pose(given);
        let difference = (start.translation - given.translation).length();
        let size = start.translation.abs().max(given.translation.abs()).max_element();
        if difference > START_TOLERANCE * size || difference.is_nan() {
            let needed = start.translation.to_array().to_vec();
            return Err(MotionError::Start { quantity: "position", difference, unit: "m", needed });
        }
        let difference = start.rotation.angle_to(given.rotation);
        if difference > START_TOLERANCE || difference.is_nan() {
            let needed = start.rotation.to_wxyz().to_vec();
            return Err(MotionError::Start { quantity: "orientation", difference, unit: "rad", needed });
        }
        Ok(())
    }
}

/// The motion of a kinematic body: poses and velocities of its own origin at any time, with bounds over intervals.
#[derive(Debug, Clone, PartialEq)]
pub struct Trajectory {
    motion: PrescribedMotion,
    initial: Pose,
}

impl Trajectory {
    /// The motion that it follows.
    pub const fn motion(&self) -> &PrescribedMotion {
        &self.motion
    }

    /// Acceleration of the body's own origin (m/s^2) and angular acceleration (rad/s^2) at `t` (s), world.
    pub fn acceleration(&self, t: f64) -> Acceleration {
        match &self.motion.0 {
            Kind::Constant(_) => Acceleration { linear: DVec3::ZERO, angular: DVec3::ZERO },
            Kind::Sine(sine) => sine.at(t).acceleration(),
            Kind::Table(spline) => spline.at(t).acceleration(),
        }
    }

    /// As [`PrescribedMotion::corner_between`].
    pub fn corner_between(&self, from: f64, to: f64) -> Option<f64> {
        self.motion.corner_between(from, to)
    }

    /// The initial pose moved.
    fn moved(&self, translation: DVec3, rotation: Rotation) -> Pose {
        Pose::new(rotation * self.initial.rotation, self.initial.translation + translation)
    }
}

impl Motion for Trajectory {
    fn pose(&self, t: f64) -> Pose {
        match &self.motion.0 {
            Kind::Constant(velocity) => {
                self.moved(velocity.linear * t, Rotation::from_rotation_vector(velocity.angular * t))
            }
            Kind::Sine(sine) => {
                let at = sine.at(t);
                self.moved(at.translation, at.rotation)
            }
            Kind::Table(spline) => {
                let at = spline.at(t);
                let (positions, orientations) = spline.gives();
                Pose {
                    translation: if positions { at.translation } else { self.initial.translation },
                    rotation: if orientations { at.rotation } else { self.initial.rotation },
                }
            }
        }
    }

    fn velocity(&self, t: f64) -> Velocity {
        match &self.motion.0 {
            Kind::Constant(velocity) => *velocity,
            Kind::Sine(sine) => sine.at(t).rate(),
            Kind::Table(spline) => spline.at(t).rate(),
        }
    }

    fn bounds(&self, t0: f64, t1: f64) -> MotionBounds {
        match &self.motion.0 {
            Kind::Constant(velocity) => MotionBounds {
                speed: velocity.linear.length() * ROUNDING,
                angular_speed: velocity.angular.length() * ROUNDING,
                ..MotionBounds::default()
            },
            Kind::Sine(sine) => sine.bounds(t0, t1),
            Kind::Table(spline) => spline.bounds(t0, t1),
        }
    }
}
