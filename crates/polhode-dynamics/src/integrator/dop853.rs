//! DOP853 with error control inside steps of fixed length: any smooth field, drag and dampers included.
//!
//! Each step of the caller is covered by as many steps of [`Dop853`] as the tolerance asks for; the quaternions are
//! normalised after each. A step is accepted when the largest error of any quantity of any body, not the mean over all
//! of them, is below its share of the tolerance: a mean over the numbers of the state grows more lenient with every
//! body, and with every number that happens to have no error.
//!
//! | quantity | error allowed in one step |
//! |---|---|
//! | position | the body's radius of gyration |
//! | attitude | 1 rad (twice the change of the quaternion) |
//! | velocity | the larger of its speeds: its own, that of its points, what its acceleration gives over its radius |
//! | angular momentum | the smallest moment times the angular speed, or what its torque gives over a turn |
//!
//! each times `tolerance` and [`STEP_SHARE`], and not below the rounding of the numbers themselves.
//! Source: docs/REFERENCES.md, Hairer, Norsett and Wanner, II.4, II.10.
//! Steps end at the corners of signals. How it fails: another force that acts for a small part of a step (a pulse of a
//! function of one's own, between two stages) can be missed; at a singularity the steps shrink until
//! [`IntegrationError::StepTooSmall`].

use super::MOST_STEPS;
use super::saved::{NotItsVariables, Reader, write_count, write_states};
use super::within_step::answered_at_end;
use super::{IntegrationError, Integrator};
use crate::error_allowance::{ErrorAllowance, LargestError};
use crate::free_motion::BufferedMotion;
use crate::state::{ANGULAR_MOMENTUM, LINEAR_VELOCITY, WIDTH};
use crate::step_control::{Attempt, StepControl, Steps};
use crate::{BodyState, DenseStep, Dop853, FreeMotion, RigidBody, System};
use glam::DVec3;
use polhode_spatial::rounding;
use thiserror::Error;

/// Share of the tolerance that one step may use (dimensionless): errors add over the steps, some fifty for ten seconds
/// at two radians a second, and the interpolation within a step, of one order less, has to stay below the tolerance
/// too. At order 8 a tenth costs a third more steps.
pub const STEP_SHARE: f64 = 0.1;

/// The smallest tolerance (dimensionless): a few hundred roundings, which no step can do better than.
pub const SMALLEST_TOLERANCE: f64 = 256.0 * f64::EPSILON;

/// The largest tolerance (dimensionless): beyond it the error estimate of a method of order 8 means nothing.
pub const LARGEST_TOLERANCE: f64 = 1e-2;

/// A tolerance out of range.
#[derive(Debug, Clone, Copy, PartialEq, Error)]
#[error("tolerance must lie between {SMALLEST_TOLERANCE:e} and {LARGEST_TOLERANCE:e}, found {0:e}")]
pub struct ToleranceError(pub f64);

/// Error of a motion over some turns, relative to the body's size and speeds (dimensionless).
#[derive(Debug, Clone, Copy, PartialEq, PartialOrd)]
pub struct Tolerance(f64);

impl Tolerance {
    /// Everyday work: 1e-11.
    pub const EVERYDAY: Self = Self(1e-11);

    /// From a number.
    ///
    /// # Errors
    /// When it is not between [`SMALLEST_TOLERANCE`] and [`LARGEST_TOLERANCE`].
    pub fn new(tolerance: f64) -> Result<Self, ToleranceError> {
        if (SMALLEST_TOLERANCE..=LARGEST_TOLERANCE).contains(&tolerance) {
            Ok(Self(tolerance))
        } else {
            Err(ToleranceError(tolerance))
        }
    }

    /// The number.
    pub const fn get(self) -> f64 {
        self.0
    }
}

impl Default for Tolerance {
    fn default() -> Self {
        Self::EVERYDAY
    }
}

