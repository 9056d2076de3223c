//! Angular velocity and acceleration of a rotation that is given by its rotation vector.
//!
//! The rotation `R(t) = exp(theta(t))` has in the world the angular velocity `w = J theta'`, with the left Jacobian
//! `J u = u + f theta x u + g theta x (theta x u)`, `f = (1 - cos a)/a^2`, `g = (a - sin a)/a^3`, `a = |theta|`, and
//! the angular acceleration `w' = J theta'' + J' theta'`. Source: docs/REFERENCES.md, Sola et al. 2018, appendix B.
//!
//! `J` is the mean of the rotations `exp(s theta)`, s from 0 to 1, so `|J u| <= |u|`; and `|J' u| <= |u| |theta x u|/2`
//! for `u = theta'`, from `J' u = integral of s (J(s theta) u) x (exp(s theta) u)`, both factors of which differ from u
//! by at most `s |theta x u|/2` and `s |theta x u|`, so that the product is at most `3 s |u| |theta x u|/2`.

use super::polynomial::Jet;
use polhode_spatial::DVec3;

/// Below this angle (rad) the functions are summed as power series; above it their closed forms lose at most two digits
/// by cancellation.
const SERIES_ANGLE: f64 = 1.0;

/// Terms of a series: the first one left out is below 1/22!.
const TERMS: u32 = 10;

/// Rounding error of an angular velocity relative to the rate of its rotation vector: the closed forms lose two digits,
/// and a few dozen operations have an error of 1.1e-16 each.
pub(super) const ANGLE_ROUNDING: f64 = 4096.0 * f64::EPSILON;

/// `f` and `g`, and their derivatives by the angle, divided by the angle.
struct Functions {
    f: f64,
    g: f64,
    f_rate: f64,
    g_rate: f64,
}

impl Functions {
    fn at(angle: f64) -> Self {
        let a2 = angle * angle;
        if angle >= SERIES_ANGLE {
            let (sine, versine) = (libm::sin(angle), 1.0 - libm::cos(angle));
            let (f, g) = (versine / a2, (angle - sine) / (a2 * angle));
            return Self { f, g, f_rate: (sine / angle - 2.0 * f) / a2, g_rate: (f - 3.0 * g) / a2 };
        }
        // sum of (-1)^k a^(2k)/(2k+2)! and of (-1)^k a^(2k)/(2k+3)!, and 2k a^(2k-2) in the place of a^(2k).
        let mut sums = Self { f: 0.5, g: 1.0 / 6.0, f_rate: 0.0, g_rate: 0.0 };
        let (mut term_f, mut term_g) = (sums.f, sums.g);
        for k in 1..TERMS {
            let n = f64::from(2 * k);
            // The same terms without a^2, for the derivatives.
            let (next_f, next_g) = (-term_f / ((n + 1.0) * (n + 2.0)), -term_g / ((n + 2.0) * (n + 3.0)));
            sums.f_rate += n * next_f;
            sums.g_rate += n * next_g;
            (term_f, term_g) = (next_f * a2, next_g * a2);
            sums.f += term_f;
            sums.g += term_g;
        }
        sums
    }

    /// `J' u` but for the part with the derivative of u.
    fn jacobian_rate(&self, theta: DVec3, u: DVec3) -> DVec3 {
        let along = theta.dot(u);
        let once = theta.cross(u);
        once * (self.f_rate * along) + theta.cross(once) * (self.g_rate * along) + u.cross(once) * self.g
    }

    /// `J u`.
    fn jacobian(&self, theta: DVec3, u: DVec3) -> DVec3 {
        let once = theta.cross(u);
        u + once * self.f + theta.cross(once) * self.g
    }
}

/// Angular velocity and acceleration of `exp(theta)`.
pub(super) fn rates(theta: &Jet) -> (DVec3, DVec3) {
    let functions = Functions::at(theta.value.length());
    let velocity = functions.jacobian(theta.value, theta.first);
    let acceleration =
        functions.jacobian(theta.value, theta.second) + functions.jacobian_rate(theta.value, theta.first);
    (velocity, acceleration)
}

/// The rotation vector `theta` (at most half a turn) with the derivatives that give this angular velocity and
/// acceleration.
pub(super) fn jet(theta: DVec3, velocity: DVec3, acceleration: DVec3) -> Jet {
    let angle = theta.length();
    let functions = Functions::at(angle);
    // J^-1 u = u - theta x u/2 + c theta x (theta x u), c = 1/a^2 - (1 + cos a)/(2 a sin a)
    let inverse = |u: DVec3| {
        let once = theta.cross(u);
        u - once * 0.5 + theta.cross(once) * inverse_factor(angle, &functions)
    };
    let first = inverse(velocity);
    Jet { value: theta, first, second: inverse(acceleration - functions.jacobian_rate(theta, first)) }
}

/// `1/a^2 - (1 + cos a)/(2 a sin a) = (2 f - 1 + a^2 g)/(2 a^2 f)`, the numerator of which is `a^2` times a series.
fn inverse_factor(angle: f64, functions: &Functions) -> f64 {
    let a2 = angle * angle;
    if angle >= SERIES_ANGLE {
        return (2.0 * functions.f - 1.0 + a2 * functions.g) / (2.0 * a2 * functions.f);
    }
    // 2 f - 1 + a^2 g = sum over k >= 1 of (-1)^k a^(2k) (2/(2k+2)! - 1/(2k+1)!): the terms of f and of sin a/a.
    let (mut sum, mut power, mut factorial) = (0.0, 1.0, 1.0);
    for k in 1..TERMS {
        let n = f64::from(2 * k);
        factorial *= n * (n + 1.0);
        let sign = if k % 2 == 0 { 1.0 } else { -1.0 };
        sum += sign * power / factorial * (2.0 / (n + 2.0) - 1.0);
        power *= a2;
    }
    sum / (2.0 * functions.f)
}
