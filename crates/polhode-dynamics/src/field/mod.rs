//! Force fields: forces and torques that act on bodies without contact.
//!
//! A field adds a [`Wrench`] to each body it acts on. A conservative field also gives its potential energy V, and its
//! wrench is then minus the gradient of V; the others say to which account of the ledger their work goes. Uniform
//! gravity is not a field: free flight has it in closed form ([`crate::FreeMotion::gravity`]).
//!
//! | field | force | account |
//! |---|---|---|
//! | [`PointGravity`], [`MutualGravity`] | attraction by a point, of all pairs | potential |
//! | [`Spring`] | along the line between two points | potential |
//! | [`Damper`] | the same, against the rate of the distance | damping |
//! | [`Drag`] | linear or quadratic in the velocity | damping; in a wind external |
//! | [`AppliedForce`], [`AppliedTorque`] | given, constant or following a [`Signal`] | external |
//!
//! Fields name bodies by their index in the slice; one that names a body that is not there does nothing. A field of
//! one's own:
//!
//! ```
//! use polhode_dynamics::field::{Account, Dependence, Field, Wrench};
//! use polhode_dynamics::{BodyState, DVec3, FreeMotion, Inertia, Mass, MassProperties, Pose, RigidBody};
//! /// A trap that holds centres of mass near the plane z = 0: `V = k z^2/2` each.
//! #[derive(Debug)]
//! struct Trap {
//!     stiffness: f64,
//! }
//! impl Field for Trap {
//!     fn dependence(&self) -> Dependence {
//!         Dependence::Poses
//!     }
//!     fn account(&self) -> Account {
//!         Account::Potential
//!     }
//!     fn add_wrenches(&self, _t: f64, bodies: &[RigidBody], states: &[BodyState], wrenches: &mut [Wrench]) {
//!         for ((body, state), wrench) in bodies.iter().zip(states).zip(wrenches) {
//!             wrench.force.z -= self.stiffness * body.center_of_mass_position(state).z;
//!         }
//!     }
//!     fn potential_energy(&self, bodies: &[RigidBody], states: &[BodyState]) -> f64 {
//!         let height = |(body, state): (&RigidBody, &BodyState)| body.center_of_mass_position(state).z;
//!         bodies.iter().zip(states).map(height).map(|z| 0.5 * self.stiffness * z * z).sum()
//!     }
//! }
//! let inertia = Inertia::from_diagonal(DVec3::new(1.0, 2.0, 3.0))?;
//! let bodies = [RigidBody::new(&MassProperties::new(Mass::new(1.0)?, DVec3::ZERO, inertia))];
//! let fields: [Box<dyn Field>; 1] = [Box::new(Trap { stiffness: 4.0 })];
//! let motion = FreeMotion::new(&bodies, DVec3::ZERO, &fields);
//! let state = BodyState::at_rest(Pose::from_translation(DVec3::Z * 0.5));
//! assert_eq!(motion.potential_energy(&[state]), 0.5);
//! let mut wrenches = [Wrench::default()];
//! motion.wrenches(0.0, &[state], &mut wrenches);
//! assert_eq!(wrenches[0].force.z, -2.0);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! | module | holds |
//! |---|---|
//! | `applied_load` | [`AppliedForce`], [`AppliedTorque`] |
//! | `error` | why numbers are no force field |
//! | `link` | the line between two points, one of them on a body: what springs and dampers share |
//! | `response` | how the force of a field changes with small motions of its bodies |

pub mod applied_load;
pub mod damper;
pub mod drag;
mod error;
mod link;
pub mod mutual_gravity;
pub mod point_gravity;
pub mod response;
pub mod signal;
pub mod spring;

pub use applied_load::{AppliedForce, AppliedTorque, Frame};
pub use damper::Damper;
pub use drag::{Drag, DragLaw};
pub use error::FieldError;
pub use link::Anchor;
pub use mutual_gravity::MutualGravity;
pub use point_gravity::PointGravity;
pub use response::{Decay, ForceResponse, ResponseEnd};
pub use signal::Signal;
pub use spring::Spring;

use crate::{BodyState, RigidBody};
use glam::DVec3;
use std::fmt::Debug;