/// The method with its tolerance.
#[derive(Debug, Clone)]
pub struct AdaptiveDop853 {
    tolerance: f64,
    method: Dop853,
    from: f64,
    t: f64,
    states: Vec<BodyState>,
    flat: Vec<f64>,
    /// Largest error of an inner step of the last step, in units of what is allowed.
    error: f64,
    /// Length of the next inner step, s, without its sign; nothing before the first.
    proposed: Option<f64>,
    /// Inner steps of the last step: start, length, state at the start.
    inner: Vec<(f64, f64, Vec<f64>)>,
    /// The inner step that was last interpolated in.
    dense: Option<(usize, DenseStep)>,
}

impl AdaptiveDop853 {
    /// With the tolerance of the error control.
    pub fn new(tolerance: Tolerance) -> Self {
        Self {
            tolerance: tolerance.get(),
            method: Dop853::new(0),
            from: 0.0,
            t: 0.0,
            states: Vec::new(),
            flat: Vec::new(),
            error: 0.0,
            proposed: None,
            inner: Vec::new(),
            dense: None,
        }
    }

    /// Inner steps that the last step took.
    pub const fn accepted_steps(&self) -> usize {
        self.inner.len()
    }

    /// Writes the flat state at `t` in the inner step of this index, whose polynomials are made when they are first
    /// asked for: most steps are never looked into.
    fn interpolate(&mut self, motion: &FreeMotion<'_>, index: usize, t: f64) {
        if self.dense.as_ref().is_none_or(|(known, _)| *known != index) {
            let Some((start, h, state)) = self.inner.get(index) else { return };
            let mut system = BufferedMotion::new(*motion);
            let Ok(()) = self.method.attempt_unscaled(&mut system, *start, state, *h);
            let Ok(dense) = self.method.dense(&mut system);
            self.dense = Some((index, dense));
        }
        if let Some((_, dense)) = &self.dense {
            dense.evaluate(t, &mut self.flat);
        }
    }

    /// Covers the step to `end` by inner steps that end where a field is not smooth in time.
    fn advance(&mut self, motion: &FreeMotion<'_>, end: f64) -> Result<(), IntegrationError> {
        let mut t = self.t;
        while let Some(corner) = motion.corner_between(t, end) {
            self.advance_smoothly(motion, t, corner)?;
            // The stages of the step before saw another force.
            self.method.restart();
            t = corner;
        }
        self.advance_smoothly(motion, t, end)
    }

    /// Covers the time from `start` to `end`, between which all fields are smooth.
    fn advance_smoothly(&mut self, motion: &FreeMotion<'_>, start: f64, end: f64) -> Result<(), IntegrationError> {
        let mut control = StepControl::proposing(self.proposed.unwrap_or(f64::INFINITY));
        let mut span = SmoothSpan {
            tolerance: self.tolerance,
            method: &mut self.method,
            motion,
            system: BufferedMotion::new(*motion),
            t: start,
            flat: &mut self.flat,
            start,
            end,
            attempts: 0,
        };
        loop {
            let rest = span.limit_s();
            let accepted = control.next_step(&mut span)?;
            self.error = self.error.max(accepted.error);
            self.inner.push((span.t, span.signed(accepted.length_s), span.flat.clone()));
            span.flat.copy_from_slice(span.method.end_state());
            span.system.normalize(span.flat);
            if accepted.length_s >= rest {
                self.proposed = Some(control.proposed_s());
                return Ok(());
            }
            span.t += span.signed(accepted.length_s);
        }
    }
}

/// A time between whose ends all fields are smooth, covered up to `t` (s), and the state there.
struct SmoothSpan<'a, 'm> {
    tolerance: f64,
    method: &'a mut Dop853,
    motion: &'a FreeMotion<'m>,
    system: BufferedMotion<'m>,
    t: f64,
    flat: &'a mut Vec<f64>,
    /// Its ends, s; an end before the start goes back.
    start: f64,
    end: f64,
    /// Attempts so far.
    attempts: u32,
}

