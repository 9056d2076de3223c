//! Numbers of twice the digits: sums of two f64 (docs/REFERENCES.md, Dekker; Knuth), good to some 1e-31 relative.
//!
//! Only what directions and heights of points need. Written for the check alone, so that it shares nothing with the
//! arithmetic that it checks. Fails by overflow beyond 1e150 in a product, which lengths in metres do not reach.

use glam::DVec3;
use std::ops::{Add, Mul, Sub};

/// Splits an f64 into two halves of 26 digits: `2^27 + 1`.
const SPLITTER: f64 = 134_217_729.0;

/// A number `high + low` with `|low|` at most half a unit in the last place of `high`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Wide {
    high: f64,
    low: f64,
}

impl Wide {
    /// The sum of two numbers, exact.
    fn sum(a: f64, b: f64) -> Self {
        let high = a + b;
        let of_b = high - a;
        Self { high, low: (a - (high - of_b)) + (b - of_b) }
    }

    /// The difference of two numbers, exact.
    pub(super) fn difference(a: f64, b: f64) -> Self {
        Self::sum(a, -b)
    }

    /// The product of two numbers, exact.
    fn product(a: f64, b: f64) -> Self {
        let split = |x: f64| {
            let scaled = SPLITTER * x;
            let head = scaled - (scaled - x);
            (head, x - head)
        };
        let high = a * b;
        let ((a_head, a_tail), (b_head, b_tail)) = (split(a), split(b));
        let low = ((a_head * b_head - high) + a_head * b_tail + a_tail * b_head) + a_tail * b_tail;
        Self { high, low }
    }

    /// The nearest f64.
    pub(super) fn value(self) -> f64 {
        self.high + self.low
    }
}

impl From<f64> for Wide {
    fn from(high: f64) -> Self {
        Self { high, low: 0.0 }
    }
}

impl Add for Wide {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        let (heads, tails) = (Self::sum(self.high, other.high), Self::sum(self.low, other.low));
        let first = Self::sum(heads.high, heads.low + tails.high);
        Self::sum(first.high, first.low + tails.low)
    }
}

impl Sub for Wide {
    type Output = Self;

    fn sub(self, other: Self) -> Self {
        self + Self { high: -other.high, low: -other.low }
    }
}

impl Mul for Wide {
    type Output = Self;

    fn mul(self, other: Self) -> Self {
        let product = Self::product(self.high, other.high);
        Self::sum(product.high, product.low + (self.high * other.low + self.low * other.high))
    }
}

/// The direction of `(b - a) x (d - c)`, each component good to rounding however close to parallel the two are; nothing
/// when they are parallel.
pub(super) fn perpendicular([a, b]: [DVec3; 2], [c, d]: [DVec3; 2]) -> Option<DVec3> {
    let [u, v] = [[a, b], [c, d]]
        .map(|[from, to]| std::array::from_fn::<Wide, 3, _>(|axis| Wide::difference(to[axis], from[axis])));
    let minor = |i: usize, j: usize| (u[i] * v[j] - u[j] * v[i]).value();
    let cross = DVec3::new(minor(1, 2), minor(2, 0), minor(0, 1));
    let largest = cross.abs().max_element();
    // Scaled first, since the square of a small product may vanish.
    (largest > 0.0 && largest.is_finite()).then(|| (cross / largest).normalize())
}

/// `direction . (point - origin)`.
pub(super) fn height(direction: DVec3, point: DVec3, origin: DVec3) -> Wide {
    (0..3).fold(Wide::from(0.0), |sum, axis| {
        sum + Wide::difference(point[axis], origin[axis]) * Wide::from(direction[axis])
    })
}

#[cfg(test)]
mod tests {
    //! Against numbers whose digits are known.
    use super::*;

    #[test]
    fn a_height_that_plain_numbers_lose_is_kept() {
        let point = DVec3::new(1.0 + f64::EPSILON, 1e-20, 0.0);
        let height = height(DVec3::new(1.0, 1.0, 0.0), point, DVec3::X);
        assert_eq!((height - Wide::from(f64::EPSILON)).value(), 1e-20);
    }

    #[test]
    fn lines_a_millionth_of_a_millionth_apart_have_their_perpendicular() {
        let slope = 1e-12;
        let normal = perpendicular([DVec3::ZERO, DVec3::X], [DVec3::ZERO, DVec3::new(1.0, slope, slope)]);
        let expected = DVec3::new(0.0, -1.0, 1.0).normalize();
        assert!(normal.is_some_and(|normal| (normal - expected).length() < 4.0 * f64::EPSILON), "{normal:?}");
        assert_eq!(perpendicular([DVec3::ZERO, DVec3::X], [DVec3::Y, DVec3::new(3.0, 1.0, 0.0)]), None);
    }
}
