//! The exact solution of one contact on its own: the step of Gauss and Seidel's method.
//!
//! For `u = A r + b` with `A` the block of the contact:
//! - open: `b_n >= 0`, `r = 0`;
//! - stick: `r = -A^-1 b`, if it lies in the cone;
//! - slide: `u_n = 0` gives `r_n = -(b_n + A_nt r_t) / A_nn` and `u_t = W r_t + c` with `W = A_tt - A_tn A_nt / A_nn`,
//!   `c = b_t - A_tn b_n / A_nn`. With `u_t = -x r_t`, `x >= 0`, the tangential reaction is `r_t(x) = -(W + x)^-1 c`,
//!   and what is left is one equation in `x`: `|r_t(x)| = mu r_n(x)`. Its left side exceeds the right at `x = 0`, where
//!   the contact would stick, and falls below it for large `x`, so that there is a root; it is bracketed and found by
//!   Newton's method.
//!
//! Source: Bonnefon and Daviet 2011 solve the same equation as a quartic polynomial. Where several roots exist (strong
//! coupling of normal and tangent) one is taken.

use crate::dense::scalar::Scalar;
use crate::friction::coulomb_cone::{Rows, project, tangential_length};
use crate::law::{CONTACT_ROWS, Law};
use crate::tolerances::LEAST_CHANGE;

/// A block of `G` with the rows that are missing filled up by the identity.
pub(crate) type Square = [[f64; CONTACT_ROWS]; CONTACT_ROWS];

/// A row-major block of `size` rows, as a full square; diagonal entries of missing rows are 1.
pub(crate) fn square(values: &[f64], size: usize) -> Square {
    let entry = |i: usize, j: usize| {
        if i < size && j < size { values[i * size + j] } else { f64::from(u8::from(i == j)) }
    };
    std::array::from_fn(|i| std::array::from_fn(|j| entry(i, j)))
}

/// The reaction of one contact where `b` is the velocity without it; `a` is its block of `G`.
pub(crate) fn solve(block: Law, a: &Square, b: Rows) -> Rows {
    let (rows, friction) = match block {
        Law::Push => (1, 0.0),
        Law::Cone { rows, friction } => (rows, friction),
        Law::Slide { friction } => return already_sliding(a, b, friction),
        Law::Hold { .. } => return hold(a, b),
        // Its rotations are solved beside it (`gauss_seidel`).
        Law::Resist { parts: [slip, ..] } if slip.slides => return already_sliding(a, b, slip.friction),
        Law::Resist { parts: [slip, ..] } => (1 + slip.rows, slip.friction),
    };
    if b[0] >= 0.0 || a[0][0] <= 0.0 {
        return [0.0; CONTACT_ROWS];
    }
    if rows == 1 || friction == 0.0 {
        return [-b[0] / a[0][0], 0.0, 0.0];
    }
    let sticking = hold(a, b);
    if tangential_length(sticking) <= friction * sticking[0] {
        return sticking;
    }
    if rows == 2 { slide_in_plane(a, b, friction, sticking) } else { slide(a, b, friction) }
}

/// A contact that slides already. Where friction pulls the bodies together at least as much as the normal reaction
/// pushes them apart (Painleve), there is no reaction that is the answer, and the one without friction is taken.
fn already_sliding(a: &Square, b: Rows, friction: f64) -> Rows {
    if b[0] >= 0.0 || a[0][0] <= 0.0 {
        return [0.0; CONTACT_ROWS];
    }
    let pushed = a[0][0] - friction * a[0][1];
    let normal = -b[0] / if pushed > f64::ROUNDING * a[0][0] { pushed } else { a[0][0] };
    [normal, -friction * normal, 0.0]
}

/// `-A^-1 b` by elimination; where a pivot vanishes its reaction is zero.
pub(crate) fn hold(a: &Square, b: Rows) -> Rows {
    let (mut a, mut b) = (*a, b);
    for k in 0..CONTACT_ROWS {
        for i in k + 1..CONTACT_ROWS {
            let factor = if a[k][k] > 0.0 { a[i][k] / a[k][k] } else { 0.0 };
            let whole = a[i][i];
            for j in k..CONTACT_ROWS {
                a[i][j] -= factor * a[k][j];
            }
            b[i] -= factor * b[k];
            if a[i][i] <= f64::ROUNDING * whole {
                a[i][i] = 0.0;
            }
        }
    }
    let mut r = [0.0; CONTACT_ROWS];
    for k in (0..CONTACT_ROWS).rev() {
        let known: f64 = (k + 1..CONTACT_ROWS).map(|j| a[k][j] * r[j]).sum();
        r[k] = if a[k][k] > 0.0 { -(b[k] + known) / a[k][k] } else { 0.0 };
    }
    r
}