/// A force and a torque on one body.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Wrench {
    /// N, world.
    pub force: DVec3,
    /// N m, world, about the centre of mass (where it is said: about the origin of the moving frame).
    pub torque: DVec3,
}

/// What a field's force depends on, which decides the methods that may integrate it, and whether bodies under it may be
/// left at rest without being looked at.
///
/// It is a promise: the wrenches of [`Field::add_wrenches`] depend on what is named here and on nothing else. A field
/// whose force comes from a value that a program changes (a control, a measurement) depends on time, whatever its
/// formula looks like, and must say [`Self::PosesAndTime`]. One that says [`Self::Poses`] all the same is not asked
/// again while the bodies it acts on rest: they stay at rest, under the force of the moment at which they came to rest,
/// until an event wakes them.
///
/// Even a field that depends on time is asked at the stages of steps only. A value that changes between two calls takes
/// effect from the next step on, not within one that has been made; a jump at a known time belongs into
/// [`Field::corner_between`], and a force that a program sets from outside into an action on the simulation, which ends
/// the step and wakes what rests.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Dependence {
    /// On poses alone: half of a splitting. At the same poses the force is the same at any time, which is why what
    /// rests under it may be left at rest.
    Poses,
    /// On poses and time: bodies under it are integrated also while they do not move.
    PosesAndTime,
    /// On velocities too, and perhaps on time.
    Velocities,
}

/// The account of the ledger that a field's work belongs to.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Account {
    /// Conservative: its potential energy is part of the total.
    Potential,
    /// Drag and dampers.
    Damping,
    /// Work done by what is outside the scene.
    External,
}

/// The first corner of any of the fields, as [`Field::corner_between`].
pub fn corner_between(fields: &[Box<dyn Field>], from: f64, to: f64) -> Option<f64> {
    let corners = fields.iter().filter_map(|field| field.corner_between(from, to));
    corners.min_by(|a, b| (a - from).abs().total_cmp(&(b - from).abs()))
}

/// A force field over the bodies of a system.
pub trait Field: Debug + Send + Sync {
    /// What the force depends on, and nothing else: see [`Dependence`] for what is promised.
    fn dependence(&self) -> Dependence;

    /// Where the work of the force is booked.
    fn account(&self) -> Account;

    /// Whether the field can move the body of this index. Bodies that no field moves keep their exact flight.
    fn acts_on(&self, _body: usize) -> bool {
        true
    }

    /// The bodies that the field acts on, if it names them: then nobody need ask it of all others. Must agree with
    /// [`Field::acts_on`].
    fn bodies(&self) -> Option<Vec<usize>> {
        None
    }

    /// Whether the field can exert a torque about the centre of mass of a body that it acts on. The attitude of a body
    /// that no field turns is that of free rotation.
    fn turns(&self, _body: usize) -> bool {
        true
    }

    /// Whether the force on one body depends on the others, so that bodies it acts on must be integrated together.
    fn couples(&self) -> bool {
        true
    }

    /// The first time strictly between `from` and `to` (s, in either order) on the way from one to the other at which
    /// the force is not smooth in time. Integrators under error control end a step there: a pulse between two of their
    /// stages would pass unseen.
    fn corner_between(&self, _from: f64, _to: f64) -> Option<f64> {
        None
    }

    /// Adds the field's wrench on each body, torques about the centres of mass; the three slices are of one length and
    /// in one order. Positions and velocities are those of [`RigidBody::center_of_mass_position`] and its siblings,
    /// pivoted bodies included.
    fn add_wrenches(&self, t: f64, bodies: &[RigidBody], states: &[BodyState], wrenches: &mut [Wrench]);

    /// How the forces of the field change with small motions of its bodies ([`ForceResponse`]): with it a step may be
    /// longer than the time in which the field moves a body. Nothing when the field does not say; then a step that is
    /// too long for it may gain energy.
    fn responses(&self, _bodies: &[RigidBody], _states: &[BodyState]) -> Option<Vec<ForceResponse>> {
        None
    }

    /// Potential energy, J; zero for a field that is not conservative.
    fn potential_energy(&self, bodies: &[RigidBody], states: &[BodyState]) -> f64;
}
