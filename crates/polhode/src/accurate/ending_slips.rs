//! Slips that turn while they end.
//!
//! A slip that keeps its direction passes through zero smoothly: its component along that direction is the event
//! function of the location of contact changes, and nothing is lost, whether the contact sticks then or slides back.
//!
//! A slip that turns does so at the rate `g / u` and faster, so that the last bit of it takes many steps. If it
//! decelerates by `a`, it comes to a stop after the distance `u^2 / 2a`. Where that distance is below
//! [`NEGLIGIBLE_TRAVEL`] touch distances and friction holds the contact afterwards, the bodies cannot be distinguished
//! from bodies that stick: the slip is replaced by its end, as the last bounces of a contact are, by the smallest
//! change of velocities that makes it zero, booked as energy lost at rest. The event has the time at which the slip
//! would have ended. A slip that friction would not hold afterwards goes on.
//!
//! Assumes that the deceleration lasts for the rest, `u / a`: for a body on a floor of friction 0.5 some microseconds.

use super::constrained_step::{ConstrainedStep, StepEndStates};
use super::hold::Forces;
use super::motions::Motions;
use super::resolve::Resolution;
use crate::collision::contact_kinematics;
use crate::collision::friction_mode::FrictionMode;
use crate::collision::touch::Touch;
use crate::error::SimulationError;
use crate::identity::contact_id::ContactId;
use crate::model::states_of::set_states;
use crate::model::{Model, tolerances};
use crate::rows::groups::Group;
use crate::solve::projection::{self, Removal};
use crate::tier::core::Core;
use polhode_dynamics::BodyState;
use std::collections::BTreeSet;

/// Distance, in touch distances, within which a slip may end at once (1 to 64; no unit).
const NEGLIGIBLE_TRAVEL: f64 = 8.0;

/// A slip ends soon only if it has become slower than this fraction of its speed at the start of the step (no unit).
const SLOWED: f64 = 0.5;

/// Slips of two pairs whose times until they end differ by at most this factor end together (no unit): symmetric pairs
/// of a symmetric scene.
const SAME_END: f64 = 1.0 + 1e-6;

/// Whether a slip of this speed (m/s) ends within a negligible distance when it loses speed at this rate (m/s^2).
fn ends_at_once(model: &Model, states: &[BodyState], id: ContactId, speed: f64, deceleration: f64) -> bool {
    let travel = NEGLIGIBLE_TRAVEL * tolerances::touch_distance(model, states, id.a, id.b);
    speed > 0.0 && speed * speed <= 2.0 * deceleration * travel
}

/// The contacts whose slips have become so slow at the end of a step, with these states, that they are worth a look at
/// the forces: those of pairs of which a slip has turned in the step.
pub(super) fn fading_slips(core: &Core, step: &ConstrainedStep, states: &[BodyState]) -> BTreeSet<ContactId> {
    let (mut fading, mut turned) = (BTreeSet::new(), BTreeSet::new());
    for (id, slide) in step.active.sliding() {
        let Some(terms) = contact_kinematics::tangential_kinematics(&core.model, states, id) else { continue };
        let speed = terms.slip_velocity.length();
        let deceleration = (slide.speed - speed) / (step.end - step.t);
        if speed < SLOWED * slide.speed && ends_at_once(&core.model, states, id, speed, deceleration) {
            fading.insert(id);
            if slide.direction_of(terms.slip_velocity) != slide.direction {
                turned.insert((id.a, id.b));
            }
        }
    }
    fading.retain(|id| turned.contains(&(id.a, id.b)));
    fading
}

impl Motions {
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
            let Some(FrictionMode::Sliding(slide)) = step.active.modes(*id).friction else { return false };
            let terms = contact_kinematics::tangential_kinematics(&core.model, &states, *id);
            terms.is_some_and(|terms| !slide.has_vanished(terms.slip_velocity))
        };
        let misses = stopping.iter().any(misses);
        self.restore_scratch(core, states, &step.bodies);
        misses
    }
}

