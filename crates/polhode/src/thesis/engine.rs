//! A run by the thesis's algorithm, and one step of it.

use super::system::LoadedBodies;
use crate::accurate::stepped;
use crate::books::{Books, Received};
use crate::free_stage::{self, Ends};
use crate::interaction::assembly::{Assembly, free_acceleration};
use crate::interaction::contact_set::Touch;
use crate::interaction::groups::groups;
use crate::interaction::impact::{impulse_event, strike, support};
use crate::observer::Observer;
use crate::scene::ContactMethod;
use crate::settings::Settings;
use crate::world::World;
use crate::{Acceleration, Certificate, Event, Momentum, RunReport, SimulationError};
use polhode_contact::{Aabb, BroadPhase, swept_aabb};
use polhode_dynamics::field::Wrench;
use polhode_dynamics::integrator::Integrator;
use polhode_dynamics::{BodyState, RigidBody};
use polhode_response::impact::ImpactSettings;
use polhode_response::least_force::{LeastForceStage, least_force};
use polhode_response::{ComplementaritySolver, ResponseError, SolverSettings};
use polhode_spatial::{DVec3, Still};

/// A contact that parts more slowly than gravity makes bodies approach within this many steps is at rest (thesis
/// 3.5: "a speed of separation that is sufficiently small").
const RESTING_STEPS: f64 = 1.0;

/// Impulses by propagation stop when every speed of approach is below this fraction of the first ones (thesis 3.3:
/// "an artificial threshold for the approach velocity").
const PROPAGATION_THRESHOLD: f64 = 1e-6;

/// The largest number of impulses in one step before the rest is resolved at once.
const PROPAGATION_LIMIT: usize = 20_000;

/// Forces of the resting contacts.
struct RestingForces {
    touches: Vec<Touch>,
    forces: Vec<f64>,
}

/// A run in progress.
#[derive(Debug)]
pub(crate) struct ThesisEngine {
    world: World,
    settings: Settings,
    t: f64,
    states: Vec<BodyState>,
    /// Numbers of the bodies that move, and their mass properties.
    movable: Vec<usize>,
    rigid: Vec<RigidBody>,
    integrator: Box<dyn Integrator>,
    /// What acts during the present step.
    loaded: LoadedBodies,
    solver: ComplementaritySolver,
    broad_phase: Box<dyn BroadPhase>,
    /// Pairs whose boxes meet, as the broad phase left them.
    box_pairs: Vec<(u32, u32)>,
    books: Books,
    certificate: Certificate,
    warnings: Vec<String>,
    event_count: u64,
    steps: u64,
    next_sample: u64,
}

impl ThesisEngine {
    pub(crate) fn new(world: World, states: Vec<BodyState>, settings: Settings) -> Self {
        let books = Books::open(&world, &states);
        let movable: Vec<usize> = (0..world.bodies.len()).filter(|&body| world.bodies[body].moves()).collect();
        let rigid = movable.iter().filter_map(|&body| world.bodies[body].rigid).collect();
        Self {
            world,
            settings,
            t: 0.0,
            states,
            movable,
            rigid,
            integrator: stepped::build(&settings),
            loaded: LoadedBodies::default(),
            solver: ComplementaritySolver::default(),
            broad_phase: settings.broad_phase.build(),
            box_pairs: Vec::new(),
            books,
            certificate: Certificate::default(),
            warnings: Vec::new(),
            event_count: 0,
            steps: 0,
            next_sample: 0,
        }
    }

    /// The bodies and their present states.
    pub(crate) fn bodies(&self) -> (&World, &[BodyState]) {
        (&self.world, &self.states)
    }

    /// Time reached, s.
    pub(crate) fn time(&self) -> f64 {
        self.t
    }

