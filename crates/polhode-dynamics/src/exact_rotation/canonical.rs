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
// In this order: what an evaluation reads stands together, at the front.
#[repr(C)]
pub(super) struct Canonical {
    /// Canonical time per second.
    pub(super) time_scale: f64,
    /// Sign of the third axis: -1 for an odd permutation.
    third: f64,
    /// Which of the given axes each canonical axis is.
    order: [u8; 3],
    /// Angular momentum along the canonical axes, its largest component in [1, 2) but at the very ends of the range of
    /// doubles, or all zero.
    pub(super) momentum: [f64; 3],
    /// Principal moments, ascending, the largest likewise.
    pub(super) moments: [f64; 3],
}

impl Canonical {
    /// Of `moments` (kg m^2, any order) and the momentum along the same axes (kg m^2/s).
    pub(super) fn new(moments: DVec3, momentum: DVec3) -> Self {
        let mut axes = [(moments.x, momentum.x, 0), (moments.y, momentum.y, 1), (moments.z, momentum.z, 2)];
        let mut third = 1.0;
        for (i, j) in [(0, 1), (1, 2), (0, 1)] {
            if axes[i].0 > axes[j].0 {
                axes.swap(i, j);
                third = -third;
            }
        }
        let [(i1, p1, first), (i2, p2, second), (i3, p3, last)] = axes;
        let (by_inertia, by_momentum) = (normalizer(i3), normalizer(momentum.abs().max_element()));
        let scaled = |p: f64| {
            let p = p * by_momentum;
            if p.abs() < NEGLIGIBLE { 0.0 } else { p }
        };
        Self {
            moments: [i1 * by_inertia, i2 * by_inertia, i3 * by_inertia],
            momentum: [scaled(p1), scaled(p2), scaled(p3) * third],
            time_scale: by_inertia / by_momentum,
            order: [first, second, last],
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

    /// `|L|/I1`: the angular speed if all momentum were about the axis of the smallest moment.
    pub(super) fn largest_rate(&self) -> f64 {
        DVec3::from_array(self.momentum).length() / self.moments[0]
    }

    /// A rotation given in canonical axes, in the axes as they were given.
    pub(super) fn restore(&self, q: DQuat) -> DQuat {
        let v = [q.x, q.y, q.z * self.third];
        let mut restored = [0.0; 3];
        for (k, component) in self.order.into_iter().zip(v) {
            restored[usize::from(k)] = component;
        }
        DQuat::from_xyzw(restored[0], restored[1], restored[2], q.w)
    }
}

/// The power of two that brings `|x|` into [1, 2), or as near to it as a power of two that is a normal number can.
fn normalizer(x: f64) -> f64 {
    /// Biased exponents of the smallest normal number and of the largest whose reciprocal is normal.
    const EXPONENTS: (u64, u64) = (1, 2045);
    let exponent = (x.to_bits() >> 52) & 0x7ff;
    f64::from_bits((EXPONENTS.0 + EXPONENTS.1 - exponent.clamp(EXPONENTS.0, EXPONENTS.1)) << 52)
}
