//! A run by the thesis's algorithm: one step, and queries at the present.

use super::impulse_models::{move_apart, strike_unconditionally};
use super::system::LoadedBodies;
use crate::accounting::books::Received;
use crate::accounting::long_steps::Movement;
use crate::collision::boxes::Boxes;
use crate::collision::contact_view;
use crate::collision::touch::Touch;
use crate::error::SimulationError;
use crate::identity::contact_id::ContactId;
use crate::model::tolerances::MOST_COLLISIONS;
use crate::model::tolerances::PROPAGATION_THRESHOLD;
use crate::model::{prescribed, reported};
use crate::report::acceleration::Acceleration;
use crate::report::event::EventKind;
use crate::report::frame::{ContactView, IslandView, MotionKind};
use crate::report::momentum_ledger::Momentum;
use crate::report::observer::Observer;
use crate::rows::assembly::Assembly;
use crate::rows::groups::{Group, groups};
use crate::scene::{ContactMethod, Response};
use crate::snapshot::parts::save_contact;
use crate::snapshot::{SnapshotError, content};
use crate::solve::impact::{impulse_event, strike_group};
use crate::solve::reactions::support;
use crate::tier::core::Core;
use crate::tier::fixed_steps::{Continues, SteppedBodies, accelerations_under, contacts_within, next_step_end};
use crate::tier::free_stage::{self, Ends};
use crate::tier::sampling::emit_samples_before;
use crate::tier::{Reached, Tier};
use polhode_dynamics::BodyState;
use polhode_dynamics::field::Wrench;
use polhode_response::impact::{ImpactOutcome, ImpactSettings};
use polhode_response::{Ask, LeastForceStage, Question, ResponseError, SolverSettings, SolverStatus};
use polhode_spatial::DVec3;

/// A contact counts as resting if its rate of separation is at most the speed that gravity gives a body in this many
/// steps (thesis 3.5: "a speed of separation that is sufficiently small").
const SEPARATING_STEPS: f64 = 1.0;

/// Reach of contacts that count as touching, m: none but rounding.
const TOUCH: f64 = 0.0;

/// Forces of the resting contacts.
struct RestingForces {
    touches: Vec<Touch>,
    forces: Vec<f64>,
}

/// A run in progress.
#[derive(Debug)]
pub(crate) struct ThesisEngine {
    bodies: SteppedBodies,
    /// The movable bodies under the forces of the present step.
    loaded: LoadedBodies,
    /// Forces of the resting contacts in the last step, N.
    resting: Vec<(ContactId, f64)>,
}

impl ThesisEngine {
    /// Prepares a run.
    ///
    /// # Errors
    /// When there are more bodies than the broad phase can number.
    pub(crate) fn new(core: &Core, states: Vec<BodyState>) -> Result<Self, SimulationError> {
        let mut engine =
            Self { loaded: LoadedBodies::default(), resting: Vec::new(), bodies: SteppedBodies::new(core, states) };
        engine.bodies.detect(core, TOUCH)?;
        Ok(engine)
    }

    /// The engine of a snapshot. `core` already has the time and the accounts of the snapshot.
    ///
    /// # Errors
    /// When the data are not of this scene.
    pub(crate) fn restored(core: &Core, saved: &content::Thesis) -> Result<Self, SnapshotError> {
        let mut bodies = SteppedBodies::restored(core, &saved.states, &saved.integrator)?;
        bodies.touching_pairs = saved.touching_pairs;
        Ok(Self {
            loaded: LoadedBodies::default(),
            resting: crate::snapshot::parts::restored_forces(&core.model, &saved.resting)?,
            bodies,
        })
    }

    /// One step of section 3.5, to `t_next`.
    fn step(&mut self, core: &mut Core, t_next: f64, observer: &mut dyn Observer) -> Result<(), SimulationError> {
        let touches = self.bodies.detect(core, TOUCH)?;
        self.apply_impulses(core, &touches, observer)?;
        let resting = self.resting_forces(core)?;
        let loads = loads(core, &self.bodies.states, &resting);
        self.resting = resting.touches.iter().map(|touch| touch.id).zip(resting.forces.iter().copied()).collect();

        self.integrate(core, loads.clone(), t_next - core.t)?;
        self.emit_samples_within(core, t_next, observer)?;
        let movable = core.model.movable.clone();
        let before = core.accounts.books.balance(&core.model, &self.bodies.states, &movable);
        let ends = self.bodies.all_states(core, self.bodies.integrator.states(), t_next);
        let received = self.received(core, &resting, &loads, &ends, t_next);
        self.note_movements(core, &ends, t_next - core.t);
        self.bodies.states = ends;
        let after = core.accounts.books.balance(&core.model, &self.bodies.states, &movable);
        core.accounts.books.smooth_stage(before, after, received);
        core.t = t_next;
        core.accounts.count_step();
        core.accounts.observe(&core.model, &self.bodies.states, core.t)?;
        let touches = self.bodies.detect(core, TOUCH)?;
        for touch in &touches {
            core.note_contact(core.t, &self.bodies.states, (touch.id.a, touch.id.b), &touch.kinematics);
        }
        if core.settings.response == Response::ImpulseProjection {
            move_apart(core, &mut self.bodies.states, &touches);
        }
        Ok(())
    }

