//! Exact flight with forces as kicks, under error control: conservative fields of any strength along the motion.
//!
//! A step of the caller is made twice by [`super::Exact`]'s composition of order 4, as n and as 2 n equal steps. The
//! finer result is kept when its error, by Richardson a fifteenth of the difference, is within what is allowed; else n
//! doubles. n is kept from step to step and halves when half would do, so that where the forces stay alike the steps
//! stay equal: the energy of a bound motion then oscillates and does not drift. What a step may err is
//! [`super::dop853`]'s table, of which it uses [`STEP_SHARE`].
//!
//! The spin costs nothing, however fast, and an attitude that no torque turns is exact to rounding. Fields may depend
//! on time, not on velocities. Source: docs/REFERENCES.md, Hairer, Lubich and Wanner, II.5; Hairer, Norsett and Wanner,
//! II.4. How it fails: as [`super::AdaptiveDop853`], with which it shares [`IntegrationError::StepTooSmall`]: also when
//! twice as many steps do not err less, where rounding decides. Order 4 makes a long way of strong forces: there DOP853
//! is cheaper.

use super::MOST_STEPS;
use super::dop853::{Tolerance, allowance};
use super::drift_kick::{check, compose};
use super::exact::{follow, records};
use super::saved::{NotItsVariables, Reader, write_count, write_flights, write_states};
use super::within_step::answered_at_end;
use super::{IntegrationError, Integrator, blanes_moan};
use crate::error_allowance::LargestError;
use crate::field::Wrench;
use crate::state::{LINEAR_VELOCITY, QUATERNION, WIDTH};
use crate::{BodyState, Flight, FreeMotion, RigidBody};

/// Share of the tolerance that one step may use: steps of one length err alike, and hundreds of them add up.
pub const STEP_SHARE: f64 = 1e-2;

/// What the difference from twice as many steps exceeds their error by, at order 4.
const RICHARDSON: f64 = 15.0;

/// An error below this share of what is allowed is within it with half as many steps too: `1/2^4`, and half for safety.
const HALVING_SHARE: f64 = 1.0 / 32.0;

/// Twice as many steps must bring the error below this share of what it was (the order promises 1/16)...
const GAIN: f64 = 0.5;

/// ... but for this many doublings in a row: the first are too coarse for the order, and where more do not help
/// rounding or a singularity decides.
const FRUITLESS: u32 = 4;

/// What refusals name the method by.
const NAME: &str = "exact-adaptive";

/// Exact drifts with kicks of order 4 and the tolerance of their error control.
#[derive(Debug, Clone)]
pub struct AdaptiveExact {
    tolerance: f64,
    most_steps: u32,
    from: f64,
    t: f64,
    before: Vec<BodyState>,
    states: Vec<BodyState>,
    /// The results of n and of 2 n steps.
    coarse: Vec<BodyState>,
    fine: Vec<BodyState>,
    wrenches: Vec<Wrench>,
    /// Whether any body is loaded, so that drifts and kicks are needed.
    loaded: bool,
    /// Records of the bodies that nothing loads.
    flights: Vec<Option<Flight>>,
    /// n of the next step.
    proposed: u32,
    /// Steps that the last step was made of.
    inner: u32,
    /// Error of the last step in units of what is allowed.
    error: f64,
    /// How many of them lead to `cursor`, the states that were last looked at on the way: looking at one time after the
    /// other makes each of them once.
    passed: u32,
    cursor: Vec<BodyState>,
}

impl AdaptiveExact {
    /// With the tolerance of the error control.
    pub fn new(tolerance: Tolerance) -> Self {
        Self {
            tolerance: tolerance.get(),
            most_steps: MOST_STEPS,
            from: 0.0,
            t: 0.0,
            before: Vec::new(),
            states: Vec::new(),
            coarse: Vec::new(),
            fine: Vec::new(),
            wrenches: Vec::new(),
            loaded: false,
            flights: Vec::new(),
            proposed: 1,
            inner: 1,
            error: 0.0,
            passed: 0,
            cursor: Vec::new(),
        }
    }

