//! A trial step: every moving group integrated once, under error control, before any event is looked for.
//!
//! All groups take the same step, the longest that all of their error estimates accept, so that each body has one
//! motion over the step. A trial that an event cuts short is repeated from its start with the shorter step, not
//! interpolated, so that states at events are as accurate as states at step ends.

use super::engine::{Engine, Mode};
use super::system::ContactSystem;
use crate::SimulationError;
use crate::interaction::contact_set::{ContactId, Hold};
use crate::world::World;
use polhode_dynamics::{BodyState, DenseStep, Dop853, state::WIDTH};
use polhode_response::ResponseError;
use polhode_spatial::{Motion, Still};

/// A step shorter than this fraction of the longest allowed, and than the spacing of times, makes no progress.
const SMALLEST_STEP_RELATIVE: f64 = 1e-15;

/// What a stage that could not be evaluated shortens the step to.
const FAILED_STAGE_FACTOR: f64 = 0.25;

/// A step of every moving group.
#[derive(Debug)]
pub(super) struct Trial {
    pub(super) t: f64,
    /// End of the step: `t + h`, or exactly the end of the run.
    end: f64,
    pub(super) groups: Vec<GroupTrial>,
}

/// A step of one group.
#[derive(Debug)]
pub(super) struct GroupTrial {
    /// Movable bodies, ascending.
    pub(super) bodies: Vec<usize>,
    /// Contacts held over the step.
    pub(super) held: Vec<ContactId>,
    pub(super) dense: DenseStep,
    end_state: Vec<f64>,
}

impl Trial {
    pub(super) fn end(&self) -> f64 {
        self.end
    }
}

impl GroupTrial {
    /// States of the group's bodies at a time within the step, written over `states`.
    pub(super) fn states_at(&self, t: f64, states: &mut [BodyState]) {
        let mut flat = vec![0.0; self.end_state.len()];
        self.dense.evaluate(t, &mut flat);
        for (&body, state) in self.bodies.iter().zip(unpack(&flat)) {
            states[body] = state;
        }
    }
}

/// Body states of a flat state, quaternions normalised.
fn unpack(flat: &[f64]) -> impl Iterator<Item = BodyState> + '_ {
    flat.as_chunks::<WIDTH>().0.iter().map(BodyState::from_array)
}

/// One attempt at a step of a group.
struct Attempt {
    integrator: Dop853,
    error: f64,
}

impl Engine {
    /// Integrates every moving group over the longest step that all accept.
    ///
    /// # Errors
    /// When no step is short enough.
    pub(super) fn integrate(&mut self) -> Result<Trial, SimulationError> {
        let limit = self.step_limit();
        let groups = self.constrained_groups();
        if groups.is_empty() {
            return Ok(Trial { t: self.t, end: self.end_of(limit), groups: Vec::new() });
        }
        let mut h = self.proposed_step_s.min(limit);
        loop {
            self.check_step(h)?;
            match self.attempt_all(&groups, h) {
                Ok((trial, factor)) => {
                    self.proposed_step_s = (h * factor).min(self.settings.step_s);
                    return Ok(trial);
                }
                Err(factor) => h *= factor,
            }
        }
    }

    /// Attempts `h` for every group; the factor for the next step on success, for this one again on failure.
    fn attempt_all(&mut self, groups: &[crate::interaction::groups::Group], h: f64) -> Result<(Trial, f64), f64> {
        let mut smallest = f64::INFINITY;
        let mut trials = Vec::with_capacity(groups.len());
        for group in groups {
            let held: Vec<ContactId> = group
                .contacts
                .iter()
                .filter(|&&i| self.touches[i].hold == Hold::Held)
                .map(|&i| self.touches[i].id)
                .collect();
            let mut system = ContactSystem::new(&self.world, &self.states, &group.bodies, &held);
            let mut attempt = self.attempt(&mut system, h).map_err(|_| FAILED_STAGE_FACTOR)?;
            let factor = Dop853::next_step_factor(attempt.error);
            if attempt.error > 1.0 || attempt.error.is_nan() {
                return Err(factor.min(0.9));
            }
            self.certificate.max_step_error = self.certificate.max_step_error.max(attempt.error);
            smallest = smallest.min(factor);
            let dense = attempt.integrator.dense(&mut system).map_err(|_| FAILED_STAGE_FACTOR)?;
            let end_state = attempt.integrator.end_state().to_vec();
            trials.push(GroupTrial { bodies: group.bodies.clone(), held, dense, end_state });
        }
        Ok((Trial { t: self.t, end: self.end_of(h), groups: trials }, smallest))
    }

