//! Numbers of twice the working precision, without fused multiply-add: the same bits on every platform.
//!
//! A number is an unevaluated sum `high + low`. Source: Dekker 1971 (splitting, product, quotient, square root),
//! Knuth's two-sum; Hida, Li and Bailey 2001. Errors are below 1e-31 of the terms. Assumption: magnitudes from 1e-260
//! to 1e292; beyond it the splitting overflows and the result is not finite, below it the low part is lost.

use std::ops::{Add, Div, Mul, Neg, Sub};

/// A number of twice the working precision: `high + low` with `|low| <= ulp(high) / 2`.
///
/// ```
/// use polhode_spatial::DoubleDouble;
/// // Working precision loses the second term: (1 + 2^-30)^2 - 1 - 2^-29 is 2^-60.
/// let a = 1.0 + 2.0_f64.powi(-30);
/// let rest = DoubleDouble::new(-1.0).plus_product(a, a).plus_product(-1.0, 2.0_f64.powi(-29));
/// assert_eq!(rest.value(), 2.0_f64.powi(-60));
/// ```
#[derive(Debug, Clone, Copy, Default, PartialEq, PartialOrd)]
pub struct DoubleDouble {
    high: f64,
    low: f64,
}

impl DoubleDouble {
    /// A working-precision number.
    #[inline]
    pub const fn new(value: f64) -> Self {
        Self { high: value, low: 0.0 }
    }

    /// Rounded to working precision.
    #[inline]
    pub fn value(self) -> f64 {
        self.high + self.low
    }

    /// `a - b` without error.
    #[inline]
    pub fn difference(a: f64, b: f64) -> Self {
        let (high, low) = two_sum(a, -b);
        Self { high, low }
    }

    /// The product with a number of working precision.
    #[inline]
    pub fn times(self, factor: f64) -> Self {
        let (product, error) = two_product(self.high, factor);
        Self::normalized(product, error + self.low * factor)
    }

    /// The square root; NaN of a negative number.
    #[inline]
    pub fn sqrt(self) -> Self {
        let root = self.high.sqrt();
        if root == 0.0 {
            return Self::new(root);
        }
        let rest = self.plus_product(-root, root);
        Self::normalized(root, 0.5 * rest.value() / root)
    }

    /// `self + a b`.
    #[inline]
    pub fn plus_product(self, a: f64, b: f64) -> Self {
        let (product, error) = two_product(a, b);
        self.plus(product, error)
    }

    /// `self + a b` for a `b` of twice the precision.
    #[inline]
    pub fn plus_long_product(self, a: f64, b: Self) -> Self {
        let (product, error) = two_product(a, b.high);
        self.plus(product, error + a * b.low)
    }

    #[inline]
    fn plus(self, high: f64, low: f64) -> Self {
        let (sum, error) = two_sum(self.high, high);
        Self::normalized(sum, error + (self.low + low))
    }

    /// The sum of a number and one that is small against it.
    #[inline]
    fn normalized(large: f64, small: f64) -> Self {
        let high = large + small;
        Self { high, low: small - (high - large) }
    }
}

impl Add for DoubleDouble {
    type Output = Self;

    #[inline]
    fn add(self, other: Self) -> Self {
        self.plus(other.high, other.low)
    }
}

impl Sub for DoubleDouble {
    type Output = Self;

    #[inline]
    fn sub(self, other: Self) -> Self {
        self.plus(-other.high, -other.low)
    }
}

impl Neg for DoubleDouble {
    type Output = Self;

    #[inline]
    fn neg(self) -> Self {
        Self { high: -self.high, low: -self.low }
    }
}

impl Mul for DoubleDouble {
    type Output = Self;

    #[inline]
    fn mul(self, other: Self) -> Self {
        let (product, error) = two_product(self.high, other.high);
        Self::normalized(product, error + (self.high * other.low + self.low * other.high))
    }
}

impl Div for DoubleDouble {
    type Output = Self;

    #[inline]
    fn div(self, other: Self) -> Self {
        let quotient = self.high / other.high;
        let rest = self - other * Self::new(quotient);
        Self::normalized(quotient, rest.value() / other.high)
    }
}

/// The sum and its rounding error.
#[inline]
fn two_sum(a: f64, b: f64) -> (f64, f64) {
    let sum = a + b;
    let part = sum - a;
    (sum, (a - (sum - part)) + (b - part))
}

/// The product and its rounding error.
#[inline]
fn two_product(a: f64, b: f64) -> (f64, f64) {
    let product = a * b;
    let ((a_high, a_low), (b_high, b_low)) = (split(a), split(b));
    (product, ((a_high * b_high - product) + a_high * b_low + a_low * b_high) + a_low * b_low)
}

/// The upper 26 bits and the rest.
#[inline]
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
