//! A simulation: a scene that a program advances in time, queries and changes.

use crate::accounting::Accounts;
use crate::accounting::last_sample::LastSample;
use crate::error::SimulationError;
use crate::error_estimate::references::References;
use crate::identity::body_id::BodyId;
use crate::identity::joint_id::JointId;
use crate::joints::motors;
use crate::model::body_queries::BodyQueries;
use crate::model::plane_of_motion::PlanarBodies;
use crate::model::tolerances::SAME_TIME_RELATIVE;
use crate::model::{Model, ModelBody, work};
use crate::plan::decisions::{Findings, Plan};
use crate::plan::free_method;
use crate::plan::planar::{self, PlanarFinding};
use crate::report::acceleration::Acceleration;
use crate::report::contact_sample::ContactSample;
use crate::report::frame::{ContactView, Frame, IslandView, JointView, MotionKind, PivotView};
use crate::report::joint_sample::{CoordinateSample, JointSample};
use crate::report::momentum_ledger::Momentum;
use crate::report::observer::{BodySample, Flow, Observer, Unobserved};
use crate::report::run_report::{Energy, Outcome, PlanChange, RunReport};
use crate::run::stability::{self, FrictionMargin, Margins, MovingBody, Stability};
use crate::run::{engines, singular_force, start_overlap};
use crate::scene::effects::Effects;
use crate::scene::{Coordinate, Scene};
use crate::solve::open_contacts::contact_samples;
use crate::tier::choice::{self, Candidate, TierChoice};
use crate::tier::core::Core;
use crate::tier::executor::{Executor, OneThread};
use crate::tier::joint_samples::joint_samples;
use crate::tier::sampling::{emit_sample, frame};
use crate::tier::settings::Settings;
use crate::tier::{Reached, Tier};
use polhode_contact::QueryError;
use polhode_dynamics::BodyState;
use polhode_response::Memory;
use std::sync::Arc;

/// How a step ended.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub enum StepEnd {
    /// At its full length.
    Planned,
    /// At an event: an impact, or a change of contacts.
    Event,
}

/// A step that has been made.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct StepOutcome {
    /// Time reached, s.
    pub t_s: f64,
    /// How the step ended.
    pub end: StepEnd,
}

impl StepOutcome {
    /// Whether the step ended at an event.
    pub fn is_event(&self) -> bool {
        self.end == StepEnd::Event
    }
}

/// A scene that is advanced in time.
///
/// ```
/// use polhode::contact::Shape;
/// use polhode::mesh::solid_box;
/// use polhode::spatial::{DVec3, Mass, Pose, UnitVector};
/// use polhode::{Body, Scene, Simulation};
/// let brick = Body::movable("brick", solid_box(DVec3::ONE, Mass::new(2.0)?)?)
///     .geometry(Shape::cuboid(DVec3::ONE)?.into())
///     .pose(Pose::from_translation(DVec3::Z * 0.75));
/// let floor = Body::fixed("floor").geometry(Shape::half_space(UnitVector::Z).into());
/// let scene = Scene::builder("drop").body(floor).body(brick).build()?;
/// let mut simulation = Simulation::new(&scene)?;
/// let brick = simulation.body_id("brick").ok_or("no brick")?;
/// simulation.advance_to(0.1)?;
/// assert!((simulation.body(brick).velocity.linear.z + 0.981).abs() < 1e-14);
/// simulation.advance_to(0.5)?;
/// assert_eq!(simulation.contacts().len(), 4);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug)]
pub struct Simulation {
    pub(super) scene: Scene,
    pub(crate) plan: Plan,
    pub(crate) core: Core,
    pub(crate) tier: Box<dyn Tier>,
    pub(crate) plan_changes: Vec<PlanChange>,
    pub(super) plan_at_start: Plan,
    pub(super) planar_at_start: PlanarBodies,
    /// Whether the end of the scene's duration has been reached.
    pub(super) ended: bool,
    /// The runs beside it, which estimate its error.
    pub(super) references: References<Self>,
}

/// How a simulation begins.
pub(super) struct Start {
    /// When, s.
    pub(super) t_s: f64,
    pub(super) effects: Effects,
    pub(super) settings: Settings,
    /// Why this tier, in words.
    pub(super) tier_reason: String,
}