    /// The same, which fails with [`IntegrationError::StepTooSmall`] when a step would need more than this many, at
    /// least two, within it.
    pub fn limited_to(mut self, steps: u32) -> Self {
        self.most_steps = steps.clamp(2, MOST_STEPS);
        self
    }

    /// Makes the fine result of a step of `h` (s), which must not be zero.
    fn advance(&mut self, motion: &FreeMotion<'_>, h: f64) -> Result<(), IntegrationError> {
        let t = self.t;
        let (mut before, mut fruitless) = (f64::INFINITY, 0);
        while 2 * self.proposed <= self.most_steps && fruitless < FRUITLESS {
            let n = self.proposed;
            for (count, end) in [(n, &mut self.coarse), (2 * n, &mut self.fine)] {
                end.clone_from(&self.states);
                divided(motion, t, h, count, end, &mut self.wrenches);
            }
            let error = error(motion, [&self.states, &self.coarse, &self.fine], h, self.tolerance * STEP_SHARE);
            if error.is_nan() {
                return Err(IntegrationError::NotFinite { t });
            }
            if error <= 1.0 {
                (self.inner, self.error) = (2 * n, error);
                self.proposed = if error < HALVING_SHARE { (n / 2).max(1) } else { n };
                return Ok(());
            }
            fruitless = if error > GAIN * before { fruitless + 1 } else { 0 };
            before = error;
            self.proposed = 2 * n;
        }
        let smallest_s = h.abs() / f64::from(self.proposed.min(self.most_steps));
        self.proposed = 1;
        Err(IntegrationError::StepTooSmall { t, smallest_s })
    }
}

/// `count` equal steps over `h` (s).
fn divided(motion: &FreeMotion<'_>, t: f64, h: f64, count: u32, states: &mut [BodyState], wrenches: &mut Vec<Wrench>) {
    let inner = h / f64::from(count);
    for k in 0..count {
        compose(motion, t + f64::from(k) * inner, inner, blanes_moan::STAGES, states, wrenches);
    }
}

/// Largest error of the fine result over all bodies and quantities, in units of what is allowed; NaN when one is.
/// `states` are those at the start, and the coarse and the fine ones at the end.
fn error(motion: &FreeMotion<'_>, states: [&[BodyState]; 3], h: f64, tolerance: f64) -> f64 {
    let [starts, coarse, fine] = states;
    let mut largest = LargestError::default();
    for (((body, start), coarse), fine) in motion.bodies().iter().zip(starts).zip(coarse).zip(fine) {
        include_body(&mut largest, body, [start, coarse, fine].map(BodyState::to_array), h, tolerance);
    }
    largest.get()
}

fn include_body(
    largest: &mut LargestError,
    body: &RigidBody,
    [start, mut coarse, fine]: [[f64; WIDTH]; 3],
    h: f64,
    tolerance: f64,
) {
    let attitude = QUATERNION..LINEAR_VELOCITY;
    let same_side: f64 = coarse[attitude.clone()].iter().zip(&fine[attitude.clone()]).map(|(a, b)| a * b).sum();
    if same_side < 0.0 {
        // q and -q are one attitude.
        coarse[attitude].iter_mut().for_each(|number| *number = -*number);
    }
    let rate: [f64; WIDTH] = std::array::from_fn(|k| (fine[k] - start[k]) / h);
    for (range, allowed) in allowance(body, &start, &fine, &rate, tolerance).by_quantity() {
        let squares = coarse[range.clone()].iter().zip(&fine[range]).map(|(a, b)| (a - b) * (a - b));
        largest.include(squares.sum::<f64>().sqrt() / RICHARDSON, allowed);
    }
}

impl Integrator for AdaptiveExact {
    fn order(&self) -> u32 {
        4
    }

    fn start(&mut self, motion: &FreeMotion<'_>, t: f64, states: &[BodyState]) {
        (self.from, self.t, self.proposed, self.inner, self.error) = (t, t, 1, 1, 0.0);
        self.passed = 0;
        for own in [&mut self.before, &mut self.states, &mut self.cursor] {
            own.clear();
            own.extend_from_slice(states);
        }
        self.loaded = motion.has_loads();
        self.flights = records(motion, t, states);
    }