    /// Records how far the bodies move in a step of `h` (s) to `ends`.
    fn note_movements(&self, core: &mut Core, ends: &[BodyState], h: f64) {
        let model = &core.model;
        for &body in model.movable.iter().filter(|&&body| model.bodies[body].moves()) {
            if model.bodies[body].shape.is_some() {
                let movement = Movement::between(model, body, (&self.bodies.states[body], &ends[body]), (core.t, h));
                core.accounts.measures.long_steps.note(movement);
            }
        }
    }

    /// Applies impulses, one contact after the other, until no contact approaches.
    fn apply_impulses(
        &mut self,
        core: &mut Core,
        touches: &[Touch],
        observer: &mut dyn Observer,
    ) -> Result<(), SimulationError> {
        let all = touches.iter().enumerate().map(|(index, touch)| (index, touch.id.a, touch.id.b));
        for group in groups(&core.model, all) {
            let Some(outcome) = self.strike(core, &group, touches)? else { continue };
            let impulses = group.contacts.iter().zip(&outcome.impulses);
            let impulses = impulses.map(|(&i, &p)| (touches[i].id, &touches[i].kinematics.geometry, p));
            let work = prescribed::prescribed_work(&core.model, &self.bodies.states, impulses.clone());
            let given = support(&core.model, core.accounts.books.ledger.momentum.about, impulses);
            core.accounts.books.impact((outcome.energy_change, 0.0), given, work);
            core.accounts.note_impact(&core.model, core.t, core.settings.impact, &group.bodies, &outcome);
            for application in &outcome.applications {
                let touch = &touches[group.contacts[application.row]];
                core.accounts.add_event(impulse_event(core.t, EventKind::Impact, touch, application));
            }
        }
        core.accounts.emit_events(core.t, observer);
        Ok(())
    }

    /// Applies impulses to the contacts of a group; nothing when its bodies are left as they are.
    fn strike(
        &mut self,
        core: &mut Core,
        group: &Group,
        touches: &[Touch],
    ) -> Result<Option<ImpactOutcome>, SimulationError> {
        let (model, states) = (&core.model, &mut self.bodies.states);
        let outcome = if core.settings.response == Response::ImpulseUnconditional {
            strike_unconditionally(model, states, group, touches)
        } else {
            if group.contacts.iter().all(|&i| touches[i].kinematics.separation_rate >= 0.0) {
                return Ok(None);
            }
            let solver = SolverSettings::default();
            let settings = ImpactSettings { threshold: PROPAGATION_THRESHOLD, limit: MOST_COLLISIONS, solver };
            let law = core.settings.impact;
            strike_group(model, states, group, touches, law, &settings, &mut core.memory).map(|struck| struck.outcome)
        };
        outcome.map(Some).map_err(|source| SimulationError::of_response(core.t, source))
    }

    /// The resting contacts and their forces; none where bodies act on each other by impulses alone.
    fn resting_forces(&mut self, core: &mut Core) -> Result<RestingForces, SimulationError> {
        if core.settings.response != Response::Constraint {
            return Ok(RestingForces { touches: Vec::new(), forces: Vec::new() });
        }
        let slow = SEPARATING_STEPS * core.model.gravity().length() * core.settings.step_s;
        let mut touches = self.bodies.detect(core, TOUCH)?;
        touches.retain(|touch| touch.kinematics.separation_rate.abs() <= slow);
        let mut forces = vec![0.0; touches.len()];
        let all: Vec<_> = touches.iter().enumerate().map(|(index, touch)| (index, touch.id.a, touch.id.b)).collect();
        for group in groups(&core.model, all.into_iter()) {
            let members: Vec<Touch> = group.contacts.iter().map(|&i| touches[i]).collect();
            let solved = group_forces(core, &self.bodies.states, &group.bodies, &members);
            let solved = solved.map_err(|source| SimulationError::of_response(core.t, source))?;
            for (&i, force) in group.contacts.iter().zip(solved) {
                forces[i] = force;
            }
        }
        Ok(RestingForces { touches, forces })
    }

