//! The implicit midpoint rule on a group with its springs: `y_m = y_0 + h/2 f(y_m)`, `y_1 = 2 y_m - y_0`.
//!
//! It is stable however stiff a spring is. The equation is solved by Newton's method, with a matrix of differences that
//! is made anew when the iteration slows; where it does not converge the step is halved, and both halves are made in
//! turn. The ledgers are integrated by the same rule. Source: docs/REFERENCES.md, Hairer, Norsett and Wanner, II.7.
//! The matrix is dense: 13 numbers for each body and 3 for each spring, factorised in their cube. More than
//! [`MOST_BODIES`] that may meet are refused: [`SimulationError::ImplicitTooLarge`].
//! How it fails: a force that no midpoint satisfies leaves no step above [`SMALLEST_PART`] of that asked:
//! [`SimulationError::StepTooSmall`].

use super::contact::{Grip, SPRING};
use super::laws::Laws;
use super::system::SpringSystem;
use crate::error::SimulationError;
use polhode_dynamics::state::{ANGULAR_MOMENTUM, LINEAR_VELOCITY, POSITION, QUATERNION, WIDTH};
use polhode_dynamics::{RigidBody, System};

/// Most bodies of a group (32 to 128): with two springs each a factorisation is of 1200 rows, half a second.
const MOST_BODIES: usize = 64;

/// The shortest part of a step that is tried.
const SMALLEST_PART: f64 = 1.0 / 1024.0;

/// Iterations of Newton's method (10 to 50).
const ITERATIONS: u32 = 30;

/// A change of all numbers below this part of their scales ends the iteration (1e-13 to 1e-9).
const NEWTON_CONVERGED: f64 = 1e-11;

/// A step of a difference, relative to the scale of its number (1e-8 to 1e-5).
const STATE_DIFFERENCE: f64 = 1e-6;

/// An iteration that reduces changes by less makes its matrix anew (0.05 to 0.5).
const SLOW_NEWTON: f64 = 0.1;

/// Advances a flat state over `h` from `t` (s).
///
/// # Errors
/// When there are too many bodies, or Newton's method does not converge in a small part of the step either.
pub(super) fn step(
    system: &mut SpringSystem<'_>,
    laws: &Laws,
    (t, h): (f64, f64),
    state: &mut [f64],
) -> Result<(), SimulationError> {
    let bodies = system.bodies.len();
    if bodies > MOST_BODIES {
        return Err(SimulationError::ImplicitTooLarge { t_s: t, bodies, limit: MOST_BODIES });
    }
    let (mut made, mut part) = (0.0, 1.0);
    while made < 1.0 {
        if midpoint(system, laws, (t + made * h, part * h), state) {
            made += part;
            continue;
        }
        part *= 0.5;
        if part < SMALLEST_PART {
            let (t_s, smallest_s) = (t + made * h, SMALLEST_PART * h);
            return Err(SimulationError::StepTooSmall { t_s, smallest_s, bodies: Vec::new() });
        }
    }
    Ok(())
}

/// One step by the rule; whether the iteration converged. Otherwise the state is left as it was.
fn midpoint(system: &mut SpringSystem<'_>, laws: &Laws, (t, h): (f64, f64), state: &mut [f64]) -> bool {
    let unknowns = system.bodies.len() * WIDTH + system.springs.len() * SPRING;
    let scales = scales(system, laws, &state[..unknowns]);
    let middle_time = t + 0.5 * h;
    let mut rates = vec![0.0; state.len()];
    let mut middle = state.to_vec();
    let mut residual = |system: &mut SpringSystem<'_>, middle: &[f64], out: &mut [f64]| {
        let Ok(()) = system.derivative(middle_time, middle, &mut rates);
        for i in 0..unknowns {
            out[i] = middle[i] - state[i] - 0.5 * h * rates[i];
        }
    };
    let mut factors: Option<Factors> = None;
    let mut last = f64::INFINITY;
    let (mut own, mut other) = (vec![0.0; unknowns], vec![0.0; unknowns]);
    let mut converged = false;
    for _ in 0..ITERATIONS {
        residual(system, &middle, &mut own);
        if factors.is_none() {
            let mut matrix = vec![0.0; unknowns * unknowns];
            for column in 0..unknowns {
                let (kept, change) = (middle[column], STATE_DIFFERENCE * scales[column]);
                middle[column] = kept + change;
                residual(system, &middle, &mut other);
                middle[column] = kept;
                for row in 0..unknowns {
                    matrix[row * unknowns + column] = (other[row] - own[row]) / change;
                }
            }
            factors = Factors::of(matrix, unknowns);
        }
        let Some(known) = &factors else { return false };
        known.solve(&mut own);
        let mut largest = 0.0f64;
        for ((number, change), scale) in middle.iter_mut().zip(&own).zip(&scales) {
            *number -= change;
            let relative = change.abs() / scale;
            largest = if relative > largest || relative.is_nan() { relative } else { largest };
        }
        if largest <= NEWTON_CONVERGED {
            converged = true;
            break;
        }
        if !largest.is_finite() {
            return false;
        }
        if largest > SLOW_NEWTON * last {
            factors = None;
        }
        last = largest;
    }
    if !converged {
        return false;
    }
    let mut rates = vec![0.0; state.len()];
    let Ok(()) = system.derivative(middle_time, &middle, &mut rates);
    for (number, rate) in state.iter_mut().zip(&rates) {
        *number += h * rate;
    }
    system.normalize(state);
    true
}

