//! What all methods of fixed step share: the variables kept, the step taken or refused, the time within it.
//!
//! A [`StepMap`] advances the variables of all bodies by one step and is the whole of a method; [`OneStep`] makes an
//! [`Integrator`] of it. A step is computed aside and taken only when it has succeeded, so a failed one leaves
//! everything as it was. The state within a step is the map's own step of that length from the same start, which is
//! as accurate as the method and continuous with it at both ends.

use super::saved::{NotItsVariables, Reader, write_count, write_states};
use super::within_step::answered_at_end;
use super::{IntegrationError, Integrator};
use crate::{BodyState, FreeMotion, RigidBody};
use std::fmt::Debug;

/// The variables of one body that a method keeps from step to step.
pub(crate) trait Variables: Copy + Debug + Send {
    /// Those of a state.
    fn of(body: &RigidBody, state: &BodyState) -> Self;

    /// The state that they stand for.
    fn state(&self, body: &RigidBody) -> BodyState;

    /// Whether every number is finite.
    fn is_finite(&self) -> bool;

    /// Writes the numbers.
    fn write(&self, numbers: &mut Vec<f64>);

    /// Reads the numbers that [`Variables::write`] has written.
    fn read(numbers: &mut Reader<'_>) -> Result<Self, NotItsVariables>;

    /// Writes the states of the variables of all bodies, where [`Variables::shown`] looks for them.
    fn show(bodies: &[RigidBody], variables: &[Self], states: &mut [BodyState]) {
        for ((body, variables), state) in bodies.iter().zip(variables).zip(states) {
            *state = variables.state(body);
        }
    }

    /// The states of `variables`, where [`Variables::show`] has put them into `states`.
    fn shown<'a>(_variables: &'a [Self], states: &'a [BodyState]) -> &'a [BodyState] {
        states
    }
}

impl Variables for BodyState {
    fn of(_body: &RigidBody, state: &BodyState) -> Self {
        *state
    }

    fn state(&self, _body: &RigidBody) -> BodyState {
        *self
    }

    #[inline]
    fn is_finite(&self) -> bool {
        // Zero times a number is zero unless the number is not finite: one test instead of thirteen, every step.
        let q = self.pose.rotation.quaternion() * 0.0;
        let v = self.pose.translation * 0.0 + self.linear_velocity * 0.0 + self.angular_momentum * 0.0;
        (v.x + v.y) + (v.z + q.w) + (q.x + q.y) + q.z == 0.0
    }

    fn write(&self, numbers: &mut Vec<f64>) {
        write_states(&[*self], numbers);
    }

    fn read(numbers: &mut Reader<'_>) -> Result<Self, NotItsVariables> {
        numbers.state()
    }

    /// States are shown where they are kept.
    fn show(_bodies: &[RigidBody], _variables: &[Self], _states: &mut [BodyState]) {}

    fn shown<'a>(variables: &'a [Self], _states: &'a [BodyState]) -> &'a [BodyState] {
        variables
    }
}

/// The time of a step.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Span {
    /// Start, s.
    pub(crate) t: f64,
    /// Length, s; negative goes back. Never zero.
    pub(crate) h: f64,
}

/// A map of the variables of all bodies over one step. It may keep buffers; its result depends on its arguments alone.
pub(crate) trait StepMap: Debug + Send {
    /// What it keeps of a body.
    type Variables: Variables;

    /// Order of convergence.
    fn order(&self) -> u32;

    /// Writes into `to` the variables at `t + h` (s) of the bodies that have the variables `from` at `t`. All are one
    /// per body of the motion; what a failed step leaves in `to` is not used.
    fn advance(
        &mut self,
        motion: &FreeMotion<'_>,
        span: Span,
        from: &[Self::Variables],
        to: &mut [Self::Variables],
    ) -> Result<(), IntegrationError>;
}

/// The integrator of a map.
#[derive(Debug)]
pub(crate) struct OneStep<M: StepMap> {
    map: M,
    start: f64,
    time: f64,
    /// Variables at the start of the last step, at the time reached, and of the step being tried.
    before: Vec<M::Variables>,
    now: Vec<M::Variables>,
    trial: Vec<M::Variables>,
    states: Vec<BodyState>,
}

impl<M: StepMap> OneStep<M> {
    pub(crate) fn new(map: M) -> Self {
        let (before, now, trial) = (Vec::new(), Vec::new(), Vec::new());
        Self { map, start: 0.0, time: 0.0, before, now, trial, states: Vec::new() }
    }
}

