//! What most programs name, for one `use`.
//!
//! ```
//! use polhode::prelude::*;
//! // A door of 20 kg on a hinge along z is pushed at its edge, and turns through one revolution.
//! let slab = polhode::mesh::solid_box(DVec3::new(0.8, 0.04, 2.0), Mass::new(20.0)?)?;
//! let mut scene = Scene::builder("door");
//! let door = scene.add_body(Body::movable("door", slab).pose(Pose::from_translation(DVec3::X * 0.4)));
//! let scene = scene.joint(Joint::hinge(door, DVec3::ZERO, UnitVector::Z)).build()?;
//! let mut simulation = Simulation::new(&scene)?;
//! simulation.apply_impulse(door, DVec3::Y * 5.0, DVec3::X * 0.8)?;
//! let rate = simulation.body(door).velocity.angular.z;
//! simulation.advance_to(std::f64::consts::TAU / rate)?;
//! assert!((simulation.body(door).pose.translation - DVec3::X * 0.4).length() < 1e-9);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

pub use crate::contact::Shape;
pub use crate::error::SimulationError;
pub use crate::identity::body_id::BodyId;
pub use crate::identity::joint_id::JointId;
pub use crate::report::body_sample::BodySample;
pub use crate::report::event::{Event, EventKind};
pub use crate::report::observer::{Observer, Recorder, Unobserved};
pub use crate::report::run_report::{Outcome, RunReport};
pub use crate::run::simulation::Simulation;
pub use crate::run::steering::Steering;
pub use crate::scene::effects::Effects;
pub use crate::scene::{Body, Geometry, Scene, SceneBuilder};
pub use crate::scene::{Coordinate, Joint, JointKind, Material, Method, PrescribedMotion, Tier};
pub use crate::spatial::{DVec3, Density, Inertia, Mass, MassProperties, Pose, Rotation, UnitVector, Velocity};
