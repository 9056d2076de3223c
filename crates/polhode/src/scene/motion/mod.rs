//! Prescribed motion: the pose and velocity of a kinematic body as functions of time.
//!
//! No force changes such a motion: examples are a shaker, a turntable, a pusher, a lift. Position, velocity and
//! acceleration are those of the body's own origin, in the world; the body turns about that origin. With the initial
//! pose `(R0, p0)` and the time t in s from the start of the run:
//!
//! | kind | pose at t |
//! |---|---|
//! | constant velocity v, w | `p = p0 + v t`, `R = exp(w t) R0`: w is constant in the world |
//! | sine | `p = p0 + A s`, `R = exp(B s) R0` with `s = sin(2 pi f t + phase)` |
//! | table | a curve through samples, as its [`Interpolation`] says ([`MotionTable`]) |
//!
//! The initial pose of a sine is the centre of the oscillation; the pose at t = 0 differs from it by `s = sin(phase)`.
//! Before the first and after the last sample of a table the body stands still.
//!
//! A constant velocity moves the body itself. A conveyor belt, whose surface moves while its shape stays in place, is
//! a body with a [`surface_velocity`](crate::scene::Body::surface_velocity).
//!
//! | module | holds |
//! |---|---|
//! | `displacement` | displacement by a motion, with its time derivatives |
//! | `error` | limits of the numbers, and [`MotionError`] |
//! | `excursion` | [`Excursion`]: where a table leaves the range of its samples |
//! | `interpolation` | [`Interpolation`]: what is between the samples of a table |
//! | `monotone` | rates at the samples of a table with which it stays between them |
//! | `polynomial` | polynomials of degree five, their bounds, and the clamped cubic spline |
//! | `sine` | oscillation |
//! | `table` | [`MotionTable`]: motion through samples |
//! | `turning` | angular velocity and acceleration of a rotation given by its rotation vector |
//!
//! **Limits.** No number, speed or acceleration may exceed [`LARGEST`]. Far from t = 0 the rounding of the time limits
//! the accuracy of the pose: a time of 1e6 s is rounded to 1e-10 s.

mod displacement;
mod error;
mod excursion;
mod interpolation;
mod monotone;
mod polynomial;
mod sine;
mod table;
mod turning;

pub use error::{LARGEST, LARGEST_TURN, MotionError};
pub use excursion::Excursion;
pub use interpolation::Interpolation;
use polhode_spatial::rotation::NORM_TOLERANCE;
use polhode_spatial::rounding;
pub(crate) use table::Departure;
pub use table::{MotionTable, SampledOrientations};

use crate::report::acceleration::Acceleration;
use polhode_spatial::{DVec3, Isometry, Motion, MotionBounds, Pose, Rotation, Velocity};
use sine::Sine;
use std::sync::Arc;
use table::SampledCurve;

/// A prescribed motion, relative to the initial pose of a kinematic body.
#[derive(Debug, Clone, PartialEq)]
pub struct PrescribedMotion(Kind);

#[derive(Debug, Clone, PartialEq)]
enum Kind {
    /// This velocity; the displacement is zero at this time, s.
    Constant(Velocity, f64),
    Sine(Sine),
    Table(Arc<SampledCurve>),
}

impl PrescribedMotion {
    /// A motion with this velocity of the body's own origin and this angular velocity, both constant in the world.
    ///
    /// # Errors
    /// When a component is not finite or exceeds [`LARGEST`].
    pub fn constant_velocity(velocity: Velocity) -> Result<Self, MotionError> {
        error::vector("the velocity", velocity.linear)?;
        error::vector("the angular velocity", velocity.angular)?;
        Ok(Self(Kind::Constant(velocity, 0.0)))
    }

