//! Bodies between contacts by the integrator that the scene asks for.
//!
//! The integrator moves all bodies of [`Mode::Stepped`] together, by steps of the length given, and keeps its own
//! variables from step to step; after an event, or when other bodies have cut a step short, it starts anew from the
//! states. The states within its step are the method's own. Where such bodies may collide, their motion over the step
//! is made of polynomials through eight of those states each, as many as the turning of the bodies needs. No force of the
//! scene acts on the integrator's copies of bodies that move otherwise: they mean nothing, and may go where forces are
//! singular.

use super::engine::{Engine, Mode};
use crate::SimulationError;
use crate::scene::Integrator;
use crate::settings::Settings;
use crate::world::World;
use polhode_dynamics::field::{self, Account, Dependence, Field, Wrench};
use polhode_dynamics::integrated_motion::IntegratedMotion;
use polhode_dynamics::integrator::{self, AdaptiveExact, IntegrationError, MethodSettings, Tolerance};
use polhode_dynamics::{BodyState, DenseStep, Flight, FreeMotion, RigidBody};
use polhode_spatial::{Motion, MotionBounds, Pose, Velocity};
use std::sync::Arc;

/// Turn of a body within one polynomial, rad: the interpolation of its quaternion then errs by some 1e-14.
const TURN_OF_POLYNOMIAL: f64 = 0.5;

/// Splittings within a step that the plan has chosen them for, at the most: more cost more than DOP853 does.
const MOST_SPLITTINGS: u32 = 64;

/// Polynomials of a step at the most: beyond, an impact found late shows in the certificate.
const MOST_POLYNOMIALS: f64 = 4096.0;

/// The integrator of the stepped bodies.
#[derive(Debug)]
pub(super) struct Stepper {
    integrator: Box<dyn integrator::Integrator>,
    /// Whether it stands at the present states.
    current: bool,
    /// Its own time at the start of the last step, s.
    from: f64,
    /// Which movable bodies are stepped.
    stepped: Vec<bool>,
    /// The scene's fields on those.
    fields: [Box<dyn Field>; 1],
}

impl Stepper {
    pub(super) fn new(settings: &Settings) -> Self {
        let fields = Masked { fields: Arc::from(Vec::new()), stepped: Vec::new() };
        let integrator = if settings.splits_by_choice() {
            Box::new(AdaptiveExact::new(tolerance(settings)).limited_to(MOST_SPLITTINGS))
        } else {
            build(settings)
        };
        Self { integrator, current: false, from: 0.0, stepped: Vec::new(), fields: [Box::new(fields)] }
    }

    /// The present states are no longer those of the integrator.
    pub(super) fn interrupt(&mut self) {
        self.current = false;
    }

    /// Steps the movable bodies marked in `stepped` from `states` (of all bodies) at `t` to `end`.
    fn step(
        &mut self,
        world: &World,
        states: &[BodyState],
        stepped: Vec<bool>,
        t: f64,
        end: f64,
    ) -> Result<(), IntegrationError> {
        if self.stepped != stepped {
            self.fields = [Box::new(Masked { fields: world.shared_fields(), stepped: stepped.clone() })];
            self.stepped = stepped;
            self.current = false;
        }
        let motion = FreeMotion::new(world.free_motion().bodies(), world.gravity(), &self.fields);
        if !self.current {
            self.integrator.start(&motion, t, &world.movable_states(states));
            self.current = true;
        }
        self.from = self.integrator.time();
        self.integrator.step(&motion, end - t)
    }

    /// Estimated error of the last step in units of what is allowed; zero for methods that know none.
    fn step_error(&self) -> f64 {
        self.integrator.step_error().unwrap_or(0.0)
    }

    /// States of the movable bodies within the last step.
    fn within(&mut self, world: &World, t: f64, states: &mut [BodyState]) -> Result<(), IntegrationError> {
        let motion = FreeMotion::new(world.free_motion().bodies(), world.gravity(), &self.fields);
        // The integrator's own sum of steps may differ from the engine's time by a rounding, at both ends of a step.
        self.integrator.states_within(&motion, t.min(self.integrator.time()).max(self.from), states)
    }
}

