//! Validation cases: what the project promises, measured on what its users run.
//!
//! A case builds scenes, runs them through the facade with default settings (unless it is about a setting) and turns
//! what it measures into rows. Where a quantity is internal (forces, mass properties) it calls the crate that computes
//! it. Names of cases with a number (`RC-10`) are those of the reference values.
//!
//! | module | holds |
//! |---|---|
//! | `case` | a case, and how it gives rows whatever happens |
//! | `context` | what every case may use |
//! | `error_estimates` | told errors beside true ones |
//! | `list` | all cases, in the order in which they run |
//! | `kept` | what is made once and used by several cases |
//! | `run` | runs of scenes, and those of the shipped ones, each made once |
//! | `bodies` | bodies that several cases are built from |
//! | `setting` | the same scene set differently in the world |
//! | `motion` | states at any time, zeros and angles of what moved |
//! | `random_impacts` | impacts with friction made from random numbers |
//! | `random_pairs` | pairs of bodies made from random numbers |
//! | `random_throws` | bodies thrown at walls, made from random numbers, with their closed forms |
//! | `rough_plane` | a rough plane, level or inclined, bodies on it, and thresholds |
//! | `feature_numbers` | a polyhedron of the contact crate and the exact one, and which features of them are the same |
//! | the others | the cases, one file per group |

mod accuracy_choice;
mod arches;
pub(crate) mod bodies;
mod case;
mod chung_ooi;
mod context;
mod convergence;
mod convex_pairs;
mod crowds;
mod cube_tosses;
mod curved_bodies;
mod decomposition;
mod diamonds;
mod effects;
mod elastic_body;
mod error_estimates;
pub(crate) mod exact_drift;
mod falling_shapes;
mod fast_tier;
mod feature_numbers;
mod free_rotation;
mod friction_effects;
mod friction_invariances;
mod friction_scenes;
mod frictional_impacts;
pub(crate) mod frictional_statics;
mod heaps;
pub(crate) mod heavy_tops;
mod impact_chains;
mod impact_laws;
mod impacts;
mod impacts_every_way;
mod invariances;
pub(crate) mod joints;
mod kept;
mod ledger;
mod list;
mod long_runs;
mod mass_properties;
mod mesh_program;
pub(crate) mod motion;
mod numerical_loss;
mod one_dependency;
mod orders_in_contact;
mod peers;
mod pi_machine;
mod polhode_times;
mod program;
mod published_rotations;
mod random_impacts;
mod random_pairs;
pub mod random_scenes;
mod random_solids;
pub(crate) mod random_throws;
mod reductions;
mod rest_every_way;
mod resting_contact;
mod rigid_ipc;
mod rocking_and_toppling;
mod rolling_disc;
pub(crate) mod rough_plane;
mod run;
pub(crate) mod seams;
mod setting;
mod sliding;
mod sliding_and_spinning;
mod sliding_height;
pub(crate) mod slipping_and_rolling;
pub(crate) mod slopes;
mod snapshots;
mod speed;
mod spinning_scenes;
mod stability;
mod stackings;
pub(crate) mod stacks;
pub(crate) mod stacks_on_slopes;
mod stiffness_limit;
pub(crate) mod structures;
mod table_edge;
mod thesis_forces;
mod thesis_tier;
pub mod tiers_agree;
mod tunnelling;
mod two_balls;
mod units;
mod valleys;
mod videos;
mod walls;
mod ways;

pub use case::{CaseResult, Company, guarded};
pub use context::{Amount, Context};
pub use list::{ALL, QUICK, company};
pub use run::Run;
pub(crate) use run::movement_m;
