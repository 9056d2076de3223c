//! Numbers `m 2^e` with a whole `m` of any length: sums and products of numbers of f64 without rounding.

use glam::DVec3;
use num_bigint::{BigInt, Sign};
use num_traits::ToPrimitive;
use std::cmp::Ordering;
use std::ops::{Add, Mul, Neg, Sub};

/// Bits of the fraction of an f64.
const FRACTION_BITS: u32 = 52;
/// Exponent of the last bit of a subnormal f64.
const LEAST_EXPONENT: i64 = -1074;

/// `m 2^e`.
#[derive(Debug, Clone, PartialEq)]
pub struct Dyadic {
    m: BigInt,
    e: i64,
}

impl From<f64> for Dyadic {
    /// Exactly; zero for what is not finite, which no caller passes.
    fn from(value: f64) -> Self {
        let bits = value.to_bits();
        let exponent = (bits >> FRACTION_BITS & 0x7FF) as i64;
        let fraction = (bits & ((1 << FRACTION_BITS) - 1)) as i64;
        if exponent == 0x7FF {
            return Self { m: BigInt::ZERO, e: 0 };
        }
        let (m, e) = if exponent == 0 {
            (fraction, LEAST_EXPONENT)
        } else {
            (fraction | 1 << FRACTION_BITS, LEAST_EXPONENT + exponent - 1)
        };
        let zeros = if m == 0 { 0 } else { m.trailing_zeros() };
        let m = BigInt::from(if value.is_sign_negative() { -(m >> zeros) } else { m >> zeros });
        Self { m, e: e + i64::from(zeros) }
    }
}

impl Dyadic {
    /// -1, 0 or 1.
    pub fn signum(&self) -> i32 {
        match self.m.sign() {
            Sign::Minus => -1,
            Sign::NoSign => 0,
            Sign::Plus => 1,
        }
    }

    /// The number times itself.
    pub fn square(&self) -> Self {
        self * self
    }

    /// Order of `self` and `other`.
    pub fn compare(&self, other: &Self) -> Ordering {
        (self - other).signum().cmp(&0)
    }

    /// `floor(self 2^places)`.
    fn scaled(&self, places: u32) -> BigInt {
        let shift = self.e + i64::from(places);
        if shift >= 0 { &self.m << shift } else { &self.m >> -shift }
    }

    /// `sign(self) |self| / sqrt(square)` less `measured`, rounded once at the end.
    pub fn over_root_less(&self, square: &Self, measured: f64) -> f64 {
        /// Binary places of the root: 1e-48, far below an ulp of any separation.
        const PLACES: u32 = 160;
        let (top, bottom) = (self.square(), square);
        // floor(top/bottom 4^PLACES), with both brought to whole numbers.
        let shift = top.e - bottom.e + 2 * i64::from(PLACES);
        let quotient = if shift >= 0 { (&top.m << shift) / &bottom.m } else { &top.m / (&bottom.m << -shift) };
        let root = quotient.sqrt() * self.signum();
        let difference = root - Self::from(measured).scaled(PLACES);
        difference.to_f64().unwrap_or(f64::NAN) * libm::ldexp(1.0, -(PLACES as i32))
    }
}

impl Add for &Dyadic {
    type Output = Dyadic;
    fn add(self, other: Self) -> Dyadic {
        let e = self.e.min(other.e);
        Dyadic { m: (&self.m << (self.e - e)) + (&other.m << (other.e - e)), e }
    }
}

impl Sub for &Dyadic {
    type Output = Dyadic;
    fn sub(self, other: Self) -> Dyadic {
        let e = self.e.min(other.e);
        Dyadic { m: (&self.m << (self.e - e)) - (&other.m << (other.e - e)), e }
    }
}

impl Mul for &Dyadic {
    type Output = Dyadic;
    fn mul(self, other: Self) -> Dyadic {
        Dyadic { m: &self.m * &other.m, e: self.e + other.e }
    }
}

impl Neg for &Dyadic {
    type Output = Dyadic;
    fn neg(self) -> Dyadic {
        Dyadic { m: -&self.m, e: self.e }
    }
}

/// A vector of exact numbers.
#[derive(Debug, Clone, PartialEq)]
pub struct ExactVector(pub [Dyadic; 3]);

impl From<DVec3> for ExactVector {
    fn from(v: DVec3) -> Self {
        Self(v.to_array().map(Dyadic::from))
    }
}

impl ExactVector {
    /// The inner product.
    pub fn dot(&self, other: &Self) -> Dyadic {
        let ([a, b, c], [x, y, z]) = (&self.0, &other.0);
        &(&(a * x) + &(b * y)) + &(c * z)
    }

    /// The cross product.
    pub fn cross(&self, other: &Self) -> Self {
        let ([a, b, c], [x, y, z]) = (&self.0, &other.0);
        Self([&(b * z) - &(c * y), &(c * x) - &(a * z), &(a * y) - &(b * x)])
    }

    /// The vector times a number.
    pub fn scaled(&self, by: &Dyadic) -> Self {
        Self([&self.0[0] * by, &self.0[1] * by, &self.0[2] * by])
    }

    /// Whether all components are zero.
    pub fn is_zero(&self) -> bool {
        self.0.iter().all(|c| c.signum() == 0)
    }
}

impl Add for &ExactVector {
    type Output = ExactVector;
    fn add(self, other: Self) -> ExactVector {
        ExactVector([&self.0[0] + &other.0[0], &self.0[1] + &other.0[1], &self.0[2] + &other.0[2]])
    }
}

impl Sub for &ExactVector {
    type Output = ExactVector;
    fn sub(self, other: Self) -> ExactVector {
        ExactVector([&self.0[0] - &other.0[0], &self.0[1] - &other.0[1], &self.0[2] - &other.0[2]])
    }
}

impl Neg for &ExactVector {
    type Output = ExactVector;
    fn neg(self) -> ExactVector {
        ExactVector([-&self.0[0], -&self.0[1], -&self.0[2]])
    }
}

#[cfg(test)]
mod tests {
    //! Sums and products do not round, and a root is right to the last bit.
    use super::*;

    #[test]
    fn sums_of_numbers_far_apart_do_not_round() {
        let (large, small) = (Dyadic::from(1e300), Dyadic::from(-5e-324));
        assert_eq!((&(&large + &small) - &large).compare(&small), Ordering::Equal);
        assert_eq!((&Dyadic::from(0.1) * &Dyadic::from(3.0)).compare(&Dyadic::from(0.1 * 3.0)), Ordering::Less);
    }

    #[test]
    fn roots_are_right_to_the_last_bit() {
        // -3/sqrt(2) and its rounded value differ by less than half an ulp, and not by nothing.
        let error = Dyadic::from(-3.0).over_root_less(&Dyadic::from(2.0), -3.0 / 2.0_f64.sqrt());
        assert!(error != 0.0 && error.abs() < 4e-16, "{error}");
        assert_eq!(Dyadic::from(6.0).over_root_less(&Dyadic::from(4.0), 3.0), 0.0);
    }
}
