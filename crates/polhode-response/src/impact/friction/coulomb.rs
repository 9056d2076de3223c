//! Coulomb's law at one contact, as rates in the normal impulse.
//!
//! While the contact slips in the direction `d`, the impulse grows by `(1, -mu d)` with the normal impulse `p_n`. With
//! `k = K_tn`, and the slip `u_t = r d`:
//!
//! - `du_n/dp_n = a(d) = K_nn - mu k.d`: negative where the contact jams (Painleve);
//! - `dr/dp_n = g(d) = k.d - mu d.K_tt d`;
//! - `r d(direction)/dp_n = h(d) = k.d' - mu d'.K_tt d` with `d'` = `d` turned by a quarter: zero where the direction
//!   of slip stays.
//!
//! A contact that sticks feels the impulse `(1, q)` with `q = -K_tt^-1 k`, which keeps `u_t = 0`; Coulomb's law allows
//! it if and only if `|q| <= mu`. If not, it slips at once along the one direction that leads away from zero slip:
//! `k - mu K_tt d = lambda d` with `lambda > 0`. On the way from there, and while it sticks, `u_n` rises: a jam always
//! ends.
//!
//! Source: Routh 1905; Keller 1986; Bhatt and Koechling 1995 (the one direction).

use super::collision_matrix::CollisionMatrix;
use super::plane::{self, Tangent};
use super::root::rising_zero;
use polhode_spatial::rounding;

/// Coulomb's law with its coefficient at a contact.
#[derive(Debug, Clone, Copy)]
pub(super) struct Coulomb {
    pub(super) matrix: CollisionMatrix,
    /// Coefficient of friction (no unit).
    pub(super) friction: f64,
}

impl Coulomb {
    /// `a(d)`: rate of the normal velocity.
    pub(super) fn normal_rate(&self, d: Tangent) -> f64 {
        self.matrix.normal - self.friction * plane::dot(self.matrix.coupling, d)
    }

    /// The terms of `a(d)`, in magnitude.
    pub(super) fn normal_rate_terms(&self) -> f64 {
        self.matrix.normal + self.friction * plane::length(self.matrix.coupling)
    }

    /// `g(d)`: rate of the speed of slip.
    pub(super) fn speed_rate(&self, d: Tangent) -> f64 {
        plane::dot(d, self.tangential_pull(d))
    }

    /// `h(d)`: speed of slip times the rate at which its direction turns; 0 where it is rounding.
    pub(super) fn turning(&self, d: Tangent) -> f64 {
        let turning = plane::dot(plane::quarter_turn(d), self.tangential_pull(d));
        // What the entries of the matrix are rounded by is of the size of the largest one.
        let terms = self.slip_rate_terms() + self.matrix.normal;
        if turning.abs() <= rounding::FEW_TERMS * terms { 0.0 } else { turning }
    }

    /// What a unit of normal impulse and its friction do to the slip: `k - mu K_tt d`.
    fn tangential_pull(&self, d: Tangent) -> Tangent {
        plane::sum(self.matrix.coupling, plane::scaled(plane::times(self.matrix.tangential, d), -self.friction))
    }

    /// The terms of `g(d)` and `h(d)`, in magnitude.
    pub(super) fn slip_rate_terms(&self) -> f64 {
        let [t11, _, t22] = self.matrix.tangential;
        plane::length(self.matrix.coupling) + self.friction * (t11 + t22)
    }

    /// What the contact does from zero slip on.
    pub(super) fn leaving_zero_slip(&self) -> ZeroSlip {
        let stick = plane::scaled(self.matrix.solve_tangential(self.matrix.coupling), -1.0);
        if plane::length(stick) <= self.friction {
            let rate = self.matrix.normal + plane::dot(self.matrix.coupling, stick);
            let normal_rate = if rate <= rounding::HUNDREDS_OF_TERMS * self.matrix.normal { 0.0 } else { rate };
            return ZeroSlip::Sticks { ratio: stick, normal_rate };
        }
        ZeroSlip::Slips(self.direction_away())
    }

    /// The direction `d` with `(mu K_tt + lambda) d = k` and `lambda > 0`.
    ///
    /// `1 / |(mu K_tt + lambda)^-1 k| - 1` rises with `lambda` from below zero, where the contact does not stick, to
    /// above it at `lambda = |k|`, and is nearly straight.
    fn direction_away(&self) -> Tangent {
        let k = self.matrix.coupling;
        let [t11, t12, t22] = self.matrix.tangential.map(|entry| self.friction * entry);
        let at = |lambda: f64, right: Tangent| plane::solve([t11 + lambda, t12, t22 + lambda], right, 0.0);
        let secular = |lambda: f64| {
            let y = at(lambda, k);
            let size = plane::length(y);
            (1.0 / size - 1.0, plane::dot(y, at(lambda, y)) / (size * size * size))
        };
        let lambda = rising_zero(secular, 0.0, plane::length(k));
        plane::direction(at(lambda, k)).unwrap_or([1.0, 0.0])
    }
}

/// What a contact does from zero slip on.
#[derive(Debug, Clone, Copy)]
pub(super) enum ZeroSlip {
    /// It sticks.
    Sticks {
        /// Tangential impulse over normal impulse.
        ratio: Tangent,
        /// `du_n/dp_n`, 1/kg: positive, or zero where the matrix is singular.
        normal_rate: f64,
    },
    /// It slips in this direction, which stays.
    Slips(Tangent),
}