    fn step(&mut self, motion: &FreeMotion<'_>, h: f64) -> Result<(), IntegrationError> {
        check(motion, self.states.len(), NAME)?;
        let (t, end) = (self.t, self.t + h);
        if !end.is_finite() || !self.states.iter().all(BodyState::is_finite) {
            return Err(IntegrationError::NotFinite { t });
        }
        if self.loaded && h != 0.0 {
            self.advance(motion, h)?;
        } else {
            self.fine.clone_from(&self.states);
        }
        follow(&self.flights, end, &mut self.fine);
        if !self.fine.iter().all(BodyState::is_finite) {
            return Err(IntegrationError::NotFinite { t });
        }
        std::mem::swap(&mut self.before, &mut self.states);
        std::mem::swap(&mut self.states, &mut self.fine);
        (self.from, self.t, self.passed) = (t, end, 0);
        self.cursor.clone_from(&self.before);
        Ok(())
    }

    fn time(&self) -> f64 {
        self.t
    }

    fn states(&self) -> &[BodyState] {
        &self.states
    }

    fn step_error(&self) -> Option<f64> {
        Some(self.error)
    }

    fn inner_steps(&self) -> u32 {
        self.inner
    }

    fn states_within(
        &mut self,
        motion: &FreeMotion<'_>,
        t: f64,
        states: &mut [BodyState],
    ) -> Result<(), IntegrationError> {
        if answered_at_end(motion, [self.from, self.t], &self.states, t, states)? {
            return Ok(());
        }
        if self.loaded && t != self.from {
            let inner = (self.t - self.from) / f64::from(self.inner);
            let whole = ((t - self.from) / inner) as u32;
            if whole < self.passed {
                self.passed = 0;
                self.cursor.clone_from(&self.before);
            }
            let reached = |passed: u32| self.from + f64::from(passed) * inner;
            while self.passed < whole {
                let start = reached(self.passed);
                compose(motion, start, inner, blanes_moan::STAGES, &mut self.cursor, &mut self.wrenches);
                self.passed += 1;
            }
            states.copy_from_slice(&self.cursor);
            let start = reached(whole);
            compose(motion, start, t - start, blanes_moan::STAGES, states, &mut self.wrenches);
        } else {
            states.copy_from_slice(&self.before);
        }
        follow(&self.flights, t, states);
        Ok(())
    }

    fn save(&self) -> Vec<f64> {
        let mut numbers = vec![self.from, self.t, self.error, f64::from(self.proposed), f64::from(self.inner)];
        numbers.push(f64::from(u8::from(self.loaded)));
        write_count(self.states.len(), &mut numbers);
        write_states(&self.before, &mut numbers);
        write_states(&self.states, &mut numbers);
        write_flights(&self.flights, &mut numbers);
        numbers
    }

    fn restore(&mut self, motion: &FreeMotion<'_>, saved: &[f64]) -> Result<(), NotItsVariables> {
        let mut numbers = Reader::new(motion, saved);
        let [from, t, error] = numbers.array()?;
        let (proposed, inner) = (numbers.integer()?, numbers.integer()?);
        if !((1..=MOST_STEPS).contains(&proposed) && (1..=2 * MOST_STEPS).contains(&inner)) {
            return numbers.refused();
        }
        let loaded = numbers.flag()?;
        let count = numbers.count()?;
        let (before, states) = (numbers.states(count)?, numbers.states(count)?);
        let flights = numbers.flights(motion, &states)?;
        numbers.end()?;
        (self.from, self.t, self.error, self.proposed, self.inner) = (from, t, error, proposed, inner);
        // Looking begins at the start of the step again.
        (self.passed, self.cursor) = (0, before.clone());
        (self.loaded, self.before, self.states, self.flights) = (loaded, before, states, flights);
        Ok(())
    }
}
