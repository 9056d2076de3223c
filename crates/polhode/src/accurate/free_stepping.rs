//! Steps of bodies without contacts by the integrator that the scene names or the plan chooses.
//!
//! The integrator moves the bodies of an island by steps of a given length, and keeps its own variables from step to
//! step; after an event it starts anew from the states. The states within a step are evaluated by the method itself. If
//! such bodies may collide, the search for impacts needs their motion over the step. It is then represented by
//! polynomials, each through eight states; the number of polynomials follows from the angle by which the bodies turn.
//!
//! The length of the steps adapts to the motion if the plan has chosen splitting under error control, the scene names
//! no step, and no bodies may collide. The next step is twice as long after a step that the integrator has not divided
//! and whose error is negligible, and half as long after a step that it has divided into many parts.

use super::constrained_step::{end_of, step_limit};
use crate::accounting::books::Received;
use crate::error::SimulationError;
use crate::model::states_of::states_of;
use crate::model::{Model, work};
use crate::plan::free_method::MOST_SPLITTINGS;
use crate::snapshot::numbers::{read_states, write_states};
use crate::snapshot::{SnapshotError, content};
use crate::tier::core::Core;
use crate::tier::free_stage::{self, Ends};
use crate::tier::settings::Settings;
use polhode_dynamics::field::{self, Account, Dependence, Field, Wrench};
use polhode_dynamics::integrated_motion::IntegratedMotion;
use polhode_dynamics::integrator::{self, AdaptiveExact, Tolerance};
use polhode_dynamics::state::WIDTH;
use polhode_dynamics::{BodyState, DenseStep, FreeMotion, RigidBody};
use polhode_spatial::{DVec3, Motion, MotionBounds, Pose, Velocity};
use std::sync::Arc;

/// Turn of a body within one polynomial, rad: the interpolation of its quaternion then errs by some 1e-14.
const TURN_OF_POLYNOMIAL: f64 = 0.5;

/// Most polynomials of one step. If a body turns too fast for them, an impact may be found late; the certificate then
/// shows the penetration.
const MOST_POLYNOMIALS: f64 = 4096.0;

/// Number of parts of a step that error-controlled splitting has not divided: its error estimate alone needs two.
const UNDIVIDED: u32 = 2;

/// A step whose error is below this fraction of the allowed error is followed by a longer one (dimensionless, 1e-9 to
/// 1e-3). The error of a step twice as long is 32 times as large, and over a run it must stay far below that of a fixed
/// step.
const NEGLIGIBLE_ERROR: f64 = 1e-3;

/// Number of parts from which on the next step is shorter: twice as many as a step twice as long may take at order 4.
const MUCH_DIVIDED: u32 = 8;

/// A step of bodies by an integrator of free motion.
#[derive(Debug)]
pub(super) struct FreeStep {
    /// Movable bodies, ascending, and their mass properties.
    bodies: Vec<usize>,
    rigid: Vec<RigidBody>,
    /// The scene's fields on those.
    fields: Vec<Box<dyn Field>>,
    integrator: Box<dyn integrator::Integrator>,
    /// Start of the step, s, and the integrator's own time there.
    t: f64,
    from: f64,
    /// End of the step, s.
    pub(super) end: f64,
    /// States at its start.
    start: Vec<BodyState>,
    /// Motion of each body over the step, where it is needed.
    motions: Vec<Option<Piecewise>>,
    /// States at the present.
    present: Vec<BodyState>,
    /// Length of the next step, if the length adapts to the motion, s.
    own_step_s: f64,
}

impl FreeStep {
    /// The first step, from `t` (s) and the states of all bodies.
    ///
    /// # Errors
    /// When no step is possible.
    pub(super) fn first(
        core: &mut Core,
        bodies: &[usize],
        states: &[BodyState],
        t: f64,
    ) -> Result<Self, SimulationError> {
        let mut step = Self::unstarted(core, bodies, t);
        step.start = states_of(states, bodies);
        step.present = step.start.clone();
        let motion = Self::motion(&step.rigid, &step.fields, &core.model);
        step.integrator.start(&motion, t, &step.start);
        step.advance(core)?;
        Ok(step)
    }