impl SmoothSpan<'_, '_> {
    /// A length with the sign of the span's direction, s.
    fn signed(&self, length_s: f64) -> f64 {
        (self.end - self.start).signum() * length_s
    }

    /// Largest error of the last attempt over all bodies and quantities, in units of what is allowed.
    fn error(&self) -> f64 {
        let ends = self.flat.as_chunks::<WIDTH>().0.iter().zip(self.method.end_state().as_chunks::<WIDTH>().0);
        let rates = self.method.start_rates().as_chunks::<WIDTH>().0;
        let mut largest = LargestError::default();
        for (index, ((body, (start, end)), rate)) in self.motion.bodies().iter().zip(ends).zip(rates).enumerate() {
            let allowance = allowance(body, start, end, rate, self.tolerance * STEP_SHARE);
            largest.include_body(self.method, index * WIDTH, allowance);
        }
        largest.get()
    }
}

impl Steps for SmoothSpan<'_, '_> {
    type Step = ();
    type Error = IntegrationError;

    fn limit_s(&self) -> f64 {
        (self.end - self.t).abs()
    }

    fn smallest_s(&self) -> f64 {
        rounding::DOZEN_TERMS * self.start.abs().max(self.end.abs())
    }

    /// The last two steps are of one length: none is left over that is a fraction of what is allowed.
    fn first_length(&self, proposed_s: f64) -> f64 {
        let rest = self.limit_s();
        if proposed_s >= rest {
            rest
        } else if 2.0 * proposed_s > rest {
            0.5 * rest
        } else {
            proposed_s
        }
    }

    fn repeated_length(&self, proposed_s: f64) -> f64 {
        self.first_length(proposed_s)
    }

    fn attempt(&mut self, length_s: f64) -> Result<Attempt<()>, IntegrationError> {
        if self.attempts == MOST_STEPS {
            let smallest_s = (self.end - self.start).abs() / f64::from(MOST_STEPS);
            return Err(IntegrationError::StepTooSmall { t: self.t, smallest_s });
        }
        self.attempts += 1;
        let h = self.signed(length_s);
        let Ok(()) = self.method.attempt_unscaled(&mut self.system, self.t, self.flat, h);
        Ok(Attempt::Made { step: (), error: Some(self.error()) })
    }

    fn too_small(&self, last: Option<f64>) -> IntegrationError {
        if last.is_some_and(f64::is_nan) {
            IntegrationError::NotFinite { t: self.t }
        } else {
            IntegrationError::StepTooSmall { t: self.t, smallest_s: self.smallest_s() }
        }
    }
}

/// The error allowed in each quantity of one body; `rate` is the change of the state per second over the step, or at
/// its start.
pub(super) fn allowance(
    body: &RigidBody,
    start: &[f64; WIDTH],
    end: &[f64; WIDTH],
    rate: &[f64; WIDTH],
    tolerance: f64,
) -> ErrorAllowance {
    let ends = [BodyState::from_array(start), BodyState::from_array(end)];
    let largest = |size: &dyn Fn(&BodyState) -> f64| size(&ends[0]).max(size(&ends[1]));
    let vector = |first: usize| DVec3::new(rate[first], rate[first + 1], rate[first + 2]).length();
    let moments = body.moments();
    let radius = (moments.max_element() / body.mass()).sqrt();
    let angular_speed = largest(&|state| body.angular_velocity(state).length());
    let speed = largest(&|state| state.linear_velocity.length())
        .max(angular_speed * radius)
        .max((vector(LINEAR_VELOCITY) * radius).sqrt());
    let turning = angular_speed.max((vector(ANGULAR_MOMENTUM) / moments.max_element()).sqrt());
    let position = (tolerance * radius).max(rounding::DOZEN_TERMS * largest(&|state| state.pose.translation.length()));
    // An error of the angular momentum about the axis of the smallest moment changes the angular velocity most.
    let angular_momentum = (tolerance * moments.min_element() * turning)
        .max(rounding::DOZEN_TERMS * largest(&|state| state.angular_momentum.length()));
    let quaternion = ErrorAllowance::of_angle(tolerance);
    ErrorAllowance { position, quaternion, velocity: tolerance * speed, angular_momentum }
}

