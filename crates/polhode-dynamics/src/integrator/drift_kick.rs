//! The two halves of free motion that are solved exactly: drift without forces, and kick without motion.
//!
//! ```text
//! drift    p += h v + h^2 g/2,   v += h g,   R by free rotation (crate::exact_rotation),   L constant
//! kick     v += h F/m,   L += h torque,   poses constant
//! ```
//!
//! Both are flows of a Hamiltonian when F derives from a potential, so that every composition of them is symplectic.
//! Uniform gravity is in the drift of a free body, where it is exact, and in the kick of a pivoted one.

use super::IntegrationError;
use super::saved::{NotItsVariables, Reader, write_count, write_states};
use super::within_step::answered_at_end;
use crate::field::{Dependence, Wrench};
use crate::{BodyState, FreeMotion, RigidBody, exact_rotation};
use glam::DVec3;

/// The states of the last step and the buffer of the kicks: what the compositions of drifts and kicks share.
#[derive(Debug, Clone, Default)]
pub(super) struct Stepper {
    pub(super) from: f64,
    pub(super) t: f64,
    pub(super) before: Vec<BodyState>,
    pub(super) states: Vec<BodyState>,
    next: Vec<BodyState>,
    wrenches: Vec<Wrench>,
}

/// A composition: for each stage the fraction of the step to drift, then to kick.
pub(super) type Stages = [(f64, f64)];

impl Stepper {
    pub(super) fn start(&mut self, t: f64, states: &[BodyState]) {
        self.from = t;
        self.t = t;
        for own in [&mut self.before, &mut self.states] {
            own.clear();
            own.extend_from_slice(states);
        }
    }

    /// Writes what the next step and a look at the last one go on from.
    pub(super) fn write(&self, numbers: &mut Vec<f64>) {
        numbers.extend([self.from, self.t]);
        write_count(self.states.len(), numbers);
        write_states(&self.before, numbers);
        write_states(&self.states, numbers);
    }

    /// Reads what [`Stepper::write`] has written.
    pub(super) fn read(numbers: &mut Reader<'_>) -> Result<Self, NotItsVariables> {
        let [from, t] = numbers.array()?;
        let count = numbers.count()?;
        let (before, states) = (numbers.states(count)?, numbers.states(count)?);
        Ok(Self { from, t, before, states, ..Self::default() })
    }

    /// Composes a step of `h` (s) from the present states, then lets `finish` correct the states at its end.
    pub(super) fn step(
        &mut self,
        motion: &FreeMotion<'_>,
        h: f64,
        stages: &Stages,
        method: &'static str,
        finish: impl FnOnce(f64, &mut [BodyState]),
    ) -> Result<(), IntegrationError> {
        check(motion, self.states.len(), method)?;
        self.next.clone_from(&self.states);
        if h == 0.0 {
            // Not even the rounding of drifts that cancel.
            self.before.clone_from(&self.states);
            self.from = self.t;
            return Ok(());
        }
        compose(motion, self.t, h, stages, &mut self.next, &mut self.wrenches);
        finish(self.t + h, &mut self.next);
        if !h.is_finite() || !self.next.iter().all(BodyState::is_finite) {
            return Err(IntegrationError::NotFinite { t: self.t });
        }
        std::mem::swap(&mut self.before, &mut self.states);
        std::mem::swap(&mut self.states, &mut self.next);
        self.from = self.t;
        self.t += h;
        Ok(())
    }

    /// States at `t` within the last step: a step of that length from its start.
    pub(super) fn states_within(
        &mut self,
        motion: &FreeMotion<'_>,
        t: f64,
        stages: &Stages,
        states: &mut [BodyState],
    ) -> Result<(), IntegrationError> {
        if answered_at_end(motion, [self.from, self.t], &self.states, t, states)? {
            return Ok(());
        }
        states.copy_from_slice(&self.before);
        compose(motion, self.from, t - self.from, stages, states, &mut self.wrenches);
        Ok(())
    }
}

/// Whether drifts and kicks can integrate the motion.
pub(super) fn check(motion: &FreeMotion<'_>, states: usize, method: &'static str) -> Result<(), IntegrationError> {
    if states != motion.bodies().len() {
        return Err(IntegrationError::StateCount { states, bodies: motion.bodies().len() });
    }
    if motion.dependence() == Dependence::Velocities {
        return Err(IntegrationError::VelocityDependentField { method });
    }
    Ok(())
}

/// Drifts and kicks in turn; the kick sees the time that the drifts before it have reached.
pub(super) fn compose(
    motion: &FreeMotion<'_>,
    t: f64,
    h: f64,
    stages: &Stages,
    states: &mut [BodyState],
    wrenches: &mut Vec<Wrench>,
) {
    let mut reached = 0.0;
    for &(drifted, kicked) in stages {
        for (body, state) in motion.bodies().iter().zip(&mut *states) {
            *state = drift(body, motion.free_acceleration(body), state, drifted * h);
        }
        reached += drifted;
        if kicked != 0.0 {
            kick(motion, t + reached * h, kicked * h, states, wrenches);
        }
    }
}

/// Free flight over `h` (s) under `gravity` (m/s^2).
pub(super) fn drift(body: &RigidBody, gravity: DVec3, state: &BodyState, h: f64) -> BodyState {
    let axes = body.axes();
    let turned = exact_rotation::drift(body.moments(), state.pose.rotation * axes, state.angular_momentum, h);
    let mut next = *state;
    next.pose.rotation = turned * axes.inverse();
    next.pose.translation += (state.linear_velocity + gravity * (0.5 * h)) * h;
    next.linear_velocity += gravity * h;
    next
}

/// Impulse of the wrenches at `t` over `h` (s).
pub(super) fn kick(motion: &FreeMotion<'_>, t: f64, h: f64, states: &mut [BodyState], wrenches: &mut Vec<Wrench>) {
    wrenches.resize(states.len(), Wrench::default());
    motion.wrenches(t, states, wrenches);
    for ((body, state), wrench) in motion.bodies().iter().zip(states).zip(&*wrenches) {
        state.linear_velocity += wrench.force * (h * body.inverse_mass());
        state.angular_momentum += wrench.torque * h;
    }
}
