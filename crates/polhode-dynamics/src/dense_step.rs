//! The state at any time within a step of [`crate::Dop853`]: a polynomial of degree 7 per component.
//!
//! `y(x) = y0 + x (F0 + (1-x) (F1 + x (F2 + (1-x) (F3 + x (F4 + (1-x) (F5 + x F6))))))` with `x = (t - t0)/h`; its error
//! over the step is of order h^8, as is that of a step; value and rate at both ends are those of the
//! step. Source: docs/REFERENCES.md, Hairer, Norsett and Wanner, II.6, dop853.f (contd8).

use crate::integrated_motion::IntegratedMotion;
use crate::state::{LINEAR_VELOCITY, QUATERNION, WIDTH};
use crate::{BodyState, RigidBody};

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

    /// The polynomials through a motion's states at eight times of the step (its ends, and between them the extrema of
    /// Chebyshev's polynomial of degree 7, whose interpolation error is near the least): for a method whose states within
    /// a step cost a step each. `sample` gives the states of all bodies at a time.
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

    /// As [`DenseStep::through`], for flat states of any meaning that are smooth over the step; `sample` gives the state at a
    /// fraction of it, in ascending order from 0 to exactly 1.
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

/// Where the states are sampled, as fractions of the step: `(1 - cos(k pi/7))/2`.
const NODES: [f64; COEFFICIENTS] = [
    0.0,
    0.049_515_566_048_790_43,
    0.188_255_099_070_633_2,
    0.388_739_533_021_842_8,
    0.611_260_466_978_157_2,
    0.811_744_900_929_366_7,
    0.950_484_433_951_209_5,
    1.0,
];

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

/// Coefficients of the nest through values at [`NODES`]: Newton's form with the nodes 0, 1, 0, 1, ... of the nest, by
/// elimination on the values of its products.
fn nested(values: [f64; COEFFICIENTS]) -> [f64; COEFFICIENTS] {
    let mut rows = NODES.map(|x| {
        let mut product = 1.0;
        let mut row = [1.0; COEFFICIENTS];
        for k in 1..COEFFICIENTS {
            product *= if k % 2 == 1 { x } else { 1.0 - x };
            row[k] = product;
        }
        row
    });
    // The rows at both ends are units but for the first two columns: they give the value and the change.
    let change = values[COEFFICIENTS - 1] - values[0];
    let mut right: [f64; COEFFICIENTS] = std::array::from_fn(|k| values[k] - values[0] - NODES[k] * change);
    for column in 2..COEFFICIENTS {
        let inner = column - 1..COEFFICIENTS - 1;
        let pivot = inner.clone().max_by(|&i, &j| rows[i][column].abs().total_cmp(&rows[j][column].abs()));
        let Some(pivot) = pivot else { continue };
        rows.swap(column - 1, pivot);
        right.swap(column - 1, pivot);
        for i in column..COEFFICIENTS - 1 {
            let factor = rows[i][column] / rows[column - 1][column];
            for k in column..COEFFICIENTS {
                rows[i][k] -= factor * rows[column - 1][k];
            }
            right[i] -= factor * right[column - 1];
        }
    }
    let mut f = [values[0], change, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0];
    for column in (2..COEFFICIENTS).rev() {
        let known: f64 = (column + 1..COEFFICIENTS).map(|k| rows[column - 1][k] * f[k]).sum();
        f[column] = (right[column - 1] - known) / rows[column - 1][column];
    }
    f
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