/// The scene's fields on the bodies that are stepped.
#[derive(Debug)]
struct Masked {
    fields: Arc<[Box<dyn Field>]>,
    stepped: Vec<bool>,
}

impl Masked {
    fn is_stepped(&self, body: usize) -> bool {
        self.stepped.get(body).copied().unwrap_or(false)
    }
}

impl Field for Masked {
    fn dependence(&self) -> Dependence {
        self.fields.iter().map(|field| field.dependence()).max().unwrap_or(Dependence::Poses)
    }

    fn account(&self) -> Account {
        Account::External
    }

    fn acts_on(&self, body: usize) -> bool {
        self.is_stepped(body) && self.fields.iter().any(|field| field.acts_on(body))
    }

    fn corner_between(&self, from: f64, to: f64) -> Option<f64> {
        field::corner_between(&self.fields, from, to)
    }

    fn add_wrenches(&self, t: f64, bodies: &[RigidBody], states: &[BodyState], wrenches: &mut [Wrench]) {
        for field in self.fields.iter() {
            field.add_wrenches(t, bodies, states, wrenches);
        }
        for (body, wrench) in wrenches.iter_mut().enumerate() {
            if !self.is_stepped(body) {
                *wrench = Wrench::default();
            }
        }
    }

    fn potential_energy(&self, _bodies: &[RigidBody], _states: &[BodyState]) -> f64 {
        0.0
    }
}

fn tolerance(settings: &Settings) -> Tolerance {
    Tolerance::new(settings.tolerance).unwrap_or_default()
}

/// The integrator of free motion that the settings name.
pub(crate) fn build(settings: &Settings) -> Box<dyn integrator::Integrator> {
    settings.integrator.build(&MethodSettings {
        tolerance: tolerance(settings),
        orientation: settings.orientation,
        rotation_rate: settings.rotation_rate,
        ..MethodSettings::default()
    })
}

/// A step of the stepped bodies.
#[derive(Debug)]
pub(super) struct SteppedTrial {
    /// The motion of all movable bodies, where it is needed.
    pub(super) dense: Option<SteppedMotion>,
}

/// The motion of all movable bodies over a step: polynomials, one after the other.
#[derive(Debug)]
pub(super) struct SteppedMotion {
    parts: Vec<DenseStep>,
}

impl SteppedMotion {
    /// Motion of the body whose state begins at `offset`; nothing when the state ends before it does.
    pub(super) fn body_motion(&self, offset: usize, body: &RigidBody) -> Option<Piecewise> {
        let parts: Option<Vec<_>> = self.parts.iter().map(|part| part.body_motion(offset, body)).collect();
        parts.filter(|parts| !parts.is_empty()).map(|parts| Piecewise { parts })
    }
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

impl Engine {
    /// Bodies that the chosen integrator moves.
    pub(super) fn stepped_bodies(&self) -> Vec<usize> {
        (0..self.modes.len()).filter(|&body| matches!(self.modes[body], Mode::Stepped)).collect()
    }

    /// Mode of a body that no contact holds.
    pub(super) fn free_mode(&self, body: usize) -> Option<Mode> {
        let rigid = self.world.bodies[body].rigid.as_ref()?;
        let loaded = self.world.is_loaded(body);
        Some(match self.settings.integrator {
            _ if self.settings.flies() && !loaded => {
                // In planar motion the spin is about a principal axis, to rounding that must not grow.
                let record = if self.world.plane.is_some() { Flight::steady } else { Flight::new };
                let acceleration = self.world.free_acceleration(body);
                Mode::Flight(Box::new(record(rigid, self.t, &self.states[body], acceleration)))
            }
            Integrator::Dop853 => Mode::Constrained,
            // What is coupled to bodies that contacts may hold is integrated with them.
            _ if self.world.may_collide_at_all() && self.world.is_coupled(body) => Mode::Constrained,
            _ => Mode::Stepped,
        })
    }