impl Simulation {
    /// Prepares a simulation of the effects that the plan chooses: derives the plan, finds the contacts of the start
    /// and checks that no bodies overlap.
    ///
    /// # Errors
    /// When bodies overlap at the start, a force is not finite there, or the solver finds no contact forces.
    pub fn new(scene: &Scene) -> Result<Self, SimulationError> {
        Self::with_effects(scene, Effects::Planned)
    }

    /// As [`Simulation::new`], with these effects.
    ///
    /// # Errors
    /// See [`Simulation::new`].
    pub fn with_effects(scene: &Scene, effects: Effects) -> Result<Self, SimulationError> {
        // The method or the duration may have been replaced after the scene was built.
        scene.check_times()?;
        match choice::choose(scene) {
            Candidate::Decided(choice) => Self::in_tier(scene, effects, choice),
            Candidate::IfAllRest(resting, other) => {
                // Bodies that do not touch fall: their tier is not begun in vain.
                let begun = Self::in_tier(scene, effects, other)?;
                if begun.tier.touching_pairs() < begun.core.model.movable.len() {
                    return Ok(begun);
                }
                // The first instant is resolved with the first step, whose events are for the observer of the run: that
                // of another simulation tells.
                let mut trial = Self::in_tier(scene, effects, resting.clone())?;
                if trial.step().is_ok() && trial.all_rest() {
                    Self::in_tier(scene, effects, resting)
                } else {
                    Ok(begun)
                }
            }
        }
    }

    /// Whether every body that forces move is at rest.
    fn all_rest(&self) -> bool {
        let motions = self.tier.motions(&self.core);
        self.core.model.movable.iter().all(|&body| motions.get(body) == Some(&MotionKind::Rest))
    }

    /// Prepares a simulation by this tier.
    fn in_tier(scene: &Scene, effects: Effects, tier: TierChoice) -> Result<Self, SimulationError> {
        let settings = Settings::resolve(scene.method(), tier.tier);
        let (model, mut states) = Model::new(scene, settings.pivot_rows(effects))?;
        if let Some(error) = singular_force::not_finite(&model, 0.0, &states) {
            return Err(error);
        }
        let separated = start_overlap::judge(&model, &settings, &mut states)?;
        let start = Start { t_s: 0.0, effects, settings, tier_reason: tier.reason };
        let mut simulation = Self::begin(scene, (model, states), start)?;
        for what in separated.into_iter().chain(scene.warnings()) {
            simulation.core.accounts.warn(0.0, what);
        }
        simulation.references = References::new(scene.method().error.unwrap_or_default());
        Ok(simulation)
    }

    /// A simulation that begins with these states of a model of the scene, and no references.
    ///
    /// # Errors
    /// When contacts or forces of the first instant cannot be found.
    pub(super) fn begin(
        scene: &Scene,
        (mut model, mut states): (Model, Vec<BodyState>),
        start: Start,
    ) -> Result<Self, SimulationError> {
        let Start { t_s, effects, mut settings, tier_reason } = start;
        let choice = free_method::choose(&model, &states, &settings);
        settings.integrator = choice.integrator;
        let planar = match effects {
            Effects::Planned => planar::find(&model, &states, &settings),
            Effects::All => PlanarFinding::off("the run simulates all effects: every body moves in space"),
        };
        model.confine_to_plane(planar.planar.clone(), &mut states);
        model.work.add(work::OF_BEGINNING + states.len() * work::OF_STEP);
        let accounts = Accounts::open(&model, &states, settings.promise);
        let (memory, last_sample) = (Memory::default(), LastSample::default());
        let executor = Arc::new(OneThread);
        let (t, stated_depth_m) = (t_s, f64::INFINITY);
        let mut core =
            Core { model, settings, effects, t, accounts, memory, executor, stated_depth_m, work: 0, last_sample };
        let engine = engines::begun(&mut core, states)?;
        core.work = core.model.work.total();
        let touching_pairs = engine.touching_pairs();
        let findings = Findings { t_s, touching_pairs, tier_reason, choice, planar };
        let plan = Plan::derive(&core.model, &settings, effects, &findings);
        Ok(Self {
            scene: scene.clone(),
            plan_at_start: plan.clone(),
            planar_at_start: core.model.planar.clone(),
            plan,
            core,
            tier: engine,
            plan_changes: Vec::new(),
            ended: false,
            references: References::default(),
        })
    }