impl Integrator for AdaptiveDop853 {
    fn order(&self) -> u32 {
        8
    }

    fn start(&mut self, _motion: &FreeMotion<'_>, t: f64, states: &[BodyState]) {
        self.method = Dop853::new(states.len() * WIDTH);
        self.states.clear();
        self.states.extend_from_slice(states);
        (self.from, self.t, self.proposed, self.dense) = (t, t, None, None);
        self.inner.clear();
    }

    fn step(&mut self, motion: &FreeMotion<'_>, h: f64) -> Result<(), IntegrationError> {
        let (t, end) = (self.t, self.t + h);
        if self.states.len() != motion.bodies().len() {
            return Err(IntegrationError::StateCount { states: self.states.len(), bodies: motion.bodies().len() });
        }
        if !end.is_finite() || !self.states.iter().all(BodyState::is_finite) {
            return Err(IntegrationError::NotFinite { t });
        }
        self.flat.clear();
        self.flat.extend(self.states.iter().flat_map(BodyState::to_array));
        let kept = std::mem::take(&mut self.inner);
        self.method.restart();
        self.error = 0.0;
        if end != t
            && let Err(error) = self.advance(motion, end)
        {
            self.inner = kept;
            return Err(error);
        }
        for (state, numbers) in self.states.iter_mut().zip(self.flat.as_chunks::<WIDTH>().0) {
            *state = BodyState::from_array(numbers);
        }
        (self.from, self.t, self.dense) = (t, end, None);
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

    fn states_within(
        &mut self,
        motion: &FreeMotion<'_>,
        t: f64,
        states: &mut [BodyState],
    ) -> Result<(), IntegrationError> {
        if answered_at_end(motion, [self.from, self.t], &self.states, t, states)? {
            return Ok(());
        }
        let direction = (self.t - self.from).signum();
        let index = self.inner.partition_point(|(start, ..)| direction * (t - start) >= 0.0).saturating_sub(1);
        self.interpolate(motion, index, t);
        for (state, numbers) in states.iter_mut().zip(self.flat.as_chunks::<WIDTH>().0) {
            *state = BodyState::from_array(numbers);
        }
        Ok(())
    }

    fn save(&self) -> Vec<f64> {
        let mut numbers = vec![self.from, self.t, self.error];
        numbers.push(f64::from(u8::from(self.proposed.is_some())));
        numbers.push(self.proposed.unwrap_or(0.0));
        write_count(self.states.len(), &mut numbers);
        write_states(&self.states, &mut numbers);
        write_count(self.inner.len(), &mut numbers);
        for (start, h, state) in &self.inner {
            numbers.extend([*start, *h]);
            numbers.extend_from_slice(state);
        }
        numbers
    }

    fn restore(&mut self, motion: &FreeMotion<'_>, saved: &[f64]) -> Result<(), NotItsVariables> {
        let mut numbers = Reader::new(motion, saved);
        let [from, t, error] = numbers.array()?;
        let (is_proposed, proposed) = (numbers.flag()?, numbers.number()?);
        let count = numbers.count()?;
        let states = numbers.states(count)?;
        let width = count * WIDTH;
        let inner =
            (0..numbers.integer()?).map(|_| Ok((numbers.number()?, numbers.number()?, numbers.numbers(width)?)));
        let inner = inner.collect::<Result<Vec<_>, _>>()?;
        numbers.end()?;
        (self.from, self.t, self.error, self.proposed) = (from, t, error, is_proposed.then_some(proposed));
        (self.method, self.dense, self.flat) = (Dop853::new(width), None, vec![0.0; width]);
        (self.states, self.inner) = (states, inner);
        Ok(())
    }
}