/// A scale for every unknown: by how much it changes in a contact.
fn scales(system: &SpringSystem<'_>, laws: &Laws, state: &[f64]) -> Vec<f64> {
    let mut scales = vec![1.0; state.len()];
    let resting = laws.resting_speed(system.model).max(laws.speed);
    for (index, &body) in system.bodies.iter().enumerate() {
        let size = system.model.bodies[body].size.max(laws.depth_m);
        let moment =
            system.model.bodies[body].rigid.as_ref().map_or(1.0, |rigid: &RigidBody| rigid.moments().max_element());
        let speed = if resting > 0.0 { resting } else { 1.0 };
        let own = &mut scales[index * WIDTH..(index + 1) * WIDTH];
        own[POSITION..QUATERNION].fill(laws.depth_m);
        own[QUATERNION..LINEAR_VELOCITY].fill(laws.depth_m / size);
        own[LINEAR_VELOCITY..ANGULAR_MOMENTUM].fill(speed);
        own[ANGULAR_MOMENTUM..].fill(speed * moment / size);
    }
    let first = system.bodies.len() * WIDTH;
    for (spring, own) in system.springs.iter().zip(scales[first..].chunks_mut(SPRING)) {
        let force = spring.normal.elastic_force(laws.depth_m);
        own.fill(if spring.grip == Grip::Free { 1.0 } else { force });
    }
    scales
}

/// A square matrix, factorised by rows with pivots.
#[derive(Debug)]
struct Factors {
    size: usize,
    numbers: Vec<f64>,
    order: Vec<usize>,
}

impl Factors {
    /// None of a singular matrix.
    fn of(mut numbers: Vec<f64>, size: usize) -> Option<Self> {
        let mut order: Vec<usize> = (0..size).collect();
        for column in 0..size {
            let weight = |row: &usize| numbers[row * size + column].abs();
            let pivot = (column..size).max_by(|x, y| weight(x).total_cmp(&weight(y)))?;
            let value = numbers[pivot * size + column];
            if !(value.is_finite() && value != 0.0) {
                return None;
            }
            if pivot != column {
                (0..size).for_each(|k| numbers.swap(pivot * size + k, column * size + k));
                order.swap(pivot, column);
            }
            for row in column + 1..size {
                let factor = numbers[row * size + column] / value;
                numbers[row * size + column] = factor;
                if factor != 0.0 {
                    for k in column + 1..size {
                        numbers[row * size + k] -= factor * numbers[column * size + k];
                    }
                }
            }
        }
        Some(Self { size, numbers, order })
    }

    /// Replaces a right-hand side by the solution.
    fn solve(&self, right: &mut [f64]) {
        let n = self.size;
        let mut x: Vec<f64> = self.order.iter().map(|&row| right[row]).collect();
        for row in 0..n {
            let sum: f64 = (0..row).map(|k| self.numbers[row * n + k] * x[k]).sum();
            x[row] -= sum;
        }
        for row in (0..n).rev() {
            let sum: f64 = (row + 1..n).map(|k| self.numbers[row * n + k] * x[k]).sum();
            x[row] = (x[row] - sum) / self.numbers[row * n + row];
        }
        right[..n].copy_from_slice(&x);
    }
}
