//! Free rotation over a short phase: one power series in the square of the time, then algebra.
//!
//! With the rates `r1 = 1/I3 - 1/I2 <= 0, r2 = 1/I1 - 1/I3 >= 0, r3 = 1/I2 - 1/I1 <= 0` Euler's equations read
//! `p1' = r1 p2 p3` and so on. `G1 = r2 p1^2 - r1 p2^2` and `G3 = r2 p3^2 - r3 p2^2` are constant, sums of positive
//! terms. Let s be the half `h/2` of the time, `A = -r1 G3, B = -r3 G1`, and S the odd solution of
//! `S'^2 = (1 - A S^2)(1 - B S^2)`, `C^2 = 1 - A S^2`, `D^2 = 1 - B S^2`: sn/lambda, cn, dn of `lambda s`, but without
//! regard to which of A and B is the larger. All of this is at s. The momentum in the middle of the time is
//!
//! ```text
//! m1 = (p1 C + r1 p2 p3 S D)/d   m2 = (p2 C D + r2 p3 p1 S)/d   m3 = (p3 D + r3 p1 p2 S C)/d   d = 1 - r1 r3 p2^2 S^2
//! ```
//!
//! by the addition theorems. Seen from there the motion is its own mirror image, and the rotation between its two ends
//! is
//!
//! ```text
//! w = Q cos(a)    z = m3 (L D sin(a) - G1 S C cos(a))      x = m1 (L C sin(a) + G3 S D cos(a))
//! Q = L^2 - k S^2 y = m2 (C (L D sin(a) - G1 S C cos(a)) - r1 S Q cos(a)),   k = G1 G3
//! a = 2T s/L + k/L^3 (r1 p3^2 - r3 p1^2) J,   J = int_0^s S^2/(1 - k S^2/L^2) ds
//! ```
//!
//! up to length: a is half the turn about L beside the shortest rotation between the two directions of the momentum,
//! whose rate `(2T/L)(...)/(...)` is a rational function of S^2. No frame is chosen, so none is singular, and with no
//! quotient by a difference of moments nothing is special about tops and spheres. `Y = S^2` obeys
//! `Y'' = 2 - 4 (A+B) Y + 6 A B Y^2`: three numbers per term. Its series converges for `|s| < (pi/2)/sqrt(max(A, B))`.
//! Errors are relative to the turn, however short. Only + - * / and square roots are used but for sin(a), cos(a).
//! Source: derived here from Euler's equations (Whittaker, 69) and the addition theorems (Abramowitz and Stegun,
//! 16.17); docs/REFERENCES.md, Jorba and Zou 2005, for the recurrences; the form of the quaternion is that of the
//! discrete mechanics of Moser and Veselov 1991.

use super::canonical::Canonical;
use crate::lanes::Lanes;
use glam::DQuat;

/// Largest phase (rad) for which the power series is taken: `lambda h/2`, by the faster of the two rates of the
/// momentum's Jacobi functions, of which a quarter period is pi/2 at least. There it costs as much as the elliptic
/// functions.
pub const TAYLOR_REACH: f64 = 0.35;

/// Room for the terms; within the reach 14 are the most that are used.
const MAX_TERMS: usize = 16;
/// Square of the ratio of successive powers at the radius of convergence, `(2/pi)^2`.
const CONVERGENCE: f64 = 0.405_284_734_569_351_1;
/// Terms are negligible below this part of the first, 2^-56: an eighth of the last bit.
const NEGLIGIBLE: f64 = 1.387_778_780_781_445_7e-17;

/// What is constant during a rotation, in canonical units.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Taylor {
    momentum: [f64; 3],
    rates: [f64; 3],
    /// G1 and G3.
    invariants: [f64; 2],
    /// A and B.
    squared_rates: [f64; 2],
    length: f64,
    length_squared: f64,
    /// `k/L^2`.
    pole: f64,
    /// `2T/L`.
    spin: f64,
    /// `k/L^3 (r1 p3^2 - r3 p1^2)`.
    twist: f64,
}

impl Taylor {
    /// Of any motion but rest.
    pub(super) fn new(canonical: &Canonical) -> Self {
        let ([i1, i2, i3], [p1, p2, p3]) = (canonical.moments, canonical.momentum);
        let (n1, n2, n3) = (1.0 / i1, 1.0 / i2, 1.0 / i3);
        // Differences of reciprocals, without the cancellation.
        let rates = [(i2 - i3) * n2 * n3, (i3 - i1) * n3 * n1, (i1 - i2) * n1 * n2];
        let [r1, r2, r3] = rates;
        let (s1, s2, s3) = (p1 * p1, p2 * p2, p3 * p3);
        let (g1, g3) = (r2 * s1 - r1 * s2, r2 * s3 - r3 * s2);
        let length_squared = s1 + s2 + s3;
        let length = length_squared.sqrt();
        let pole = g1 * g3 / length_squared;
        Self {
            momentum: canonical.momentum,
            rates,
            invariants: [g1, g3],
            squared_rates: [-r1 * g3, -r3 * g1],
            length,
            length_squared,
            pole,
            spin: (s1 * n1 + s2 * n2 + s3 * n3) / length,
            twist: pole * (r1 * s3 - r3 * s1) / length,
        }
    }

    /// Whether the series reaches over the canonical time `h`.
    pub(super) fn reaches(&self, h: f64) -> bool {
        let [a, b] = self.squared_rates;
        0.25 * h * h * a.max(b) <= TAYLOR_REACH * TAYLOR_REACH
    }

