//! Friction that depends on the direction of the slip: an ellipse about the grain of a surface.
//!
//! Along the grain of a body (the run of planks, the runners of a sledge) the coefficient of friction is another than
//! across it. With the normal force `f_n` the force of friction lies in the ellipse
//!
//! `(f_1 / mu_1)^2 + (f_2 / mu_2)^2 <= f_n^2`,
//!
//! whose first axis is the direction of the grain, projected on the tangent plane. Source: docs/REFERENCES.md,
//! Michalowski and Mroz 1978. Limits: one grain in a contact, coefficients that do not
//! depend on the speed.

use super::SceneError;
use polhode_spatial::{DVec3, Handedness};

/// Neither coefficient may be more than this many times the other (no unit): the direction of a slip turns towards the
/// axis of the smaller one at a rate that grows with the square of the ratio, and steps must follow it.
const MOST_RATIO: f64 = 1e3;

/// Coefficients of friction along the grain of a surface and across it.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct FrictionEllipse {
    /// Along the grain (no unit).
    pub along: f64,
    /// Across the grain (no unit).
    pub across: f64,
}

impl FrictionEllipse {
    /// The same coefficient in all directions.
    pub const fn circle(coefficient: f64) -> Self {
        Self { along: coefficient, across: coefficient }
    }

    /// The larger coefficient.
    pub fn largest(self) -> f64 {
        self.along.max(self.across)
    }

    /// The default rule for two materials: the geometric mean.
    pub(super) fn combined(self, other: Self) -> Self {
        Self { along: (self.along * other.along).sqrt(), across: (self.across * other.across).sqrt() }
    }

    /// The ellipse with the larger of both coefficients along each axis.
    pub(super) fn including(self, other: Self) -> Self {
        Self { along: self.along.max(other.along), across: self.across.max(other.across) }
    }

    /// Checks that both are finite and positive, and not too different.
    pub(super) fn check(self, material: &str) -> Result<(), SceneError> {
        let Self { along, across } = self;
        let is_usable = |value: f64, other: f64| value > 0.0 && value <= MOST_RATIO * other && value.is_finite();
        if is_usable(along, across) && is_usable(across, along) {
            return Ok(());
        }
        Err(SceneError::FrictionEllipse { material: material.to_owned(), along, across, ratio: MOST_RATIO })
    }
}

/// Whose grain that of a pair is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum GrainOf {
    /// That of the first body.
    First,
    /// That of the second one.
    Second,
    /// Both have one, and no rule for the pair says which counts.
    Both,
}

/// The grain of a surface.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Grain {
    /// Its direction in the frame of the body, unit vector.
    pub(crate) direction: DVec3,
    /// Whose it is. Of a single material always the first one's.
    pub(crate) of: GrainOf,
}

impl Grain {
    /// A grain of one material in this direction (any length).
    pub(super) fn new(material: &str, direction: DVec3) -> Result<Self, SceneError> {
        let unit = direction.is_finite().then(|| direction.try_normalize()).flatten();
        let unusable = || SceneError::GrainDirection { material: material.to_owned(), direction: direction.to_array() };
        Ok(Self { direction: unit.ok_or_else(unusable)?, of: GrainOf::First })
    }

    /// That of a mirrored body.
    pub(super) fn mirrored(self) -> Self {
        Self { direction: Handedness::Mirrored.vector(self.direction), ..self }
    }

    /// The grain of a pair of materials with these grains.
    pub(super) fn of_pair(first: Option<Self>, second: Option<Self>) -> Option<Self> {
        match (first, second) {
            (Some(grain), None) => Some(grain),
            (None, Some(grain)) => Some(Self { of: GrainOf::Second, ..grain }),
            (Some(grain), Some(_)) => Some(Self { of: GrainOf::Both, ..grain }),
            (None, None) => None,
        }
    }
}

/// Friction that a rule for a pair of materials gives.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum GivenFriction {
    /// The same in all directions.
    Circle(f64),
    /// Along and across the grain of the bodies of the first material of the rule, or, without a direction, along and
    /// across the grain that one of the materials has.
    Ellipse(FrictionEllipse, Option<DVec3>),
}

impl GivenFriction {
    /// That of mirrored bodies.
    pub(super) fn mirrored(self) -> Self {
        match self {
            Self::Ellipse(ellipse, Some(grain)) => Self::Ellipse(ellipse, Some(Handedness::Mirrored.vector(grain))),
            Self::Circle(_) | Self::Ellipse(_, None) => self,
        }
    }

    pub(super) fn ellipse(self) -> FrictionEllipse {
        match self {
            Self::Circle(coefficient) => FrictionEllipse::circle(coefficient),
            Self::Ellipse(ellipse, _) => ellipse,
        }
    }
}