impl Resolution<'_> {
    /// Ends the slips of candidates whose way to a stop is negligible under these forces. Returns whether there are
    /// any.
    ///
    /// # Errors
    /// When a number is not finite.
    pub(super) fn end_slips(
        &mut self,
        group: &Group,
        (candidates, forces): (&[usize], &Forces),
    ) -> Result<bool, SimulationError> {
        let members: Vec<Touch> = candidates.iter().map(|&i| self.instant.touches[i]).collect();
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
            let Some(terms) =
                contact_kinematics::tangential_kinematics(&self.core.model, &self.motions.states, touch.id)
            else {
                continue;
            };
            let (speed, deceleration) = (terms.slip_velocity.length(), -friction.growth_along(direction));
            let fades = self.instant.change.fading.contains(&touch.id);
            if fades && ends_at_once(&self.core.model, &self.motions.states, touch.id, speed, deceleration) {
                ending.push((touch.id, speed / deceleration));
            }
        }
        // The end of one slip changes the forces of the others: those that end later are looked at again.
        let soonest = ending.iter().fold(f64::INFINITY, |soonest: f64, &(_, time)| soonest.min(time));
        let ends_now = |id: ContactId| {
            let of_pair = ending.iter().filter(|(other, _)| (other.a, other.b) == (id.a, id.b));
            of_pair.fold(f64::INFINITY, |soonest: f64, &(_, time)| soonest.min(time)) <= SAME_END * soonest
        };
        let ended: Vec<ContactId> = ending.iter().map(|&(id, _)| id).filter(|&id| ends_now(id)).collect();
        if ended.is_empty() || ended.iter().all(|id| self.instant.change.stopping.contains(id)) {
            return Ok(false);
        }
        sticking.extend(&ended);
        let ids: Vec<_> = members.iter().map(|touch| touch.id).collect();
        self.motions.end_flights(self.core, self.instant.t, &group.bodies);
        let sliding: Vec<BodyState> = group.bodies.iter().map(|&body| self.motions.states[body]).collect();
        let before = self.core.accounts.books.balance(&self.core.model, &self.motions.states, &group.bodies);
        let of = (&ids[..], &sticking[..], &[][..]);
        let slowed = projection::project_velocities(
            &self.core.model,
            &mut self.motions.states,
            &group.bodies,
            of,
            Removal::Complete,
        )
        .map_err(|source| SimulationError::of_response(self.instant.t, source))?;
        let newly: Vec<ContactId> =
            ended.iter().copied().filter(|&id| self.instant.change.stopping.insert(id)).collect();
        self.refresh_kinematics();
        let holds = self.friction_holds(group, (candidates, &ended));
        if !matches!(holds, Ok(true)) {
            set_states(&mut self.motions.states, &group.bodies, &sliding);
            self.instant.change.stopping.retain(|id| !newly.contains(id));
            self.instant.change.fading.retain(|id| !ended.contains(id));
            self.refresh_kinematics();
            return holds;
        }
        let after = self.core.accounts.books.balance(&self.core.model, &self.motions.states, &group.bodies);
        self.core.accounts.books.rest(before, after, slowed.work_j);
        let end = self.instant.t + soonest;
        self.instant.slip_ends.extend(newly.into_iter().map(|id| (id, end)));
        Ok(true)
    }

    /// Whether friction holds these contacts with the present velocities.
    fn friction_holds(
        &mut self,
        group: &Group,
        (candidates, ended): (&[usize], &[ContactId]),
    ) -> Result<bool, SimulationError> {
        let forces = self.forces(group, candidates)?;
        let is_held = |row: usize| forces.friction(row).is_some_and(|friction| friction.is_held);
        let of_ended = candidates.iter().enumerate().filter(|&(_, &i)| ended.contains(&self.instant.touches[i].id));
        Ok(of_ended.map(|(row, _)| row).all(is_held))
    }
}