    /// Impulse and work of gravity, fields and fixed bodies over the step to `ends`. Contact forces are constant, and
    /// their points of action move with the centres of mass.
    fn received(
        &self,
        core: &Core,
        resting: &RestingForces,
        loads: &[Wrench],
        ends: &[BodyState],
        t_next: f64,
    ) -> Received {
        let model = &core.model;
        let about = core.accounts.books.ledger.momentum.about;
        let h = t_next - core.t;
        let stage = Ends { t: [core.t, t_next], states: [&self.bodies.states, ends] };
        let mut received = free_stage::received(model, stage, &model.movable, about);
        // The work of constant forces is along the path of the contact points: to second order, by their speed in the
        // middle.
        let mut middle = self.bodies.states.clone();
        prescribed::prescribe(model, core.t + 0.5 * h, &mut middle);
        let contacts = resting.touches.iter().zip(&resting.forces);
        let impulses = contacts.map(|(touch, &force)| (touch.id, &touch.kinematics.geometry, force * h));
        received.external_j += prescribed::prescribed_work(model, &middle, impulses);
        for (&body, (rigid, load)) in model.movable.iter().zip(model.free_motion().bodies().iter().zip(loads)) {
            let state = &self.bodies.states[body];
            let acceleration = model.gravity() + load.force * rigid.inverse_mass();
            let shift = state.linear_velocity * (0.5 * h) + acceleration * (h * h / 6.0);
            let contacts = resting.touches.iter().zip(&resting.forces);
            let contacts = contacts.filter(|(touch, _)| touch.id.a == body || touch.id.b == body);
            let impulses = contacts.map(|(touch, &force)| (touch.id, &touch.kinematics.geometry, force * h));
            let now = support(model, about, impulses);
            let moved = Momentum { linear: DVec3::ZERO, angular: shift.cross(now.linear) };
            received.support = received.support + now + moved;
        }
        received
    }

    /// Integrates the bodies over a step of length `h` under the loads. The integrator continues from its own variables
    /// if only it has changed the states since its last step.
    fn integrate(&mut self, core: &Core, loads: Vec<Wrench>, h: f64) -> Result<(), SimulationError> {
        let loaded = loads.iter().any(|load| *load != Wrench::default());
        self.loaded = LoadedBodies::new(core.model.forces.shared_fields(), loads);
        let motion = self.loaded.motion(core.model.free_motion().bodies(), core.model.gravity());
        let continues = if loaded { Continues::Anew } else { Continues::Untouched };
        self.bodies.integrate(core, &motion, (h, continues))
    }

    /// Gives the observer the samples within the step that has just been integrated, computed by a shorter step under
    /// the same loads.
    fn emit_samples_within(
        &mut self,
        core: &mut Core,
        t_next: f64,
        observer: &mut dyn Observer,
    ) -> Result<(), SimulationError> {
        emit_samples_before(t_next, self, core, observer, |engine, core, t| {
            let motion = engine.loaded.motion(core.model.free_motion().bodies(), core.model.gravity());
            engine.bodies.states_within(core, &motion, t)
        })
    }
}

impl Tier for ThesisEngine {
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

    fn accelerations(&mut self, core: &mut Core) -> Result<Vec<Acceleration>, SimulationError> {
        let resting = self.resting_forces(core)?;
        let loads = loads(core, &self.bodies.states, &resting);
        let motion = core.model.free_motion();
        let bodies = motion.bodies();
        let load_of = |place: usize| {
            let (load, rigid) = (loads.get(place)?, bodies.get(place)?);
            let rotation = self.bodies.states[*core.model.movable.get(place)?].pose.rotation;
            Some((load.force, load.torque + rotation.rotate(rigid.arm()).cross(load.force)))
        };
        Ok(accelerations_under(core, &self.bodies.states, load_of))
    }