    /// The same from a time (s) on, at which the body has the pose that [`PrescribedMotion::from_pose`] takes.
    ///
    /// # Errors
    /// When a component is not finite or exceeds [`LARGEST`].
    pub(crate) fn steady_from(velocity: Velocity, from_s: f64) -> Result<Self, MotionError> {
        Self::constant_velocity(velocity)?;
        error::number("a time", from_s)?;
        Ok(Self(Kind::Constant(velocity, from_s)))
    }

    /// The motion from `start` at the first time (s) to the pose `end` at the second, where the body then stands still.
    ///
    /// # Errors
    /// When the times do not increase, or a number, a speed or an acceleration is too large.
    pub(crate) fn approach(times_s: [f64; 2], start: &Departure<'_>, end: &Pose) -> Result<Self, MotionError> {
        SampledCurve::approach(times_s, start, end).map(|curve| Self(Kind::Table(Arc::new(curve))))
    }

    /// An oscillation about the initial pose. With `s = sin(2 pi frequency_hz t + phase)` it displaces the body's own
    /// origin by `amplitude s` (m, world) and turns the body about that origin by the rotation vector `rotation s`
    /// (rad, world), where `rotation` is the axis times the largest angle.
    ///
    /// # Errors
    /// When a number is not finite, the frequency is not positive, or a number, the largest speed or the largest
    /// acceleration exceeds [`LARGEST`].
    pub fn sine(amplitude: DVec3, rotation: DVec3, frequency_hz: f64, phase: f64) -> Result<Self, MotionError> {
        Sine::new(amplitude, rotation, frequency_hz, phase).map(|sine| Self(Kind::Sine(sine)))
    }

    /// A motion through samples. Before the first and after the last sample the body stands still.
    ///
    /// # Errors
    /// When there are fewer than two samples, there is not one position or orientation for each time, both are absent,
    /// the times do not increase, the body turns by more than [`LARGEST_TURN`] from one sample to the next, or a
    /// number, a speed or an acceleration is not finite or exceeds [`LARGEST`].
    pub fn table(table: &MotionTable) -> Result<Self, MotionError> {
        SampledCurve::new(table).map(|curve| Self(Kind::Table(Arc::new(curve))))
    }

    /// The motion of a body with this initial pose. Positions and orientations of a table do not depend on it.
    pub fn from_pose(&self, initial: &Pose) -> Trajectory {
        Trajectory { motion: self.clone(), initial: *initial }
    }

    /// The same motion in a space set otherwise, of a body whose initial pose is moved too.
    pub(crate) fn moved(&self, space: &Isometry) -> Self {
        Self(match &self.0 {
            Kind::Constant(velocity, from_s) => Kind::Constant(space.velocity(velocity), *from_s),
            Kind::Sine(sine) => Kind::Sine(sine.moved(space)),
            Kind::Table(curve) => Kind::Table(Arc::new(curve.moved(space))),
        })
    }

    /// The first time on the way from `from` to `to` (s, in either order), strictly between them, at which the motion
    /// is not smooth: a sample of a table, where the third derivatives jump, or the velocities with linear
    /// interpolation. The other motions are smooth.
    pub fn corner_between(&self, from: f64, to: f64) -> Option<f64> {
        match &self.0 {
            Kind::Constant(..) | Kind::Sine(_) => None,
            Kind::Table(curve) => curve.corner_between(from, to),
        }
    }

    /// The first time strictly between `from` and `to` (s, `from < to`) at which the velocity jumps: an inner, first or
    /// last sample of a table with linear interpolation.
    pub fn jump_between(&self, from: f64, to: f64) -> Option<f64> {
        match &self.0 {
            Kind::Constant(..) | Kind::Sine(_) => None,
            Kind::Table(curve) => curve.jump_between(from, to),
        }
    }

    /// What is between the samples of a table.
    pub(crate) fn interpolation(&self) -> Option<Interpolation> {
        match &self.0 {
            Kind::Constant(..) | Kind::Sine(_) => None,
            Kind::Table(curve) => Some(curve.interpolation()),
        }
    }

