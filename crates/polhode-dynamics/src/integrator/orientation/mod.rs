//! Representations of orientation that the classical Runge-Kutta method integrates: those that the thesis weighs (3.3).
//!
//! | file | coordinates | after each step |
//! |---|---|---|
//! | `quaternion.rs` | four numbers | normalised, left alone, or cut to three |
//! | `matrix.rs` | nine numbers | orthogonalised, or left alone |
//! | `euler_angles.rs` | three angles | left alone; singular where the first and the last axis coincide |
//!
//! A representation is a vector space of coordinates with a kinematic equation, `rate(coordinates, w)`. It keeps its
//! own numbers from step to step, the errors it makes included.

pub(crate) mod euler_angles;
pub(crate) mod matrix;
pub(crate) mod quaternion;

use super::one_step::Span;
use super::saved::{NotItsVariables, Reader};
use crate::integrator::IntegrationError;
use glam::{DMat3, DQuat, DVec3};
use polhode_spatial::Rotation;
use std::fmt::Debug;

/// The coordinates of orientation that are integrated.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Orientation {
    /// Four numbers, normalised after each step and where vectors are turned.
    #[default]
    Quaternion,
    /// Four numbers, never normalised: their length drifts, and with it the rate of turning.
    QuaternionUnnormalized,
    /// The three numbers x, y, z of a quaternion with `w >= 0`, as the thesis suggests to store it, w being recovered
    /// as `sqrt(1 - x^2 - y^2 - z^2)` at each step: half the digits are lost near w = 0, half a turn from the axes of
    /// the world.
    QuaternionThreeNumbers,
    /// Nine numbers, brought to the nearest rotation after each step.
    Matrix,
    /// Nine numbers that drift from a rotation.
    MatrixUnorthogonalized,
    /// Three angles about z, x, z of the turning axes; a step fails that comes near the singular attitudes, in which
    /// the z axis of the body lies along that of the world (as in the attitude without rotation).
    EulerAngles,
}

/// The variable that carries the rate of rotation.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum RotationRate {
    /// Angular momentum in world axes, constant in free motion.
    #[default]
    AngularMomentum,
    /// Angular velocity in world axes, by the thesis's equation 9.
    AngularVelocity,
}

/// What turns vectors between body and world.
pub(crate) trait Frame: Copy {
    /// World to body.
    fn to_body(self, vector: DVec3) -> DVec3;
    /// Body to world.
    fn to_world(self, vector: DVec3) -> DVec3;
}

impl Frame for Rotation {
    fn to_body(self, vector: DVec3) -> DVec3 {
        self.inverse_rotate(vector)
    }

    fn to_world(self, vector: DVec3) -> DVec3 {
        self.rotate(vector)
    }
}

/// Coordinates as numbers, to be kept.
pub(crate) trait Stored: Sized {
    /// Writes them.
    fn write(&self, numbers: &mut Vec<f64>);

    /// Reads what [`Stored::write`] has written.
    fn read(numbers: &mut Reader<'_>) -> Result<Self, NotItsVariables>;
}

impl Stored for DQuat {
    fn write(&self, numbers: &mut Vec<f64>) {
        numbers.extend(self.to_array());
    }

    fn read(numbers: &mut Reader<'_>) -> Result<Self, NotItsVariables> {
        numbers.array().map(Self::from_array)
    }
}

impl Stored for DMat3 {
    fn write(&self, numbers: &mut Vec<f64>) {
        numbers.extend(self.to_cols_array());
    }

    fn read(numbers: &mut Reader<'_>) -> Result<Self, NotItsVariables> {
        numbers.array().map(|columns| Self::from_cols_array(&columns))
    }
}

impl Stored for DVec3 {
    fn write(&self, numbers: &mut Vec<f64>) {
        numbers.extend(self.to_array());
    }

    fn read(numbers: &mut Reader<'_>) -> Result<Self, NotItsVariables> {
        numbers.vector()
    }
}

/// A representation of orientation.
pub(crate) trait Representation: Copy + Debug + Send {
    /// The numbers, or their rates.
    type Coordinates: Copy
        + Debug
        + Default
        + Send
        + Stored
        + std::ops::Add<Output = Self::Coordinates>
        + std::ops::Mul<f64, Output = Self::Coordinates>;
    /// What they turn vectors by, errors included.
    type Frame: Frame;

    /// Those of a rotation (`R_WB`).
    fn of(rotation: Rotation) -> Self::Coordinates;

    /// The rotation they stand for: the nearest one.
    fn rotation(coordinates: &Self::Coordinates) -> Rotation;

    /// What turns vectors.
    fn frame(coordinates: &Self::Coordinates) -> Self::Frame;

    /// Their rates for the angular velocity `w` (rad/s, body axes) at a stage.
    fn rate(coordinates: &Self::Coordinates, w: DVec3, span: Span) -> Result<Self::Coordinates, IntegrationError>;

    /// What is kept of them after a step.
    fn settled(coordinates: Self::Coordinates) -> Self::Coordinates {
        coordinates
    }

    /// Whether all are finite.
    fn is_finite(coordinates: &Self::Coordinates) -> bool;
}
