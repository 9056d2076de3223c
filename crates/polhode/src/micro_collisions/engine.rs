//! A run by micro-collisions: one step, and queries at the present.

use crate::collision::boxes::Boxes;
use crate::collision::contact_view;
use crate::collision::touch::Touch;
use crate::error::SimulationError;
use crate::identity::contact_id::ContactId;
use crate::model::envelope::CollisionEnvelope;
use crate::model::tolerances::MOST_COLLISIONS;
use crate::model::tolerances::PROPAGATION_THRESHOLD;
use crate::model::tolerances::STATED_DEPTH_RELATIVE;
use crate::report::acceleration::Acceleration;
use crate::report::event::EventKind;
use crate::report::frame::{ContactView, IslandView, MotionKind};
use crate::report::observer::Observer;
use crate::rows::groups::{Group, groups};
use crate::snapshot::parts::{restored_id, save_contact};
use crate::snapshot::{SnapshotError, content};
use crate::solve::impact::{Struck, impulse_event, strike_group};
use crate::tier::core::Core;
use crate::tier::fixed_steps::{Continues, SteppedBodies, accelerations_under, contacts_within, next_step_end};
use crate::tier::free_stage::{self, Ends};
use crate::tier::sampling::emit_samples_before;
use crate::tier::{Reached, Tier};
use polhode_dynamics::BodyState;
use polhode_response::impact::{ImpactSettings, ImpactStatus};
use polhode_spatial::DVec3;

/// Impulses of a contact in the last step, over its length.
#[derive(Debug, Clone, Copy)]
struct MeanForce {
    id: ContactId,
    /// N.
    normal: f64,
    /// Along the tangent plane, on A, N.
    friction: DVec3,
}

/// A run in progress.
#[derive(Debug)]
pub(crate) struct MicroCollisionEngine {
    bodies: SteppedBodies,
    envelope: CollisionEnvelope,
    /// Of the last step.
    forces: Vec<MeanForce>,
}

/// The envelope that the scene gives, or that its smallest body suggests.
fn envelope_of(core: &Core) -> CollisionEnvelope {
    let model = &core.model;
    let sizes = model.movable.iter().map(|&body| model.bodies[body].size).filter(|size| *size > 0.0);
    let smallest = sizes.fold(f64::INFINITY, f64::min);
    let suggested = if smallest.is_finite() { STATED_DEPTH_RELATIVE * smallest } else { STATED_DEPTH_RELATIVE };
    let depth_m = model.scene.method().collision_envelope_m.unwrap_or(suggested);
    CollisionEnvelope::new(depth_m, model.gravity().length())
}

impl MicroCollisionEngine {
    /// Prepares a run.
    pub(crate) fn new(core: &mut Core, states: Vec<BodyState>) -> Self {
        let envelope = envelope_of(core);
        core.model.envelope = Some(envelope);
        core.stated_depth_m = envelope.depth_m;
        Self { bodies: SteppedBodies::new(core, states), envelope, forces: Vec::new() }
    }

    /// The engine of a snapshot. `core` already has the time and the accounts of the snapshot.
    ///
    /// # Errors
    /// When the data are not of this scene.
    pub(crate) fn restored(core: &mut Core, saved: &content::MicroCollisions) -> Result<Self, SnapshotError> {
        let bodies = SteppedBodies::restored(core, &saved.states, &saved.integrator)?;
        let mut engine = Self::new(core, Vec::new());
        engine.bodies = bodies;
        engine.bodies.touching_pairs = saved.touching_pairs;
        for (contact, normal, friction) in &saved.forces {
            let id = restored_id(&core.model, contact)?;
            engine.forces.push(MeanForce { id, normal: *normal, friction: DVec3::from_array(*friction) });
        }
        Ok(engine)
    }