/// Sliding along the one tangent of a plane, to the side to which the contact would have to be held beyond the cone.
fn slide_in_plane(a: &Square, b: Rows, friction: f64, sticking: Rows) -> Rows {
    let side = if sticking[1] >= 0.0 { friction } else { -friction };
    for side in [side, -side] {
        let normal = -b[0] / (a[0][0] + side * a[0][1]);
        if normal > 0.0 && normal.is_finite() {
            return [normal, side * normal, 0.0];
        }
    }
    project(friction, sticking)
}

/// Sliding in space.
fn slide(a: &Square, b: Rows, friction: f64) -> Rows {
    let (over, c) = (1.0 / a[0][0], [b[1] - a[1][0] * b[0] / a[0][0], b[2] - a[2][0] * b[0] / a[0][0]]);
    let w = |i: usize, j: usize| a[i][j] - a[i][0] * a[0][j] * over;
    let [[xx, xy], [yx, yy]] = [[w(1, 1), w(1, 2)], [w(2, 1), w(2, 2)]];
    let (trace, determinant) = (xx + yy, xx * yy - xy * yx);
    // (W + x)^-1 c = (adj W c + x c) / (x^2 + x trace + det).
    let adjoint = [yy * c[0] - xy * c[1], xx * c[1] - yx * c[0]];
    let at = |x: f64| {
        let below = -1.0 / (x * (x + trace) + determinant);
        let t = [(adjoint[0] + x * c[0]) * below, (adjoint[1] + x * c[1]) * below];
        (t, below)
    };
    let normal = |t: [f64; 2]| -(b[0] + a[0][1] * t[0] + a[0][2] * t[1]) * over;
    // Beyond this, |r_t| <= |c| / x is below what the normal force allows for whatever the coupling.
    let coupling = friction * (a[0][1] * a[0][1] + a[0][2] * a[0][2]).sqrt() * over;
    let reach = (1.0 + coupling) * (c[0] * c[0] + c[1] * c[1]).sqrt() / (friction * -b[0] * over);
    let (mut low, mut high) = (0.0_f64, 2.0 * (reach + trace.abs()));
    // Where sweeps diverge nothing here is a number, which `clamp` would not take.
    let mut x = (reach - 0.5 * trace).max(0.0).min(high);
    let mut t = at(x).0;
    let mut change = high;
    // Each step replaces an end of the bracket by a place within it, near the root by Newton's quadratic steps: they
    // end when a step is rounding.
    while change > LEAST_CHANGE * (x + trace.abs()) {
        let (tangent, below) = at(x);
        t = tangent;
        let length = (t[0] * t[0] + t[1] * t[1]).sqrt();
        let value = length - friction * normal(t);
        if value > 0.0 {
            low = x;
        } else {
            high = x;
        }
        // dt/dx = -(W + x)^-1 t.
        let slope_t = [below * ((yy + x) * t[0] - xy * t[1]), below * ((xx + x) * t[1] - yx * t[0])];
        let slope = (t[0] * slope_t[0] + t[1] * slope_t[1]) / length
            + friction * (a[0][1] * slope_t[0] + a[0][2] * slope_t[1]) * over;
        // 1/|t| is nearly linear in x, as in trust regions: Newton's method for 1/|t| - 1/(mu n) is the plain one
        // stretched.
        let allowed = length - value;
        let newton = x - value / slope * if allowed > 0.0 { length / allowed } else { 1.0 };
        let next = if newton > low && newton < high { newton } else { 0.5 * (low + high) };
        change = (next - x).abs();
        x = next;
    }
    let (length, normal) = ((t[0] * t[0] + t[1] * t[1]).sqrt(), normal(t));
    if !(normal > 0.0 && length > 0.0 && normal.is_finite()) {
        return project(friction, [-b[0] * over, t[0], t[1]].map(|value| if value.is_finite() { value } else { 0.0 }));
    }
    let scale = friction * normal / length;
    [normal, scale * t[0], scale * t[1]]
}