    fn contacts(&self, core: &Core, _t: f64, states: &[BodyState]) -> Vec<ContactView> {
        let mut views = Vec::new();
        let mut boxes = Boxes::new(core.settings.broad_phase, states.len());
        for touch in contacts_within(core, states, &mut boxes, TOUCH).unwrap_or_default() {
            let id = touch.id;
            let resting = self.resting.iter().find(|(known, _)| *known == id);
            let force = resting.map_or(0.0, |(_, force)| *force);
            contact_view::view_contact(&core.model, states, &touch, (force, DVec3::ZERO), &mut views);
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
    }

    fn touching_pairs(&self) -> usize {
        self.bodies.touching_pairs
    }

    fn save(&self) -> content::Tier {
        content::Tier::Thesis(content::Thesis {
            states: self.bodies.save_states(),
            resting: self.resting.iter().map(|&(id, force)| (save_contact(id), force)).collect(),
            touching_pairs: self.bodies.touching_pairs,
            integrator: self.bodies.integrator.save(),
        })
    }
}

fn group_forces(
    core: &mut Core,
    states: &[BodyState],
    bodies: &[usize],
    contacts: &[Touch],
) -> Result<Vec<f64>, ResponseError> {
    let model = &core.model;
    let loads = model.loads(core.t, states);
    let rows = contacts.iter().map(|touch| (touch.id, touch.kinematics.geometry));
    let assembly = Assembly::new(model, states, bodies, rows)?;
    let free = assembly.free_accelerations(model, states, &loads);
    let kinematics = contacts.iter().map(|touch| (touch.id, &touch.kinematics));
    let b = assembly.acceleration_constants(model, core.t, states, &free, kinematics)?;
    let (known, contact) = (Question { constants: &b, ..Question::default() }, core.settings.contact);
    let ask = match contact {
        ContactMethod::LeastForce | ContactMethod::Heuristic => Ask::LeastForce,
        ContactMethod::Guesses => Ask::Guesses,
        ContactMethod::ActiveSet | ContactMethod::SequentialImpulses | ContactMethod::ConjugateGradients => {
            Ask::Instant
        }
    };
    let mut found = assembly.answer(known, ask, &mut core.memory)?;
    if let Some(stage) = found.stage {
        if contact != ContactMethod::LeastForce {
            core.accounts.note_residual(core.t, found.report.residual);
        }
        tell_stage(core, stage);
        // The bound in the certificate needs forces under which no contact closes.
        if stage == LeastForceStage::NoForces && b.iter().any(|&b| b < 0.0) {
            let what = match contact {
                ContactMethod::Guesses => "no guess of vanishing contacts had forces, and exact ones were used instead",
                _ => "a linear programme of least total force was not solved, and exact forces were used instead",
            };
            core.accounts.warn_of_tolerated(core.t, what);
            found = assembly.answer(known, Ask::Instant, &mut core.memory)?;
        }
    }
    if found.stage.is_none() && found.report.status != SolverStatus::Solved {
        let names = reported::names_of(&core.model, assembly.bodies());
        let residual = found.report.residual;
        let what =
            format!("the solver found no contact forces of {names}: the relative residual stays at {residual:e}");
        core.accounts.note_unsolved(core.t, what);
    }
    let worst = &mut core.accounts.certificate.max_acceleration_error_bound;
    *worst = Some(worst.unwrap_or(0.0).max(found.report.bound));
    Ok(found.reactions)
}

/// Tells what a method of the thesis took for vanishing contacts.
fn tell_stage(core: &mut Core, stage: LeastForceStage) {
    match (core.settings.contact, stage) {
        (ContactMethod::Guesses, LeastForceStage::GuessOfVanishing) => {
            core.accounts.warn(core.t, "guesses took contacts for vanishing: they bear no force and open");
        }
        (ContactMethod::Heuristic, LeastForceStage::GuessOfVanishing) => core.accounts.warn(
            core.t,
            "the heuristic took contacts for vanishing, those that the forces of least sum open, and found forces \
             (stage 2)",
        ),
        (ContactMethod::Heuristic, LeastForceStage::LeastSum) => core.accounts.warn_of_tolerated(
            core.t,
            "the heuristic's guess of vanishing contacts has no forces: those of least sum were used, which add energy \
             (stage 3)",
        ),
        _ => {}
    }
}

/// Resultant force and torque of the contact forces on every movable body.
fn loads(core: &Core, states: &[BodyState], resting: &RestingForces) -> Vec<Wrench> {
    let mut loads = vec![Wrench::default(); core.model.movable.len()];
    for (touch, &force) in resting.touches.iter().zip(&resting.forces) {
        for (body, signed) in [(touch.id.a, force), (touch.id.b, -force)] {
            let (Some(slot), Some(rigid)) = (core.model.slot(body), &core.model.bodies[body].rigid) else { continue };
            let geometry = &touch.kinematics.geometry;
            let vector = geometry.normal * signed;
            loads[slot].force += vector;
            loads[slot].torque += (geometry.point - rigid.center_of_mass_position(&states[body])).cross(vector);
        }
    }
    loads
}
