//! Carlson's symmetric elliptic integral of the third kind.
//!
//! `RJ(x, y, z, p) = 3/2 int_0^inf dt / ((t + p) sqrt((t + x)(t + y)(t + z)))`, by duplication: each round brings the
//! four arguments four times closer to their mean, until a Taylor polynomial of degree seven about it is exact to
//! round-off. No subtraction of like numbers occurs in the sum, so the result is accurate to a few ulp. Source:
//! docs/REFERENCES.md, Carlson 1995; DLMF 19.36(i). Arguments: x, y, z not negative and at most one of them zero,
//! p positive; anything else gives NaN or infinity. The arguments have a positive limit in common, and a round quarters
//! what is compared with their mean: the rounds end, usually after 4 to 20.

use crate::lanes::Lanes;

/// `(r/4)^(-1/8)` with r = 2^-56: how many times closer than their spread the arguments must be to their mean for the
/// polynomial's remainder to be below r.
const CLOSENESS: f64 = 153.0;
/// `RJ(x, y, z, p)`.
pub fn rj(x: f64, y: f64, z: f64, p: f64) -> f64 {
    let [value] = rj_lanes(Lanes([x]), Lanes([y]), Lanes([z]), Lanes([p])).0;
    value
}

/// [`rj`] in each lane.
#[inline(never)]
pub(crate) fn rj_lanes<const N: usize>(x: Lanes<N>, y: Lanes<N>, z: Lanes<N>, p: Lanes<N>) -> Lanes<N> {
    let mean0 = 0.2 * (x + y + z + p + p);
    let spread = [x, y, z, p].into_iter().fold(Lanes::splat(0.0), |s, a| s.max((mean0 - a).abs()));
    let delta = (p - x) * (p - y) * (p - z);
    let (mut xn, mut yn, mut zn, mut pn, mut mean) = (x, y, z, p, mean0);
    let (mut quarter, mut sum) = (Lanes::splat(1.0), Lanes::splat(0.0));
    loop {
        let reach = CLOSENESS * quarter * spread;
        let goes_on: [bool; N] = std::array::from_fn(|i| reach.0[i] > mean.0[i]);
        if goes_on == [false; N] {
            break;
        }
        let (rx, ry, rz, rp) = (xn.sqrt(), yn.sqrt(), zn.sqrt(), pn.sqrt());
        let d = (rp + rx) * (rp + ry) * (rp + rz);
        let e = quarter * quarter * quarter * delta / (d * d);
        sum = (sum + quarter / d * rc_one(e, goes_on)).where_or(goes_on, sum);
        let lambda = rx * ry + rz * (rx + ry);
        let closer = |a: Lanes<N>| (0.25 * (a + lambda)).where_or(goes_on, a);
        (xn, yn, zn, pn, mean) = (closer(xn), closer(yn), closer(zn), closer(pn), closer(mean));
        quarter = (quarter * 0.25).where_or(goes_on, quarter);
    }
    let relative = |a: Lanes<N>| quarter * (mean0 - a) / mean;
    quarter * about_the_mean(relative(x), relative(y), relative(z)) / (mean * mean.sqrt()) + 6.0 * sum
}

/// `RC(1, 1 + e) = int_0^inf dt / (2 (t + 1 + e) sqrt(t + 1))`: an arc tangent, for e > -1; in the lanes asked for.
#[inline]
fn rc_one<const N: usize>(e: Lanes<N>, asked: [bool; N]) -> Lanes<N> {
    /// Below this |e| six terms of the series are exact to 1e-18.
    const SMALL: f64 = 1e-3;
    let mut values = 1.0 - e * (1.0 / 3.0 - e * (0.2 - e * (1.0 / 7.0 - e * (1.0 / 9.0 - e * (1.0 / 11.0)))));
    for ((value, e), asked) in values.0.iter_mut().zip(e.0).zip(asked) {
        if !asked || e.abs() < SMALL {
            continue;
        }
        *value = if e > 0.0 {
            let root = e.sqrt();
            libm::atan(root) / root
        } else {
            let root = (-e).sqrt();
            libm::atanh(root) / root
        };
    }
    values
}

/// DLMF 19.36.2, to degree seven: the integrand about the mean of the arguments, whose relative distances from it are
/// x, y, z and, twice, p.
#[inline]
fn about_the_mean<const N: usize>(x: Lanes<N>, y: Lanes<N>, z: Lanes<N>) -> Lanes<N> {
    let p = -0.5 * (x + y + z);
    let e2 = x * y + x * z + y * z - 3.0 * p * p;
    let e3 = x * y * z + 2.0 * e2 * p + 4.0 * p * p * p;
    let e4 = (2.0 * x * y * z + e2 * p + 3.0 * p * p * p) * p;
    let e5 = x * y * z * p * p;
    let degree_five =
        e3 / 6.0 - 3.0 * e2 / 14.0 + 9.0 * e2 * e2 / 88.0 - 3.0 * e4 / 22.0 - 9.0 * e2 * e3 / 52.0 + 3.0 * e5 / 26.0;
    let degree_six = 3.0 * e3 * e3 / 40.0 - e2 * e2 * e2 / 16.0 + 3.0 * e2 * e4 / 20.0;
    let degree_seven = 45.0 * e2 * e2 * e3 / 272.0 - 9.0 * (e3 * e4 + e2 * e5) / 68.0;
    1.0 + (degree_five + (degree_six + degree_seven))
}
