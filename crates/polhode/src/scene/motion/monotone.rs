//! Monotone interpolation: rates at the samples with which polynomials of degree five stay between their samples.
//!
//! Each coordinate is treated alone. Between two samples that are the step `d` and the time h apart, with the
//! velocities v0, v1 and accelerations a0, a1 at its ends, the polynomial has the Bezier coefficients
//!
//! ```text
//! b0 = 0   b1 = h v0/5   b2 = 2 h v0/5 + h^2 a0/20   b3 = d - 2 h v1/5 + h^2 a1/20   b4 = d - h v1/5   b5 = d
//! ```
//!
//! It is monotone if they are in order, from 0 to d (variation diminishing). The rates of the spline are kept at both
//! ends of every interval where they are. Where they are not, the velocity of both ends is limited to between zero and
//! 5/4 of the smaller slope on either side, and is zero at a sample where the slopes differ in sign; then the
//! acceleration is limited to what leaves the coefficients on both sides in order:
//!
//! ```text
//! -4 v <= h a   and   8 v + h a <= 10 s    on the side after the sample, with the slope s = d/h
//! h a <= 4 v    and   8 v - h a <= 10 s    on the side before it
//! ```
//!
//! (for s >= 0; with all signs reversed otherwise). Zero always satisfies them. Limiting a sample may spoil the
//! interval on its other side, whose other end is limited then, too: each sample is limited at most once.
//!
//! Source: docs/REFERENCES.md, Fritsch and Carlson 1980 (the idea, for cubics); Farin 2002 for Bezier coefficients.

use polhode_spatial::DVec3;

/// Largest velocity at a sample, of the smaller slope beside it: with 5/4 on both sides the middle coefficients b2 and
/// b3 meet at accelerations of zero.
const STEEPEST: f64 = 1.25;

/// The rates `(y', y'')` of the samples, limited so that every coordinate between two samples is monotone. `spacings`
/// and `steps` have one entry for each interval, `rates` one more.
pub(super) fn limited(spacings: &[f64], steps: &[DVec3], rates: &[(DVec3, DVec3)]) -> Vec<(DVec3, DVec3)> {
    let mut limited = rates.to_vec();
    for axis in 0..3 {
        let steps: Vec<f64> = steps.iter().map(|step| step[axis]).collect();
        let mut column: Vec<Rate> =
            rates.iter().map(|(first, second)| Rate { velocity: first[axis], acceleration: second[axis] }).collect();
        limit(spacings, &steps, &mut column);
        for ((first, second), rate) in limited.iter_mut().zip(&column) {
            first[axis] = rate.velocity;
            second[axis] = rate.acceleration;
        }
    }
    limited
}

/// Velocity and acceleration of one coordinate at a sample.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Rate {
    velocity: f64,
    acceleration: f64,
}

/// One side of a sample: the time to the next sample there, and the slope.
#[derive(Debug, Clone, Copy)]
struct Side {
    spacing: f64,
    slope: f64,
}

fn limit(spacings: &[f64], steps: &[f64], rates: &mut [Rate]) {
    let sides: Vec<Side> =
        spacings.iter().zip(steps).map(|(&spacing, &step)| Side { spacing, slope: step / spacing }).collect();
    let mut is_limited = vec![false; rates.len()];
    loop {
        let spoiled: Vec<usize> =
            (0..sides.len()).filter(|&k| !is_in_order(sides[k], rates[k], rates[k + 1])).collect();
        let ends: Vec<usize> = spoiled.into_iter().flat_map(|k| [k, k + 1]).filter(|&k| !is_limited[k]).collect();
        if ends.is_empty() {
            return;
        }
        for k in ends {
            let before = k.checked_sub(1).map(|k| sides[k]);
            rates[k] = limited_rate(rates[k], before, sides.get(k).copied());
            is_limited[k] = true;
        }
    }
}

