//! The state at any time within a step of [`crate::Dop853`]: a polynomial of degree 7 per component.
//!
//! `y(x) = y0 + x (F0 + (1-x) (F1 + x (F2 + (1-x) (F3 + x (F4 + (1-x) (F5 + x F6))))))` with `x = (t - t0)/h`; its error
//! over the step is of order h^8, as is that of a step; value and rate at both ends are those of the
//! step. Source: docs/REFERENCES.md, Hairer, Norsett and Wanner, II.6, dop853.f (contd8).

use crate::RigidBody;
use crate::integrated_motion::IntegratedMotion;
use crate::state::WIDTH;

/// Coefficients per component: y0, F0 ... F6.
pub(crate) const COEFFICIENTS: usize = 8;

/// The polynomials of one step.
#[derive(Debug, Clone, PartialEq)]
pub struct DenseStep {
    t0: f64,
    h: f64,
    coefficients: Vec<[f64; COEFFICIENTS]>,
}

impl DenseStep {
    pub(crate) const fn new(t0: f64, h: f64, coefficients: Vec<[f64; COEFFICIENTS]>) -> Self {
        Self { t0, h, coefficients }
    }

    /// Time at the start of the step, s.
    pub const fn t0(&self) -> f64 {
        self.t0
    }

    /// Length of the step, s.
    pub const fn h(&self) -> f64 {
        self.h
    }

    /// Length of the state.
    pub fn dimension(&self) -> usize {
        self.coefficients.len()
    }

    /// Writes the state at `t` (s). Meant for times of the step; outside it the polynomial goes on and soon means
    /// nothing. At the end of the step the value is that of [`crate::Dop853::end_state`] to the last bit or two.
    /// Components beyond the shorter of state and slice are left alone.
    pub fn evaluate(&self, t: f64, state: &mut [f64]) {
        let x = fraction(self.t0, self.h, t);
        for (y, f) in state.iter_mut().zip(&self.coefficients) {
            *y = evaluate(f, x);
        }
    }

    /// Motion over the step of the body whose state begins at `offset`; nothing when the state ends before it does.
    pub fn body_motion(&self, offset: usize, body: &RigidBody) -> Option<IntegratedMotion> {
        let components = self.coefficients.get(offset..)?.first_chunk::<WIDTH>()?;
        Some(IntegratedMotion::new(self.t0, self.h, components, body))
    }
}

/// Where in the step the time lies: 0 at its start, 1 at its end. A step of length zero is all start.
pub(crate) fn fraction(t0: f64, h: f64, t: f64) -> f64 {
    if h == 0.0 { 0.0 } else { (t - t0) / h }
}

/// One component at `x`.
pub(crate) fn evaluate(f: &[f64; COEFFICIENTS], x: f64) -> f64 {
    let mut y = 0.0;
    for (i, coefficient) in f[1..].iter().rev().enumerate() {
        y += coefficient;
        y *= if i % 2 == 0 { x } else { 1.0 - x };
    }
    f[0] + y
}

/// Coefficients of one component in powers of its distance from `x`.
pub(crate) fn expand(f: &[f64; COEFFICIENTS], x: f64) -> [f64; COEFFICIENTS] {
    let mut y = [0.0; COEFFICIENTS];
    for (i, coefficient) in f[1..].iter().rev().enumerate() {
        y[0] += coefficient;
        // The next factor of the nest is x + s or 1 - x - s, s the distance.
        let (constant, slope) = if i % 2 == 0 { (x, 1.0) } else { (1.0 - x, -1.0) };
        for k in (1..COEFFICIENTS).rev() {
            y[k] = constant * y[k] + slope * y[k - 1];
        }
        y[0] *= constant;
    }
    y[0] += f[0];
    y
}
