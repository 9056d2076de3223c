//! An axis-aligned box.

use glam::DVec3;
use thiserror::Error;

/// Boxes are enlarged by this many epsilons of their largest coordinate, because their bounds are computed with
/// rounding.
pub(crate) const ROUNDING_ULPS: f64 = 16.0;

/// Why a box cannot be made.
#[derive(Debug, Clone, Copy, PartialEq, Error)]
pub enum AabbError {
    /// A coordinate is NaN or a lower bound exceeds its upper bound.
    #[error("bounds {min} to {max}: every lower bound must be a number that does not exceed its upper bound")]
    Invalid {
        /// Lower bounds, m.
        min: DVec3,
        /// Upper bounds, m.
        max: DVec3,
    },
    /// The interval of time is reversed or not finite.
    #[error("the interval of time {t0} s to {t1} s must be finite and in order")]
    Interval {
        /// Start, s.
        t0: f64,
        /// End, s.
        t1: f64,
    },
}

/// An axis-aligned box in the world. Bounds may be infinite (a half-space), never NaN.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Aabb {
    pub(crate) min: DVec3,
    pub(crate) max: DVec3,
}

impl Aabb {
    /// All of space.
    pub const UNBOUNDED: Self = Self { min: DVec3::NEG_INFINITY, max: DVec3::INFINITY };

    /// Contains nothing: the neutral element of [`Self::merged`].
    pub(crate) const EMPTY: Self = Self { min: DVec3::INFINITY, max: DVec3::NEG_INFINITY };

    /// From its lower and upper bounds, m.
    ///
    /// # Errors
    /// When a bound is NaN or the bounds are reversed.
    pub fn new(min: DVec3, max: DVec3) -> Result<Self, AabbError> {
        if min.cmple(max).all() { Ok(Self { min, max }) } else { Err(AabbError::Invalid { min, max }) }
    }

    /// The box of a single point, m.
    pub(crate) const fn of_point(point: DVec3) -> Self {
        Self { min: point, max: point }
    }

    /// The smallest box that contains all points (m); [`Self::EMPTY`] when there are none.
    pub(crate) fn of_points(points: impl IntoIterator<Item = DVec3>) -> Self {
        points.into_iter().fold(Self::EMPTY, |b, p| Self { min: b.min.min(p), max: b.max.max(p) })
    }

    /// Lower bounds, m.
    pub const fn min(&self) -> DVec3 {
        self.min
    }

    /// Upper bounds, m.
    pub const fn max(&self) -> DVec3 {
        self.max
    }

    /// The middle of the box, m.
    pub(crate) fn middle(&self) -> DVec3 {
        0.5 * self.min + 0.5 * self.max
    }

    /// Whether the boxes share a point; touching counts.
    pub fn overlaps(&self, other: &Self) -> bool {
        self.min.cmple(other.max).all() && other.min.cmple(self.max).all()
    }

    /// Whether all of the other box is in this one; touching borders count.
    pub fn encloses(&self, other: &Self) -> bool {
        self.min.cmple(other.min).all() && other.max.cmple(self.max).all()
    }

    /// Whether the point (m) is in the box.
    pub fn contains(&self, point: DVec3) -> bool {
        self.min.cmple(point).all() && point.cmple(self.max).all()
    }

    /// The smallest box that contains both.
    pub fn merged(&self, other: &Self) -> Self {
        Self { min: self.min.min(other.min), max: self.max.max(other.max) }
    }

    /// Whether every bound is finite.
    pub fn is_finite(&self) -> bool {
        self.min.is_finite() && self.max.is_finite()
    }

    /// The box enlarged by a distance on every side, m.
    ///
    /// # Errors
    /// When the distance is NaN, or so negative that nothing is left.
    pub fn inflated(&self, by: f64) -> Result<Self, AabbError> {
        Self::new(self.min - by, self.max + by)
    }

    /// The same for a distance that is not negative, which needs no check.
    pub(crate) fn widened(&self, by: f64) -> Self {
        Self { min: self.min - by, max: self.max + by }
    }

    /// Distance of two boxes, m; zero when they share a point.
    pub(crate) fn distance(&self, other: &Self) -> f64 {
        (other.min - self.max).max(self.min - other.max).max(DVec3::ZERO).length()
    }
}
