//! Prescribed motions of the coordinates of joints: an angle or a displacement as a function of time.
//!
//! The coordinate follows `q(t) = s(t) - s(0)` exactly, whatever acts on its bodies (of a distance `q` is what it has
//! grown since the start): a row of the joint keeps value, rate and acceleration. The force along it is what the drive
//! has to exert; its work is external work of the ledger. `s` has the kinds of the motions of kinematic bodies
//! ([`crate::scene::motion`]): constant rate, sine, a table. The velocities of the bodies at the start must have the
//! rate `s'(0)`.

use super::motion::{Interpolation, MotionError, MotionTable, PrescribedMotion};
use polhode_spatial::{DVec3, Handedness, Isometry, Motion as _, Pose, Rotation, Velocity};

/// A coordinate of a joint as a function of time.
///
/// ```
/// use polhode::mesh::solid_box;
/// use polhode::prelude::*;
/// use polhode::scene::CoordinateMotion;
/// // A drive swings a door of 0.8 m to and fro by half a radian, once in two seconds.
/// let leaf = solid_box(DVec3::new(0.8, 0.04, 2.0), Mass::new(20.0)?)?;
/// let mut scene = Scene::builder("door");
/// let rate = 0.5 * std::f64::consts::PI;
/// let turning = Velocity::new(DVec3::Y * (0.4 * rate), DVec3::Z * rate);
/// let door = Body::movable("door", leaf).pose(Pose::from_translation(DVec3::X * 0.4)).velocity(turning);
/// let door = scene.add_body(door);
/// let hinge = scene.add_joint(Joint::hinge(door, DVec3::ZERO, UnitVector::Z));
/// let swing = CoordinateMotion::sine(0.5, 0.5, 0.0)?;
/// assert_eq!(swing.rate_at_start(), rate);
/// let scene = scene.coordinate_motion(hinge, Coordinate::Angle, swing).build()?;
/// let mut simulation = Simulation::new(&scene)?;
/// simulation.advance_to(0.5)?;
/// let angle = simulation.coordinate(hinge, Coordinate::Angle).map_or(0.0, |angle| angle.value);
/// assert!((angle - 0.5).abs() < 1e-12);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct CoordinateMotion(PrescribedMotion);

impl CoordinateMotion {
    /// A constant rate, rad/s or m/s.
    ///
    /// # Errors
    /// When it is not finite, or too large ([`crate::scene::motion::LARGEST`]).
    pub fn rate(rate: f64) -> Result<Self, MotionError> {
        PrescribedMotion::constant_velocity(Velocity::new(DVec3::X * rate, DVec3::ZERO)).map(Self)
    }

    /// An oscillation, `amplitude sin(2 pi frequency_hz t + phase)`: the amplitude in rad or m, the phase in rad.
    ///
    /// # Errors
    /// When a number is not finite, the frequency is not positive, or one is too large.
    pub fn sine(amplitude: f64, frequency_hz: f64, phase: f64) -> Result<Self, MotionError> {
        PrescribedMotion::sine(DVec3::X * amplitude, DVec3::ZERO, frequency_hz, phase).map(Self)
    }

    /// Values (rad, m) at these times (s), with a curve between them. Before the first and after the last one the
    /// coordinate stands still. Linear interpolation is refused with the scene: its rates jump.
    ///
    /// # Errors
    /// When there are fewer than two, not one value for each time, the times do not increase, or a number is not finite
    /// or too large.
    pub fn table(times_s: Vec<f64>, values: &[f64], interpolation: Interpolation) -> Result<Self, MotionError> {
        let positions_m = Some(values.iter().map(|value| DVec3::X * *value).collect());
        PrescribedMotion::table(&MotionTable { times_s, positions_m, orientations: None, interpolation }).map(Self)
    }

    /// Its rate at the start, `s'(0)`, rad/s or m/s: what the velocities of the bodies must have then.
    pub fn rate_at_start(&self) -> f64 {
        self.0.from_pose(&self.0.initial_pose(&Pose::IDENTITY)).velocity(0.0).linear.x
    }

    /// The same of the coordinate with the opposite sign.
    pub(crate) fn reversed(&self) -> Self {
        Self(self.0.moved(&Isometry::new(Rotation::IDENTITY, DVec3::ZERO, Handedness::Mirrored)))
    }

    /// The motion of a point along the x axis with the coordinate as its displacement.
    pub(crate) const fn along_x(&self) -> &PrescribedMotion {
        &self.0
    }
}
