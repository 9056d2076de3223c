//! The state at any time within a step of [`crate::Dop853`]: a polynomial of degree 7 per component.
//!
//! The polynomials are those of `dense_polynomial`; their error over the step is of order h^8, as is that of a step;
//! value and rate at both ends are those of the step.

use crate::dense_polynomial::{COEFFICIENTS, NODES, evaluate, fraction, nested};
use crate::integrated_motion::IntegratedMotion;
use crate::state::{LINEAR_VELOCITY, QUATERNION, WIDTH};
use crate::{BodyState, RigidBody};

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

    /// The polynomials through a motion's states at eight times of the step (its ends, and between them the extrema of
    /// Chebyshev's polynomial of degree 7, whose interpolation error is near the least): for a method whose states
    /// within a step cost a step each. `sample` gives the states of all bodies at a time.
    ///
    /// # Errors
    /// Those of `sample`.
    pub fn through<E>(t0: f64, h: f64, mut sample: impl FnMut(f64) -> Result<Vec<BodyState>, E>) -> Result<Self, E> {
        let mut last: Option<Vec<f64>> = None;
        Self::through_values(t0, h, |x| {
            let mut flat: Vec<f64> = sample(t0 + x * h)?.iter().flat_map(BodyState::to_array).collect();
            if let Some(last) = &last {
                keep_signs(last, &mut flat);
            }
            last = Some(flat.clone());
            Ok(flat)
        })
    }

    /// As [`DenseStep::through`], for flat states of any meaning that are smooth over the step; `sample` gives the
    /// state at a fraction of it, in ascending order from 0 to exactly 1.
    ///
    /// # Errors
    /// Those of `sample`.
    pub fn through_values<E>(t0: f64, h: f64, mut sample: impl FnMut(f64) -> Result<Vec<f64>, E>) -> Result<Self, E> {
        let flat = NODES.iter().map(|&x| sample(x)).collect::<Result<Vec<Vec<f64>>, E>>()?;
        let count = flat.iter().map(Vec::len).min().unwrap_or(0);
        let component = |i: usize| nested(std::array::from_fn(|k| flat[k][i]));
        Ok(Self::new(t0, h, (0..count).map(component).collect()))
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

/// Turns the quaternions of a flat state to the side of those before: a rotation has two, and a path must not jump.
fn keep_signs(before: &[f64], state: &mut [f64]) {
    for (before, now) in before.as_chunks::<WIDTH>().0.iter().zip(state.as_chunks_mut::<WIDTH>().0) {
        let numbers = QUATERNION..LINEAR_VELOCITY;
        let dot: f64 = before[numbers.clone()].iter().zip(&now[numbers.clone()]).map(|(a, b)| a * b).sum();
        if dot < 0.0 {
            now[numbers].iter_mut().for_each(|number| *number = -*number);
        }
    }
}
