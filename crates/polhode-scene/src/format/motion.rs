//! Prescribed motions of kinematic bodies.

use super::exactly::{Exactly, Vector};
use schemars::JsonSchema;
use serde::Deserialize;

/// How a kinematic body moves: exactly one of the kinds.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum MotionEntry {
    /// Velocity and angular velocity that stay the same.
    Constant(ConstantMotionEntry),
    /// An oscillation about the body's position and orientation.
    Sine(SineMotionEntry),
    /// Samples joined by a curve.
    Table(TableMotionEntry),
}

/// Constant velocity; at least one of the keys.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ConstantMotionEntry {
    /// Velocity of the body's own origin, world, m/s; zero when absent.
    pub velocity: Option<Vector>,
    /// Angular velocity, world, rad/s; zero when absent.
    pub angular_velocity: Option<Vector>,
}

/// With s = sin(2 pi frequency t + phase): the body's own origin is moved by amplitude s, and the body turned about it
/// by the angle s; amplitude, or axis and angle, or all three.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct SineMotionEntry {
    /// Largest displacement of the body's own origin, world, m; zero when absent.
    pub amplitude: Option<Vector>,
    /// Frequency, Hz.
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub frequency: f64,
    /// Phase at t = 0, rad; 0 when absent.
    pub phase: Option<f64>,
    /// Axis that the body turns about, world, of any length.
    pub axis: Option<Vector>,
    /// Largest angle, rad.
    pub angle: Option<f64>,
}

/// Samples: positions, orientations, or both, one for each time. Before the first and after the last one the body
/// stands still.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct TableMotionEntry {
    /// Times, s, that rise.
    #[schemars(length(min = 2))]
    pub times: Vec<f64>,
    /// Positions of the body's own origin, world, m; the body's position when absent.
    #[schemars(length(min = 2))]
    pub positions: Option<Vec<Vector>>,
    /// Orientations as unit quaternions [w, x, y, z]; or rotation_vectors; the body's orientation when both are absent.
    #[schemars(length(min = 2))]
    pub orientations: Option<Vec<Exactly<f64, 4>>>,
    /// Orientations as axis times angle, rad, that change by less than half a turn from sample to sample; or
    /// orientations.
    #[schemars(length(min = 2))]
    pub rotation_vectors: Option<Vec<Vector>>,
    /// What is between the samples; monotone when absent.
    pub interpolation: Option<InterpolationEntry>,
}

/// What is between the samples of a table.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum InterpolationEntry {
    /// A smooth curve of which every coordinate stays between two neighbouring samples.
    Monotone,
    /// The cubic spline, which is more accurate for samples of a smooth motion, and overshoots where samples turn or
    /// stop.
    Spline,
    /// Constant velocity from sample to sample; it jumps at the samples, so that the body may not touch others that
    /// move.
    Linear,
}
