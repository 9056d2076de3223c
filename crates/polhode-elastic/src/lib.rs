//! An elastic rectangle by explicit finite elements, to hold rigid impact laws against (thesis, Figure 2).
//!
//! A rigid body is told by a coefficient what an impact leaves of its motion. This crate computes it: a rectangle of
//! elastic matter in plane strain meets a rigid floor, waves run through it, and it leaves with what of its energy did
//! not stay behind as vibration. SI units, f64, the same bits everywhere; positions are (x, z), rotation is about y (z
//! towards x), and all that is extensive is for each metre of depth. Nothing here reads a file, prints or panics. Of
//! polhode it knows the leaf crate alone, and no crate of the simulation depends on it.
//!
//! | module | holds |
//! |---|---|
//! | [`material`] | [`ElasticMaterial`]: moduli, and speeds of waves |
//! | [`mesh`] | [`QuadMesh`]: four-node elements that are not folded; [`Cells`] of a rectangle |
//! | [`body`] | [`ElasticBody`]: mesh, material and lumped masses |
//! | [`guide`] | [`Guide`]: free, or confined |
//! | [`floor`] | [`Floor`], and the law of a node that meets it |
//! | [`run`] | [`ElasticRun`]: central differences, with ledgers of energy and momentum |
//! | [`stability`] | the longest stable step |
//! | [`mod@drop`] | [`RectangleDrop`]: from the first touch to the rebound, and its [`DropReport`] |
//! | [`study`] | [`DropStudy`]: drops by several steps on several meshes |
//! | [`extrapolation`] | [`Extrapolated`]: values without the error of the mesh |
//! | `error` | what keeps an elastic body from being made or moved |
//!
//! ```
//! use polhode_elastic::{ElasticMaterial, RectangleDrop};
//!
//! let rubber = ElasticMaterial::new(1e6, 0.3, 1000.0)?;
//! // Confined, a bar of height L bounces off whole: after 2 L / c_p, with twice its momentum as impulse.
//! let drop = RectangleDrop::new(2.0, 1.0, rubber, 1.0)?.confined()?;
//! let report = drop.run(drop.cells(200))?;
//! assert!((report.contact_time_s * rubber.dilatational_speed() / 2.0 - 1.0).abs() < 1e-9);
//! assert!((report.impulse_n_s / (2.0 * report.mass_kg) - 1.0).abs() < 1e-9);
//! # Ok::<(), polhode_elastic::ElasticError>(())
//! ```
//!
//! # Stages
//!
//! In the order of the calls; paths are in `src`.
//!
//! | stage | what it does | where |
//! |---|---|---|
//! | material | checks the constants | `material.rs` |
//! | mesh | lays out elements and their integrals, and refuses folded ones | `mesh.rs` |
//! | body | lumps the masses and finds the longest step | `body.rs`, `stability.rs` |
//! | forces | elastic forces of every element, without locking and without hourglassing | `law.rs`, `element.rs` |
//! | step | velocities, guides, floor, displacements, ledgers | `run.rs`, `floor.rs` |
//! | report | rebound, restitution and where the energy is | `drop.rs` |
//! | limit | takes means over step lengths, and extrapolates over meshes | `study.rs`, `extrapolation.rs` |

pub mod body;
pub mod drop;
pub mod error;
pub mod extrapolation;
pub mod floor;
pub mod guide;
pub mod material;
pub mod mesh;
pub mod run;
pub mod stability;
pub mod study;

mod element;
mod law;

pub use body::{ElasticBody, Momentum};
pub use drop::{DropReport, ReboundEnergy, RectangleDrop};
pub use error::ElasticError;
pub use extrapolation::{Extrapolated, Mean};
pub use floor::Floor;
pub use glam::{DMat2, DVec2};
pub use guide::Guide;
pub use material::ElasticMaterial;
pub use mesh::{Cells, QuadMesh};
pub use run::{ContactTimes, ElasticRun, EnergyLedger, MomentumLedger, NodeStates};
pub use study::{DropStudy, MeshedDrops, Quantity};

// The program in the README is compiled and run as a test.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
