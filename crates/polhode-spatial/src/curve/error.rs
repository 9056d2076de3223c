//! Why a curve is refused.

use thiserror::Error;

/// Why a curve is refused. Each message names the value and what is accepted.
#[derive(Debug, Clone, Copy, PartialEq, Error)]
#[non_exhaustive]
pub enum CurveError {
    /// A number is not finite.
    #[error("{quantity} of a curve is not finite: finite numbers are needed")]
    NotFinite {
        /// Which number.
        quantity: &'static str,
    },
    /// A length is not positive.
    #[error("{quantity} of a curve is {value}: a finite number above 0 is needed")]
    NotPositive {
        /// Which length.
        quantity: &'static str,
        /// The value found.
        value: f64,
    },
    /// Too few points or parts.
    #[error("a curve has {found} {what}: at least {least} are needed")]
    TooFew {
        /// Of what.
        what: &'static str,
        /// How many there are.
        found: usize,
        /// How many are needed.
        least: usize,
    },
    /// Two points that follow each other are one point.
    #[error("points {first} and {second} of a curve (counted from 0) are at one place: points that differ are needed")]
    Coincident {
        /// The place of the first in the list.
        first: usize,
        /// The place of the second in the list.
        second: usize,
    },
    /// The directions that span its plane are parallel, or one is zero.
    #[error("the directions of a curve are zero or parallel: two directions that differ are needed")]
    Parallel,
    /// The curve stops and turns back.
    #[error("a curve has a cusp {arc_m} m after its start: a curve that never stops is needed")]
    Cusp {
        /// Where, as arc length from the start, m.
        arc_m: f64,
    },
    /// The curve turns too often to be represented.
    #[error("a curve turns too often: at most {most} parts of a quarter of a radian are represented")]
    TooWinding {
        /// Most parts.
        most: usize,
    },
    /// The curve meets itself, so that a point on it has two places.
    #[error(
        "a curve comes within {distance_m} m of itself, {first_m} m and {second_m} m after its start: at least \
         {least_m} m are needed, since a point there would have two places on it; move one part aside"
    )]
    MeetsItself {
        /// The distance, m.
        distance_m: f64,
        /// Arc length of the first place, m.
        first_m: f64,
        /// Arc length of the second place, m.
        second_m: f64,
        /// The least distance, m.
        least_m: f64,
    },
}

pub(super) fn finite(quantity: &'static str, is_finite: bool) -> Result<(), CurveError> {
    if is_finite { Ok(()) } else { Err(CurveError::NotFinite { quantity }) }
}

pub(super) fn positive(quantity: &'static str, value: f64) -> Result<f64, CurveError> {
    if value > 0.0 && value.is_finite() { Ok(value) } else { Err(CurveError::NotPositive { quantity, value }) }
}
