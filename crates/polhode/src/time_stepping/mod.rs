//! Time steps at the level of velocities, after Moreau and Jean: contacts that come and go within a step need no event.
//!
//! One step of length h advances bodies that may touch, with all their touching and nearly touching contacts together:
//!
//! 1. Contacts within reach of the step are found where it begins (`contacts.rs`).
//! 2. What approaches fast enough to be seen as an impact and closes within the step is struck where it stands, by the
//!    scene's impact law, together with everything that touches it (`impacts.rs`).
//! 3. The bodies fly for h/2 ([`drift`], exact), force fields act as one kick of length h (`kick.rs`), and one
//!    complementarity problem over all contacts that press or would close gives the impulses `p` of the contacts over the
//!    whole step (`sustained.rs`): `0 <= p _|_ u+ + r >= 0`.
//! 4. The bodies fly for the other h/2.
//! 5. Overlap that is left is moved out (`projection.rs`).
//!
//! Accuracy: flight has no error from the step; between changes of contact the composition is symmetric, of order 2 in h; an
//! impact is early by at most h, of order 1, unless the step is split there ([`TimeStepper::advance`]).
//!
//! Energy is never gained at contacts: drifts conserve it, the impulses of stage 3 change it by exactly
//! `sum p.(u- + u+)/2`, and r is chosen so that no term of it is positive; the impact laws see to it in stage 2.
//! Source: docs/REFERENCES.md, Moreau 1988, Jean 1999; the energy of Moreau's midpoint rule after Acary 2016.
//!
//! Assumes that nothing of the scene's bodies is thinner than a step's motion. Fails softly: a contact that its pairs did not
//! tell is found one step late, as an overlap that is moved out and reported.

mod contacts;
mod halving;
mod impacts;
mod kick;
mod projection;
mod report;
mod step;
mod sustained;

pub(crate) use report::{ImpulseKind, TimeStepReport};
pub(crate) use step::{TimeStepper, given_by_gravity};

use crate::world::World;
use polhode_dynamics::{BodyState, Flight};

/// Work of prescribed motions, J, where overlap is moved out and velocities are set to rest: their impulses do it before.
const NO_WORK_J: f64 = 0.0;

/// The state of a body after `h` seconds of free flight under gravity alone: exact, and without a turn exactly unturned.
pub(crate) fn drift(world: &World, body: usize, state: &BodyState, h: f64) -> BodyState {
    let Some(rigid) = &world.bodies[body].rigid else { return *state };
    let record = if world.plane.is_some() { Flight::steady } else { Flight::new };
    let mut next = record(rigid, 0.0, state, world.free_acceleration(body)).state(h);
    world.keep_in_plane(body, &mut next);
    next
}