    /// Whether splitting, which the plan has chosen, is given up from now on because forces have grown strong: DOP853 goes
    /// on from the present states.
    pub(super) fn gives_up_splitting(&mut self, error: &SimulationError) -> bool {
        let is_too_small =
            matches!(error, SimulationError::Integration { source: IntegrationError::StepTooSmall { .. }, .. });
        if !is_too_small || !self.settings.splits_by_choice() {
            return false;
        }
        self.warn("forces have grown too strong for splitting: dop853 goes on from here");
        self.settings.integrator = Integrator::Dop853;
        for body in self.stepped_bodies() {
            self.modes[body] = Mode::Constrained;
        }
        true
    }

    /// Steps the stepped bodies to `end`; nothing when there are none.
    pub(super) fn step_freely(&mut self, end: f64) -> Result<Option<SteppedTrial>, SimulationError> {
        let bodies = self.stepped_bodies();
        if bodies.is_empty() {
            return Ok(None);
        }
        let failed = |source| SimulationError::Integration { t: self.t, source };
        let marks = self.world.movable.iter().map(|body| bodies.binary_search(body).is_ok()).collect();
        self.stepper.step(&self.world, &self.states, marks, self.t, end).map_err(failed)?;
        self.certificate.max_step_error = self.certificate.max_step_error.max(self.stepper.step_error());
        let colliding = || bodies.iter().copied().filter(|&body| self.world.bodies[body].shape.is_some());
        if colliding().next().is_none() || !self.world.may_collide_at_all() {
            return Ok(Some(SteppedTrial { dense: None }));
        }
        let turning = |body: usize| self.world.velocity(body, &self.states[body]).angular.length();
        let turn = (end - self.t) * colliding().map(turning).fold(0.0, f64::max);
        // Not a number counts as one.
        let count = ((turn / TURN_OF_POLYNOMIAL).ceil().clamp(1.0, MOST_POLYNOMIALS) as u32).max(1);
        let (world, stepper, t) = (&self.world, &mut self.stepper, self.t);
        let mut states = world.movable_states(&self.states);
        let mut sample = |t: f64| {
            stepper.within(world, t, &mut states)?;
            Ok(states.clone())
        };
        let time = |k: u32| if k == count { end } else { t + (end - t) * (f64::from(k) / f64::from(count)) };
        let parts = (0..count).map(|k| DenseStep::through(time(k), time(k + 1) - time(k), &mut sample));
        let parts = parts.collect::<Result<Vec<_>, _>>().map_err(failed)?;
        Ok(Some(SteppedTrial { dense: Some(SteppedMotion { parts }) }))
    }

    /// States of the stepped bodies at the ends of the parts that the step up to `t` was made of, the first at its start:
    /// time (s) and states of all bodies.
    pub(super) fn stepped_parts(&mut self, t: f64) -> Result<Vec<(f64, Vec<BodyState>)>, SimulationError> {
        let (start, end) = (self.stepper.from, self.stepper.integrator.time());
        let share = if end > start { ((t - start) / (end - start)).clamp(0.0, 1.0) } else { 1.0 };
        let count = (share * f64::from(self.stepper.integrator.inner_steps())).ceil().max(1.0) as u32;
        let mut parts = Vec::with_capacity(count as usize + 1);
        parts.push((start, self.states.clone()));
        for k in 1..=count {
            let at = if k == count { t } else { start + (t - start) * (f64::from(k) / f64::from(count)) };
            let mut states = self.states.clone();
            self.stepped_states(at, &mut states)?;
            parts.push((at, states));
        }
        Ok(parts)
    }

    /// Writes the states of the stepped bodies at a time within the last step over `states`.
    pub(super) fn stepped_states(&mut self, t: f64, states: &mut [BodyState]) -> Result<(), SimulationError> {
        let bodies = self.stepped_bodies();
        if bodies.is_empty() {
            return Ok(());
        }
        let mut movable = self.world.movable_states(&self.states);
        self.stepper
            .within(&self.world, t, &mut movable)
            .map_err(|source| SimulationError::Integration { t: self.t, source })?;
        for body in bodies {
            if let Some(slot) = self.world.slot(body) {
                states[body] = movable[slot];
            }
        }
        Ok(())
    }
}
