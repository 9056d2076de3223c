//! DOP853: the explicit Runge-Kutta method of order 8 by Dormand and Prince.
//!
//! Twelve stages; the error estimate combines an estimate `e5` of order 5 and one `e3` of order 3 to
//! `|h| |e5|^2 / sqrt(n (|e5|^2 + 0.01 |e3|^2))`, norms of the components divided by their scale (what error is
//! allowed); the next step is longer by `0.9 error^(-1/8)`, within limits. Source: docs/REFERENCES.md, Hairer,
//! Norsett and Wanner, II.5 and II.10, dop853.f.
//!
//! The caller owns the loop: it attempts a step, accepts it when the error is at most one, may project the state, and
//! takes dense output only of the steps that need it. The rates at the start of a step are taken over from the last
//! attempt whenever time and state are the same to the last bit (a repeated attempt after a refused one, or a step from
//! the end of the last one after [`Dop853::dense`]). A change of the *system* cannot be seen from here: call
//! [`Dop853::restart`] then. How it fails: on a system that is not smooth within the step the order is lost, which the
//! estimate reports; NaN in the rates gives a NaN error, which is not at most one, and the smallest step factor.

use crate::System;
use crate::dense_step::DenseStep;
use crate::dop853_coefficients::{A, ALL_STAGES, C, DENSE, ERROR_3, ERROR_5, Row, STAGES};
use std::ops::Range;

/// Fraction of the step that the estimate would allow, so that the next attempt is seldom refused.
const SAFETY: f64 = 0.9;
/// The least and the largest change of the step: dop853.f's defaults.
const SMALLEST_FACTOR: f64 = 1.0 / 3.0;
const LARGEST_FACTOR: f64 = 6.0;
/// Power of the step that the error estimate follows.
const ERROR_ORDER: f64 = 8.0;
/// Stage that holds the rates at the end of the step.
const END: usize = STAGES;

/// The method with its buffers, reused from step to step.
#[derive(Debug, Clone)]
pub struct Dop853 {
    t: f64,
    h: f64,
    start: Vec<f64>,
    end: Vec<f64>,
    stage: Vec<f64>,
    rates: [Vec<f64>; ALL_STAGES],
    /// Whether stage 0 holds the rates at (t, start), and stage `END` those at (t + h, end).
    start_known: bool,
    end_known: bool,
}

impl Dop853 {
    /// For states of `dimension` numbers.
    pub fn new(dimension: usize) -> Self {
        let zeros = || vec![0.0; dimension];
        Self {
            t: 0.0,
            h: 0.0,
            start: zeros(),
            end: zeros(),
            stage: zeros(),
            rates: std::array::from_fn(|_| zeros()),
            start_known: false,
            end_known: false,
        }
    }

    /// Forgets the rates of the last attempt; to be called when the system itself has changed (an impulse in the
    /// forces, another set of contacts).
    pub fn restart(&mut self) {
        self.start_known = false;
        self.end_known = false;
    }

    /// Attempts a step from (`t`, `state`) over `h` (s; may be negative) and returns its error norm: at most one when
    /// the step is as accurate as `scale` asks. `scale` is the error allowed per component, positive, usually
    /// `absolute + relative |y|`. The state at the end is [`Dop853::end_state`], whatever the error.
    ///
    /// A slice that is not of the method's dimension gives NaN, and the end state is then of no use.
    ///
    /// # Errors
    /// The system's own; the attempt is then of no use.
    pub fn attempt<S: System>(
        &mut self,
        system: &mut S,
        t: f64,
        state: &[f64],
        h: f64,
        scale: &[f64],
    ) -> Result<f64, S::Error> {
        if scale.len() != self.end.len() {
            self.restart();
            return Ok(f64::NAN);
        }
        self.attempt_unscaled(system, t, state, h)?;
        Ok(self.error_norm(scale))
    }

    /// As [`Dop853::attempt`], for a caller that asks for the errors of its own quantities ([`Dop853::error_of`]) and
    /// may take their scales from both ends of the step. With a state or a system of another dimension every error is
    /// NaN.
    ///
    /// # Errors
    /// The system's own; the attempt is then of no use.
    pub fn attempt_unscaled<S: System>(
        &mut self,
        system: &mut S,
        t: f64,
        state: &[f64],
        h: f64,
    ) -> Result<(), S::Error> {
        let dimension = self.end.len();
        if state.len() != dimension || system.dimension() != dimension {
            self.restart();
            for rates in &mut self.rates {
                rates.fill(f64::NAN);
            }
            return Ok(());
        }
        self.begin(system, t, state, h)?;
        for stage in 1..STAGES {
            self.prepare(A[stage]);
            system.derivative(t + C[stage] * h, &self.stage, &mut self.rates[stage])?;
        }
        self.prepare(A[END]);
        std::mem::swap(&mut self.stage, &mut self.end);
        Ok(())
    }

    /// Sets the start of the step and makes its rates known.
    fn begin<S: System>(&mut self, system: &mut S, t: f64, state: &[f64], h: f64) -> Result<(), S::Error> {
        if self.end_known && self.end_time() == t && same_bits(&self.end, state) {
            self.rates.swap(0, END);
            self.start_known = true;
        } else if !(self.start_known && self.t == t && same_bits(&self.start, state)) {
            self.start_known = false;
        }
        self.end_known = false;
        self.t = t;
        self.h = h;
        self.start.copy_from_slice(state);
        if !self.start_known {
            system.derivative(t, state, &mut self.rates[0])?;
            self.start_known = true;
        }
        Ok(())
    }