    /// No step yet of these bodies, at `t` (s).
    fn unstarted(core: &Core, bodies: &[usize], t: f64) -> Self {
        let model = &core.model;
        let rigid: Vec<RigidBody> = bodies.iter().filter_map(|&body| model.bodies[body].rigid).collect();
        let slots: Vec<usize> = bodies.iter().filter_map(|&body| model.slot(body)).collect();
        let own = Restricted { fields: model.forces.shared_fields(), all: model.shared_rigid(), slots };
        let fields: Vec<Box<dyn Field>> = if model.forces.has_fields() { vec![Box::new(own)] } else { Vec::new() };
        let integrator: Box<dyn integrator::Integrator> = if core.settings.splits_by_choice() {
            // A run may ask for more than its start: beyond this they would cost more than DOP853.
            Box::new(AdaptiveExact::new(tolerance(&core.settings)).limited_to(4 * MOST_SPLITTINGS))
        } else {
            core.settings.build_integrator()
        };
        let (start, present, motions) = (Vec::new(), Vec::new(), Vec::new());
        let own_step_s = core.settings.step_s;
        let bodies = bodies.to_vec();
        Self { bodies, rigid, fields, integrator, t, from: t, end: t, start, motions, present, own_step_s }
    }

    /// The step as plain data.
    pub(super) fn save(&self) -> content::FreeStep {
        content::FreeStep {
            from: self.from,
            end: self.end,
            start: write_states(&self.start),
            present: write_states(&self.present),
            integrator: self.integrator.save(),
            own_step_s: self.own_step_s,
        }
    }

    /// The step of such data, which these bodies began at `t` (s).
    ///
    /// # Errors
    /// When the data are not of these bodies.
    pub(super) fn restored(
        core: &Core,
        bodies: &[usize],
        t: f64,
        saved: &content::FreeStep,
    ) -> Result<Self, SimulationError> {
        let mut step = Self::unstarted(core, bodies, t);
        (step.from, step.end, step.own_step_s) = (saved.from, saved.end, saved.own_step_s);
        step.start = read_states(&saved.start, bodies.len())?;
        step.present = read_states(&saved.present, bodies.len())?;
        let motion = Self::motion(&step.rigid, &step.fields, &core.model);
        let refused = SnapshotError::Invalid("the variables of an integrator do not fit its bodies");
        step.integrator.restore(&motion, &saved.integrator).map_err(|_| refused.clone())?;
        let is_within = t <= step.end && step.from <= step.integrator.time();
        if !is_within || step.integrator.states().len() != bodies.len() {
            return Err(refused.into());
        }
        step.motions = step.polynomials(core)?;
        Ok(step)
    }

    /// The next step.
    ///
    /// # Errors
    /// When no step is possible.
    pub(super) fn next(mut self, core: &mut Core) -> Result<Self, SimulationError> {
        self.t = self.end;
        self.start = self.integrator.states().to_vec();
        self.advance(core)?;
        Ok(self)
    }

    fn motion<'a>(rigid: &'a [RigidBody], fields: &'a [Box<dyn Field>], model: &Model) -> FreeMotion<'a> {
        FreeMotion::new(rigid, model.gravity(), fields)
    }

    fn advance(&mut self, core: &mut Core) -> Result<(), SimulationError> {
        let mut h = if adapts_step(core) { self.own_step_s } else { step_limit(core, (&[], &[]), self.t) };
        self.from = self.integrator.time();
        let motion = Self::motion(&self.rigid, &self.fields, &core.model);
        loop {
            self.end = end_of(core, (&[], &[]), self.t, h);
            match self.integrator.step(&motion, self.end - self.t) {
                Ok(()) => break,
                // Only a failed step of the length that the scene allows shows that forces are too strong for
                // splitting.
                Err(_) if adapts_step(core) && h > core.settings.step_s => h = (0.5 * h).max(core.settings.step_s),
                Err(source) => return Err(SimulationError::Integration { t_s: self.t, source }),
            }
        }
        let steps = self.rigid.len() * self.integrator.inner_steps() as usize;
        core.model.work.add(steps * work::OF_STEP);
        let error = self.integrator.step_error().unwrap_or(f64::INFINITY);
        self.own_step_s = match self.integrator.inner_steps() {
            ..=UNDIVIDED if error < NEGLIGIBLE_ERROR => 2.0 * h,
            MUCH_DIVIDED.. => (0.5 * h).max(core.settings.step_s),
            _ => h,
        };
        if let Some(error) = self.integrator.step_error() {
            core.accounts.note_step_error(error);
        }
        self.motions = self.polynomials(core)?;
        Ok(())
    }