/// The map over the span from `from` into `to`, checked.
fn attempt<M: StepMap>(
    map: &mut M,
    motion: &FreeMotion<'_>,
    span: Span,
    from: &[M::Variables],
    to: &mut Vec<M::Variables>,
) -> Result<(), IntegrationError> {
    if span.h == 0.0 || to.len() != from.len() {
        to.clear();
        to.extend_from_slice(from);
    }
    if span.h != 0.0 {
        map.advance(motion, span, from, to)?;
    }
    let finite = span.h.is_finite() && to.iter().all(Variables::is_finite);
    if finite { Ok(()) } else { Err(IntegrationError::NotFinite { t: span.t }) }
}

impl<M: StepMap> Integrator for OneStep<M> {
    fn order(&self) -> u32 {
        self.map.order()
    }

    fn start(&mut self, motion: &FreeMotion<'_>, t: f64, states: &[BodyState]) {
        (self.start, self.time) = (t, t);
        self.now.clear();
        self.now.extend(motion.bodies().iter().zip(states).map(|(body, state)| M::Variables::of(body, state)));
        self.before.clone_from(&self.now);
        self.states.clear();
        self.states.extend_from_slice(states);
    }

    fn step(&mut self, motion: &FreeMotion<'_>, h: f64) -> Result<(), IntegrationError> {
        check_count(motion, self.states.len())?;
        let span = Span { t: self.time, h };
        attempt(&mut self.map, motion, span, &self.now, &mut self.trial)?;
        std::mem::swap(&mut self.before, &mut self.now);
        std::mem::swap(&mut self.now, &mut self.trial);
        (self.start, self.time) = (self.time, self.time + h);
        M::Variables::show(motion.bodies(), &self.now, &mut self.states);
        Ok(())
    }

    fn time(&self) -> f64 {
        self.time
    }

    fn states(&self) -> &[BodyState] {
        M::Variables::shown(&self.now, &self.states)
    }

    fn states_within(
        &mut self,
        motion: &FreeMotion<'_>,
        t: f64,
        states: &mut [BodyState],
    ) -> Result<(), IntegrationError> {
        if answered_at_end(motion, [self.start, self.time], self.states(), t, states)? {
            return Ok(());
        }
        let span = Span { t: self.start, h: t - self.start };
        attempt(&mut self.map, motion, span, &self.before, &mut self.trial)?;
        for ((body, variables), state) in motion.bodies().iter().zip(&self.trial).zip(states) {
            *state = variables.state(body);
        }
        Ok(())
    }

    fn save(&self) -> Vec<f64> {
        let mut numbers = vec![self.start, self.time];
        write_count(self.now.len(), &mut numbers);
        for variables in self.before.iter().chain(&self.now) {
            variables.write(&mut numbers);
        }
        write_states(&self.states, &mut numbers);
        numbers
    }

    fn restore(&mut self, motion: &FreeMotion<'_>, saved: &[f64]) -> Result<(), NotItsVariables> {
        let mut numbers = Reader::new(motion, saved);
        let [start, time] = numbers.array()?;
        let count = numbers.count()?;
        let mut variables = || (0..count).map(|_| M::Variables::read(&mut numbers)).collect::<Result<Vec<_>, _>>();
        let (before, now) = (variables()?, variables()?);
        let states = numbers.states(count)?;
        numbers.end()?;
        (self.start, self.time, self.before, self.now, self.states) = (start, time, before, now, states);
        Ok(())
    }
}

fn check_count(motion: &FreeMotion<'_>, states: usize) -> Result<(), IntegrationError> {
    let bodies = motion.bodies().len();
    if states == bodies { Ok(()) } else { Err(IntegrationError::StateCount { states, bodies }) }
}

/// Makes a public integrator of a struct whose only field is its driver, so that what drives it stays private.
macro_rules! integrator_by_driver {
    ($name:ident) => {
        impl $crate::integrator::Integrator for $name {
            fn order(&self) -> u32 {
                self.0.order()
            }

            fn start(&mut self, motion: &$crate::FreeMotion<'_>, t: f64, states: &[$crate::BodyState]) {
                self.0.start(motion, t, states);
            }

            fn step(
                &mut self,
                motion: &$crate::FreeMotion<'_>,
                h: f64,
            ) -> Result<(), $crate::integrator::IntegrationError> {
                self.0.step(motion, h)
            }

            fn time(&self) -> f64 {
                self.0.time()
            }

            fn states(&self) -> &[$crate::BodyState] {
                self.0.states()
            }

            fn states_within(
                &mut self,
                motion: &$crate::FreeMotion<'_>,
                t: f64,
                states: &mut [$crate::BodyState],
            ) -> Result<(), $crate::integrator::IntegrationError> {
                self.0.states_within(motion, t, states)
            }

            fn save(&self) -> Vec<f64> {
                self.0.save()
            }

            fn restore(
                &mut self,
                motion: &$crate::FreeMotion<'_>,
                saved: &[f64],
            ) -> Result<(), $crate::integrator::NotItsVariables> {
                self.0.restore(motion, saved)
            }
        }
    };
}
pub(crate) use integrator_by_driver;
