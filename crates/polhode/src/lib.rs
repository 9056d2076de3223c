//! Rigid-body simulation that accounts for its accuracy: the facade of the polhode crates.
//!
//! ```text
//! Scene --> Plan --> Simulation --> samples, events --> RunReport (energies, ledger, certificate)
//! ```
//!
//! A program describes bodies in a [`Scene`], makes a [`Simulation`] of it, and runs it to a [`RunReport`] or advances
//! it in steps of its own. SI units, f64, right-handed frames, z up (docs/NOTATION.md, with a glossary).
//!
//! # Examples
//!
//! A ball falls and bounces; the report says how the run ended and where the energy went.
//!
//! ```
//! use polhode::contact::Shape;
//! use polhode::mesh::solid_sphere;
//! use polhode::scene::Material;
//! use polhode::spatial::{DVec3, Mass, Pose, UnitVector};
//! use polhode::{Body, EventKind, Outcome, Recorder, Scene, Simulation};
//! let ball = Body::movable("ball", solid_sphere(0.1, Mass::new(2.0)?)?)
//!     .geometry(Shape::sphere(0.1)?.into())
//!     .material(Material::new("rubber").with_restitution(0.5)?)
//!     .pose(Pose::from_translation(DVec3::Z * 1.1));
//! let floor = Body::fixed("floor").geometry(Shape::half_space(UnitVector::Z).into());
//! let scene = Scene::builder("bounce").duration_s(0.8).body(floor).body(ball).build()?;
//! let mut recorder = Recorder::default();
//! let report = Simulation::new(&scene)?.run_observed(&mut recorder)?;
//! assert_eq!(report.outcome, Outcome::Completed);
//! let impacts: Vec<_> = recorder.events.iter().filter(|event| event.kind == EventKind::Impact).collect();
//! assert!((impacts[0].t_s - (2.0_f64 / 9.81).sqrt()).abs() < 1e-14);
//! // A fall by 1 m and a restitution of 0.5 leave a quarter of m g h.
//! assert!((report.ledger.impact.value() - 0.75 * 2.0 * 9.81).abs() < 1e-12);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! A program advances a simulation to times of its own and reads poses there. A pendulum of length 1 m swings a little:
//! after half a period it is on the other side.
//!
//! ```
//! use polhode::spatial::{DVec3, Inertia, Mass, MassProperties, Pose, Rotation};
//! use polhode::{Body, Scene, Simulation};
//! let bob = MassProperties::new(Mass::new(1.0)?, DVec3::ZERO, Inertia::from_diagonal(DVec3::splat(1e-9))?);
//! let tilt = Rotation::from_rotation_vector(DVec3::Y * 1e-4);
//! let start = Pose::new(tilt, tilt.rotate(-DVec3::Z));
//! let scene = Scene::builder("pendulum").body(Body::movable("bob", bob).pose(start).pivot(DVec3::ZERO)).build()?;
//! let mut simulation = Simulation::new(&scene)?;
//! let bob = simulation.body_id("bob").ok_or("no body of this name")?;
//! simulation.advance_to(std::f64::consts::PI * (1.0_f64 / 9.81).sqrt())?;
//! let mirrored = start.translation * DVec3::new(-1.0, 1.0, 1.0);
//! assert!((simulation.body(bob).pose.translation - mirrored).length() < 1e-8);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! The plan says what is simulated, by which method, and why; ledger and certificate say how far to trust the result.
//!
//! ```
//! use polhode::contact::Shape;
//! use polhode::mesh::solid_box;
//! use polhode::spatial::{DVec3, Mass, Pose, UnitVector};
//! use polhode::{Body, Decision, Effect, Scene, Simulation};
//! let brick = Body::movable("brick", solid_box(DVec3::ONE, Mass::new(2.0)?)?)
//!     .geometry(Shape::cuboid(DVec3::ONE)?.into())
//!     .pose(Pose::from_translation(DVec3::Z * 0.75));
//! let floor = Body::fixed("floor").geometry(Shape::half_space(UnitVector::Z).into());
//! let scene = Scene::builder("drop").body(floor).body(brick).build()?;
//! let mut simulation = Simulation::new(&scene)?;
//! let planar = simulation.plan().effects.iter().find(|decision| decision.effect == Effect::PlanarMotion);
//! let planar = planar.ok_or("one decision for each effect")?;
//! assert_eq!(planar.decision, Decision::On, "{}", planar.fact);
//! let report = simulation.run()?;
//! // The terms of the ledger explain the change of energy to rounding, and no limit of the promise was exceeded.
//! assert!(report.ledger.closure_relative() < 1e-14);
//! assert!(report.certificate.max_penetration_of_limit <= 1.0);
//! assert_eq!(report.certificate.fallbacks, 0);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! Longer programs are in the folder `examples` of the crate: `golden_trajectory`, `custom_force_field`,
//! `contacts_listened_to`, `hovering_thruster`, `bodies_that_come_and_go` and `paused_and_resumed`.
//!
//! # Stages of a run
//!
//! In the order of the calls, for the tier `accurate`; paths are in `src`.
//!
//! | stage | what it does | where |
//! |---|---|---|
//! | scene | collects bodies, forces and method, and checks them | `scene/builder.rs`, `tier/scene_checks.rs` |
//! | settings | completes the method by the defaults of its tier | `tier/settings.rs` |
//! | model | puts bodies into their moving frames, makes force fields | `model` |
//! | findings | chooses the integrator, tells planar motion | `plan/free_method.rs`, `plan/planar.rs` |
//! | plan | decides which effects are simulated, and says why | `plan/decisions.rs` |
//! | simulation | makes the tier, and lets it advance to a time or event | `run/simulation.rs`, `tier/mod.rs` |
//! | first instant | finds the contacts of the start and decides which are active | `accurate/start.rs` |
//! | free flight | makes a flight record of each body under gravity alone | `accurate/motions.rs` |
//! | step | integrates each island, held or free | `accurate/constrained_stepping.rs`, `accurate/free_stepping.rs` |
//! | forces of a stage | assembles rows of contacts and pivots, and solves | `accurate/system.rs`, `rows/assembly.rs` |
//! | event location | finds the first change of contacts in the step | `accurate/locate.rs` |
//! | search for impacts | finds swept boxes that overlap; impacts | `collision/boxes.rs`, `accurate/impact_search.rs` |
//! | agenda | gives the next end of a step, change of contacts or impact | `accurate/agenda.rs`, `accurate/tier.rs` |
//! | samples | evaluates the states at the times of output before that | `tier/sampling.rs`, `report/observer.rs` |
//! | event | ends the islands concerned at that time | `accurate/events.rs` |
//! | projection | puts active contacts and pivots back in place | `accurate/projection.rs` |
//! | | positions, then velocities | `solve/projection.rs` |
//! | impact | detects contacts, and strikes those that approach | `accurate/resolve.rs`, `solve/impact.rs` |
//! | hold | decides which contacts are active, and which bodies rest | `accurate/hold.rs`, `accurate/resolve.rs` |
//! | crowded events | advances an island by time steps where events crowd | `accurate/crowding.rs`, `time_stepping` |
//! | ledger | books energy and momentum of steps, impacts and projections | `accounting/books.rs` |
//! | certificate | records penetrations and projections | `accounting/measures.rs` |
//! | | compares them with the promise of the tier | `tier/promise.rs` |
//! | report | puts outcome, plan, ledger, certificate and warnings together | `report/run_report.rs` |
//! | | | `run/simulation.rs`, `accounting/mod.rs` |
//!
//! The tiers `stepped` and `thesis` (`stepped/engine.rs`, `thesis/engine.rs`) share all but the stages in `accurate`.
//!
//! # Modules
//!
//! From the bottom to the top: a room imports from those above its line in this table, with few exceptions.
//!
//! | room | holds |
//! |---|---|
//! | [`mod@error`] | [`SimulationError`], [`SceneError`], [`ActionError`], [`SnapshotError`] |
//! | [`mod@prelude`] | what most programs name, for one `use` |
//! | `identity` | what bodies, joints and contacts are called |
//! | [`mod@report`] | what a run tells: [`RunReport`], [`Ledger`], [`Certificate`], |
//! | | [`Event`], [`Frame`], [`Observer`] |
//! | [`mod@scene`] | [`Scene`], [`Body`], [`Geometry`]; materials, forces, motions, methods, the names of tiers |
//! | `snapshot` | [`Snapshot`]: a simulation at one time as bytes |
//! | `constraint` | what holds bodies together: kinds of joints, their rows, coordinates, stops; times of events |
//! | `model` | bodies in their moving frames, and the forces on them |
//! | `collision` | boxes and contacts of pairs |
//! | `joints` | the joints of a model: whom they hold, what acts along their coordinates |
//! | `reduced` | trees of joints in the coordinates of the joints |
//! | `rows` | rows of contacts and bilateral constraints, by groups of bodies, which the tiers share |
//! | `solve` | what they are solved for: forces at an instant, impacts, projection |
//! | `accounting` | books, measures and warnings of a run |
//! | `time_stepping` | the time step at the level of velocities |
//! | [`mod@tier`] | the interface of a tier, what each is ([`tier::TierFacts`]), and what tiers share |
//! | [`mod@plan`] | [`Plan`]: the decision about each [`Effect`], with its reason |
//! | `accurate`, `stepped`, `fast`, `micro_collisions`, `penalty`, `thesis` | the tiers |
//! | `error_estimate` | what runs beside a run say of its error |
//! | `run` | [`Simulation`]: steps, runs, queries, actions, snapshots; [`Evaluation`]: given states |
//!
//! This crate is all that a program needs to name: the crates below it are re-exported as [`contact`], [`dynamics`],
//! [`mesh`], [`response`] and [`spatial`].

