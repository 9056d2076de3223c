//! Blanes and Moan's composition of order 4 with six kicks: coefficients that make its error far smaller than that of
//! other compositions of that order, where drift and kick are both exact.
//!
//! `D(a1) K(b1) D(a2) K(b2) D(a3) K(b3) D(a4) K(b3) D(a3) K(b2) D(a2) K(b1) D(a1)`, D the drift and K the kick of
//! [`super::exact`]. Symmetric and symplectic; two of the stages go back in time, which is harmless for conservative
//! forces. Source: docs/REFERENCES.md, Blanes and Moan 2002, table 2, S6 of order 4.

use super::drift_kick::Stages;

/// Drifts, fractions of the step; the fourth makes their sum one.
const A: [f64; 3] = [0.0792036964311957, 0.353172906049774, -0.0420650803577195];

/// Kicks, fractions of the step; the third makes their sum one.
const B: [f64; 2] = [0.209515106613362, -0.143851773179818];

/// The composition.
pub(super) const STAGES: &Stages = &{
    let [a1, a2, a3] = A;
    let [b1, b2] = B;
    let (a4, b3) = (1.0 - 2.0 * (a1 + a2 + a3), 0.5 - (b1 + b2));
    [(a1, b1), (a2, b2), (a3, b3), (a4, b3), (a3, b2), (a2, b1), (a1, 0.0)]
};
