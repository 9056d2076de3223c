//! The equation of implicit maps of free rotation whose turn is Cayley's map of a vector f.
//!
//! The turn of the step is by the quaternion `(1, f)`, f along principal axes, normalised: half the axis of rotation by
//! the tangent of half the angle, about `h w/2`. With `g = h p/(2 I)` and `d_1 = (I3 - I2)/I1` (and cyclic) it solves
//!
//! ```text
//! f_1 + d_1 f_2 f_3 = g_1 (1 + s |f|^2)    (and cyclic)
//! ```
//!
//! s = 0: the implicit midpoint rule `p+ - p = h p_m x I^-1 p_m`, `p_m = (p + p+)/2`, for `f = h I^-1 p_m/2`.
//! s = 1: the discrete Moser-Veselov equation `h p_1 = 2 I1 e0 e1 + 2 (I3 - I2) e2 e3` of the quaternion (e0, e), for
//! `f = e/e0`. Either way `p+ = R^T p` for the turn R.
//!
//! Newton's method from the solution to fourth order in h takes one or two iterations at usual steps. The solution
//! that goes to zero with h has a Jacobian of positive determinant; where that is lost the step has none, and it fails.

use super::IntegrationError;
use super::body_axes::{cayley, solve};
use glam::{DQuat, DVec3};
use polhode_spatial::rounding;

/// The coefficient s of the equation.
#[derive(Debug, Clone, Copy)]
pub(crate) enum Rule {
    /// s = 0.
    Midpoint,
    /// s = 1.
    MoserVeselov,
}

/// `(I3 - I2)/I1` and cyclic.
#[inline]
pub(crate) fn asymmetry(moments: DVec3) -> DVec3 {
    let i = moments;
    DVec3::new(i.z - i.y, i.x - i.z, i.y - i.x) / i
}

/// The turn, from `g = h p/(2 I)` (rad) and `d` ([`asymmetry`]).
#[inline]
pub(crate) fn turn(rule: Rule, g: DVec3, d: DVec3) -> Result<DQuat, IntegrationError> {
    if !g.is_finite() {
        // The state is then not finite, which is reported with its time.
        return Ok(DQuat::from_xyzw(f64::NAN, f64::NAN, f64::NAN, f64::NAN));
    }
    let s = match rule {
        Rule::Midpoint => 0.0,
        Rule::MoserVeselov => 1.0,
    };
    let products = |f: DVec3| DVec3::new(f.y * f.z, f.z * f.x, f.x * f.y);
    let sweep = |f: DVec3| g * (1.0 + s * f.length_squared()) - d * products(f);
    let mut f = sweep(sweep(g));
    // Steps of Newton's method that converges become shorter: by half near the longest step that has a solution, where
    // the Jacobian is all but singular. Usual steps take one or two.
    let (mut change, mut last) = (f64::INFINITY, f64::INFINITY);
    let mut iterations = 0;
    loop {
        iterations += 1;
        let residual = f - sweep(f);
        let slope = g * (-2.0 * s);
        let columns = [
            DVec3::new(1.0, d.y * f.z, d.z * f.y) + slope * f.x,
            DVec3::new(d.x * f.z, 1.0, d.z * f.x) + slope * f.y,
            DVec3::new(d.x * f.y, d.y * f.x, 1.0) + slope * f.z,
        ];
        let (step, determinant) = solve(columns, residual);
        let length = step.length();
        // Written so that NaN ends it.
        let is_shorter = length < last;
        if determinant <= 0.0 || !is_shorter {
            return Err(IntegrationError::NoConvergence { iterations, change });
        }
        f -= step;
        (change, last) = (length / f.length(), length);
        // A body that does not turn has no f to compare with.
        if length <= rounding::HALF_OF_THE_DIGITS * f.length() {
            return Ok(cayley(f));
        }
    }
}