    /// The plan.
    pub fn plan(&self) -> &Plan {
        &self.plan
    }

    /// Time reached, s.
    pub fn time(&self) -> f64 {
        self.core.t
    }

    /// Whether the end of the scene's duration has been reached.
    pub fn has_ended(&self) -> bool {
        self.ended
    }

    /// Lets `executor` compute what does not depend on each other: in tier `stepped` the islands of a step, and the
    /// margins of [`Simulation::stability`]. Both have the same bits for every executor. At first it is the thread of
    /// the caller ([`OneThread`]).
    pub fn set_executor(&mut self, executor: Arc<dyn Executor>) {
        self.core.executor = executor;
    }

    /// Makes one step, which ends at the first event in it. A step ends exactly at the end of the scene's duration;
    /// further calls make steps beyond it.
    ///
    /// # Errors
    /// See [`SimulationError`].
    pub fn step(&mut self) -> Result<StepOutcome, SimulationError> {
        self.step_observed(&mut Unobserved)
    }

    /// As [`Simulation::step`], with an observer of samples and events.
    ///
    /// # Errors
    /// See [`SimulationError`].
    pub fn step_observed(&mut self, observer: &mut dyn Observer) -> Result<StepOutcome, SimulationError> {
        let (t, duration) = (self.core.t, self.scene.duration_s());
        let stride = self.tier.stride(&self.core);
        let left_over = duration - t - stride <= SAME_TIME_RELATIVE * self.core.settings.step_s;
        let limit = if !self.ended && left_over { duration } else { t + stride };
        // Beyond the end of the run the stride of bodies at rest is infinite.
        let limit = if limit.is_finite() { limit } else { t + self.core.settings.step_s };
        self.advance(limit, observer)
    }

    /// Makes one step of at most this length (s), which ends at the first event in it; no longer one than the tier
    /// would make. In the tier `accurate` the motion does not depend on it, to the last bit.
    ///
    /// # Errors
    /// When the length is not positive and finite, or too small to change the time; then nothing has changed. See also
    /// [`SimulationError`].
    pub fn step_within(&mut self, length_s: f64, observer: &mut dyn Observer) -> Result<StepOutcome, SimulationError> {
        let (now_s, t_s) = (self.core.t, self.core.t + length_s);
        if !(t_s.is_finite() && t_s > now_s) {
            return Err(SimulationError::TimeInThePast { t_s, now_s });
        }
        let limit = t_s.min(now_s + self.tier.stride(&self.core));
        // A step ends exactly at the end of the duration.
        self.advance(if self.ended { limit } else { limit.min(self.scene.duration_s()) }, observer)
    }

    /// Advances exactly to a time (s). In the tier `accurate` the motion does not depend on the times at which it is
    /// called, to the last bit. The tiers of fixed steps shorten a step, so that the motion is the same to the error of
    /// a step.
    ///
    /// # Errors
    /// When the time is not finite or lies in the past; then nothing has changed. See also [`SimulationError`].
    pub fn advance_to(&mut self, t_s: f64) -> Result<(), SimulationError> {
        self.advance_to_observed(t_s, &mut Unobserved)
    }

    /// As [`Simulation::advance_to`], with an observer of samples and events, which may stop it after a step: the time
    /// reached is then before `t_s`.
    ///
    /// # Errors
    /// See [`Simulation::advance_to`].
    pub fn advance_to_observed(&mut self, t_s: f64, observer: &mut dyn Observer) -> Result<(), SimulationError> {
        if !(t_s.is_finite() && t_s >= self.core.t) {
            return Err(SimulationError::TimeInThePast { t_s, now_s: self.core.t });
        }
        loop {
            // A step ends exactly at the end of the duration, also when a program advances past it.
            let limit = if self.ended { t_s } else { t_s.min(self.scene.duration_s()) };
            let step = self.advance(limit, observer)?;
            let is_stopped = observer.progress(step.t_s) == Flow::Stop;
            if is_stopped || (step.t_s >= t_s && !step.is_event()) {
                return Ok(());
            }
        }
    }

