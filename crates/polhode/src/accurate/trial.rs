//! A trial step: every moving group integrated once, under error control, before any event is looked for.
//!
//! All groups take the same step, the longest that all of their error estimates accept, so that each body has one
//! motion over the step. The attitude of a body that only forces through its centre of mass act on is that of free
//! rotation, unless an integrator is asked for by name. A trial that an event cuts short is repeated from its start with the shorter step, not
//! interpolated, so that states at events are as accurate as states at step ends.

use super::engine::{Engine, Mode};
use super::stepped::SteppedTrial;
use super::system::{ContactSystem, received};
use crate::SimulationError;
use crate::books::Received;
use crate::interaction::contact_set::{ContactId, Hold};
use polhode_dynamics::field::Wrench;
use polhode_dynamics::integrator::dop853::STEP_SHARE;
use polhode_dynamics::state::{ANGULAR_MOMENTUM, LINEAR_VELOCITY, POSITION, QUATERNION, WIDTH};
use polhode_dynamics::{BodyState, DenseStep, Dop853, Flight, RigidBody};
use polhode_response::ResponseError;
use polhode_spatial::{DVec3, Motion, Still};
use std::ops::Range;

/// A step shorter than this fraction of the longest allowed, and than the spacing of times, makes no progress.
const SMALLEST_STEP_RELATIVE: f64 = 1e-15;

/// Rounding of the directions of contact forces, of which one stage may differ from another: that of the normals, a few
/// rounding units.
const DIRECTION_ROUNDING: f64 = 2.0 * f64::EPSILON;

/// What a stage that could not be evaluated shortens the step to.
const FAILED_STAGE_FACTOR: f64 = 0.25;

/// A step of every moving group.
#[derive(Debug)]
pub(super) struct Trial {
    pub(super) t: f64,
    /// End of the step: `t + h`, or exactly the end of the run.
    end: f64,
    pub(super) groups: Vec<GroupTrial>,
    pub(super) stepped: Option<SteppedTrial>,
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
    /// Free rotations of those bodies that nothing turns.
    spins: Vec<Option<Flight>>,
}

impl Trial {
    pub(super) fn end(&self) -> f64 {
        self.end
    }
}

impl GroupTrial {
    /// The pairs that contacts hold together, ascending.
    pub(super) fn held_pairs(&self) -> Vec<(usize, usize)> {
        let mut pairs: Vec<_> = self.held.iter().map(|id| (id.a, id.b)).collect();
        pairs.dedup();
        pairs
    }

    /// States of the group's bodies at a time within the step, written over `states`.
    pub(super) fn states_at(&self, t: f64, states: &mut [BodyState]) {
        let mut flat = vec![0.0; self.end_state.len()];
        self.dense.evaluate(t, &mut flat);
        for (index, &body) in self.bodies.iter().enumerate() {
            if let Some(state) = self.state(&flat, index, t) {
                states[body] = state;
            }
        }
    }

    /// State of the body of this index, from the group's flat state at `t`.
    fn state(&self, flat: &[f64], index: usize, t: f64) -> Option<BodyState> {
        let mut state = BodyState::from_array(flat.as_chunks::<WIDTH>().0.get(index)?);
        if let Some(Some(spin)) = self.spins.get(index) {
            state.pose.rotation = spin.pose(t).rotation;
            state.angular_momentum = spin.start().angular_momentum;
        }
        Some(state)
    }

    /// The group at the end of its step, from its flat state there.
    fn at_end(&self, flat: &[f64], t: f64) -> GroupEnd {
        let states = (0..self.bodies.len()).filter_map(|index| self.state(flat, index, t)).collect();
        GroupEnd { states, received: received(flat) }
    }
}

/// Body states of a flat state, quaternions normalised.
fn unpack(flat: &[f64]) -> impl Iterator<Item = BodyState> + '_ {
    flat.as_chunks::<WIDTH>().0.iter().map(BodyState::from_array)
}