    /// Polynomials for the motions of the bodies, if some may collide.
    fn polynomials(&mut self, core: &Core) -> Result<Vec<Option<Piecewise>>, SimulationError> {
        let model = &core.model;
        let collides = |body: usize| model.bodies[body].shape.is_some();
        if !model.surfaces.may_collide() || !self.bodies.iter().any(|&body| collides(body)) {
            return Ok(Vec::new());
        }
        let speeds = self.bodies.iter().zip(&self.rigid).zip(&self.start).filter(|((body, _), _)| collides(**body));
        let turning = speeds.map(|((_, rigid), state)| rigid.velocity(state).angular.length()).fold(0.0, f64::max);
        let (t, end) = (self.t, self.end);
        // If the count is not a number, one polynomial is made.
        let count = (((end - t) * turning / TURN_OF_POLYNOMIAL).ceil().clamp(1.0, MOST_POLYNOMIALS) as u32).max(1);
        let mut sample = |t: f64| self.states_at(model, t);
        let time = |k: u32| if k == count { end } else { t + (end - t) * (f64::from(k) / f64::from(count)) };
        let parts = (0..count).map(|k| DenseStep::through(time(k), time(k + 1) - time(k), &mut sample));
        let parts = parts.collect::<Result<Vec<_>, _>>()?;
        let own = |(index, rigid): (usize, &RigidBody)| {
            let parts: Option<Vec<_>> = parts.iter().map(|part| part.body_motion(index * WIDTH, rigid)).collect();
            parts.filter(|parts| !parts.is_empty()).map(|parts| Piecewise { parts })
        };
        Ok(self.rigid.iter().enumerate().map(own).collect())
    }

    /// States of the bodies at a time within the step.
    ///
    /// # Errors
    /// When the integrator cannot evaluate them.
    pub(super) fn states_at(&mut self, model: &Model, t: f64) -> Result<Vec<BodyState>, SimulationError> {
        let motion = Self::motion(&self.rigid, &self.fields, model);
        let mut states = self.start.clone();
        // The integrator's own sum of steps may differ from the island's time by a rounding, at both ends of a step.
        self.integrator
            .states_within(&motion, t.min(self.integrator.time()).max(self.from), &mut states)
            .map_err(|source| SimulationError::Integration { t_s: self.t, source })?;
        Ok(states)
    }

    /// States of the bodies at the ends of the parts that the step up to `t` is made of, the first at its start.
    ///
    /// # Errors
    /// When the integrator cannot evaluate them.
    pub(super) fn parts_until(&mut self, model: &Model, t: f64) -> Result<Vec<(f64, Vec<BodyState>)>, SimulationError> {
        let (start, end) = (self.from, self.integrator.time());
        let share = if end > start { ((t - start) / (end - start)).clamp(0.0, 1.0) } else { 1.0 };
        let count = (share * f64::from(self.integrator.inner_steps())).ceil().max(1.0) as u32;
        let mut parts = Vec::with_capacity(count as usize + 1);
        parts.push((start, self.start.clone()));
        for k in 1..=count {
            let at = if k == count { t } else { start + (t - start) * (f64::from(k) / f64::from(count)) };
            // At the end of the step the integrator has its states.
            let states = if at >= end { self.integrator.states().to_vec() } else { self.states_at(model, at)? };
            parts.push((at, states));
        }
        Ok(parts)
    }

    /// Sets the present to a time within the step, s.
    ///
    /// # Errors
    /// When the integrator cannot evaluate it.
    pub(super) fn set_present(&mut self, model: &Model, t: f64) -> Result<(), SimulationError> {
        self.present = if t == self.t { self.start.clone() } else { self.states_at(model, t)? };
        Ok(())
    }

    /// States at the present.
    pub(super) fn present(&self) -> &[BodyState] {
        &self.present
    }

    /// Motion of a body over the step.
    pub(super) fn body_motion(&self, body: usize) -> Option<&Piecewise> {
        self.motions.get(self.bodies.binary_search(&body).ok()?)?.as_ref()
    }
}

/// The scene's fields on some of its movable bodies, which an integrator numbers from zero.
#[derive(Debug)]
struct Restricted {
    fields: Arc<[Box<dyn Field>]>,
    /// Mass properties of all movable bodies.
    all: Arc<[RigidBody]>,
    /// Slots of the bodies: their places among the movable ones.
    slots: Vec<usize>,
}

