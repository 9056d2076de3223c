//! All local minima, over the angle about an axis, of a height function that occurs for circles and cones:
//!
//! `h(t) = p cos t + q sin t - k |m + c cos t + s sin t|`.
//!
//! Apart from a constant, these heights are
//!  - half the square of the distance of a circle's point `x(t)` from another circle: `x.(c_1 - c_2)` minus the other's
//!    radius times the length of the component of `x - c_2` perpendicular to its axis;
//!  - the distance of a circle's point `x(t)` from the side of a cone: `sin(alpha) x.a` plus `cos(alpha)` times the
//!    length of the component of `x - apex` perpendicular to its axis `a`;
//!  - the overlap of a disc and a cone along the cone's normal `o(t)`: `o.(apex - c)` plus the disc's radius times the
//!    length of the component of `o` perpendicular to its axis.
//!
//! Squaring `h' = 0` gives a polynomial of degree 4 in `cos t` and `sin t`, which has at most eight roots: there are at
//! most four such angles.
//!
//! A minimum and a maximum that are about to merge are arbitrarily close to each other, so that no number of samples is
//! enough. An `Interval` of half width `w` about its middle `t` has no minimum when
//! `|h'(t)| > |h''(t)| w + M w^2/2`, with `M` a bound of `|h'''|` on it, or when `h''(t) < -M w`, and at most one when
//! `h''(t) > M w`; else it is halved. `M` follows from the harmonics of the square of the length, so that it is as
//! small as `h'` itself where the height is almost constant.
//!
//! When an interval is narrower than [`NARROWEST`], or more than [`MOST_INTERVALS`] are undecided at once (heights that
//! are constant to rounding), only the slopes at the ends of the interval are used.

use super::place::Places;
use glam::DVec3;
use std::f64::consts::TAU;

/// Number of initial intervals.
const FIRST: u32 = 16;

/// Sine and cosine of the middles of the initial intervals, the odd multiples of pi/16, with the bits of `libm`.
const FIRST_MIDDLES: [(f64, f64); FIRST as usize] = [
    (0.19509032201612825, 0.9807852804032304),
    (0.5555702330196022, 0.8314696123025452),
    (0.8314696123025452, 0.5555702330196023),
    (0.9807852804032304, 0.19509032201612833),
    (0.9807852804032304, -0.1950903220161282),
    (0.8314696123025453, -0.555570233019602),
    (0.5555702330196022, -0.8314696123025453),
    (0.1950903220161286, -0.9807852804032304),
    (-0.19509032201612836, -0.9807852804032304),
    (-0.555570233019602, -0.8314696123025455),
    (-0.8314696123025452, -0.5555702330196022),
    (-0.9807852804032303, -0.19509032201612866),
    (-0.9807852804032304, 0.1950903220161283),
    (-0.8314696123025455, 0.5555702330196018),
    (-0.5555702330196022, 0.8314696123025452),
    (-0.19509032201612872, 0.9807852804032303),
];

/// Most undecided intervals of one width: those around eight angles, and some beside them.
const MOST_INTERVALS: usize = 48;

/// Width, as a fraction of a turn, below which an interval is not halved: within it the height is constant to rounding.
const NARROWEST: f64 = 1e-9;

/// A height as in the module's formula.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Height {
    /// `p` and `q`.
    linear: [f64; 2],
    /// `k`.
    weight: f64,
    middle: DVec3,
    cosine: DVec3,
    sine: DVec3,
    /// Bounds of the first three derivatives of the square of the length.
    of_square: [f64; 3],
    /// Length of `(p, q)`.
    of_linear: f64,
}

/// An interval of angles, as fractions of a turn.
#[derive(Debug, Clone, Copy)]
struct Interval {
    from: f64,
    width: f64,
}

/// How many minima an interval can contain.
enum MinimaCount {
    None,
    AtMostOne,
    Unknown,
}

impl Height {
    /// `linear` times cosine and sine, minus `weight` times the length of `middle + cosine cos t + sine sin t`.
    pub(crate) fn new(linear: [f64; 2], weight: f64, [middle, cosine, sine]: [DVec3; 3]) -> Self {
        let once = 2.0 * libm::hypot(middle.dot(cosine), middle.dot(sine));
        let twice = libm::hypot(0.5 * (cosine.length_squared() - sine.length_squared()), cosine.dot(sine));
        let of_square = [2.0, 4.0, 8.0].map(|factor| once + factor * twice);
        let of_linear = libm::hypot(linear[0], linear[1]);
        Self { linear, weight, middle, cosine, sine, of_square, of_linear }
    }

    /// First and second derivative at an angle, and the square of the length.
    fn derivatives(&self, angle: f64) -> (f64, f64, f64) {
        self.derivatives_along(libm::sincos(angle))
    }

    /// The same at the angle of this sine and cosine.
    fn derivatives_along(&self, (sine, cosine): (f64, f64)) -> (f64, f64, f64) {
        let turning = self.sine * cosine - self.cosine * sine;
        let bending = -(self.cosine * cosine + self.sine * sine);
        let vector = self.middle - bending;
        let square = vector.length_squared();
        let length = square.sqrt();
        let along = vector.dot(turning);
        let (slope, bend) = if length > 0.0 {
            let slope = along / length;
            (slope, (turning.length_squared() + vector.dot(bending) - slope * slope) / length)
        } else {
            (0.0, 0.0)
        };
        let [p, q] = self.linear;
        (q * cosine - p * sine - self.weight * slope, -(p * cosine + q * sine) - self.weight * bend, square)
    }

    fn slope(&self, angle: f64) -> f64 {
        self.derivatives(angle).0
    }

