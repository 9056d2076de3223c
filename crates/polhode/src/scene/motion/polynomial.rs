//! Polynomials of degree five with vector coefficients, bounds of their derivatives over an interval, and the clamped
//! cubic spline.
//!
//! About the middle m of an interval of half width r, `y = sum c_k s^k` with `|s| <= r`; then
//! `|y'| <= sum k |c_k| r^(k-1)` and `|y''| <= sum k (k-1) |c_k| r^(k-2)`. The bounds shrink to the true values as the
//! interval does.

use polhode_spatial::DVec3;

/// Coefficients of a polynomial of degree five.
const COEFFICIENTS: usize = 6;

/// Bound on the rounding error of a coefficient after a shift of the argument, and of the evaluation, relative to the
/// sum of all coefficients. The shift takes fifteen additions of numbers that grow by at most 2^5, the evaluation as
/// many: the error is below 2^5 * 2^5 * 2^-53, taken with a margin of two.
const DERIVATIVE_ROUNDING: f64 = 1.0 / (1u64 << 42) as f64;

/// `sum c_k x^k`, for x from 0 to 1.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Quintic([DVec3; COEFFICIENTS]);

/// A value with its first two derivatives.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Jet {
    pub(super) value: DVec3,
    pub(super) first: DVec3,
    pub(super) second: DVec3,
}

/// Bounds of a polynomial's derivatives over an interval.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Rates {
    /// Of `|y'|`.
    pub(super) first: f64,
    /// Of `|y''|`.
    pub(super) second: f64,
    /// Of `|y x y'|`.
    pub(super) aside: f64,
}

impl Quintic {
    /// The polynomial with value zero and these derivatives at x = 0, and the value and derivatives `end` at x = 1.
    pub(super) fn between(first: DVec3, second: DVec3, end: &Jet) -> Self {
        let (y, u0, a0, u1, a1) = (end.value, first, second, end.first, end.second);
        Self([
            DVec3::ZERO,
            u0,
            a0 * 0.5,
            y * 10.0 - u0 * 6.0 - u1 * 4.0 - a0 * 1.5 + a1 * 0.5,
            -y * 15.0 + u0 * 8.0 + u1 * 7.0 + a0 * 1.5 - a1,
            y * 6.0 - (u0 + u1) * 3.0 + (a1 - a0) * 0.5,
        ])
    }

    /// The straight line from zero to `end` at x = 1.
    pub(super) fn line(end: DVec3) -> Self {
        let mut coefficients = [DVec3::ZERO; COEFFICIENTS];
        coefficients[1] = end;
        Self(coefficients)
    }

    /// With every coefficient mapped, by a linear map.
    pub(super) fn mapped(&self, map: impl Fn(DVec3) -> DVec3) -> Self {
        Self(self.0.map(map))
    }

    /// The places from 0 to 1, ends included, at which a coordinate (0 to 2) may be largest or smallest.
    pub(super) fn extremes(&self, axis: usize) -> Vec<f64> {
        let derivative: Vec<f64> = (1..COEFFICIENTS).map(|k| k as f64 * self.0[k][axis]).collect();
        let mut places = vec![0.0];
        places.extend(sign_changes(&derivative));
        places.push(1.0);
        places
    }

    /// Bound of the rounding error of a value.
    pub(super) fn rounding(&self) -> f64 {
        DERIVATIVE_ROUNDING * self.0.iter().map(|c| c.length()).sum::<f64>()
    }

    /// Value and derivatives at `x`.
    pub(super) fn at(&self, x: f64) -> Jet {
        let mut jet = Jet { value: DVec3::ZERO, first: DVec3::ZERO, second: DVec3::ZERO };
        for &c in self.0.iter().rev() {
            jet.second = jet.second * x + jet.first * 2.0;
            jet.first = jet.first * x + jet.value;
            jet.value = jet.value * x + c;
        }
        jet
    }