    /// One step of section 3.5.
    ///
    /// # Errors
    /// When the state is no longer finite or a contact problem is not.
    pub(crate) fn step(&mut self, observer: &mut dyn Observer) -> Result<(), SimulationError> {
        let duration = self.world.scene.duration_s();
        let h = self.settings.step_s.min(duration - self.t);
        let t_next = if h >= duration - self.t { duration } else { self.t + h };
        if self.steps == 0 {
            self.emit_sample(0.0, &self.states, observer);
            self.next_sample = 1;
        }
        let touches = self.detect()?;
        self.apply_impulses(&touches, observer)?;
        let resting = self.resting_forces()?;
        let loads = self.loads(&resting);

        self.integrate(loads.clone(), h)?;
        self.emit_samples_within(t_next, observer)?;
        let before = self.books.balance(&self.world, &self.states, &self.movable);
        let ends = self.all_states(self.integrator.states());
        let received = self.received(&resting, &loads, &ends, t_next);
        self.states = ends;
        let after = self.books.balance(&self.world, &self.states, &self.movable);
        self.books.smooth_stage(before, after, received);
        self.t = t_next;
        self.steps += 1;
        self.audit()?;
        if self.t >= duration {
            self.emit_sample(self.t, &self.states, observer);
        }
        Ok(())
    }

    /// Penetrations: every contact point of every pair that touches or overlaps.
    ///
    /// # Errors
    /// When there are more bodies than the broad phase can number.
    fn detect(&mut self) -> Result<Vec<Touch>, SimulationError> {
        let mut colliders = Vec::new();
        let mut boxes = Vec::new();
        for (body, (world_body, state)) in self.world.bodies.iter().zip(&self.states).enumerate() {
            if let Some(shape) = &world_body.shape {
                colliders.push(body);
                let aabb = swept_aabb(shape, &Still(state.pose), self.t, self.t);
                boxes.push(aabb.unwrap_or(Aabb::UNBOUNDED));
            }
        }
        self.broad_phase.pairs(&boxes, &mut self.box_pairs).map_err(SimulationError::BroadPhase)?;
        let mut pairs: Vec<_> = self
            .box_pairs
            .iter()
            .map(|&(i, j)| (colliders[i as usize], colliders[j as usize]))
            .filter(|&(a, b)| self.world.scene.may_collide(a, b))
            .collect();
        pairs.sort_unstable();
        let mut touches = Vec::new();
        for (a, b) in pairs {
            let reach = self.world.rounding(&self.states, a, b);
            touches.extend(self.world.contacts_of_pair(&self.states, a, b, reach));
        }
        Ok(touches)
    }

    /// Impulses, one contact after the other, until nothing approaches.
    fn apply_impulses(&mut self, touches: &[Touch], observer: &mut dyn Observer) -> Result<(), SimulationError> {
        let solver_settings = SolverSettings::default();
        let settings =
            ImpactSettings { threshold: PROPAGATION_THRESHOLD, limit: PROPAGATION_LIMIT, solver: solver_settings };
        let all = touches.iter().enumerate().map(|(index, touch)| (index, touch.id.a, touch.id.b));
        for group in groups(&self.world, all) {
            if group.contacts.iter().all(|&i| touches[i].kinematics.separation_rate >= 0.0) {
                continue;
            }
            let law = self.settings.impact;
            let outcome = strike(&self.world, &mut self.states, &group, touches, law, &settings, &mut self.solver)
                .map_err(|source| self.response_error(source))?;
            let impulses = group.contacts.iter().zip(&outcome.impulses);
            let impulses = impulses.map(|(&i, &p)| (touches[i].id, &touches[i].kinematics.geometry, p));
            let given = support(&self.world, self.books.ledger.momentum.about, impulses);
            self.books.impact(outcome.energy_change, given);
            self.certificate.max_residual = self.certificate.max_residual.max(outcome.residual);
            for application in &outcome.applications {
                let event: Event = impulse_event(self.t, &touches[group.contacts[application.row]], application);
                observer.event(&event);
                self.event_count += 1;
            }
        }
        Ok(())
    }

    /// Contacts at rest and their forces.
    fn resting_forces(&mut self) -> Result<RestingForces, SimulationError> {
        let slow = RESTING_STEPS * self.world.gravity().length() * self.settings.step_s;
        let mut touches = self.detect()?;
        touches.retain(|touch| touch.kinematics.separation_rate.abs() <= slow);
        let mut forces = vec![0.0; touches.len()];
        let all: Vec<_> = touches.iter().enumerate().map(|(index, touch)| (index, touch.id.a, touch.id.b)).collect();
        for group in groups(&self.world, all.into_iter()) {
            let rows = group.contacts.iter().map(|&i| (touches[i].id, touches[i].kinematics.geometry));
            let kinematics = group.contacts.iter().map(|&i| &touches[i].kinematics);
            let solved = self.group_forces(&group.bodies, rows, kinematics);
            let solved = solved.map_err(|source| self.response_error(source))?;
            for (&i, force) in group.contacts.iter().zip(solved) {
                forces[i] = force;
            }
        }
        Ok(RestingForces { touches, forces })
    }

