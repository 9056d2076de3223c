//! Lower bounds of functions of time by parabolas that open downwards, and how long these bounds stay positive.
//!
//! A function with value `a`, rate `b` and `|f''| <= c` satisfies `f(t + s) >= a + b s - c s^2/2`. Sums and minima of
//! such bounds are concave. A bound that is positive at both ends of an interval is therefore positive on all of it.

use polhode_spatial::rounding;

/// `value + rate s - curvature s^2/2`.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(crate) struct Quadratic {
    pub(crate) value: f64,
    pub(crate) rate: f64,
    /// Bound of the magnitude of the second derivative, not negative.
    pub(crate) curvature: f64,
}

impl Quadratic {
    pub(crate) const ZERO: Self = Self { value: 0.0, rate: 0.0, curvature: 0.0 };

    fn at(self, s: f64) -> f64 {
        self.value + s * (self.rate - 0.5 * self.curvature * s)
    }

    /// A bound of the sum.
    pub(crate) fn plus(self, other: Self) -> Self {
        Self {
            value: self.value + other.value,
            rate: self.rate + other.rate,
            curvature: self.curvature + other.curvature,
        }
    }

    /// A bound of a multiple; `factor` is not negative.
    pub(crate) fn times(self, factor: f64) -> Self {
        Self { value: factor * self.value, rate: factor * self.rate, curvature: factor * self.curvature }
    }

    /// Whether its computation has not overflowed; an infinite bound is no bound.
    fn is_finite(&self) -> bool {
        (self.value.abs() + self.rate.abs() + self.curvature).is_finite()
    }

    /// The positive root when the value at zero is positive, infinite when there is none; 0 for other values at zero.
    pub(crate) fn first_root(self) -> f64 {
        if self.value.is_nan() || self.value <= 0.0 {
            return 0.0;
        }
        let root = (self.rate * self.rate + 2.0 * self.curvature * self.value).sqrt();
        if self.rate < 0.0 {
            2.0 * self.value / (root - self.rate)
        } else if self.curvature > 0.0 {
            (self.rate + root) / self.curvature
        } else {
            f64::INFINITY
        }
    }
}

/// How long `L(s) = base + min(first) + min(second)` stays positive, at most `window`; an empty list adds nothing.
///
/// The root is approached from the right. The sum of the parabolas that are least at `s` is an upper bound of `L`, so
/// that its root is not before that of `L`; it is the root of `L` when the same parabolas are least there. Before its
/// root a sum is positive, so that each pair of parabolas decides once at most, and the rounds end.
pub(crate) fn positive_until(base: Quadratic, first: &[Quadratic], second: &[Quadratic], window: f64) -> f64 {
    let at = |s: f64| base.plus(least_at(first, s)).plus(least_at(second, s));
    if ![first, second].into_iter().flatten().chain([&base]).all(Quadratic::is_finite) {
        return 0.0;
    }
    // A negative value at the start means that the hulls overlap now: the axis separates them for no time at all.
    if at(0.0).value <= 0.0 {
        return 0.0;
    }
    let mut s = window;
    let mut previous = f64::INFINITY;
    loop {
        let deciding = at(s);
        if deciding.at(s) >= 0.0 || s >= previous {
            return if s < window { s * (1.0 - rounding::FEW_TERMS) } else { window };
        }
        previous = s;
        s = deciding.first_root().min(s);
    }
}

fn least_at(parabolas: &[Quadratic], s: f64) -> Quadratic {
    let mut least = (f64::INFINITY, Quadratic::ZERO);
    for &parabola in parabolas {
        let value = parabola.at(s);
        if value < least.0 {
            least = (value, parabola);
        }
    }
    least.1
}
