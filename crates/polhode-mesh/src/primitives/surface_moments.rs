//! Area and second moments of the surface of an ellipsoid.
//!
//! With the surface as the image of the unit sphere (normal n), `r = (a n_x, b n_y, c n_z)` and
//! `dA = sqrt(Q) dn`, `Q = p_x n_x^2 + p_y n_y^2 + p_z n_z^2`, `p_x = (b c)^2` and so on. The moments needed are
//! `M_x = int n_x^2 sqrt(Q) dn`; then `A = M_x + M_y + M_z` and the mean of `x^2` over the surface is `a^2 M_x / A`.
//! Writing `sqrt(Q) = Q / sqrt(Q)` turns each into a sum of Carlson's functions `R_{-1/2}` of positive terms
//! (docs/REFERENCES.md, DLMF 19.16, 19.23), and with their integral representation, `z = p`,
//!
//! ```text
//! M_x = pi/4 int_0^inf t^2 / sqrt((t + z_x)(t + z_y)(t + z_z)) / (t + z_x)
//!                      * (3 z_x / (t + z_x) + z_y / (t + z_y) + z_z / (t + z_z)) dt .
//! ```
//!
//! With `t = e^u` the integrand is analytic for `|Im u| < pi` and decays exponentially on both sides, so the
//! trapezoidal rule of step h errs by about `exp(-2 pi^2 / h)` (docs/REFERENCES.md, Trefethen and Weideman 2014): below
//! one rounding at the step chosen. All terms are positive, so nothing cancels, whatever the ratio of the axes.

use glam::DVec3;
use polhode_spatial::CompensatedSum;
use std::f64::consts::PI;

/// Step of the trapezoidal rule in `u = ln t` (dimensionless): `exp(-2 pi^2 / h) = 4e-22`, which the
/// strength of the singularity at `Im u = pi`, some hundreds, leaves below one rounding.
const STEP: f64 = 0.4;

/// How far below the smallest and above the largest z the rule goes, in u: the integrand falls as `e^(3u)` below and
/// `e^(-u/2)` above, so what is left out is below `e^-39 = 1e-17` of the whole.
const BELOW: f64 = 14.0;
/// See [`BELOW`].
const ABOVE: f64 = 78.0;

/// Area (m^2) of an ellipsoid with these semi-axes (m), and the means of x^2, y^2, z^2 over it (m^2).
pub(super) fn surface_moments(semi_axes: DVec3) -> (f64, DVec3) {
    // In units of the longest axis, so that products of axes do not overflow.
    let unit = semi_axes.max_element();
    let s = semi_axes / unit;
    let products = DVec3::new(s.y * s.z, s.z * s.x, s.x * s.y);
    let z = products * products;
    let from = libm::log(z.min_element().max(f64::MIN_POSITIVE)) - BELOW;
    let steps = ((libm::log(z.max_element().max(f64::MIN_POSITIVE)) + ABOVE - from) / STEP) as u32;
    let mut sums = [CompensatedSum::ZERO; 3];
    for k in 0..=steps {
        let t = libm::exp(from + STEP * f64::from(k));
        let inverse = 1.0 / (t + z);
        // One factor t is dt/du; each root goes with its own part of t^(3/2), so that no product underflows.
        let ratio = t * inverse;
        let root = (ratio.x).sqrt() * (ratio.y).sqrt() * (ratio.z).sqrt();
        let parts = z * inverse;
        let sum = parts.x + parts.y + parts.z;
        for axis in 0..3 {
            sums[axis].add(t.sqrt() * root * ratio[axis] * (sum + 2.0 * parts[axis]));
        }
    }
    let moments = DVec3::from_array(sums.map(|sum| sum.value()));
    let total = moments.x + moments.y + moments.z;
    let area = 0.25 * PI * STEP * total * unit * unit;
    (area, semi_axes * semi_axes * (moments / total))
}
