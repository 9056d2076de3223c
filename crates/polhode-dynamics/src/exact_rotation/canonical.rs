//! The canonical form of a free rotation: moments ascending, both moments and momentum near one.
//!
//! Axes are permuted so that `I1 <= I2 <= I3`; an odd permutation also turns the third axis round, so that they stay
//! right-handed. Moments and momentum are scaled by powers of two, which are exact: a division would round, and near
//! the separatrix the motion amplifies what is lost there by exp(lambda t).

use glam::{DQuat, DVec3};

/// A component of the momentum below this part of the whole counts as zero: its square would underflow. Such a
/// deviation from an unstable axis takes 345 e-folding times to be seen.
const NEGLIGIBLE: f64 = 1e-150;

/// Moments and momentum in principal axes at one time, in canonical form.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Canonical {
    /// Principal moments, ascending, the largest in [1, 2).
    pub(super) moments: [f64; 3],
    /// Angular momentum along those axes, its largest component in [1, 2) or all zero.
    pub(super) momentum: [f64; 3],
    /// Canonical time per second.
    pub(super) time_scale: f64,
    /// Which of the given axes each canonical axis is.
    order: [usize; 3],
    /// Sign of the third axis: -1 for an odd permutation.
    third: f64,
}

impl Canonical {
    /// Of `moments` (kg m^2, any order) and the momentum along the same axes (kg m^2/s).
    pub(super) fn new(moments: DVec3, momentum: DVec3) -> Self {
        let mut order = [0, 1, 2];
        for (i, j) in [(0, 1), (1, 2), (0, 1)] {
            if moments[order[i]] > moments[order[j]] {
                order.swap(i, j);
            }
        }
        let third = if (order[0] + 1) % 3 == order[1] { 1.0 } else { -1.0 };
        let inertia_exponent = exponent(moments[order[2]]);
        let momentum_exponent = exponent(momentum.abs().max_element());
        let p = order.map(|k| libm::scalbn(momentum[k], -momentum_exponent));
        let p = p.map(|p| if p.abs() < NEGLIGIBLE { 0.0 } else { p });
        Self {
            moments: order.map(|k| libm::scalbn(moments[k], -inertia_exponent)),
            momentum: [p[0], p[1], p[2] * third],
            time_scale: libm::scalbn(1.0, momentum_exponent - inertia_exponent),
            order,
            third,
        }
    }

    /// Whether all rates of Euler's equations are exactly zero: a sphere, a principal axis, the equator of a
    /// symmetric body, no rotation.
    pub(super) fn is_steady(&self) -> bool {
        let ([i1, i2, i3], [p1, p2, p3]) = (self.moments, self.momentum);
        (i1 == i2 || p1 == 0.0 || p2 == 0.0)
            && (i2 == i3 || p2 == 0.0 || p3 == 0.0)
            && (i1 == i3 || p1 == 0.0 || p3 == 0.0)
    }

    /// Angular velocity along the canonical axes, per canonical time.
    pub(super) fn angular_velocity(&self) -> DVec3 {
        DVec3::from_array(self.momentum) / DVec3::from_array(self.moments)
    }

    /// Upper bound, per canonical time, of the angular speed at any time: `min(|L|, sqrt(2 T I1)) / I1`.
    pub(super) fn fastest(&self) -> f64 {
        let by_energy = DVec3::from_array(self.momentum).dot(self.angular_velocity()) / self.moments[0];
        by_energy.sqrt().min(self.largest_rate())
    }

    /// `|L|/I1`: the angular speed if all momentum were about the axis of the smallest moment.
    pub(super) fn largest_rate(&self) -> f64 {
        DVec3::from_array(self.momentum).length() / self.moments[0]
    }

    /// A rotation given in canonical axes, in the axes as they were given.
    pub(super) fn restore(&self, q: DQuat) -> DQuat {
        let v = [q.x, q.y, q.z * self.third];
        let mut restored = [0.0; 3];
        for (k, component) in self.order.into_iter().zip(v) {
            restored[k] = component;
        }
        DQuat::from_xyzw(restored[0], restored[1], restored[2], q.w)
    }
}

/// Binary exponent e with `2^e <= |x| < 2^(e+1)`; 0 for zero and what is not finite.
fn exponent(x: f64) -> i32 {
    if x.is_finite() && x != 0.0 { libm::ilogb(x) } else { 0 }
}
