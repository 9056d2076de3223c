//! Rigid-body simulation that accounts for its accuracy.
//!
//! ```text
//! Scene --> Plan --> Simulation --> samples, events --> RunReport (energies, ledger, certificate)
//! ```

mod acceleration;
mod accounting;
mod accurate;
mod action_error;
mod actions;
mod body_id;
pub mod body_queries;
mod body_sample;
mod collision;
mod core;
mod disjoint_sets;
mod effects;
mod energy;
pub mod error;
pub mod event;
pub mod frame;
mod free_method;
mod free_stage;
mod interaction;
pub mod ledger;
pub mod momentum_ledger;
pub mod observer;
mod pivot_form;
mod pivots;
pub mod plan;
mod planar;
mod plane_of_motion;
mod prescribed;
mod prescribed_state;
mod promise;
pub mod report;
mod sampling;
pub mod scene;
mod settings;
mod simulation;
mod singular_force;
mod snapshot;
mod stepped;
mod thesis;
mod tier;
mod time_stepping;
mod world;

pub use acceleration::Acceleration;
pub use action_error::ActionError;
pub use body_id::BodyId;
pub use body_queries::BodyQueries;
pub use body_sample::BodySample;
pub use effects::Effects;
pub use energy::Energy;
pub use error::SimulationError;
pub use event::{Event, EventKind};
pub use frame::{ContactView, Frame, IslandView, MotionKind, PivotView};
pub use ledger::Ledger;
pub use momentum_ledger::{Momentum, MomentumLedger, MomentumSum};
pub use observer::{Flow, Observer, Recorder, Unobserved};
pub use plan::{Decision, Effect, EffectDecision, Plan};
pub use report::{Certificate, CrowdedStretch, Outcome, PairAt, PlanChange, RunReport, Tolerated};
pub use scene::{Body, Geometry, Scene, SceneBuilder, SceneError};
pub use simulation::{Simulation, StepEnd, StepOutcome};
pub use snapshot::{Snapshot, SnapshotError};

pub use polhode_contact as contact;
pub use polhode_dynamics as dynamics;
pub use polhode_mesh as mesh;
pub use polhode_response as response;
pub use polhode_spatial as spatial;
