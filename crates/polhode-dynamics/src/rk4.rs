//! The classical Runge-Kutta method of order 4: the thesis's integrator (3.3, "Simulating Motion when in Free Fall").
//!
//! `k1 = f(t, y), k2 = f(t + h/2, y + h k1/2), k3 = f(t + h/2, y + h k2/2), k4 = f(t + h, y + h k3)`,
//! `y + h (k1 + 2 k2 + 2 k3 + k4)/6`. Fixed step, no error estimate; the error of a smooth motion over a fixed time is
//! of order h^4. Source: docs/REFERENCES.md, Hairer, Norsett and Wanner, II.1.

use crate::System;

/// The method with its buffers, which are reused from step to step.
#[derive(Debug, Clone, Default)]
pub struct Rk4 {
    rates: Vec<f64>,
    sum: Vec<f64>,
    stage: Vec<f64>,
}

/// One step without buffers of its own; see [`Rk4::step`].
///
/// # Errors
/// The system's own, with the state unchanged.
pub fn step<S: System>(system: &mut S, t: f64, h: f64, state: &mut [f64]) -> Result<(), S::Error> {
    Rk4::new(state.len()).step(system, t, h, state)
}

impl Rk4 {
    /// For states of `dimension` numbers.
    pub fn new(dimension: usize) -> Self {
        Self { rates: vec![0.0; dimension], sum: vec![0.0; dimension], stage: vec![0.0; dimension] }
    }

    /// Advances `state` from `t` to `t + h` (s; negative goes back) and normalises it by [`System::normalize`].
    ///
    /// # Errors
    /// The system's own, with the state unchanged.
    pub fn step<S: System>(&mut self, system: &mut S, t: f64, h: f64, state: &mut [f64]) -> Result<(), S::Error> {
        for buffer in [&mut self.rates, &mut self.sum, &mut self.stage] {
            buffer.resize(state.len(), 0.0);
        }
        system.derivative(t, state, &mut self.rates)?;
        self.sum.copy_from_slice(&self.rates);
        for (time, reach, weight) in [(t + 0.5 * h, 0.5 * h, 2.0), (t + 0.5 * h, 0.5 * h, 2.0), (t + h, h, 1.0)] {
            for ((stage, y), k) in self.stage.iter_mut().zip(&*state).zip(&self.rates) {
                *stage = y + reach * k;
            }
            system.derivative(time, &self.stage, &mut self.rates)?;
            for (sum, k) in self.sum.iter_mut().zip(&self.rates) {
                *sum += weight * k;
            }
        }
        for (y, sum) in state.iter_mut().zip(&self.sum) {
            *y += h / 6.0 * sum;
        }
        system.normalize(state);
        Ok(())
    }
}