    /// Where a table leaves the range of two neighbouring samples the farthest; only a spline does.
    pub fn excursion(&self) -> Option<Excursion> {
        match &self.0 {
            Kind::Constant(..) | Kind::Sine(_) => None,
            Kind::Table(curve) => curve.excursion(),
        }
    }

    /// The initial pose of a body that is given the pose `given`: positions and orientations of a table at t = 0
    /// replace it.
    pub fn initial_pose(&self, given: &Pose) -> Pose {
        match &self.0 {
            Kind::Constant(..) | Kind::Sine(_) => *given,
            Kind::Table(_) => self.from_pose(given).pose(0.0),
        }
    }

    /// Checks that the initial pose given for a body is that of the table at t = 0.
    ///
    /// # Errors
    /// When it is not.
    pub fn check_start(&self, given: &Pose) -> Result<(), MotionError> {
        let start = self.initial_pose(given);
        let difference = (start.translation - given.translation).length();
        let size = start.translation.abs().max(given.translation.abs()).max_element();
        if difference > NORM_TOLERANCE * size || difference.is_nan() {
            let needed = start.translation.to_array().to_vec();
            return Err(MotionError::Start { quantity: "position", difference, unit: "m", needed });
        }
        let difference = start.rotation.angle_to(given.rotation);
        if difference > NORM_TOLERANCE || difference.is_nan() {
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
    /// The prescribed motion.
    pub const fn motion(&self) -> &PrescribedMotion {
        &self.motion
    }

    /// Acceleration of the body's own origin (m/s^2) and angular acceleration (rad/s^2) at `t` (s), world.
    pub fn acceleration(&self, t: f64) -> Acceleration {
        match &self.motion.0 {
            Kind::Constant(..) => Acceleration { linear: DVec3::ZERO, angular: DVec3::ZERO },
            Kind::Sine(sine) => sine.at(t).acceleration(),
            Kind::Table(curve) => curve.at(t).acceleration(),
        }
    }

    /// As [`PrescribedMotion::corner_between`].
    pub fn corner_between(&self, from: f64, to: f64) -> Option<f64> {
        self.motion.corner_between(from, to)
    }

    /// The initial pose, displaced and then turned about its origin.
    fn moved(&self, translation: DVec3, rotation: Rotation) -> Pose {
        Pose::new(rotation * self.initial.rotation, self.initial.translation + translation)
    }
}

impl Motion for Trajectory {
    fn pose(&self, t: f64) -> Pose {
        match &self.motion.0 {
            Kind::Constant(velocity, from_s) => {
                let t = t - from_s;
                self.moved(velocity.linear * t, Rotation::from_rotation_vector(velocity.angular * t))
            }
            Kind::Sine(sine) => {
                let at = sine.at(t);
                self.moved(at.translation, at.rotation)
            }
            Kind::Table(curve) => {
                let at = curve.at(t);
                let (positions, orientations) = curve.gives();
                Pose {
                    translation: if positions { at.translation } else { self.initial.translation },
                    rotation: if orientations { at.rotation } else { self.initial.rotation },
                }
            }
        }
    }

    fn velocity(&self, t: f64) -> Velocity {
        match &self.motion.0 {
            Kind::Constant(velocity, _) => *velocity,
            Kind::Sine(sine) => sine.at(t).rate(),
            Kind::Table(curve) => curve.at(t).rate(),
        }
    }

    fn bounds(&self, t0: f64, t1: f64) -> MotionBounds {
        match &self.motion.0 {
            Kind::Constant(velocity, _) => MotionBounds {
                speed: velocity.linear.length() * (1.0 + rounding::DOZEN_TERMS),
                angular_speed: velocity.angular.length() * (1.0 + rounding::DOZEN_TERMS),
                ..MotionBounds::default()
            },
            Kind::Sine(sine) => sine.bounds(t0, t1),
            Kind::Table(curve) => curve.bounds(t0, t1),
        }
    }
}
