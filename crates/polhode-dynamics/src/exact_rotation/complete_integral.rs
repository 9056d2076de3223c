//! The complete elliptic integral that a half period adds to the attitude.
//!
//! `J(K) = int_0^K sn^2 u/(1 + n sn^2 u) du = int_0^(pi/2) sin^2 / ((1 + n sin^2) sqrt(cos^2 + m1 sin^2))`, Bulirsch's
//! `cel(sqrt m1, 1 + n, 0, 1)`: arithmetic-geometric means carried along with two numbers more, sums and products of
//! positive terms throughout, so that the result is good to a few ulp. A tenth of the cost of Carlson's RJ. Source:
//! docs/REFERENCES.md, Bulirsch 1969. Infinite for m1 = 0.

use polhode_spatial::rounding;
use std::f64::consts::FRAC_PI_2;

/// Levels after which the means agree for every double in (0, 1].
const LEVELS: usize = 16;
/// `J(K)` for the characteristic `n >= 0` and the complementary parameter `m1` in [0, 1].
pub(super) fn complete_integral(n: f64, complement: f64) -> f64 {
    if complement == 0.0 {
        return f64::INFINITY;
    }
    let mut geometric = complement.sqrt();
    let (mut arithmetic, mut product) = (1.0, geometric);
    let mut p = (1.0 + n).sqrt();
    let (mut a, mut b) = (0.0, 1.0 / p);
    for _ in 0..LEVELS {
        let reciprocal = 1.0 / p;
        let ratio = product * reciprocal;
        (a, b) = (a + b * reciprocal, 2.0 * (b + a * ratio));
        p += ratio;
        let before = arithmetic;
        arithmetic += geometric;
        if (before - geometric).abs() <= rounding::HALF_OF_THE_DIGITS * before {
            break;
        }
        geometric = 2.0 * product.sqrt();
        product = geometric * arithmetic;
    }
    FRAC_PI_2 * (b + a * arithmetic) / (arithmetic * (arithmetic + p))
}
