//! What of a scene is uncertain, beside the scene: a run does not know of it, a sweep draws it.
//!
//! A body whose pose is uncertain is moved by a vector `s`, m, and turned by a rotation vector `r`, rad, both along the
//! axes of the world: its origin is at `p + s`, and its rotation is `exp(r) R`. Components of `s` and `r` are normal
//! and independent.

use crate::document::Override;
use glam::DVec3;
use polhode::spatial::{Pose, Rotation};
use std::fmt;

/// What of a scene is uncertain.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub enum Uncertain {
    /// The value of a key.
    Key {
        /// Dotted path of the key.
        key: String,
        /// What its value is drawn from.
        drawn: Distribution,
    },
    /// The poses of bodies at the start.
    Poses {
        /// The bodies.
        bodies: Vec<StartPose>,
        /// Standard deviation of the position along each axis, m.
        position_deviation_m: [f64; 3],
        /// Standard deviation of the angle about each axis, rad.
        rotation_deviation_rad: [f64; 3],
        /// Whether they are drawn alone or alike.
        draw: Draw,
    },
}

/// How the bodies of a group are drawn.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub enum Draw {
    /// Each body alone.
    Each,
    /// All alike.
    Alike,
}

/// What a value is drawn from.
#[derive(Debug, Clone, PartialEq)]
pub enum Distribution {
    /// The normal distribution.
    Normal {
        /// Its mean.
        mean: f64,
        /// Its standard deviation, not negative.
        deviation: f64,
    },
    /// A quantity whose logarithm is normal.
    LogNormal {
        /// Half of the draws lie below it; positive.
        median: f64,
        /// The standard deviation of the natural logarithm, not negative.
        spread: f64,
    },
    /// All values between two are as probable as each other.
    Uniform {
        /// The smallest value.
        low: f64,
        /// The largest value.
        high: f64,
    },
    /// Each of some values, as TOML has them, at least one, is as probable as the others.
    Choice(Vec<String>),
}

impl Distribution {
    /// The middle of the values, as TOML: the median, or the first of a choice.
    pub fn middle(&self) -> String {
        match self {
            Self::Normal { mean: middle, .. } | Self::LogNormal { median: middle, .. } => format!("{middle:?}"),
            Self::Uniform { low, high } => format!("{:?}", low + (high - low) * 0.5),
            Self::Choice(values) => values.first().cloned().unwrap_or_default(),
        }
    }
}

impl fmt::Display for Distribution {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Normal { mean, deviation } => write!(f, "normal({mean}, {deviation})"),
            Self::LogNormal { median, spread } => write!(f, "lognormal({median}, {spread})"),
            Self::Uniform { low, high } => write!(f, "uniform({low}, {high})"),
            Self::Choice(values) => write!(f, "choice({})", values.join(", ")),
        }
    }
}

/// The pose of a body at the start, as its file has it.
#[derive(Debug, Clone, PartialEq)]
pub struct StartPose {
    body: String,
    position_m: DVec3,
    rotation: Rotation,
    form: RotationForm,
}

/// Which key has the rotation of a body.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum RotationForm {
    Quaternion,
    Vector,
}

impl StartPose {
    pub(crate) fn new(body: &str, pose: Pose, form: RotationForm) -> Self {
        Self { body: body.to_owned(), position_m: pose.translation, rotation: pose.rotation, form }
    }

    /// The name of the body.
    pub fn body(&self) -> &str {
        &self.body
    }

    /// The changes that move the body by `shift_m` and turn it by the rotation vector `turn_rad`, both along the axes
    /// of the world; `origin` is what errors name as their place.
    pub fn moved(&self, shift_m: DVec3, turn_rad: DVec3, origin: &str) -> Vec<Override> {
        let body = crate::document::written_key(&self.body);
        let change = |key: &str, values: &[f64]| {
            let values: Vec<String> = values.iter().map(|value| format!("{value:?}")).collect();
            Override::new(origin, format!("bodies.{body}.{key}"), format!("[{}]", values.join(", ")))
        };
        let mut changes = Vec::new();
        if shift_m != DVec3::ZERO {
            changes.push(change("position", &(self.position_m + shift_m).to_array()));
        }
        if turn_rad != DVec3::ZERO {
            let rotation = Rotation::from_rotation_vector(turn_rad) * self.rotation;
            changes.push(match self.form {
                RotationForm::Quaternion => change("orientation", &rotation.to_wxyz()),
                RotationForm::Vector => change("rotation_vector", &rotation.to_rotation_vector().to_array()),
            });
        }
        changes
    }
}
