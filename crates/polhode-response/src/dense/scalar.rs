//! The numbers that the active set calculates with: working precision and twice the working precision.
//!
//! One algorithm serves both. Decisions that only compare magnitudes are taken on [`Scalar::to_f64`].

use polhode_spatial::DoubleDouble;
use std::fmt::Debug;
use std::ops::{Add, Div, Mul, Neg, Sub};

/// A real number of some precision.
pub(crate) trait Scalar:
    Copy
    + Debug
    + Default
    + PartialOrd
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
{
    /// Rounding of a sum of a few dozen terms, relative to the terms (no unit): some 50 rounding units.
    const ROUNDING: f64;

    /// A working-precision number.
    fn from_f64(value: f64) -> Self;

    /// Rounded to working precision.
    fn to_f64(self) -> f64;

    /// Square root; NaN below zero.
    fn sqrt(self) -> Self;

    /// The number, or zero when it is negative or NaN.
    fn or_zero(self) -> Self {
        if self > Self::default() { self } else { Self::default() }
    }
}

impl Scalar for f64 {
    const ROUNDING: Self = 1e-14;

    fn from_f64(value: Self) -> Self {
        value
    }

    fn to_f64(self) -> Self {
        self
    }

    fn sqrt(self) -> Self {
        // The inherent function comes before that of the trait.
        self.sqrt()
    }
}

impl Scalar for DoubleDouble {
    const ROUNDING: f64 = 1e-27;

    fn from_f64(value: f64) -> Self {
        Self::new(value)
    }

    fn to_f64(self) -> f64 {
        self.value()
    }

    fn sqrt(self) -> Self {
        Self::sqrt(self)
    }
}