    /// Advances to a limit of time (s) or to the first event before it.
    pub(super) fn advance(&mut self, limit: f64, observer: &mut dyn Observer) -> Result<StepOutcome, SimulationError> {
        self.begin_references();
        if self.core.accounts.is_unsampled() {
            let (t, states) = (self.core.t, self.tier.states(&self.core));
            emit_sample(&*self.tier, &mut self.core, &states, t, observer)?;
        }
        let in_plane = self.core.model.planar.bodies().count();
        let before = self.core.model.work.total();
        let reached = self.tier.advance(&mut self.core, limit, observer);
        self.core.work += self.core.model.work.total() - before;
        let reached =
            reached.map_err(|error| singular_force::explained(error, &self.core, &self.tier.states(&self.core)))?;
        if self.core.model.planar.bodies().count() != in_plane {
            self.note_planar_bodies();
        }
        let t = self.core.t;
        if !self.ended && t >= self.scene.duration_s() && reached == Reached::Limit {
            self.ended = true;
            let states = self.tier.states(&self.core);
            self.core.accounts.observe(&self.core.model, &states, t)?;
            emit_sample(&*self.tier, &mut self.core, &states, t, observer)?;
        }
        self.follow();
        self.tell_errors(observer);
        let end = if reached == Reached::Event { StepEnd::Event } else { StepEnd::Planned };
        Ok(StepOutcome { t_s: t, end })
    }

    /// Runs to the end of the scene's duration and returns the report. A run that has not kept the promise of its tier
    /// ends with [`Outcome::Degraded`].
    ///
    /// # Errors
    /// See [`SimulationError`].
    pub fn run(&mut self) -> Result<RunReport, SimulationError> {
        self.run_observed(&mut Unobserved)
    }

    /// As [`Simulation::run`], with an observer of samples and events, which may stop the run.
    ///
    /// # Errors
    /// See [`SimulationError`].
    pub fn run_observed(&mut self, observer: &mut dyn Observer) -> Result<RunReport, SimulationError> {
        let mut outcome = Outcome::Completed;
        while !self.ended {
            let step = self.step_observed(observer)?;
            if observer.progress(step.t_s) == Flow::Stop && !self.ended {
                outcome = Outcome::Stopped;
                break;
            }
        }
        self.report(outcome)
    }

    /// The handle of the body with this name; none if there is no such body, or it has been removed.
    pub fn body_id(&self, name: &str) -> Option<BodyId> {
        let named = |body: &ModelBody| !body.removed && body.name == name;
        self.core.model.bodies.iter().position(named).map(BodyId::new)
    }

    /// Pose and velocity of a body at the present. A handle of another simulation with more bodies gives the last body.
    pub fn body(&self, body: BodyId) -> BodySample {
        let index = body.index().min(self.core.model.bodies.len().saturating_sub(1));
        self.tier.sample(&self.core, index)
    }

    /// Poses and velocities of all bodies at the present, by [`BodyId::index`].
    pub fn bodies(&self) -> Vec<BodySample> {
        let mut samples = self.tier.samples(&self.core);
        samples.truncate(self.core.model.shown());
        samples
    }

    /// Contacts that touch at the present, with their forces. Single forces may not be unique ([`ContactView`]).
    pub fn contacts(&self) -> Vec<ContactView> {
        self.tier.contacts(&self.core, self.core.t, &self.tier.states(&self.core))
    }

