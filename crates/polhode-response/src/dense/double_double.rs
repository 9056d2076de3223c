//! Numbers of twice the working precision, without fused multiply-add.
//!
//! A number is an unevaluated sum `high + low`. Source: Dekker 1971 (splitting, product, quotient, square root), Knuth's
//! two-sum; Hida, Li and Bailey 2001. Errors are below 1e-31 of the terms. Assumption: magnitudes from 1e-260 to 1e292;
//! beyond it the splitting overflows and the result is not finite, below it the low part is lost.

use crate::dense::scalar::Scalar;
use std::ops::{Add, Div, Mul, Neg, Sub};

/// `high + low` with `|low| <= ulp(high) / 2`.
#[derive(Debug, Clone, Copy, Default, PartialEq, PartialOrd)]
pub(crate) struct DoubleDouble {
    high: f64,
    low: f64,
}

impl DoubleDouble {
    /// A working-precision number.
    pub(crate) const fn new(value: f64) -> Self {
        Self { high: value, low: 0.0 }
    }

    /// Rounded to working precision.
    pub(crate) fn value(self) -> f64 {
        self.high + self.low
    }

    /// `self + a b`.
    pub(crate) fn plus_product(self, a: f64, b: f64) -> Self {
        let (product, error) = two_product(a, b);
        self.plus(product, error)
    }

    /// `self + a b` for a `b` of twice the precision.
    pub(crate) fn plus_long_product(self, a: f64, b: Self) -> Self {
        let (product, error) = two_product(a, b.high);
        self.plus(product, error + a * b.low)
    }

    fn plus(self, high: f64, low: f64) -> Self {
        let (sum, error) = two_sum(self.high, high);
        Self::normalized(sum, error + (self.low + low))
    }

    /// The sum of a number and one that is small against it.
    fn normalized(large: f64, small: f64) -> Self {
        let high = large + small;
        Self { high, low: small - (high - large) }
    }
}

impl Add for DoubleDouble {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        self.plus(other.high, other.low)
    }
}

impl Sub for DoubleDouble {
    type Output = Self;

    fn sub(self, other: Self) -> Self {
        self.plus(-other.high, -other.low)
    }
}

impl Neg for DoubleDouble {
    type Output = Self;

    fn neg(self) -> Self {
        Self { high: -self.high, low: -self.low }
    }
}

impl Mul for DoubleDouble {
    type Output = Self;

    fn mul(self, other: Self) -> Self {
        let (product, error) = two_product(self.high, other.high);
        Self::normalized(product, error + (self.high * other.low + self.low * other.high))
    }
}

impl Div for DoubleDouble {
    type Output = Self;

    fn div(self, other: Self) -> Self {
        let quotient = self.high / other.high;
        let rest = self - other * Self::new(quotient);
        Self::normalized(quotient, rest.value() / other.high)
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
        let root = self.high.sqrt();
        if root == 0.0 {
            return Self::new(root);
        }
        let rest = self.plus_product(-root, root);
        Self::normalized(root, 0.5 * rest.value() / root)
    }
}

/// The sum and its rounding error.
fn two_sum(a: f64, b: f64) -> (f64, f64) {
    let sum = a + b;
    let part = sum - a;
    (sum, (a - (sum - part)) + (b - part))
}

/// The product and its rounding error.
fn two_product(a: f64, b: f64) -> (f64, f64) {
    let product = a * b;
    let ((a_high, a_low), (b_high, b_low)) = (split(a), split(b));
    (product, ((a_high * b_high - product) + a_high * b_low + a_low * b_high) + a_low * b_low)
}

/// The upper 26 bits and the rest.
fn split(a: f64) -> (f64, f64) {
    // 2^27 + 1, Veltkamp's constant for 53 bits.
    let scaled = 134_217_729.0 * a;
    let high = scaled - (scaled - a);
    (high, a - high)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// `(1 + 2^-30)^2 - 1 - 2^-29 = 2^-60` is exact, where working precision gives 0.
    #[test]
    fn products_keep_their_rounding_error() {
        let a = 1.0 + 2.0_f64.powi(-30);
        let sum = DoubleDouble::new(-1.0).plus_product(a, a).plus_product(-1.0, 2.0_f64.powi(-29));
        assert_eq!(sum.value(), 2.0_f64.powi(-60));
        let long = DoubleDouble::new(0.0).plus_product(a, a);
        assert_eq!(
            DoubleDouble::new(-2.0).plus_long_product(2.0, long).value(),
            2.0 * (a * a - 1.0 + 2.0_f64.powi(-60))
        );
    }
    /// Quotients and roots, multiplied back, give what they came from to 1e-31.
    #[test]
    fn quotients_and_roots_are_inverse_to_products() {
        let numbers = [3.0, -7.0, 1e-9, 1e12].map(|a| DoubleDouble::new(a) + DoubleDouble::new(1e-17 * a / 3.0));
        for a in numbers {
            for b in numbers {
                let rest = (a / b * b - a).value() / a.value();
                assert!(rest.abs() < 1e-31, "{rest:e}");
            }
            let square = a * a;
            let rest = (square.sqrt() * square.sqrt() - square).value() / square.value();
            assert!(rest.abs() < 1e-31, "{rest:e}");
        }
        assert!(DoubleDouble::new(-1.0).sqrt().value().is_nan());
        assert_eq!(DoubleDouble::new(0.0).sqrt().value(), 0.0);
    }
}