    /// One step, to `t_next`.
    fn step(&mut self, core: &mut Core, t_next: f64, observer: &mut dyn Observer) -> Result<(), SimulationError> {
        let h = t_next - core.t;
        self.collide(core, h, observer)?;
        let movable = core.model.movable.clone();
        let before = core.accounts.books.balance(&core.model, &self.bodies.states, &movable);
        self.integrate(core, h)?;
        self.emit_samples_within(core, t_next, observer)?;
        let ends = self.bodies.all_states(core, self.bodies.integrator.states(), t_next);
        let about = core.accounts.books.ledger.momentum.about;
        let stage = Ends { t: [core.t, t_next], states: [&self.bodies.states, &ends] };
        let received = free_stage::received(&core.model, stage, &movable, about);
        self.bodies.states = ends;
        let after = core.accounts.books.balance(&core.model, &self.bodies.states, &movable);
        core.accounts.books.smooth_stage(before, after, received);
        core.t = t_next;
        core.accounts.count_step();
        core.accounts.observe(&core.model, &self.bodies.states, core.t)?;
        let touches = self.bodies.detect(core, self.envelope.depth_m)?;
        for touch in &touches {
            core.note_contact(core.t, &self.bodies.states, (touch.id.a, touch.id.b), &touch.kinematics);
        }
        Ok(())
    }

    /// Strikes the contacts that approach, those within the envelope and those that would close within `h` (s).
    fn collide(&mut self, core: &mut Core, h: f64, observer: &mut dyn Observer) -> Result<(), SimulationError> {
        self.forces.clear();
        let reach = self.envelope.depth_m + 2.0 * h * fastest(core, &self.bodies.states);
        let mut touches = contacts_within(core, &self.bodies.states, &mut self.bodies.boxes, reach)?;
        let (depth, gravity) = (self.envelope.depth_m, core.model.gravity().length());
        touches.retain(|touch| {
            let (gap, rate) = (touch.kinematics.geometry.separation, touch.kinematics.separation_rate);
            gap <= depth || gap + rate * h - 0.5 * gravity * h * h <= 0.0
        });
        let all: Vec<_> = touches.iter().enumerate().map(|(index, touch)| (index, touch.id.a, touch.id.b)).collect();
        for group in groups(&core.model, all.into_iter()) {
            if group.contacts.iter().any(|&i| touches[i].kinematics.separation_rate < 0.0) {
                self.strike_group(core, &group, &touches)?;
            }
        }
        core.accounts.emit_events(core.t, observer);
        Ok(())
    }

    /// Strikes a group, and books what that did.
    fn strike_group(&mut self, core: &mut Core, group: &Group, touches: &[Touch]) -> Result<(), SimulationError> {
        let settings =
            ImpactSettings { threshold: PROPAGATION_THRESHOLD, limit: MOST_COLLISIONS, ..ImpactSettings::default() };
        let law = core.settings.impact;
        let struck =
            strike_group(&core.model, &mut self.bodies.states, group, touches, law, &settings, &mut core.memory);
        let struck = struck.map_err(|source| SimulationError::of_response(core.t, source))?;
        // Sequences without end are what supports a body on several corners: their end at the threshold is no news.
        let mut outcome = struck.outcome.clone();
        if outcome.status == ImpactStatus::StoppedAtThreshold {
            outcome.status = ImpactStatus::Separated;
        }
        core.accounts.note_impact(&core.model, core.t, law, &group.bodies, &outcome);
        if outcome.status == ImpactStatus::NotSolved {
            return Ok(());
        }
        let members: Vec<Touch> = group.contacts.iter().map(|&i| touches[i]).collect();
        let given = struck.support(&core.model, core.accounts.books.ledger.momentum.about, &members);
        let work = struck.work(&core.model, &self.bodies.states, &members);
        core.accounts.books.impact((outcome.energy_change, struck.friction_j), given, work);
        for application in &outcome.applications {
            let Some(touch) = members.get(application.row) else { continue };
            // Micro-collisions stand for a force, and are no events.
            if -touch.kinematics.separation_rate > self.envelope.slow {
                core.accounts.add_event(impulse_event(core.t, EventKind::Impact, touch, application));
            }
        }
        // An impulse makes up for the flight before it, which was a whole step unless an end of the run cut it short.
        self.note_forces(&members, &struck, core.settings.step_s);
        Ok(())
    }