    fn group_forces<'a>(
        &mut self,
        bodies: &[usize],
        rows: impl Iterator<Item = (crate::interaction::contact_set::ContactId, polhode_contact::ContactGeometry)>,
        kinematics: impl Iterator<Item = &'a polhode_contact::ContactKinematics>,
    ) -> Result<Vec<f64>, ResponseError> {
        let assembly = Assembly::new(&self.world, &self.states, bodies, rows)?;
        let loads = self.world.loads(self.t, &self.states);
        let free = assembly.free_accelerations(&self.world, &self.states, &loads);
        let b = assembly.acceleration_constants(&free, kinematics)?;
        let delassus = assembly.problem.delassus();
        let (forces, bound) = match self.settings.contact {
            ContactMethod::LeastForce => {
                let solution = least_force(&delassus, &b, &SolverSettings::default())?;
                if solution.stage == LeastForceStage::NoForces && b.iter().any(|&b| b < 0.0) {
                    // The certificate needs forces that keep every contact from closing; the exact ones do.
                    self.warn_once("a linear programme of least force was not solved: exact forces were used");
                    self.certificate.fallbacks += 1;
                    let exact = self.solver.solve(&assembly.problem, &delassus, &b, None)?;
                    (exact.forces.clone(), exact.report.bound)
                } else {
                    (solution.forces, solution.report.bound)
                }
            }
            ContactMethod::ActiveSet => {
                let solution = self.solver.solve(&assembly.problem, &delassus, &b, None)?;
                (solution.forces.clone(), solution.report.bound)
            }
        };
        self.certificate.max_acceleration_error_bound = self.certificate.max_acceleration_error_bound.max(bound);
        Ok(forces)
    }

    /// What the forces add up to on every movable body.
    fn loads(&self, resting: &RestingForces) -> Vec<Wrench> {
        let mut loads = vec![Wrench::default(); self.movable.len()];
        for (touch, &force) in resting.touches.iter().zip(&resting.forces) {
            for (body, signed) in [(touch.id.a, force), (touch.id.b, -force)] {
                if let Ok(index) = self.movable.binary_search(&body) {
                    let geometry = &touch.kinematics.geometry;
                    let vector = geometry.normal * signed;
                    loads[index].force += vector;
                    let center = self.rigid[index].center_of_mass_position(&self.states[body]);
                    loads[index].torque += (geometry.point - center).cross(vector);
                }
            }
        }
        loads
    }

    /// What gravity, fields and fixed bodies give over the step to `ends`: the forces of contacts are constant, and the
    /// points they act at move with the bodies' centres.
    fn received(&self, resting: &RestingForces, loads: &[Wrench], ends: &[BodyState], t_next: f64) -> Received {
        let about = self.books.ledger.momentum.about;
        let h = t_next - self.t;
        let stage = Ends { t: [self.t, t_next], states: [&self.states, ends] };
        let mut received = free_stage::received(&self.world, stage, &self.movable, about);
        for (&body, (rigid, load)) in self.movable.iter().zip(self.rigid.iter().zip(loads)) {
            let state = &self.states[body];
            let acceleration = self.world.gravity() + load.force * rigid.inverse_mass();
            let shift = state.linear_velocity * (0.5 * h) + acceleration * (h * h / 6.0);
            let contacts = resting.touches.iter().zip(&resting.forces);
            let contacts = contacts.filter(|(touch, _)| touch.id.a == body || touch.id.b == body);
            let now = support(
                &self.world,
                about,
                contacts.map(|(touch, &force)| (touch.id, &touch.kinematics.geometry, force * h)),
            );
            let moved = Momentum { linear: DVec3::ZERO, angular: shift.cross(now.linear) };
            received.support = received.support + now + moved;
        }
        received
    }

    /// Integrates the bodies over a step of length `h` under the loads. The integrator goes on from its own variables
    /// while nothing but itself has changed the states.
    fn integrate(&mut self, loads: Vec<Wrench>, h: f64) -> Result<(), SimulationError> {
        let loaded = loads.iter().any(|load| *load != Wrench::default());
        let states = self.world.movable_states(&self.states);
        self.loaded = LoadedBodies::new(self.world.shared_fields(), loads);
        let motion = self.loaded.motion(&self.rigid, self.world.gravity());
        if loaded || self.integrator.states() != states {
            self.integrator.start(&motion, self.t, &states);
        }
        self.integrator.step(&motion, h).map_err(|source| SimulationError::Integration { t: self.t, source })
    }

    /// States of all bodies, given those of the movable ones.
    fn all_states(&self, movable: &[BodyState]) -> Vec<BodyState> {
        let mut states = self.states.clone();
        for (&body, state) in self.movable.iter().zip(movable) {
            states[body] = *state;
        }
        states
    }

    fn audit(&mut self) -> Result<(), SimulationError> {
        if let Some(body) = self.states.iter().position(|state| !state.is_finite()) {
            return Err(SimulationError::Diverged { body: self.world.bodies[body].name.clone(), t: self.t });
        }
        let energy = self.books.observe(&self.world, &self.states);
        if !energy.final_j.is_finite() {
            return Err(SimulationError::EnergyOverflow { t: self.t });
        }
        for touch in self.detect()? {
            let depth = -touch.kinematics.geometry.separation;
            self.certificate.max_penetration_m = self.certificate.max_penetration_m.max(depth);
        }
        Ok(())
    }

    fn emit_sample(&self, t: f64, states: &[BodyState], observer: &mut dyn Observer) {
        let samples: Vec<_> = states.iter().enumerate().map(|(body, state)| self.world.sample(body, state)).collect();
        observer.sample(t, &samples);
    }

    /// Samples before the end of the step that has just been integrated, by a shorter step under the same loads.
    fn emit_samples_within(&mut self, t_next: f64, observer: &mut dyn Observer) -> Result<(), SimulationError> {
        loop {
            let t = self.next_sample as f64 * self.world.scene.output_interval_s();
            if t >= t_next {
                return Ok(());
            }
            let motion = self.loaded.motion(&self.rigid, self.world.gravity());
            let mut movable = self.world.movable_states(&self.states);
            let within = t.min(self.integrator.time());
            self.integrator
                .states_within(&motion, within, &mut movable)
                .map_err(|source| SimulationError::Integration { t: self.t, source })?;
            self.emit_sample(t, &self.all_states(&movable), observer);
            self.next_sample += 1;
        }
    }

    /// Accelerations now, under the forces the thesis finds.
    ///
    /// # Errors
    /// When a contact problem is not finite.
    pub(crate) fn accelerations(&mut self) -> Result<Vec<Acceleration>, SimulationError> {
        let resting = self.resting_forces()?;
        let loads = self.loads(&resting);
        let fields = self.world.loads(self.t, &self.states);
        let mut out = vec![Acceleration { linear: DVec3::ZERO, angular: DVec3::ZERO }; self.world.bodies.len()];
        for ((&body, rigid), load) in self.movable.iter().zip(&self.rigid).zip(&loads) {
            let state = &self.states[body];
            let (linear, angular) = free_acceleration(&self.world, &self.states, &fields, body);
            let arm = state.pose.rotation.rotate(rigid.arm());
            let torque = load.torque + arm.cross(load.force);
            let inverse = rigid.inverse_inertia_world(state.pose.rotation);
            let (linear, angular) = (linear + load.force * rigid.inverse_mass(), angular + inverse * torque);
            out[body] = self.world.reported_acceleration(body, state, linear, angular);
        }
        Ok(out)
    }

    /// Writes the results of the run into its report.
    pub(crate) fn fill(&mut self, report: &mut RunReport) {
        report.energy = self.books.observe(&self.world, &self.states);
        report.ledger = self.books.ledger;
        report.certificate = self.certificate;
        report.warnings.clone_from(&self.warnings);
        report.steps = self.steps;
        report.events = self.event_count;
        report.bodies = self.world.named_samples(&self.states);
    }

    /// Adds a warning unless it has been given before.
    fn warn_once(&mut self, what: &str) {
        if !self.warnings.iter().any(|warning| warning.ends_with(what)) {
            self.warnings.push(format!("t = {} s: {what}", self.t));
        }
    }

    fn response_error(&self, source: ResponseError) -> SimulationError {
        SimulationError::ContactProblem { t: self.t, source }
    }
}
