//! The normal of a needle: a face so narrow that rounding of the products in its area would turn the normal.
//!
//! The area `sum (v_i - v_0) x (v_i+1 - v_0)` is summed in twice the precision of f64: differences as exact sums of two
//! numbers (Knuth), products by Dekker's splitting (docs/REFERENCES.md, Dekker 1971). The corners are taken as exact.

use glam::DVec3;
use std::ops::{Add, Mul, Sub};

/// An unevaluated sum of two numbers, the second below the rounding of the first.
#[derive(Debug, Clone, Copy, Default)]
struct Double {
    high: f64,
    low: f64,
}

/// `a + b` exactly.
fn two_sum(a: f64, b: f64) -> Double {
    let high = a + b;
    let of_b = high - a;
    Double { high, low: (a - (high - of_b)) + (b - of_b) }
}

/// Splits a number into two of 26 bits each: `2^27 + 1`.
const SPLITTER: f64 = 134_217_729.0;

fn split(a: f64) -> (f64, f64) {
    let large = SPLITTER * a;
    let high = large - (large - a);
    (high, a - high)
}

/// `a b` exactly.
fn two_product(a: f64, b: f64) -> Double {
    let high = a * b;
    let ((a1, a2), (b1, b2)) = (split(a), split(b));
    Double { high, low: a2 * b2 - (((high - a1 * b1) - a2 * b1) - a1 * b2) }
}

impl Add for Double {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        let sum = two_sum(self.high, other.high);
        two_sum(sum.high, sum.low + (self.low + other.low))
    }
}

impl Sub for Double {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        self + Self { high: -other.high, low: -other.low }
    }
}

impl Mul for Double {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        let product = two_product(self.high, other.high);
        two_sum(product.high, product.low + (self.high * other.low + self.low * other.high))
    }
}

/// The unit normal of a polygon with these corners; NaN when it has no area.
pub(super) fn needle_normal(mut corners: impl Iterator<Item = DVec3>) -> DVec3 {
    let Some(first) = corners.next() else { return DVec3::NAN };
    let from_first = |p: DVec3| [0, 1, 2].map(|i| two_sum(p[i], -first[i]));
    let mut area = [Double::default(); 3];
    let mut before: Option<[Double; 3]> = None;
    for u in corners.map(from_first) {
        if let Some(v) = before.replace(u) {
            for (i, sum) in area.iter_mut().enumerate() {
                let (j, k) = ((i + 1) % 3, (i + 2) % 3);
                *sum = *sum + (v[j] * u[k] - v[k] * u[j]);
            }
        }
    }
    let area = DVec3::from_array(area.map(|sum| sum.high));
    let largest = area.abs().max_element();
    (area / largest).normalize()
}

#[cfg(test)]
mod tests {
    //! A needle's normal is as exact as that of a wide triangle in the same plane: plain products would turn it.

    use super::*;

    #[test]
    fn the_normal_of_a_needle_is_that_of_its_plane() {
        // In the plane x + y + z = 3, with coordinates that are multiples of 2^-40: exact.
        let tiny = (-40.0_f64).exp2();
        let [a, b] = [DVec3::new(0.0, 0.0, 3.0), DVec3::new(2.0, 1.0, 0.0)];
        let beside = 0.5 * (a + b) + tiny * DVec3::new(1.0, -1.0, 0.0);
        let side = DVec3::new(1.0, -1.0, 0.0).dot((b - a).cross(DVec3::ONE)).signum();
        let normal = needle_normal([a, b, beside].into_iter());
        let expected = DVec3::ONE.normalize() * normal.dot(DVec3::ONE).signum();
        assert!((normal - expected).length() < 4.0 * f64::EPSILON, "{normal} for {expected} ({side})");
    }

    #[test]
    fn a_polygon_without_area_has_no_normal() {
        assert!(needle_normal([DVec3::ZERO, DVec3::X, 2.0 * DVec3::X].into_iter()).is_nan());
    }
}
