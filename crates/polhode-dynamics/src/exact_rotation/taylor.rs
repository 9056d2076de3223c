//! Free rotation over a short time: Taylor series to round-off.
//!
//! Euler's equations `p' = p x I^-1 p` and `q' = q (0, I^-1 p)/2` are quadratic, so the Taylor coefficients follow from
//! convolutions: `p[k+1] = h/(k+1) sum_j p[j] x I^-1 p[k-j]` and `q[k+1] = h/(k+1) sum_j q[k-j] (0, I^-1 p[j])/2`.
//! Only + - * / are used, so the bits are the same everywhere, and there are no special cases; near `h = 0` the result
//! is better than round-off of one: its error is relative to the turn. The series is used while the turn is at most
//! [`super::TAYLOR_REACH`], where some 25 terms are the most it takes. Source: docs/REFERENCES.md, Jorba and Zou 2005.

use glam::{DQuat, DVec3};

use super::canonical::Canonical;

/// Terms at most. Within the reach the series converges long before; beyond, running out of them is the sign that it
/// does not.
const MAX_TERMS: usize = 32;
/// A term is negligible below this part of the largest, 2^-56: an eighth of the last bit.
const NEGLIGIBLE: f64 = 1.387_778_780_781_445_7e-17;

/// Rotation from the axes after the canonical time `h` to those at the start; nothing when the series does not reach
/// that far.
pub(super) fn relative(canonical: &Canonical, h: f64) -> Option<DQuat> {
    let inertia = canonical.moments;
    let rates =
        [1.0 / inertia[2] - 1.0 / inertia[1], 1.0 / inertia[0] - 1.0 / inertia[2], 1.0 / inertia[1] - 1.0 / inertia[0]]
            .map(|r| r * h);
    let half = inertia.map(|i| 0.5 * h / i);
    let size = DVec3::from_array(canonical.momentum).length();
    let mut p = [[0.0f64; 3]; MAX_TERMS];
    // Half the turn: h I^-1 p / 2, of which the quaternion's rate is made.
    let mut z = [[0.0f64; 3]; MAX_TERMS];
    let mut q = [[0.0f64; 4]; MAX_TERMS];
    p[0] = canonical.momentum;
    q[0] = [1.0, 0.0, 0.0, 0.0];
    let mut negligible = 0;
    for k in 0..MAX_TERMS - 1 {
        for c in 0..3 {
            z[k][c] = half[c] * p[k][c];
        }
        let (mut x, mut w) = ([0.0; 3], [0.0; 4]);
        for j in 0..=k {
            let (a, b) = (p[j], p[k - j]);
            x[0] += a[1] * b[2];
            x[1] += a[2] * b[0];
            x[2] += a[0] * b[1];
            let (t, z) = (q[k - j], z[j]);
            w[0] -= t[1] * z[0] + t[2] * z[1] + t[3] * z[2];
            w[1] += t[0] * z[0] + t[2] * z[2] - t[3] * z[1];
            w[2] += t[0] * z[1] - t[1] * z[2] + t[3] * z[0];
            w[3] += t[0] * z[2] + t[1] * z[1] - t[2] * z[0];
        }
        let order = 1.0 / (k + 1) as f64;
        for c in 0..3 {
            p[k + 1][c] = rates[c] * x[c] * order;
        }
        q[k + 1] = w.map(|w| w * order);
        let largest = |v: &[f64]| v.iter().fold(0.0f64, |m, x| m.max(x.abs()));
        // One term can vanish by symmetry where the next does not; two in a row do not.
        negligible = if largest(&p[k + 1]) <= NEGLIGIBLE * size && largest(&q[k + 1]) <= NEGLIGIBLE {
            negligible + 1
        } else {
            0
        };
        if negligible == 2 {
            return Some(sum(&q[..=k + 1]));
        }
    }
    None
}

/// Sum of the terms, smallest first.
fn sum(terms: &[[f64; 4]]) -> DQuat {
    let mut s = [0.0; 4];
    for term in terms.iter().rev() {
        for (s, t) in s.iter_mut().zip(term) {
            *s += t;
        }
    }
    DQuat::from_xyzw(s[1], s[2], s[3], s[0])
}