    /// Rotation from the axes after the canonical time `h`, within the reach, to those at the start; of any length.
    pub(super) fn relative(&self, h: f64) -> DQuat {
        let [relative] = Self::relative_lanes([self], [h]);
        relative
    }

    /// [`Taylor::relative`] in each lane.
    #[inline]
    pub(super) fn relative_lanes<const N: usize>(own: [&Self; N], h: [f64; N]) -> [DQuat; N] {
        let time = 0.5 * Lanes(h);
        let [a, b] = [0, 1].map(|k| Lanes::of(|i| own[i].squared_rates[k]));
        let pole = Lanes::of(|i| own[i].pole);
        let (square, integral) = series([a, b], pole, time * time);
        let s = time * square.sqrt();
        let s2 = s * s;
        let (c, d) = ((1.0 - a * s2).sqrt(), (1.0 - b * s2).sqrt());
        let half_turn =
            Lanes::of(|i| own[i].spin) * time + Lanes::of(|i| own[i].twist) * (time * time * time) * integral;
        let turns: [(f64, f64); N] = std::array::from_fn(|i| libm::sincos(half_turn.0[i]));
        let (sine, cosine) = (Lanes::of(|i| turns[i].0), Lanes::of(|i| turns[i].1));
        let [p1, p2, p3] = [0, 1, 2].map(|k| Lanes::of(|i| own[i].momentum[k]));
        let [r1, r2, r3] = [0, 1, 2].map(|k| Lanes::of(|i| own[i].rates[k]));
        let [g1, g3] = [0, 1].map(|k| Lanes::of(|i| own[i].invariants[k]));
        // The momentum in the middle, times its denominator.
        let m1 = p1 * c + r1 * p2 * p3 * (s * d);
        let m2 = p2 * (c * d) + r2 * p3 * p1 * s;
        let m3 = p3 * d + r3 * p1 * p2 * (s * c);
        let denominator = 1.0 - r1 * r3 * (p2 * p2) * s2;
        let q = Lanes::of(|i| own[i].length_squared) * (1.0 - pole * s2) * cosine;
        let l = Lanes::of(|i| own[i].length) * sine;
        let tilt = l * d - g1 * (s * c) * cosine;
        let x = m1 * (l * c + g3 * (s * d) * cosine);
        let y = m2 * (c * tilt - r1 * s * q);
        let (z, w) = (m3 * tilt, q * denominator);
        std::array::from_fn(|i| DQuat::from_xyzw(x.0[i], y.0[i], z.0[i], w.0[i]))
    }
}

/// `S^2/s^2` and `J/s^3` at the time whose square is given, from A and B and `k/L^2`.
#[inline(never)]
fn series<const N: usize>(
    squared_rates: [Lanes<N>; 2],
    pole: Lanes<N>,
    time_squared: Lanes<N>,
) -> (Lanes<N>, Lanes<N>) {
    let [a, b] = squared_rates.map(|rate| rate * time_squared);
    let (linear, quadratic, pole) = (-4.0 * (a + b), 6.0 * a * b, pole * time_squared);
    let ratio = CONVERGENCE * a.max(b);
    // Coefficients of S^2 and of the integrand.
    let zero = Lanes::splat(0.0);
    let mut terms = [[zero; 2]; MAX_TERMS];
    terms[0] = [Lanes::splat(1.0); 2];
    let (mut square, mut integral, mut squares) = (zero, zero, zero);
    // The n-th term is at most n times this power: the double pole at the radius of convergence.
    let mut power = ratio;
    let mut counts = [true; N];
    for n in 1..MAX_TERMS {
        for (counts, power) in counts.iter_mut().zip(power.0) {
            let is_negligible = power * (n + 1) as f64 <= NEGLIGIBLE;
            *counts &= !is_negligible;
        }
        if counts == [false; N] {
            break;
        }
        let y = (linear * terms[n - 1][0] + quadratic * squares) * STEP[n];
        let product;
        [squares, product] = convolutions(&terms[..n]);
        let z = y + pole * product;
        terms[n] = [y, z];
        square = (square + y).where_or(counts, square);
        integral = (integral + z * ODD[n]).where_or(counts, integral);
        power = power * ratio;
    }
    (1.0 + square, ODD[0] + integral)
}

/// `sum_j y[j] y[n-1-j]` and `sum_j y[j] z[n-1-j]`.
#[inline]
fn convolutions<const N: usize>(terms: &[[Lanes<N>; 2]]) -> [Lanes<N>; 2] {
    let mut sums = [Lanes::splat(0.0); 2];
    for (a, b) in terms.iter().zip(terms.iter().rev()) {
        sums[0] = sums[0] + a[0] * b[0];
        sums[1] = sums[1] + a[0] * b[1];
    }
    sums
}

/// `1/((2n + 1)(2n + 2))`.
const STEP: [f64; MAX_TERMS] = {
    let mut table = [0.0; MAX_TERMS];
    let mut n = 0;
    while n < MAX_TERMS {
        table[n] = 1.0 / ((2 * n + 1) * (2 * n + 2)) as f64;
        n += 1;
    }
    table
};

/// `1/(2n + 3)`.
const ODD: [f64; MAX_TERMS] = {
    let mut table = [0.0; MAX_TERMS];
    let mut n = 0;
    while n < MAX_TERMS {
        table[n] = 1.0 / (2 * n + 3) as f64;
        n += 1;
    }
    table
};