    /// Writes `start + h sum a_j k_j` to the stage's state.
    fn prepare(&mut self, row: Row) {
        for (i, (stage, y)) in self.stage.iter_mut().zip(&self.start).enumerate() {
            *stage = y + self.h * weighted(&self.rates, row, i);
        }
    }

    /// Hairer's combination of the estimates of order 5 and 3, in units of `scale`.
    fn error_norm(&self, scale: &[f64]) -> f64 {
        let (mut fifth, mut third) = (0.0, 0.0);
        for (i, scale) in scale.iter().enumerate() {
            let e5 = weighted(&self.rates, ERROR_5, i) / scale;
            let e3 = weighted(&self.rates, ERROR_3, i) / scale;
            fifth += e5 * e5;
            third += e3 * e3;
        }
        combined(self.h, fifth, third, scale.len() as f64)
    }

    /// Estimated error of the last attempt in the vector that some components form, in their unit: the same combination
    /// with the vector's length for the mean. Components beyond the state count as NaN.
    pub fn error_of(&self, components: Range<usize>) -> f64 {
        if components.end > self.end.len() {
            return f64::NAN;
        }
        let (mut fifth, mut third) = (0.0, 0.0);
        for i in components {
            let (e5, e3) = (weighted(&self.rates, ERROR_5, i), weighted(&self.rates, ERROR_3, i));
            fifth += e5 * e5;
            third += e3 * e3;
        }
        combined(self.h, fifth, third, 1.0)
    }

    /// Rates at the start of the last attempt.
    pub fn start_rates(&self) -> &[f64] {
        &self.rates[0]
    }

    /// State at the end of the last attempt.
    pub fn end_state(&self) -> &[f64] {
        &self.end
    }

    /// Time at the end of the last attempt, s.
    pub fn end_time(&self) -> f64 {
        self.t + self.h
    }

    /// By what factor the next step may differ from one with this `error`; NaN and infinity give the smallest.
    pub fn next_step_factor(error: f64) -> f64 {
        if error == 0.0 {
            return LARGEST_FACTOR;
        }
        let factor = SAFETY * libm::pow(error, -1.0 / ERROR_ORDER);
        // Written so that NaN falls to the smallest factor.
        if factor > SMALLEST_FACTOR { factor.min(LARGEST_FACTOR) } else { SMALLEST_FACTOR }
    }

    /// Dense output of the last attempt: three more stages, and the rates at its end, which the next step then starts
    /// with.
    ///
    /// # Errors
    /// The system's own.
    pub fn dense<S: System>(&mut self, system: &mut S) -> Result<DenseStep, S::Error> {
        let (t, h) = (self.t, self.h);
        if !self.end_known {
            system.derivative(t + h, &self.end, &mut self.rates[END])?;
            self.end_known = true;
        }
        for stage in END + 1..ALL_STAGES {
            self.prepare(A[stage]);
            system.derivative(t + C[stage] * h, &self.stage, &mut self.rates[stage])?;
        }
        let terms = self.end.len();
        let mut coefficients = Vec::with_capacity(terms);
        for i in 0..terms {
            let change = self.end[i] - self.start[i];
            let (first, last) = (h * self.rates[0][i], h * self.rates[END][i]);
            let [d3, d4, d5, d6] = DENSE.map(|row| h * weighted(&self.rates, row, i));
            let bend = first - change;
            coefficients.push([self.start[i], change, bend, change - last - bend, d3, d4, d5, d6]);
        }
        Ok(DenseStep::new(t, h, coefficients))
    }
}

/// `|h| e5^2 / sqrt(n (e5^2 + 0.01 e3^2))` from the squares. Errors so small that their squares vanish are none, and of
/// those so large that their squares overflow nothing is known.
fn combined(h: f64, fifth: f64, third: f64, n: f64) -> f64 {
    if !third.is_finite() {
        return f64::NAN;
    }
    if fifth == 0.0 { 0.0 } else { h.abs() * fifth / ((fifth + 0.01 * third) * n).sqrt() }
}

/// `sum a_j k_j` of component `i`, in the order of the row.
fn weighted(rates: &[Vec<f64>; ALL_STAGES], row: Row, i: usize) -> f64 {
    row.iter().map(|&(stage, a)| a * rates[stage][i]).sum()
}

/// Equality that also tells 0 from -0 and finds NaN equal to itself.
fn same_bits(a: &[f64], b: &[f64]) -> bool {
    a.len() == b.len() && a.iter().zip(b).all(|(x, y)| x.to_bits() == y.to_bits())
}

#[cfg(test)]
mod tests {
    use super::combined;

    /// Velocities of 1e-148 have errors whose squares are the least numbers there are: a hundredth of them is zero.
    #[test]
    fn errors_whose_squares_vanish_are_none() {
        let least = f64::from_bits(1);
        for (fifth, third) in [(0.0, 0.0), (0.0, least), (least, 0.0), (least, least)] {
            let error = combined(1e-3, fifth, third, 26.0);
            assert!((0.0..1e-150).contains(&error), "{fifth:e} {third:e}: {error}");
        }
    }
}