/// Whether the Bezier coefficients between two samples, divided by the spacing, are in order.
fn is_in_order(side: Side, start: Rate, end: Rate) -> bool {
    let Side { spacing: h, slope } = side;
    let sign = if slope < 0.0 { -1.0 } else { 1.0 };
    let (v0, a0) = (sign * start.velocity, sign * start.acceleration * h);
    let (v1, a1) = (sign * end.velocity, sign * end.acceleration * h);
    v0 >= 0.0
        && v1 >= 0.0
        && 4.0 * v0 + a0 >= 0.0
        && 4.0 * v1 - a1 >= 0.0
        && (8.0 * v0 + a0) + (8.0 * v1 - a1) <= 20.0 * slope.abs()
}

/// The rate at a sample nearest to `rate` with which the coefficients on both sides are in order. At the first and the
/// last sample one side is absent: the body stands still there.
fn limited_rate(rate: Rate, before: Option<Side>, after: Option<Side>) -> Rate {
    let (Some(before), Some(after)) = (before, after) else { return Rate { velocity: 0.0, acceleration: 0.0 } };
    if before.slope * after.slope <= 0.0 {
        return Rate { velocity: 0.0, acceleration: 0.0 };
    }
    let sign = if after.slope < 0.0 { -1.0 } else { 1.0 };
    let (slope_before, slope_after) = (before.slope.abs(), after.slope.abs());
    let v = (sign * rate.velocity).clamp(0.0, STEEPEST * slope_before.min(slope_after));
    // Not below zero but for rounding: v is at most 5/4 of either slope.
    let room = |slope: f64| (10.0 * slope - 8.0 * v).max(0.0);
    let least = (-4.0 * v / after.spacing).max(-room(slope_before) / before.spacing);
    let most = (4.0 * v / before.spacing).min(room(slope_after) / after.spacing);
    let a = (sign * rate.acceleration).max(least).min(most);
    Rate { velocity: sign * v, acceleration: sign * a }
}

#[cfg(test)]
mod tests {
    //! What is in order is kept, and what is limited is in order.
    use super::*;

    fn along_x(values: &[f64]) -> Vec<DVec3> {
        values.iter().map(|&x| DVec3::X * x).collect()
    }

    /// A straight line, and samples of a smooth rise: the rates given are kept to the bit.
    #[test]
    fn rates_in_order_are_kept() {
        let rates: Vec<_> = [0.0, 2.0, 3.0, 0.0].map(|v| (DVec3::X * v, DVec3::ZERO)).to_vec();
        assert_eq!(limited(&[1.0; 3], &along_x(&[2.0, 2.5, 2.0]), &rates), rates);
    }

    /// A hold stands still: a sample beside a step of zero has no velocity and no acceleration.
    #[test]
    fn a_hold_stands_still() {
        let rates: Vec<_> = [0.0, -30.0, 4.0, 0.0].map(|v| (DVec3::X * v, DVec3::X * 7.0 * v)).to_vec();
        for rate in limited(&[1.0, 5.0, 0.05], &along_x(&[0.0, 0.0, -2.0]), &rates) {
            assert_eq!(rate, (DVec3::ZERO, DVec3::ZERO));
        }
    }

    /// Whatever the rates, all intervals are in order afterwards; a mirror image has the mirrored rates.
    #[test]
    fn limited_rates_are_in_order() {
        let spacings = [1.0, 0.1, 2.0, 0.5, 1.0];
        let steps = [1.0, 3.0, 0.2, -1.0, -4.0];
        let wild = [9.0, -5.0, 40.0, 3.0, -7.0, 2.0];
        let mut rates = wild.map(|v| Rate { velocity: v, acceleration: -11.0 * v });
        limit(&spacings, &steps, &mut rates);
        for k in 0..steps.len() {
            // But for the rounding of the sums that are compared.
            let side = Side { spacing: spacings[k], slope: steps[k] / spacings[k] * (1.0 + 1e-12) };
            let [start, end] =
                [rates[k], rates[k + 1]].map(|rate| Rate { acceleration: rate.acceleration * (1.0 - 1e-12), ..rate });
            assert!(is_in_order(side, start, end), "interval {k}");
        }
        let mut mirrored = wild.map(|v| Rate { velocity: -v, acceleration: 11.0 * v });
        limit(&spacings, &steps.map(|step| -step), &mut mirrored);
        for (a, b) in rates.iter().zip(&mirrored) {
            assert_eq!((a.velocity, a.acceleration), (-b.velocity, -b.acceleration));
        }
    }
}