mod accounting;
mod accurate;
mod action_error;
mod collision;
mod constraint;
pub mod error;
mod error_estimate;
mod fast;
mod identity;
mod joints;
mod micro_collisions;
mod model;
mod penalty;
pub mod plan;
pub mod prelude;
mod reduced;
pub mod report;
mod rows;
mod run;
pub mod scene;
mod snapshot;
mod solve;
mod stepped;
mod thesis;
pub mod tier;
mod time_stepping;

pub use action_error::ActionError;
pub use error::SimulationError;
pub use identity::body_id::BodyId;
pub use identity::joint_id::JointId;
pub use model::body_queries::BodyQueries;
pub use plan::decisions::{Decision, Effect, EffectDecision, Plan};
pub use report::acceleration::Acceleration;
pub use report::body_sample::BodySample;
pub use report::contact_sample::ContactSample;
pub use report::energy::Energy;
pub use report::event::{Event, EventKind};
pub use report::frame::{ContactView, Frame, IslandView, JointView, MotionKind, PivotView};
pub use report::joint_efforts::Efforts;
pub use report::joint_sample::{CoordinateSample, JointSample, Reaction};
pub use report::ledger::Ledger;
pub use report::momentum_ledger::{Momentum, MomentumLedger, MomentumSum};
pub use report::observer::{Flow, Observer, Recorder, Unobserved};
pub use report::run_error::{BodyError, LargestError, ReferenceKind, ReferenceReport, RunError};
pub use report::run_hash::{RunHash, RunHashPlace};
pub use report::run_report::{
    BrokenPromise, Certificate, CrowdedStretch, Occurrence, Outcome, PairAt, PlanChange, ReportedBody, RunReport,
};
pub use report::springs::{SpringImpact, SpringReport};

pub use run::evaluation::{Evaluation, HeldState, MovableState, NearPair, NearPoint, StateEnergy};
pub use run::simulation::{Simulation, StepEnd, StepOutcome};
pub use run::stability;
pub use run::stability::Stability;
pub use run::steering::Steering;
pub use scene::effects::Effects;
pub use scene::{ApproximateParts, Body, ErrorEstimation, Geometry, Scene, SceneBuilder, SceneError};
pub use snapshot::{Snapshot, SnapshotError};
pub use tier::executor::{Executor, OneThread, Task};

pub use polhode_contact as contact;
pub use polhode_dynamics as dynamics;
pub use polhode_mesh as mesh;
pub use polhode_response as response;
pub use polhode_spatial as spatial;

// The program in the README is compiled and run as a test.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
