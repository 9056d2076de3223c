//! Blanes and Moan's composition of order 4 with six kicks: coefficients that make its error far smaller than that of
//! other compositions of that order, where drift and kick are both exact.
//!
//! `D(a1) K(b1) D(a2) K(b2) D(a3) K(b3) D(a4) K(b3) D(a3) K(b2) D(a2) K(b1) D(a1)`, D the drift and K the kick of
//! [`super::exact`]. Symmetric and symplectic; two of the stages go back in time, which is harmless for conservative
//! forces. Source: docs/REFERENCES.md, Blanes and Moan 2002, table 2, S6 of order 4.

use super::drift_kick::Stages;

/// Drifts, fractions of the step; the fourth makes their sum one.
const A1: f64 = 0.0792036964311957;
const A2: f64 = 0.353172906049774;
const A3: f64 = -0.0420650803577195;
const A4: f64 = 1.0 - 2.0 * (A1 + A2 + A3);

/// Kicks, fractions of the step; the third makes their sum one.
const B1: f64 = 0.209515106613362;
const B2: f64 = -0.143851773179818;
const B3: f64 = 0.5 - (B1 + B2);

/// The composition.
pub(super) const STAGES: &Stages = &[(A1, B1), (A2, B2), (A3, B3), (A4, B3), (A3, B2), (A2, B1), (A1, 0.0)];
