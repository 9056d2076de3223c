//! Impact laws that are algebra on the velocity before: Whittaker, Chatterjee and Ruina.
//!
//! Both give `u_n+ = -e u_n-`. Whittaker 1904: the impulse that also leaves no slip, if it is in the cone of friction;
//! otherwise `mu p_n` against the slip before. It may raise the energy (Kane and Levinson 1985). Chatterjee and Ruina
//! 1998: with `p_I` the normal impulse that stops the approach and `p_II = -K^-1 u-` the impulse that stops the
//! contact, `p = (1 + e) p_I + s (p_II - p_I)` with `s = 1 + e_t`, or the smaller `s` at which `p` is on the border of
//! the cone. In the energy norm `p_I` and `p_II - p_I` are orthogonal and
//! `2 dT = (e^2 - 1)|p_I|^2 + ((s - 1)^2 - 1)|p_II - p_I|^2`, which is not positive for `0 <= s <= 2`.

use super::coulomb::{Coulomb, ZeroSlip};
use super::plane;
use polhode_spatial::rounding;

/// Whittaker's impulse; none when the slip before jams.
pub(super) fn whittaker(coulomb: &Coulomb, before: [f64; 3], restitution: f64) -> Option<[f64; 3]> {
    let matrix = &coulomb.matrix;
    let slip = [before[1], before[2]];
    let wanted = -(1.0 + restitution) * before[0];
    // No slip: p_t = -K_tt^-1 (u_t + k p_n) in the normal row.
    let (stop, ratio) = (matrix.solve_tangential(slip), matrix.solve_tangential(matrix.coupling));
    let pivot = matrix.normal - plane::dot(matrix.coupling, ratio);
    if pivot > rounding::HUNDREDS_OF_TERMS * matrix.normal {
        let normal = (wanted + plane::dot(matrix.coupling, stop)) / pivot;
        let tangential = plane::scaled(plane::sum(stop, plane::scaled(ratio, normal)), -1.0);
        if normal >= 0.0 && plane::length(tangential) <= coulomb.friction * normal {
            return Some([normal, tangential[0], tangential[1]]);
        }
    }
    let direction = match (plane::direction(slip), coulomb.leaving_zero_slip()) {
        (Some(direction), _) | (None, ZeroSlip::Slips(direction)) => direction,
        (None, ZeroSlip::Sticks { .. }) => return None,
    };
    along(coulomb, direction, wanted)
}

/// The impulse against a slip in one direction that changes the normal velocity by `wanted`.
fn along(coulomb: &Coulomb, direction: plane::Tangent, wanted: f64) -> Option<[f64; 3]> {
    let rate = coulomb.normal_rate(direction);
    if rate <= rounding::HUNDREDS_OF_TERMS * coulomb.matrix.normal {
        return None;
    }
    let normal = wanted / rate;
    let friction = -coulomb.friction * normal;
    Some([normal, friction * direction[0], friction * direction[1]])
}

/// Chatterjee and Ruina's impulse, with the coefficients `[e, e_t]`.
pub(super) fn chatterjee_ruina(coulomb: &Coulomb, before: [f64; 3], [e, e_t]: [f64; 2]) -> [f64; 3] {
    let matrix = &coulomb.matrix;
    let (k, [t11, t12, t22]) = (matrix.coupling, matrix.tangential);
    let stop_normal = -before[0] / matrix.normal;
    // The rest of the way to the stop, p_II - p_I, by eliminating the normal row.
    let slip = plane::sum([before[1], before[2]], plane::scaled(k, stop_normal));
    let below = |i: usize, j: usize| k[i] * (k[j] / matrix.normal);
    let rest = [t11 - below(0, 0), t12 - below(0, 1), t22 - below(1, 1)];
    let tangential = plane::scaled(plane::solve(rest, slip, rounding::HUNDREDS_OF_TERMS), -1.0);
    let normal = -plane::dot(k, tangential) / matrix.normal;
    let straight = (1.0 + e) * stop_normal;
    let (size, full) = (plane::length(tangential), 1.0 + e_t);
    let share = if full * size > coulomb.friction * (straight + full * normal) {
        // |s t| = mu ((1 + e) p_I + s n).
        let share = coulomb.friction * straight / (size - coulomb.friction * normal);
        share.clamp(0.0, full)
    } else {
        full
    };
    [straight + share * normal, share * tangential[0], share * tangential[1]]
}