    fn attempt(&self, system: &mut ContactSystem<'_>, h: f64) -> Result<Attempt, ResponseError> {
        let state = system.pack();
        let scale = error_scale(&self.world, &self.states, system.bodies(), self.settings.tolerance);
        let mut integrator = Dop853::new(state.len());
        let error = integrator.attempt(system, self.t, &state, h, &scale)?;
        Ok(Attempt { integrator, error })
    }

    /// States of each group's bodies at `t_next`: the end of the trial, or of a shorter step from the same start.
    pub(super) fn states_at_end(&self, trial: &Trial, t_next: f64) -> Result<Vec<Vec<BodyState>>, SimulationError> {
        let mut ends = Vec::with_capacity(trial.groups.len());
        for group in &trial.groups {
            if t_next >= trial.end {
                ends.push(unpack(&group.end_state).collect());
                continue;
            }
            let h = t_next - trial.t;
            let mut system = ContactSystem::new(&self.world, &self.states, &group.bodies, &group.held);
            let attempt = self.attempt(&mut system, h).map_err(|source| self.response_error(source))?;
            ends.push(unpack(attempt.integrator.end_state()).collect());
        }
        Ok(ends)
    }

    /// State of a body at a time within a trial step.
    pub(super) fn state_within(&self, trial: &Trial, body: usize, t: f64) -> BodyState {
        match &self.modes[body] {
            Mode::Flight(flight) => flight.state(t),
            Mode::Fixed | Mode::Rest => self.states[body],
            Mode::Constrained => {
                let mut state = self.states[body];
                if let Some((group, index)) = trial.find(body) {
                    let mut flat = vec![0.0; group.end_state.len()];
                    group.dense.evaluate(t, &mut flat);
                    state = unpack(&flat).nth(index).unwrap_or(state);
                }
                state
            }
        }
    }

    /// Motion of a body over a trial step.
    pub(super) fn motion_within(&self, trial: &Trial, body: usize) -> Box<dyn Motion> {
        match (&self.modes[body], trial.find(body), &self.world.bodies[body].rigid) {
            (Mode::Flight(flight), _, _) => flight.clone(),
            (Mode::Constrained, Some((group, index)), Some(rigid)) => {
                match group.dense.body_motion(index * WIDTH, rigid) {
                    Some(motion) => Box::new(motion),
                    None => Box::new(Still(self.states[body].pose)),
                }
            }
            _ => Box::new(Still(self.states[body].pose)),
        }
    }

    /// `t + h`, or exactly the end of the run when the step reaches it.
    fn end_of(&self, h: f64) -> f64 {
        let duration = self.world.scene.duration_s();
        // `t + (duration - t)` may round to either side of the duration.
        if h >= duration - self.t { duration } else { self.t + h }
    }

    fn check_step(&self, h: f64) -> Result<(), SimulationError> {
        let smallest_s = SMALLEST_STEP_RELATIVE * self.settings.step_s;
        if h > smallest_s { Ok(()) } else { Err(SimulationError::StepTooSmall { t: self.t, smallest_s }) }
    }
}

impl Trial {
    /// The group that a body moves with, and its place there.
    fn find(&self, body: usize) -> Option<(&GroupTrial, usize)> {
        self.groups.iter().find_map(|group| Some((group, group.bodies.binary_search(&body).ok()?)))
    }
}

/// Error scale of each number of the flat state: the tolerance times the size of what the number measures. Length is
/// the body's size, speed the larger of its own speed and what gravity gives over its size.
fn error_scale(world: &World, states: &[BodyState], bodies: &[usize], tolerance: f64) -> Vec<f64> {
    let mut scale = Vec::with_capacity(bodies.len() * WIDTH);
    for &body in bodies {
        let length = world.bodies[body].size;
        let velocity = world.velocity(body, &states[body]);
        let gravity_speed = (world.gravity().length() * length).sqrt();
        let speed = velocity.linear.length().max(velocity.angular.length() * length).max(gravity_speed);
        let moment = world.bodies[body].rigid.as_ref().map_or(0.0, |rigid| rigid.moments().z);
        let angular_momentum = moment * speed / length;
        scale.extend([tolerance * length; 3]);
        scale.extend([tolerance; 4]);
        scale.extend([tolerance * speed; 3]);
        scale.extend([tolerance * angular_momentum; 3]);
    }
    scale
}