    /// Bound of the third derivative where the square of the length is at least `square`.
    fn steepest(&self, square: f64) -> f64 {
        if square <= 0.0 {
            return f64::INFINITY;
        }
        let [first, second, third] = self.of_square;
        let length = square.sqrt();
        let of_length = (0.5 * third + (0.75 * second + 0.375 * first * first / square) * first / square) / length;
        self.of_linear + self.weight.abs() * of_length
    }

    fn count_minima(&self, interval: Interval) -> MinimaCount {
        let half = 0.5 * interval.width;
        self.count_minima_from(half, self.derivatives(TAU * (interval.from + half)))
    }

    /// How many minima an interval can contain, from half its width and the derivatives at its middle.
    fn count_minima_from(&self, half: f64, (slope, bend, square): (f64, f64, f64)) -> MinimaCount {
        let half_angle = TAU * half;
        let steepest = self.steepest(square - self.of_square[0] * half_angle);
        if slope.abs() > half_angle * (bend.abs() + 0.5 * steepest * half_angle) {
            MinimaCount::None
        } else if bend > steepest * half_angle {
            MinimaCount::AtMostOne
        } else if bend < -steepest * half_angle {
            MinimaCount::None
        } else {
            MinimaCount::Unknown
        }
    }

    /// The minimum in an interval that has at most one.
    fn within(&self, interval: Interval) -> Option<f64> {
        let (from, to) = (TAU * interval.from, TAU * (interval.from + interval.width));
        // The end of the last interval is the start of the first one, with the same bits: an angle exactly there is
        // found once.
        let end = if interval.from + interval.width == 1.0 { 0.0 } else { to };
        let rises = self.slope(from) <= 0.0 && self.slope(end) > 0.0;
        rises.then(|| -falling_root(-to, -from, |angle| self.slope(-angle)))
    }

    /// Calls `visit` with the angles of the minima, in no order; with one arbitrary angle when the height is constant
    /// to rounding.
    pub(crate) fn each_least(&self, mut visit: impl FnMut(f64)) {
        let mut found = 0;
        let mut report = |interval: Interval| {
            if let Some(angle) = self.within(interval).filter(|_| found < Places::MOST) {
                found += 1;
                visit(angle);
            }
        };
        let width = f64::from(FIRST).recip();
        let mut buffers = [[Interval { from: 0.0, width }; MOST_INTERVALS]; 2];
        let [open, narrower] = &mut buffers;
        let (mut open, mut narrower) = (open, narrower);
        let mut count = 0;
        let mut sort = |interval: Interval,
                        holds: MinimaCount,
                        narrower: &mut [Interval; MOST_INTERVALS],
                        left: &mut usize| match holds {
            MinimaCount::None => {}
            MinimaCount::Unknown if interval.width > NARROWEST && *left + 2 <= MOST_INTERVALS => {
                let width = 0.5 * interval.width;
                narrower[*left] = Interval { width, ..interval };
                narrower[*left + 1] = Interval { from: interval.from + width, width };
                *left += 2;
            }
            MinimaCount::AtMostOne | MinimaCount::Unknown => report(interval),
        };
        // The initial intervals are the same for all heights, and so are the sines and cosines of their middles.
        for (k, &middle) in FIRST_MIDDLES.iter().enumerate() {
            let holds = self.count_minima_from(0.5 * width, self.derivatives_along(middle));
            sort(Interval { from: width * k as f64, width }, holds, open, &mut count);
        }
        while count > 0 {
            let mut left = 0;
            for interval in &open[..count] {
                sort(*interval, self.count_minima(*interval), narrower, &mut left);
            }
            std::mem::swap(&mut open, &mut narrower);
            count = left;
        }
        if found == 0 && self.slope(0.0).is_finite() {
            visit(0.0);
        }
    }
}

/// Root of a function that is positive at `left` and not at `right`: regula falsi with the Illinois rule (the value at
/// an end that stays twice is halved); every third step is a bisection, so that it ends when no double is left between
/// the two.
pub(crate) fn falling_root(left: f64, right: f64, f: impl Fn(f64) -> f64) -> f64 {
    let (mut left, mut right) = (left, right);
    let (mut value_left, mut value_right) = (f(left), f(right));
    let mut last = 0.0;
    for step in 0_usize.. {
        let width = right - left;
        let secant = left + width * (value_left / (value_left - value_right));
        let middle = 0.5 * (left + right);
        let at = if step % 3 == 2 || !(secant > left && secant < right) { middle } else { secant };
        if !(at > left && at < right) {
            break;
        }
        let value = f(at);
        let stays = if value * last > 0.0 { 0.5 } else { 1.0 };
        last = value.signum();
        if value > 0.0 {
            (left, value_left) = (at, value);
            value_right *= stays;
        } else if value < 0.0 {
            (right, value_right) = (at, value);
            value_left *= stays;
        } else {
            return at;
        }
    }
    0.5 * (left + right)
}

#[cfg(test)]
mod tests {
    use super::{FIRST, FIRST_MIDDLES};
    use std::f64::consts::TAU;

    #[test]
    fn middles_of_the_first_intervals_have_the_bits_of_their_formula() {
        for (k, &(sine, cosine)) in FIRST_MIDDLES.iter().enumerate() {
            let (s, c) = libm::sincos(TAU * (k as f64 / f64::from(FIRST) + 0.5 / f64::from(FIRST)));
            assert_eq!((sine.to_bits(), cosine.to_bits()), (s.to_bits(), c.to_bits()), "{k}: ({s:?}, {c:?})");
        }
    }
}
