//! What acts along a freedom of a joint: limits, each of them a stop that bodies meet as they meet each other.

use thiserror::Error;

/// A coordinate along which a joint leaves its bodies free.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
#[non_exhaustive]
pub enum Coordinate {
    /// The angle of the body about the axis, relative to the other body or the world, rad; zero at the start.
    Angle,
    /// The displacement of the body along the axis, m; zero at the start.
    Displacement,
    /// The distance of the two anchors, m.
    Distance,
}

impl Coordinate {
    /// Its name in scene files.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Angle => "angle",
            Self::Displacement => "displacement",
            Self::Distance => "distance",
        }
    }

    /// Its unit.
    pub const fn unit(self) -> &'static str {
        match self {
            Self::Angle => "rad",
            Self::Displacement | Self::Distance => "m",
        }
    }
}

/// Why limits are refused. Each message names the value and what is accepted.
#[derive(Debug, Clone, Copy, PartialEq, Error)]
#[non_exhaustive]
pub enum LimitsError {
    /// The lower limit is not below the upper one, or one of them is NaN.
    #[error("limits from {lower} to {upper} are not accepted: two numbers are needed, the lower one first")]
    Order {
        /// The lower limit.
        lower: f64,
        /// The upper limit.
        upper: f64,
    },
    /// The restitution of the stops is out of range.
    #[error("restitution of limits is {0}: a number from 0 to 1 is needed")]
    Restitution(f64),
}

/// The range of a coordinate, between two stops.
///
/// ```
/// use polhode::scene::Limits;
/// let limits = Limits::new(-0.5, 0.5)?.with_restitution(0.2)?;
/// assert_eq!((limits.lower(), limits.upper(), limits.restitution()), (-0.5, 0.5, 0.2));
/// # Ok::<(), polhode::scene::LimitsError>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Limits {
    lower: f64,
    upper: f64,
    restitution: f64,
}

impl Limits {
    /// From `lower` to `upper` (rad of an angle, m otherwise). An infinite number means no stop on that side.
    ///
    /// # Errors
    /// When the lower one is not below the upper one.
    pub fn new(lower: f64, upper: f64) -> Result<Self, LimitsError> {
        if lower < upper {
            Ok(Self { lower, upper, restitution: 0.0 })
        } else {
            Err(LimitsError::Order { lower, upper })
        }
    }

    /// The same limits with this coefficient of restitution: 0, the default, stops the bodies.
    ///
    /// # Errors
    /// When it is not from 0 to 1.
    pub fn with_restitution(self, restitution: f64) -> Result<Self, LimitsError> {
        if (0.0..=1.0).contains(&restitution) {
            Ok(Self { restitution, ..self })
        } else {
            Err(LimitsError::Restitution(restitution))
        }
    }

    /// The lower limit, rad or m.
    pub const fn lower(&self) -> f64 {
        self.lower
    }

    /// The upper limit, rad or m.
    pub const fn upper(&self) -> f64 {
        self.upper
    }

    /// Coefficient of restitution of its stops.
    pub const fn restitution(&self) -> f64 {
        self.restitution
    }
}