    /// Bounds over `[x0, x1]`, which lies in `[0, 1]` but for rounding.
    pub(super) fn rates(&self, x0: f64, x1: f64) -> Rates {
        let (middle, radius) = (0.5 * (x0 + x1), 0.5 * (x1 - x0).abs() + DERIVATIVE_ROUNDING);
        let c = self.about(middle);
        let path: f64 = self.0.iter().map(|c| c.length()).sum();
        let slack = DERIVATIVE_ROUNDING * path;
        let sizes = c.map(DVec3::length);
        let first = (1..COEFFICIENTS).rev().fold(0.0, |sum, k| sum * radius + k as f64 * sizes[k]);
        let second = (2..COEFFICIENTS).rev().fold(0.0, |sum, k| sum * radius + (k * (k - 1)) as f64 * sizes[k]);
        // Coefficients of y x y', in which parallel parts cancel.
        let mut aside = [DVec3::ZERO; 2 * COEFFICIENTS - 2];
        for (i, a) in c.iter().enumerate() {
            for (k, b) in c.iter().enumerate().skip(1) {
                aside[i + k - 1] += a.cross(*b) * k as f64;
            }
        }
        let aside = aside.iter().rev().fold(0.0, |sum, c| sum * radius + c.length());
        Rates { first: first + slack, second: second + slack, aside: aside + slack * path }
    }

    /// Coefficients in powers of `x - m`.
    fn about(&self, m: f64) -> [DVec3; COEFFICIENTS] {
        let mut c = self.0;
        for low in 0..COEFFICIENTS - 1 {
            for k in (low..COEFFICIENTS - 1).rev() {
                let above = c[k + 1];
                c[k] += above * m;
            }
        }
        c
    }
}

/// Where the polynomial `sum c_k x^k` changes its sign between 0 and 1, ascending. Between the places where its
/// derivative does, it changes its sign at most once, and bisection finds where.
fn sign_changes(c: &[f64]) -> Vec<f64> {
    if c.len() < 2 {
        return Vec::new();
    }
    let derivative: Vec<f64> = c.iter().enumerate().skip(1).map(|(k, c)| k as f64 * c).collect();
    let value = |x: f64| c.iter().rev().fold(0.0, |sum, c| sum * x + c);
    let mut places = vec![0.0];
    places.extend(sign_changes(&derivative));
    places.push(1.0);
    let crosses = |pair: &&[f64]| (value(pair[0]) < 0.0) != (value(pair[1]) < 0.0);
    places.windows(2).filter(crosses).map(|pair| bisected(&value, pair[0], pair[1])).collect()
}

/// Where a function changes its sign between `low` and `high`.
fn bisected(value: &impl Fn(f64) -> f64, mut low: f64, mut high: f64) -> f64 {
    let is_negative = value(low) < 0.0;
    loop {
        let middle = 0.5 * (low + high);
        // Neighbouring numbers have no middle of their own.
        if middle <= low || middle >= high {
            return middle;
        }
        if (value(middle) < 0.0) == is_negative { low = middle } else { high = middle }
    }
}

/// Rates of the clamped cubic spline through values whose differences are `steps`, and their rates: of each knot
/// `(y', y'')`, with `y' = 0` at both ends, and `y''` set to zero there. `spacings` and `steps` are of one length, at
/// least one.
///
/// `l m_(k-1) + 2 m_k + (1 - l) m_(k+1) = 3 (l s_(k-1) + (1 - l) s_k)` with `l = h_k/(h_(k-1) + h_k)` and the slopes
/// `s_k = step_k/h_k`; the matrix is dominated by its diagonal, and elimination needs no pivots. Source:
/// docs/REFERENCES.md, de Boor 1978, chapter IV.
pub(super) fn knot_rates(spacings: &[f64], steps: &[DVec3]) -> Vec<(DVec3, DVec3)> {
    let slopes: Vec<DVec3> = spacings.iter().zip(steps).map(|(&h, &step)| step / h).collect();
    let count = slopes.len();
    let mut above = vec![0.0; count + 1];
    let mut rates = vec![DVec3::ZERO; count + 1];
    for k in 1..count {
        let before = spacings[k] / (spacings[k - 1] + spacings[k]);
        let after = 1.0 - before;
        let pivot = 2.0 - before * above[k - 1];
        above[k] = after / pivot;
        rates[k] = ((slopes[k - 1] * before + slopes[k] * after) * 3.0 - rates[k - 1] * before) / pivot;
    }
    for k in (1..count).rev() {
        let next = rates[k + 1];
        rates[k] -= next * above[k];
    }
    let second = |k: usize| {
        if k == 0 || k == count {
            return DVec3::ZERO;
        }
        (slopes[k] * 3.0 - rates[k] * 2.0 - rates[k + 1]) * (2.0 / spacings[k])
    };
    (0..=count).map(|k| (rates[k], second(k))).collect()
}
