//! Slips that end within a negligible distance.
//!
//! A contact that slides with the speed `u` and whose slip decelerates by `a` comes to a stop after the distance
//! `u^2 / 2a`. Friction turns a slip ever faster as it becomes slow (at the rate `mu g / u` where its direction must
//! change), so that the last bit of it takes many steps. Where that distance is below [`NEGLIGIBLE_TRAVEL`] touch
//! distances the bodies cannot be distinguished from bodies that stick, and the slip is replaced by its end, as the
//! last bounces of a contact are: the smallest change of velocities that makes it zero, booked as energy lost at rest.
//! Whether the contact sticks from then on its forces decide.
//!
//! Assumes that the deceleration lasts. Limit: the time until the slip would have ended, `u / a`, is lost; for a body
//! on a floor of friction 0.5 it is some microseconds.

use super::constrained_step::{ConstrainedStep, StepEndStates};
use super::engine::Engine;
use super::hold::Forces;
use super::instant::Instant;
use crate::SimulationError;
use crate::collision::contact_set::{ContactId, Touch};
use crate::collision::friction_mode::FrictionMode;
use crate::core::Core;
use crate::interaction::groups::Group;
use crate::interaction::projection::{self, Removal};
use crate::states_of::set_states;
use crate::world::World;
use polhode_dynamics::BodyState;
use std::collections::BTreeSet;

/// Distance, in touch distances, within which a slip may end at once (1 to 64; no unit).
const NEGLIGIBLE_TRAVEL: f64 = 8.0;

/// A slip ends soon only if it has become slower than this fraction of its speed at the start of the step (no unit).
const SLOWED: f64 = 0.5;

/// Slips of two pairs whose times until they end differ by at most this factor end together (no unit): symmetric pairs of a
/// symmetric scene.
const SAME_END: f64 = 1.0 + 1e-6;

/// Whether a slip of this speed (m/s) ends within a negligible distance when it loses speed at this rate (m/s^2).
fn ends_at_once(world: &World, states: &[BodyState], id: ContactId, speed: f64, deceleration: f64) -> bool {
    let travel = NEGLIGIBLE_TRAVEL * world.touch_distance(states, id.a, id.b);
    speed > 0.0 && speed * speed <= 2.0 * deceleration * travel
}

/// Whether a slip of a step has become so slow at its end, with these states, that it is worth a look at the forces.
pub(super) fn slip_nearly_ended(core: &Core, step: &ConstrainedStep, states: &[BodyState]) -> bool {
    step.active.friction.iter().any(|(&id, mode)| {
        let FrictionMode::Sliding(slide) = mode else { return false };
        let Some(terms) = core.world.tangential_kinematics(states, id) else { return false };
        let speed = terms.slip_velocity.length();
        let lost = slide.speed - speed;
        speed < SLOWED * slide.speed && ends_at_once(&core.world, states, id, speed, lost / (step.end - step.t))
    })
}

impl Engine {
    /// Whether a step that has been repeated up to the time at which these slips vanish ends elsewhere. Its last stages
    /// lie where slips are as small as the errors of stages, so that the directions of friction there may be any. Up to
    /// that time the longer step, which goes on beyond it, is the better one.
    pub(super) fn misses_ends(
        &mut self,
        core: &Core,
        step: &ConstrainedStep,
        stopping: &BTreeSet<ContactId>,
        repeated: &StepEndStates,
    ) -> bool {
        let mut states = std::mem::take(&mut self.scratch);
        set_states(&mut states, &step.bodies, &repeated.states);
        let misses = |id: &ContactId| {
            let Some(FrictionMode::Sliding(slide)) = step.active.friction.get(id) else { return false };
            let terms = core.world.tangential_kinematics(&states, *id);
            terms.is_some_and(|terms| !slide.has_vanished(terms.slip_velocity))
        };
        let misses = stopping.iter().any(misses);
        self.restore_scratch(core, states, &step.bodies);
        misses
    }

    /// Ends the slips of candidates whose way to a stop is negligible under these forces. Returns whether there are any.
    ///
    /// # Errors
    /// When a number is not finite.
    pub(super) fn end_slips(
        &mut self,
        core: &mut Core,
        instant: &mut Instant,
        group: &Group,
        (candidates, forces): (&[usize], &Forces),
    ) -> Result<bool, SimulationError> {
        let members: Vec<Touch> = candidates.iter().map(|&i| instant.touches[i]).collect();
        let mut sticking = Vec::new();
        let mut ending = Vec::new();
        for (row, touch) in members.iter().enumerate() {
            let Some(friction) = forces.friction(row) else { continue };
            let Some(direction) = friction.sliding else {
                if friction.is_held {
                    sticking.push(touch.id);
                }
                continue;
            };
            let Some(terms) = core.world.tangential_kinematics(&self.states, touch.id) else { continue };
            let (speed, deceleration) = (terms.slip_velocity.length(), -friction.growth_along(direction));
            if ends_at_once(&core.world, &self.states, touch.id, speed, deceleration) {
                ending.push((touch.id, speed / deceleration));
            }
        }
        // The end of one slip changes the forces of the others: those that end later are looked at again.
        let soonest = ending.iter().fold(f64::INFINITY, |soonest: f64, &(_, time)| soonest.min(time));
        let ends_now = |id: ContactId| {
            let of_pair = ending.iter().filter(|(other, _)| (other.a, other.b) == (id.a, id.b));
            of_pair.fold(f64::INFINITY, |soonest: f64, &(_, time)| soonest.min(time)) <= SAME_END * soonest
        };
        let mut any = false;
        for &(id, _) in &ending {
            if ends_now(id) {
                sticking.push(id);
                any |= instant.change.stopping.insert(id);
            }
        }
        if !any {
            return Ok(false);
        }
        self.end_flights(core, instant.t, group);
        let ids: Vec<_> = members.iter().map(|touch| touch.id).collect();
        let before = core.accounts.books.balance(&core.world, &self.states, &group.bodies);
        let of = (&ids[..], &sticking[..], &[][..]);
        let slowed =
            projection::project_velocities(&core.world, &mut self.states, &group.bodies, of, Removal::Complete)
                .map_err(|source| Core::response_error(instant.t, source))?;
        let after = core.accounts.books.balance(&core.world, &self.states, &group.bodies);
        core.accounts.books.rest(before, after, slowed.work_j);
        self.refresh_kinematics(core, instant);
        Ok(true)
    }
}
