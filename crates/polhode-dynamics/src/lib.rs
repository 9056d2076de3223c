//! Free motion of rigid bodies: states, exact flights, integrators over systems, conserved quantities.
//!
//! This crate knows neither shapes nor contacts: it moves what has mass and inertia (docs/ARCHITECTURE.md,
//! invariant 1). The moving frame of a body is its frame C: axes of the body, origin at the centre of mass, or at the
//! pivot of a body that is held there.
//! SI units; the world is W, the body B, its principal axes P; momenta are in world axes.
//!
//! | module | holds |
//! |---|---|
//! | [`rigid_body`] | [`RigidBody`]: mass, inertia, their inverses, principal axes |
//! | [`state`] | [`BodyState`]: pose, velocity, angular momentum, and the flat layout of [`state::WIDTH`] numbers |
//! | [`energy`] | potential and total energy |
//! | [`momentum`] | linear momentum, angular momentum about a point of the world |
//! | [`exact_rotation`] | free rotation to round-off over any time: [`exact_rotation::drift`], [`FreeRotation`] |
//! | [`flight`] | [`Flight`]: the record of a body in free flight, evaluated at any time and never chained |
//! | [`system`] | [`System`]: rates of a flat state, what the integrators integrate |
//! | [`field`] | [`field::Field`]: forces and torques without contact |
//! | [`free_motion`] | [`FreeMotion`]: bodies under gravity and fields, what the integrators integrate |
//! | [`integrator`] | [`integrator::Integrator`]: the methods of free motion behind one trait |
//! | [`rk4`] | the classical Runge-Kutta method of order 4, as the thesis uses it |
//! | [`dop853`] | [`Dop853`]: the Runge-Kutta method of order 8 by Dormand and Prince, with its error estimate |
//! | [`error_allowance`] | what a step may err in each quantity of a body, and its largest error in units of that |
//! | [`step_control`] | the control of the length of steps by an error estimate, over any system |
//! | [`dense_step`] | [`DenseStep`]: the state at any time within a step, to order 7 |
//! | [`integrated_motion`] | [`IntegratedMotion`]: one body's motion over a step, with rigorous bounds |
//! | [`carlson`] | Carlson's symmetric elliptic integrals RF, RJ |
//! | [`jacobi`] | Jacobi's elliptic functions sn, cn, dn |
//! | `dense_polynomial` | the polynomial of degree 7 that a component of a state follows within a step |
//! | `dop853_coefficients` | coefficients of DOP853 |
//! | `lanes` | several numbers at once, one in each lane |
//!
//! This crate is all that a program needs to name: what its signatures speak of is here too, the rest of
//! polhode-spatial under [`spatial`]. Programs of ten lines stand in the folder `examples` of the crate:
//! `flight_of_a_tumbling_box`, `wobble_of_a_plate` and `mass_on_a_spring`.
//!
//! ```
//! use polhode_dynamics::{DVec3, Flight, Inertia, Mass, MassProperties, Pose, RigidBody, Velocity};
//! let inertia = Inertia::from_diagonal(DVec3::new(1.0, 2.0, 3.0))?;
//! let body = RigidBody::new(&MassProperties::new(Mass::new(1.0)?, DVec3::ZERO, inertia));
//! let start = body.at_velocity(Pose::IDENTITY, Velocity::new(DVec3::ZERO, DVec3::new(0.01, 2.0, 0.01)));
//! let flight = Flight::new(&body, 0.0, &start, DVec3::new(0.0, 0.0, -9.81));
//! // One evaluation, however far: the body has flipped over nine times by now, and its energy is that of the start.
//! let end = flight.state(100.0);
//! let rotational = |s| body.rotational_energy(s);
//! assert!((rotational(&end) / rotational(&start) - 1.0).abs() < 1e-13);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! # Stages
//!
//! In the order of the calls; paths are in `src`. Free flight, under gravity alone:
//!
//! | stage | what it does | where |
//! |---|---|---|
//! | body | makes inverse mass, inverse inertia and principal axes from mass properties | `rigid_body.rs` |
//! | state | makes a state from pose and velocity | `rigid_body.rs`, `state.rs` |
//! | flight record | computes the constants of the rotation | `flight.rs`, `exact_rotation/mod.rs` |
//! | evaluation | evaluates parabola and rotation at any time | `flight.rs` |
//! | | by elliptic functions | `exact_rotation/elliptic.rs` |
//!
//! Motion under forces:
//!
//! | stage | what it does | where |
//! |---|---|---|
//! | fields | gives forces and torques at a time and a state | `field` |
//! | system | makes the rates of a flat state from them | `free_motion.rs`, `system.rs` |
//! | method | makes the integrator of a name | `integrator/method.rs` |
//! | step | evaluates the rates at its stages | `integrator`, `rk4.rs` |
//! | | estimates its error and repeats with a shorter step | `dop853.rs` |
//! | dense output | gives the state within the step, with bounds | `dense_step.rs`, `integrated_motion.rs` |
//! | event location | finds when a function of the states changes its sign | `integrator/event.rs` |

pub mod carlson;
mod dense_polynomial;
pub mod dense_step;
pub mod dop853;
mod dop853_coefficients;
pub mod energy;
pub mod error_allowance;
pub mod exact_rotation;
pub mod field;
pub mod flight;
pub mod free_motion;
pub mod integrated_motion;
pub mod integrator;
pub mod jacobi;
mod lanes;
pub mod momentum;
pub mod rigid_body;
pub mod rk4;
pub mod state;
pub mod step_control;
pub mod system;

pub use dense_step::DenseStep;
pub use dop853::Dop853;
pub use exact_rotation::FreeRotation;
pub use flight::Flight;
pub use free_motion::FreeMotion;
pub use integrated_motion::IntegratedMotion;
pub use integrator::{IntegrationError, Integrator};
pub use rigid_body::RigidBody;
pub use rk4::Rk4;
pub use state::BodyState;
pub use system::System;

pub use polhode_spatial as spatial;
pub use spatial::{
    DMat3, DQuat, DVec3, Inertia, InertiaError, Mass, MassProperties, MassPropertiesError, Motion, MotionBounds, Pose,
    PrincipalAxes, Rotation, RotationError, Velocity,
};

// The program in the README is compiled and run as a test.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