/// A group at the end of its step.
pub(super) struct GroupEnd {
    /// States of its bodies.
    pub(super) states: Vec<BodyState>,
    /// What gravity and fixed bodies gave to it over the step.
    pub(super) received: Received,
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
        match self.try_to_integrate() {
            Err(error) if self.gives_up_splitting(&error) => self.try_to_integrate(),
            result => result,
        }
    }

    fn try_to_integrate(&mut self) -> Result<Trial, SimulationError> {
        let limit = self.step_limit();
        let groups = self.constrained_groups();
        if groups.is_empty() {
            let end = self.end_of(limit);
            let stepped = self.step_freely(end)?;
            return Ok(Trial { t: self.t, end, groups: Vec::new(), stepped });
        }
        let mut h = self.proposed_step_s;
        if self.is_instant(limit - h) {
            h = limit;
        }
        loop {
            // A step that ends where a force is not smooth may be as short as it must.
            if h < limit {
                self.check_step(h)?;
            }
            match self.attempt_all(&groups, h) {
                Ok((mut trial, factor)) => {
                    trial.stepped = self.step_freely(trial.end)?;
                    // A step that was cut short says nothing against a longer one.
                    let kept = if factor >= 1.0 && h == limit { self.proposed_step_s } else { 0.0 };
                    self.proposed_step_s = (h * factor).max(kept).min(self.settings.step_s);
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
            let mut system =
                ContactSystem::new(&self.world, &self.states, &group.bodies, &held, self.books.ledger.momentum.about);
            let mut attempt = self.attempt(&mut system, h).map_err(|_| FAILED_STAGE_FACTOR)?;
            let factor = Dop853::next_step_factor(attempt.error);
            if attempt.error > 1.0 || attempt.error.is_nan() {
                return Err(factor.min(0.9));
            }
            self.certificate.max_step_error = self.certificate.max_step_error.max(attempt.error);
            smallest = smallest.min(factor);
            let dense = attempt.integrator.dense(&mut system).map_err(|_| FAILED_STAGE_FACTOR)?;
            let end_state = attempt.integrator.end_state().to_vec();
            let spins = group.bodies.iter().map(|&body| self.free_spin(body, &held)).collect();
            trials.push(GroupTrial { bodies: group.bodies.clone(), held, dense, end_state, spins });
        }
        Ok((Trial { t: self.t, end: self.end_of(h), groups: trials, stepped: None }, smallest))
    }

    /// Free rotation of a body over a step from now, if no held contact and no force can turn it: the record of the step
    /// before, not chained, as long as the body is where that leads.
    fn free_spin(&mut self, body: usize, held: &[ContactId]) -> Option<Flight> {
        let is_held = held.iter().any(|id| id.a == body || id.b == body);
        if is_held || self.settings.asked_integrator.is_some() || !self.world.is_pushed_only(body) {
            return None;
        }
        let (t, state) = (self.t, self.states[body]);
        let leads_here = |spin: &Flight| {
            spin.pose(t).rotation == state.pose.rotation && spin.start().angular_momentum == state.angular_momentum
        };
        if let Some(spin) = self.spins.get(&body).filter(|spin| leads_here(spin)) {
            return Some(*spin);
        }
        let rigid = self.world.bodies[body].rigid.as_ref()?;
        let spin = Flight::new(rigid, t, &state, DVec3::ZERO);
        self.spins.insert(body, spin);
        Some(spin)
    }

    fn attempt(&self, system: &mut ContactSystem<'_>, h: f64) -> Result<Attempt, ResponseError> {
        let state = system.pack();
        let mut integrator = Dop853::new(state.len());
        integrator.attempt_unscaled(system, self.t, &state, h)?;
        let error = self.error_of(&integrator, system, h);
        Ok(Attempt { integrator, error })
    }

    /// Largest error of an attempt over the quantities of the bodies, in units of what a step may err: NaN when one is.
    fn error_of(&self, integrator: &Dop853, system: &ContactSystem<'_>, h: f64) -> f64 {
        let (bodies, t_end) = (system.bodies(), self.t + h);
        let mut worst = 0.0f64;
        let mut ends = self.states.clone();
        for (&body, state) in bodies.iter().zip(unpack(integrator.end_state())) {
            ends[body] = state;
        }
        let loads = self.world.loads(t_end, &ends);
        for (index, &body) in bodies.iter().enumerate() {
            let offset = index * WIDTH;
            let own = offset..offset + WIDTH;
            let (rates, end) = (integrator.start_rates().get(own.clone()), integrator.end_state().get(own));
            let (Some(rates), Some(end)) = (rates, end) else { continue };
            let allowances = self.allowances(body, rates, end, loads.of(body));
            let roundings = self.roundings(body, system.cancelling()[index], h);
            for ((quantity, allowed), rounding) in allowances.into_iter().zip(roundings) {
                let allowed = allowed.max(rounding);
                let error = integrator.error_of(offset + quantity.start..offset + quantity.end);
                // No error is none, also where nothing moves and nothing is allowed.
                let ratio = if error == 0.0 { 0.0 } else { error / allowed };
                worst = if ratio > worst || ratio.is_nan() { ratio } else { worst };
            }
        }
        worst
    }

    /// The error allowed in a step for each quantity of a body: the tolerance, of which a step may use [`STEP_SHARE`],
    /// times the size of what the quantity measures. Length is the body's size, speed the largest of its own speed at
    /// both ends of the step and what gravity, its accelerations at the start (`rates`) and the forces at the end give
    /// over its size. The larger of two errors counts, not their mean: more bodies do not make a step more lenient.
    fn allowances(&self, body: usize, rates: &[f64], end: &[f64], load: Wrench) -> [(Range<usize>, f64); 4] {
        let tolerance = STEP_SHARE * self.settings.tolerance;
        let length = self.world.bodies[body].size;
        let velocity = self.world.velocity(body, &self.states[body]);
        let gravity_speed = (self.world.gravity().length() * length).sqrt();
        let rigid = self.world.bodies[body].rigid.as_ref();
        let moment = rigid.map_or(0.0, |rigid| rigid.moments().max_element());
        let inverse_mass = rigid.map_or(0.0, RigidBody::inverse_mass);
        let size = |of: &[f64], first: usize| DVec3::new(of[first], of[first + 1], of[first + 2]).length();
        let per_moment = |value: f64| if moment > 0.0 { value / moment } else { 0.0 };
        let speed = [
            gravity_speed,
            velocity.linear.length(),
            velocity.angular.length() * length,
            (size(rates, LINEAR_VELOCITY) * length).sqrt(),
            per_moment(size(rates, ANGULAR_MOMENTUM)).sqrt() * length,
            // Where a force sets in within the step, what moves at its end is of the order of the error.
            (load.force.length() * inverse_mass * length).sqrt(),
            per_moment(load.torque.length()).sqrt() * length,
            size(end, LINEAR_VELOCITY),
            per_moment(size(end, ANGULAR_MOMENTUM)) * length,
        ]
        .into_iter()
        .fold(0.0, f64::max);
        [
            (POSITION..QUATERNION, tolerance * length),
            (QUATERNION..LINEAR_VELOCITY, 0.5 * tolerance),
            (LINEAR_VELOCITY..ANGULAR_MOMENTUM, tolerance * speed),
            (ANGULAR_MOMENTUM..WIDTH, tolerance * moment * speed / length),
        ]
    }

    /// What contact forces whose magnitudes add up to `cancelling` (N, N m) leave by rounding in a step of `h` (s), for
    /// each quantity of a body: shorter steps do not make it less.
    fn roundings(&self, body: usize, [force, moment]: [f64; 2], h: f64) -> [f64; 4] {
        let Some(rigid) = &self.world.bodies[body].rigid else { return [0.0; 4] };
        let inverse_moment = 1.0 / rigid.moments().min_element();
        let (speed, spin) = (DIRECTION_ROUNDING * force * h, DIRECTION_ROUNDING * moment * h);
        [speed * rigid.inverse_mass() * h, 0.5 * spin * inverse_moment * h, speed * rigid.inverse_mass(), spin]
    }

    /// States of each group's bodies at `t_next`: the end of the trial, or of a shorter step from the same start.
    pub(super) fn states_at_end(&self, trial: &Trial, t_next: f64) -> Result<Vec<GroupEnd>, SimulationError> {
        let mut ends = Vec::with_capacity(trial.groups.len());
        for group in &trial.groups {
            if t_next >= trial.end {
                ends.push(group.at_end(&group.end_state, t_next));
                continue;
            }
            let h = t_next - trial.t;
            let mut system = ContactSystem::new(
                &self.world,
                &self.states,
                &group.bodies,
                &group.held,
                self.books.ledger.momentum.about,
            );
            let attempt = self.attempt(&mut system, h).map_err(|source| self.response_error(source))?;
            ends.push(group.at_end(attempt.integrator.end_state(), t_next));
        }
        Ok(ends)
    }

    /// State of a body at a time within a trial step.
    pub(super) fn state_within(&self, trial: &Trial, body: usize, t: f64) -> BodyState {
        match &self.modes[body] {
            Mode::Flight(flight) => flight.state(t),
            // Those of stepped bodies are written by `stepped_states`.
            Mode::Fixed | Mode::Rest | Mode::Stepped => self.states[body],
            Mode::Constrained => {
                let mut state = self.states[body];
                if let Some((group, index)) = trial.find(body) {
                    let mut flat = vec![0.0; group.end_state.len()];
                    group.dense.evaluate(t, &mut flat);
                    state = group.state(&flat, index, t).unwrap_or(state);
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
            (Mode::Stepped, _, Some(rigid)) => {
                let dense = trial.stepped.as_ref().and_then(|stepped| stepped.dense.as_ref());
                let motion =
                    dense.zip(self.world.slot(body)).and_then(|(dense, slot)| dense.body_motion(slot * WIDTH, rigid));
                match motion {
                    Some(motion) => Box::new(motion),
                    None => Box::new(Still(self.states[body].pose)),
                }
            }
            _ => Box::new(Still(self.states[body].pose)),
        }
    }

    /// `t + h`, or exactly the horizon when the step reaches it: `t + (end - t)` may round to either side of the end.
    fn end_of(&self, h: f64) -> f64 {
        let end = self.horizon();
        if h >= end - self.t { end } else { self.t + h }
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
