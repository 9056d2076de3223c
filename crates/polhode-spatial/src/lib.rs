//! Poses, velocities, inertia algebra and mass properties of rigid bodies: the leaf crate of polhode.
//!
//! Notation (docs/NOTATION.md, after Drake's monogram notation): W is the world, B a body, Bo the origin of its
//! frame, Bcm its centre of mass. `X_WB` is the pose of B in W, `R_WB` its rotation, `p_WB` its position,
//! `v_WBcm` and `w_WB` are velocities measured and expressed in W, `I_BBcm_B` is the inertia about the centre of
//! mass in body axes. SI units, right-handed, quaternions are scalar first and turn body axes into world axes.
//!
//! | module | holds |
//! |---|---|
//! | [`rotation`] | [`Rotation`]: a unit quaternion that is known to be one |
//! | [`pose`] | [`Pose`]: rotation and translation of one frame in another |
//! | [`isometry`] | [`Isometry`]: a space turned, shifted and mirrored |
//! | [`velocity`] | [`Velocity`] of a body, velocity of its points |
//! | [`unit_vector`] | [`UnitVector`]: a direction |
//! | [`motion`] | [`Motion`]: a pose as a function of time, with bounds |
//! | | [`Still`], [`ConstantVelocity`], [`ConstantScrew`], [`SteadyFlight`]: motions in closed form |
//! | [`curve`] | [`Curve`](curve::Curve): a curve by arc length, with the place nearest to a point |
//! | [`inertia`] | [`Inertia`]: a valid rotational inertia and its algebra |
//! | [`principal_axes`] | eigen-decomposition of symmetric 3x3 matrices |
//! | [`mass_properties`] | [`MassProperties`], [`Mass`], [`Density`] |
//! | [`compensated_sum`] | [`CompensatedSum`] after Neumaier |
//! | [`rounding`] | what rounding and the digits of files leave |
//! | [`double_double`] | [`DoubleDouble`]: twice the working precision |
//! | [`disjoint_sets`] | [`DisjointSets`]: which members are connected |
//! | [`split_mix`] | [`SplitMix64`]: pseudo-random numbers, the same everywhere |
//!
//! This crate is all that a program needs to name: the vectors, matrices and quaternions of glam that its signatures
//! speak of are here too, and the crates above it pass all of it on as their module `spatial`, with the names that
//! their own signatures need. Programs of ten lines stand in the folder `examples` of the crate: `dumbbell` (mass
//! properties of a body of parts) and `motions_in_closed_form`.
//!
//! ```
//! use polhode_spatial::{DVec3, Inertia, Mass, MassProperties};
//! let mass = Mass::new(6.0)?;
//! let brick = MassProperties::new(mass, DVec3::ZERO, Inertia::from_diagonal(DVec3::new(6.5, 5.0, 2.5))?);
//! assert_eq!(brick.principal_axes().moments(), DVec3::new(2.5, 5.0, 6.5));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! # Stages
//!
//! In the order of the calls, from inertia to a moving pose; paths are in `src`.
//!
//! | stage | what it does | where |
//! |---|---|---|
//! | inertia | checks that moments are positive and obey the triangle inequality | `inertia.rs` |
//! | mass properties | joins mass, centre of mass and inertia; adds the parts of a body | `mass_properties.rs` |
//! | principal axes | finds principal moments and axes | `principal_axes.rs` |
//! | pose, velocity | relate frames and give the velocities of points | `rotation.rs`, `pose.rs`, `velocity.rs` |
//! | motion | gives a pose at any time, with bounds over an interval | `motion` |

pub mod compensated_sum;
pub mod curve;
pub mod disjoint_sets;
pub mod double_double;
pub mod inertia;
pub mod isometry;
pub mod mass_properties;
pub mod motion;
pub mod pose;
pub mod principal_axes;
pub mod rotation;
pub mod rounding;
pub mod split_mix;
pub mod unit_vector;
pub mod velocity;

pub use compensated_sum::CompensatedSum;
pub use disjoint_sets::DisjointSets;
pub use double_double::DoubleDouble;
pub use glam::{DMat3, DQuat, DVec3};
pub use inertia::{Inertia, InertiaError};
pub use isometry::{Handedness, Isometry};
pub use mass_properties::{Density, Mass, MassProperties, MassPropertiesError};
pub use motion::{ConstantScrew, ConstantVelocity, Motion, MotionBounds, MotionError, SteadyFlight, Still};
pub use pose::Pose;
pub use principal_axes::PrincipalAxes;
pub use rotation::{Rotation, RotationError};
pub use split_mix::SplitMix64;
pub use unit_vector::{UnitVector, UnitVectorError};
pub use velocity::Velocity;

// The program in the README is compiled and run as a test.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