    /// Forces of the pivots at the present, in the order of the bodies. Only the tier `accurate` computes them.
    ///
    /// ```
    /// use polhode::mesh::solid_box;
    /// use polhode::spatial::{DVec3, Mass, Pose};
    /// use polhode::{Body, Scene, Simulation};
    /// // A pendulum of 2 kg that hangs at rest.
    /// let rod = Body::movable("rod", solid_box(DVec3::new(0.1, 0.1, 1.0), Mass::new(2.0)?)?).pivot(DVec3::Z * 0.5);
    /// let scene = Scene::builder("pendulum").body(rod.pose(Pose::IDENTITY)).build()?;
    /// let simulation = Simulation::new(&scene)?;
    /// assert!((simulation.pivots()[0].force_n - DVec3::Z * 19.62).length() < 1e-14);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn pivots(&self) -> Vec<PivotView> {
        self.tier.pivots(&self.core, self.core.t, &self.tier.states(&self.core))
    }

    /// Forces and moments of the joints at the present, in the order of their handles; by the law of time steps in tier
    /// `stepped`, none in tier `thesis`.
    ///
    /// ```
    /// use polhode::mesh::solid_box;
    /// use polhode::scene::{Joint, JointKind};
    /// use polhode::spatial::{DVec3, Mass};
    /// use polhode::{Body, Scene, Simulation};
    /// // A beam of 2 kg and 1 m is fixed at its end: the joint bears its weight, and the moment of it.
    /// let mut builder = Scene::builder("cantilever");
    /// let beam = builder.add_body(Body::movable("beam", solid_box(DVec3::new(1.0, 0.1, 0.1), Mass::new(2.0)?)?));
    /// let scene = builder.joint(Joint::new(JointKind::Fixed, beam, DVec3::X * -0.5)).build()?;
    /// let load = Simulation::new(&scene)?.joint_loads()[0];
    /// assert!((load.force_n - DVec3::Z * 19.62).length() < 1e-12);
    /// assert!((load.moment_n_m - DVec3::Y * -9.81).length() < 1e-12);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn joint_loads(&self) -> Vec<JointView> {
        self.tier.joint_loads(&self.core, self.core.t, &self.tier.states(&self.core))
    }

    /// Contacts that touch at the present, with what of their forces is not unique.
    pub fn contact_samples(&self) -> Vec<ContactSample> {
        contact_samples(&self.core.model, &self.tier.states(&self.core), &self.contacts())
    }

    /// The joints at the present, in the order of their handles: coordinates, what acts along them, loads and powers.
    pub fn joints(&self) -> Vec<JointSample> {
        joint_samples(&*self.tier, &self.core, self.core.t, &self.tier.states(&self.core))
    }

    /// A coordinate of a joint at the present; none of one that the joint does not have, or of a joint that was removed
    /// with a body.
    pub fn coordinate(&self, joint: JointId, coordinate: Coordinate) -> Option<CoordinateSample> {
        motors::coordinate_of(&self.core.model, &self.tier.states(&self.core), joint.index(), coordinate)
    }

    /// Whether a joint is there: it has not been removed, with a body either, and has not let go.
    pub fn has_joint(&self, joint: JointId) -> bool {
        self.core.model.joints.pair_of_joint(joint.index()).is_some()
    }

    /// The islands at the present: bodies that move together or rest together.
    pub fn islands(&self) -> Vec<IslandView> {
        self.tier.islands(&self.core)
    }

    /// Everything that a viewer draws, at the present.
    pub fn frame(&self) -> Frame {
        frame(&*self.tier, &self.core, self.core.t, &self.tier.states(&self.core))
    }

    /// Energies at the present.
    pub fn energy(&self) -> Energy {
        self.core.accounts.books.clone().observe(&self.core.model, &self.tier.states(&self.core))
    }

    /// Momentum at the present; the angular part is about the point of the momentum ledger.
    pub fn momentum(&self) -> Momentum {
        let mut books = self.core.accounts.books.clone();
        books.observe(&self.core.model, &self.tier.states(&self.core));
        books.ledger.momentum.current
    }

    /// Accelerations of all bodies at the present, by [`BodyId::index`].
    ///
    /// # Errors
    /// When the contact forces cannot be found.
    pub fn accelerations(&mut self) -> Result<Vec<Acceleration>, SimulationError> {
        let mut accelerations = self.tier.accelerations(&mut self.core)?;
        accelerations.truncate(self.core.model.shown());
        Ok(accelerations)
    }

    /// How far the bodies at rest are from moving at the present: how far friction may fall, and how far the scene may
    /// be tilted or its bodies pushed, before the first of them moves; and what begins to move then.
    ///
    /// ```
    /// use polhode::contact::Shape;
    /// use polhode::mesh::solid_box;
    /// use polhode::scene::Material;
    /// use polhode::spatial::{DVec3, Mass, Pose, UnitVector};
    /// use polhode::{Body, Scene, Simulation};
    /// // A box of 1 m x 1 m x 4 m on a floor of friction 0.5 tips before it slides: at a push of 1/4 of its weight.
    /// let wood = Material::new("wood").with_friction(0.5)?;
    /// let size = DVec3::new(1.0, 1.0, 4.0);
    /// let column = Body::movable("column", solid_box(size, Mass::new(2.0)?)?)
    ///     .geometry(Shape::cuboid(size)?.into())
    ///     .pose(Pose::from_translation(DVec3::Z * 2.0));
    /// let floor = Body::fixed("floor").geometry(Shape::half_space(UnitVector::Z).into());
    /// let scene = Scene::builder("column").body(floor.material(wood.clone())).body(column.material(wood)).build()?;
    /// let stability = Simulation::new(&scene)?.stability()?;
    /// let push = stability.worst_push().ok_or("gravity acts")?;
    /// assert!(push.of_weight.is_some_and(|part| (part - 0.25).abs() < 1e-8));
    /// assert_eq!(stability.friction.needed, Some(0.0));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// When rows cannot be made of the contacts.
    pub fn stability(&self) -> Result<Stability, SimulationError> {
        let states = self.tier.states(&self.core);
        let contacts = self.tier.contacts(&self.core, self.core.t, &states);
        stability::of_contacts(&self.core, &states, &contacts, Margins::All)
    }

    /// How far friction may fall, as [`Simulation::stability`] has it, without the margins of pushes: whether the
    /// bodies stand takes a fraction of the time.
    ///
    /// # Errors
    /// When rows cannot be made of the contacts.
    pub fn friction_margin(&self) -> Result<FrictionMargin, SimulationError> {
        let states = self.tier.states(&self.core);
        let contacts = self.tier.contacts(&self.core, self.core.t, &states);
        Ok(stability::of_contacts(&self.core, &states, &contacts, Margins::OfFriction)?.friction)
    }

    /// The bodies that move at present though nothing carries them, the fastest first, as a motion that begins.
    pub fn moving_bodies(&self) -> Vec<MovingBody> {
        let states = self.tier.states(&self.core);
        let moved = |body: &usize| self.core.model.bodies[*body].moves();
        let bodies = (0..states.len()).filter(moved);
        stability::in_motion(&self.core, bodies.map(|body| (body, self.core.model.velocity(body, &states[body]))))
    }

    /// Geometric queries about the bodies at the present: nearest body, rays, overlaps, distances. [`BodyQueries`] has
    /// an example.
    ///
    /// # Errors
    /// When a pose is not finite.
    pub fn queries(&self) -> Result<BodyQueries<'_>, QueryError> {
        BodyQueries::new(&self.core.model, &self.tier.states(&self.core))
    }

    /// The report of the run up to the present, which goes on: its ledgers, its certificate and its warnings.
    ///
    /// # Errors
    /// When what holds at present cannot be measured.
    pub fn report_so_far(&mut self) -> Result<RunReport, SimulationError> {
        self.report(if self.ended { Outcome::Completed } else { Outcome::Stopped })
    }

    /// The report of the run up to the present.
    fn report(&mut self, outcome: Outcome) -> Result<RunReport, SimulationError> {
        let mut accounts = self.core.accounts.clone();
        let error = self.error();
        self.tier.book_present(&self.core, &mut accounts)?;
        let mut report = RunReport {
            scene: self.scene.name().to_owned(),
            plan: self.plan.clone(),
            outcome,
            duration_s: self.scene.duration_s(),
            simulated_s: self.core.t,
            steps: 0,
            events: 0,
            energy: Energy::default(),
            ledger: crate::report::ledger::Ledger::default(),
            certificate: crate::report::run_report::Certificate::default(),
            broken: Vec::new(),
            warnings: Vec::new(),
            crowded: Vec::new(),
            error,
            plan_changes: self.plan_changes.clone(),
            tolerated: Vec::new(),
            choices: Vec::new(),
            springs: None,
            bodies: Vec::new(),
        };
        let (states, limits) = (self.tier.states(&self.core), self.core.limits());
        accounts.fill(&self.core.model, &states, &limits, &mut report);
        self.tier.fill(&mut report);
        Ok(report)
    }
}