    /// Keeps the impulses of a step of `h` (s) as mean forces.
    fn note_forces(&mut self, members: &[Touch], struck: &Struck, h: f64) {
        for (touch, impulse) in members.iter().zip(&struck.reactions.normal) {
            let along = struck.reactions.along_tangents().filter(|(id, ..)| *id == touch.id);
            let friction: DVec3 = along.map(|(_, geometry, p)| geometry.normal * p).sum();
            if *impulse != 0.0 {
                self.forces.push(MeanForce { id: touch.id, normal: impulse / h, friction: friction / h });
            }
        }
    }

    /// Integrates the bodies over a step of length `h`. The integrator continues from its own variables if only it has
    /// changed the states since its last step.
    fn integrate(&mut self, core: &Core, h: f64) -> Result<(), SimulationError> {
        let motion = core.model.free_motion();
        self.bodies.integrate(core, &motion, (h, Continues::Untouched))
    }

    /// Gives the observer the samples within the step that has just been integrated, computed by a shorter step.
    fn emit_samples_within(
        &mut self,
        core: &mut Core,
        t_next: f64,
        observer: &mut dyn Observer,
    ) -> Result<(), SimulationError> {
        emit_samples_before(t_next, self, core, observer, |engine, core, t| {
            engine.bodies.states_within(core, &core.model.free_motion(), t)
        })
    }
}

impl Tier for MicroCollisionEngine {
    fn advance(
        &mut self,
        core: &mut Core,
        limit_s: f64,
        observer: &mut dyn Observer,
    ) -> Result<Reached, SimulationError> {
        while core.t < limit_s {
            let t_next = next_step_end(core, limit_s);
            self.step(core, t_next, observer)?;
        }
        Ok(Reached::Limit)
    }

    fn stride(&self, core: &Core) -> f64 {
        core.settings.step_s
    }

    fn states(&self, _core: &Core) -> Vec<BodyState> {
        self.bodies.states.clone()
    }

    fn state(&self, _core: &Core, body: usize) -> BodyState {
        self.bodies.states[body]
    }

    /// Those of free motion: there are no contact forces.
    fn accelerations(&mut self, core: &mut Core) -> Result<Vec<Acceleration>, SimulationError> {
        Ok(accelerations_under(core, &self.bodies.states, |_| None))
    }

    fn contacts(&self, core: &Core, _t: f64, states: &[BodyState]) -> Vec<ContactView> {
        let mut views = Vec::new();
        let mut boxes = Boxes::new(core.settings.broad_phase, states.len());
        for touch in contacts_within(core, states, &mut boxes, self.envelope.depth_m).unwrap_or_default() {
            let force = self.forces.iter().find(|force| force.id == touch.id);
            let force = force.map_or((0.0, DVec3::ZERO), |force| (force.normal, force.friction));
            contact_view::view_contact(&core.model, states, &touch, force, &mut views);
        }
        views
    }

    fn motions(&self, _core: &Core) -> Vec<MotionKind> {
        self.bodies.motions()
    }

    fn islands(&self, _core: &Core) -> Vec<IslandView> {
        self.bodies.islands()
    }

    fn states_mut(&mut self) -> &mut [BodyState] {
        &mut self.bodies.states
    }

    fn add_body(&mut self, core: &Core, state: BodyState) {
        self.bodies.add_body(core, state);
    }

    fn remove_body(&mut self, body: usize) {
        self.bodies.remove_body(body);
        self.forces.retain(|force| force.id.a != body && force.id.b != body);
    }

    fn touching_pairs(&self) -> usize {
        self.bodies.touching_pairs
    }

    fn save(&self) -> content::Tier {
        let force = |force: &MeanForce| (save_contact(force.id), force.normal, force.friction.to_array());
        content::Tier::MicroCollisions(content::MicroCollisions {
            states: self.bodies.save_states(),
            forces: self.forces.iter().map(force).collect(),
            touching_pairs: self.bodies.touching_pairs,
            integrator: self.bodies.integrator.save(),
        })
    }
}

/// Largest speed of any point of a body, m/s, bounded by its size.
fn fastest(core: &Core, states: &[BodyState]) -> f64 {
    let model = &core.model;
    let speed = |(body, state): (usize, &BodyState)| {
        let velocity = model.velocity(body, state);
        velocity.linear.length() + velocity.angular.length() * model.bodies[body].size
    };
    states.iter().enumerate().map(speed).fold(0.0, f64::max)
}
