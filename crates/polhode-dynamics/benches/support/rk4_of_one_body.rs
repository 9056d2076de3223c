//! RK4 of one free body, written by hand on (q, L): the yardstick of the exact drift's cost.
//!
//! `q' = q (0, I^-1 R^T L)/2` in principal axes with L constant, normalised after the step as the thesis does. Nothing
//! is generic or allocated: four evaluations of 60 operations and their sums are all there is.

use glam::{DQuat, DVec3};

/// The attitude after the step `h`.
#[inline(never)]
pub(crate) fn step(inverse_moments: DVec3, q: DQuat, momentum: DVec3, h: f64) -> DQuat {
    let rate = |q: DQuat| {
        let u = DVec3::new(q.x, q.y, q.z);
        let t = 2.0 * momentum.cross(u);
        let w = (momentum + q.w * t + t.cross(u)) * inverse_moments * 0.5;
        let v = q.w * w + u.cross(w);
        DQuat::from_xyzw(v.x, v.y, v.z, -u.dot(w))
    };
    let k1 = rate(q);
    let k2 = rate(q + k1 * (0.5 * h));
    let k3 = rate(q + k2 * (0.5 * h));
    let k4 = rate(q + k3 * h);
    let q = q + (k1 + (k2 + k3) * 2.0 + k4) * (h / 6.0);
    q * (1.0 / q.length())
}
