//! Time stepping at velocity level, after Moreau and Jean: contacts may close and break within a step without event
//! location.
//!
//! One step of length h advances bodies that may touch, with all their touching and nearly touching contacts:
//!
//! 1. At its start, the contacts that may close within the step are detected (`contacts.rs`).
//! 2. Contacts that approach fast enough to count as impacts, close within the step and bounce are resolved at the
//!    present positions by the scene's impact law, together with all contacts connected to them (`impacts.rs`). Others
//!    that close within the step are slowed down so that their gaps close at its end (`closing.rs`).
//! 3. The bodies move in free flight for h/2 ([`drift`], exact). Force fields act as one kick of length h (`kick.rs`),
//!    stiff ones and drag implicitly (`implicit_kick.rs`).
//!    One complementarity problem over all contacts that press or would close gives the contact impulses `p` over the
//!    whole step (`sustained.rs`): `0 <= p _|_ u+ + r >= 0`.
//! 4. The bodies move in free flight for the other h/2.
//! 5. While bodies overlap by more than a part of what is promised, the step is made again with better rows
//!    (`repeated.rs`). Remaining penetration is removed (`projection.rs`).
//!
//! Accuracy: flight has no error from the step; between changes of contact the composition is symmetric, of order 2 in
//! h; an impact occurs early by at most h, an error of order 1, unless the step is split there
//! ([`TimeStepper::advance`]).
//!
//! Energy is never gained at contacts: drifts conserve it, the impulses of stage 3 change it by exactly
//! `sum p.(u- + u+)/2` (`shared_work.rs`), and r is chosen so that no term of it is positive; in stage 2 the impact
//! laws ensure it. Source: docs/REFERENCES.md, Moreau 1988, Jean 1999; the energy of Moreau's midpoint rule after Acary
//! 2016.
//!
//! Assumes that no body is thinner than the motion within a step. Limit: what repeated steps leave of overlaps is
//! removed and reported.
//!
//! | module | holds |
//! |---|---|
//! | `step`, `repeated`, `made` | one time step, steps that are split at impacts, and steps that are made again |
//! | `contacts`, `closing`, `impacts` | stages 1 and 2: contacts that may close, and those that bounce |
//! | `kick`, `implicit_kick`, `middle` | stage 3: forces over the step, and where its impulses act |
//! | `sustained`, `sustained_friction`, `step_rows`, `row` | the rows of contacts and joints over the step |
//! | `consistent_rows`, `rigid_terms` | rows of one pair of bodies that do not contradict each other |
//! | `cone_problem`, `solved_group` | who solves them, and the impulses of a group |
//! | `last_forces` | the forces of the last step, from which the next begins |
//! | `projection`, `closed_joints` | stage 5: what is left of penetration and of gaps of joints |
//! | `shared_work`, `newton_law` | work of the impulses; how far the loads that are told are from Newton's law |
//! | `halving` | unsolved steps made again as halves; the error by step halving |

mod closed_joints;
mod closing;
mod cone_problem;
mod consistent_rows;
mod contacts;
mod halving;
mod impacts;
mod implicit_kick;
mod kick;
mod last_forces;
mod made;
mod middle;
mod newton_law;
mod projection;
mod repeated;
mod rigid_terms;
mod row;
mod shared_work;
mod solved_group;
mod step;
mod step_rows;
mod sustained;
mod sustained_friction;

pub(crate) use repeated::{MOST_TIMES, SHARE_OF_SIZE};
pub(crate) use step::{MOST_SPLITS, TimeStepper, given_by_gravity};

use crate::model::Model;
use polhode_dynamics::{BodyState, Flight};

/// Work of prescribed motions, J, when penetration is removed or velocities are set to zero: none, because their work
/// in a step is booked with its impulses.
pub(crate) const NO_WORK_J: f64 = 0.0;

/// The state of a body after `h` seconds of free flight under gravity alone: exact; without rotation the attitude is
/// unchanged to the last bit.
pub(crate) fn drift(model: &Model, body: usize, state: &BodyState, h: f64) -> BodyState {
    let Some(rigid) = &model.bodies[body].rigid else { return *state };
    let record = if model.planar.contains(body) { Flight::steady } else { Flight::new };
    let mut next = record(rigid, 0.0, state, model.free_acceleration(body)).state(h);
    model.keep_in_plane(body, &mut next);
    next
}