impl Field for Restricted {
    fn dependence(&self) -> Dependence {
        self.fields.iter().map(|field| field.dependence()).max().unwrap_or(Dependence::Poses)
    }

    fn account(&self) -> Account {
        Account::External
    }

    fn acts_on(&self, body: usize) -> bool {
        self.slots.get(body).is_some_and(|&slot| self.fields.iter().any(|field| field.acts_on(slot)))
    }

    fn corner_between(&self, from: f64, to: f64) -> Option<f64> {
        field::corner_between(&self.fields, from, to)
    }

    fn add_wrenches(&self, t: f64, _bodies: &[RigidBody], states: &[BodyState], wrenches: &mut [Wrench]) {
        // No field of this island depends on bodies of other islands, so their states are arbitrary.
        let mut all_states = vec![BodyState::default(); self.all.len()];
        let mut all_wrenches = vec![Wrench::default(); self.all.len()];
        for (&slot, state) in self.slots.iter().zip(states) {
            all_states[slot] = *state;
        }
        for field in self.fields.iter() {
            field.add_wrenches(t, &self.all, &all_states, &mut all_wrenches);
        }
        for (&slot, wrench) in self.slots.iter().zip(wrenches) {
            wrench.force += all_wrenches[slot].force;
            wrench.torque += all_wrenches[slot].torque;
        }
    }

    fn potential_energy(&self, _bodies: &[RigidBody], _states: &[BodyState]) -> f64 {
        0.0
    }
}

/// Whether the length of the steps adapts to the motion.
fn adapts_step(core: &Core) -> bool {
    core.settings.splits_by_choice() && !core.settings.step_is_given && !core.model.surfaces.may_collide()
}

fn tolerance(settings: &Settings) -> Tolerance {
    Tolerance::new(settings.tolerance).unwrap_or_default()
}

/// One body's motion over polynomials that follow each other.
#[derive(Debug)]
pub(super) struct Piecewise {
    /// At least one.
    parts: Vec<IntegratedMotion>,
}

impl Piecewise {
    /// Where in `parts` a time lies.
    fn index(&self, t: f64) -> usize {
        self.parts.partition_point(|part| part.t0() <= t).saturating_sub(1)
    }
}

impl Motion for Piecewise {
    fn pose(&self, t: f64) -> Pose {
        self.parts[self.index(t)].pose(t)
    }

    fn velocity(&self, t: f64) -> Velocity {
        self.parts[self.index(t)].velocity(t)
    }

    fn bounds(&self, t0: f64, t1: f64) -> MotionBounds {
        let (first, last) = (self.index(t0), self.index(t1));
        let mut bounds = MotionBounds::default();
        for (index, part) in self.parts.iter().enumerate().take(last + 1).skip(first) {
            let from = if index == first { t0 } else { part.t0() };
            let to = if index == last { t1 } else { part.t0() + part.h() };
            let own = part.bounds(from, to);
            bounds.speed = bounds.speed.max(own.speed);
            bounds.acceleration = bounds.acceleration.max(own.acceleration);
            bounds.angular_speed = bounds.angular_speed.max(own.angular_speed);
            bounds.angular_acceleration = bounds.angular_acceleration.max(own.angular_acceleration);
        }
        bounds
    }
}

/// States at `t` of bodies that an integrator of free motion moves, and the momentum and energy that external agents
/// gave to them since their step began; `states` are those of all bodies.
///
/// # Errors
/// When the integrator cannot evaluate them.
pub(super) fn free_end(
    model: &Model,
    step: &mut FreeStep,
    bodies: &[usize],
    states: &[BodyState],
    about: DVec3,
    t: f64,
) -> Result<(Vec<BodyState>, Received), SimulationError> {
    let parts = step.parts_until(model, t)?;
    let mut received = Received::default();
    let mut ends = [states.to_vec(), states.to_vec()];
    for pair in parts.windows(2) {
        let [(t0, start), (t1, end)] = pair else { continue };
        for (k, &body) in bodies.iter().enumerate() {
            (ends[0][body], ends[1][body]) = (start[k], end[k]);
        }
        let stage = Ends { t: [*t0, *t1], states: [&ends[0], &ends[1]] };
        received += free_stage::received(model, stage, bodies, about);
    }
    Ok((parts.into_iter().next_back().map(|(_, states)| states).unwrap_or_default(), received))
}
