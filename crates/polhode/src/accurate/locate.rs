//! Location of contact changes: the time until which the active set of an island is valid.
//!
//! Within a step the active set (the held contacts) is fixed. It is valid as long as (a) every held contact point lies
//! on its features (margin) and does not jump to a point at which the bodies approach or separate, (b) no other contact
//! between these bodies penetrates, and (c) pushing forces suffice: the complementarity problem over the set has
//! `chi'' = 0` at every contact. A failure of one of these conditions is called a violation. The event locator
//! (`crate::constraint::locator`) finds the first one on the dense output of the step, to 1e-13 of the step.
//!
//! It looks for (a) and (b) at eight times of a step, and for (c), slips and rotations at its end; where a kinematic
//! body moves, or a track with one side presses, for all at each of the eight. What begins and ends again between two
//! looks is not seen: a stop or an edge that is crossed twice, or a force that pulls for less than a step. The error
//! control keeps steps short where motions curve; the penetration that is left is measured at each sample and reported.

use super::constrained_step::ConstrainedStep;
use super::contact_change::ContactChange;
use super::ending_slips::fading_slips;
use super::hold::Forces;
use super::motions::Motions;
use super::pace::Pace;
use super::step_search::StepSearch;
use crate::collision::friction_mode::{FrictionMode, Slide};
use crate::collision::touch::Touch;
use crate::collision::turn::Turn;
use crate::collision::{contact_kinematics, contact_set, friction};
use crate::constraint::ContactEvent;
use crate::constraint::locator::{Side, close_in};
use crate::error::SimulationError;
use crate::identity::contact_id::{ContactId, Feature};
use crate::model::{TOUCH_RELATIVE, prescribed, reported, tolerances};
use crate::solve::projection::rate_exceeds_drift;
use crate::tier::core::Core;
use polhode_contact::ContactKinematics;
use polhode_dynamics::BodyState;
use polhode_spatial::DVec3;
use std::collections::{BTreeMap, BTreeSet};

/// Time after the break of a contact at which its acceleration is evaluated again, as a fraction of the step: long
/// enough to distinguish its growth from rounding, short enough for linear growth.
const EXTRAPOLATION: f64 = 1e-5;

/// Longest backward extrapolation, in units of the distance of the two times: beyond it the growth is not linear.
const LONGEST_EXTRAPOLATION: f64 = 100.0;

/// Intervals of a step at whose ends held contacts are checked for leaving their features, and others for penetration.
pub(super) const PENETRATION_CHECKS: u32 = 8;

impl Motions {
    /// The first time in a step, up to `limit` (s), at which its active set ceases to be valid.
    ///
    /// # Errors
    /// When contact forces cannot be found.
    pub(super) fn locate_contact_change(
        &mut self,
        core: &mut Core,
        step: &ConstrainedStep,
        limit: f64,
        pace: &Pace,
    ) -> Result<Option<ContactChange>, SimulationError> {
        let mut states = std::mem::take(&mut self.scratch);
        let mut search =
            StepSearch { core, step, start: &self.states, states: &mut states, tolerated: BTreeSet::new() };
        let change = search.change_within(limit, pace).map(|change| search.or_end_of_track(limit, change));
        let change = change.and_then(|found| search.or_earlier_break(found, limit));
        self.restore_scratch(core, states, &step.bodies);
        change
    }
}

impl StepSearch<'_> {
    /// The first time up to `limit` (s) at which the active set ceases to be valid.
    ///
    /// # Errors
    /// When contact forces cannot be found.
    fn change_within(&mut self, mut limit: f64, pace: &Pace) -> Result<Option<ContactChange>, SimulationError> {
        let longest = self.core.settings.step_s;
        let mut found = None;
        let mut violated = self.first_violation(limit)?;
        while let Some(t) = violated.filter(|&t| pace.is_backing_off() && pace.is_stall(t, longest)) {
            let before = self.tolerated.len();
            let violations = self.violations(t)?;
            self.tolerated.extend(violations);
            if self.tolerated.len() == before {
                break;
            }
            limit = limit.min(pace.retry_time(longest));
            found = Some(ContactChange { t: limit, ..ContactChange::default() });
            violated = self.first_violation(limit)?;
        }
        let mut pairs: Vec<_> = self.tolerated.iter().map(|id: &ContactId| (id.a, id.b)).collect();
        pairs.dedup();
        for (a, b) in pairs {
            let names = reported::pair_names(&self.core.model, a, b);
            self.core.accounts.tolerate(
                self.step.t,
                format!("contacts of {names} that no longer hold were self.tolerated for a short time"),
            );
        }
        match violated {
            Some(violated) => self.locate_change(violated).map(Some),
            None if found.is_none() && limit >= self.step.end => {
                self.step.states_at(&self.core.model, self.step.end, self.states);
                let fading = fading_slips(self.core, self.step, self.states);
                let any = !fading.is_empty();
                Ok(any.then(|| ContactChange { t: self.step.end, fading, ..ContactChange::default() }))
            }
            None => Ok(found),
        }
    }

    /// The time of the change that is visible at `violated` (s): when the penetrating contact closes, or when the force
    /// of the breaking contact reaches zero. The contact that penetrates at `violated` need not be the first one. If
    /// another contact penetrates at the time found, that contact is located in turn.
    fn locate_change(&mut self, mut violated: f64) -> Result<ContactChange, SimulationError> {
        let at = |t: f64| ContactChange { t, ..ContactChange::default() };
        loop {
            let Some(closing) = self.closing_time(violated) else {
                let stopping = stopping_contacts(self.core, self.step, violated, self.states);
                self.step.states_at(&self.core.model, violated, self.states);
                let settling: BTreeSet<_> = settled(self.core, self.step, violated, self.states).collect();
                if !(stopping.is_empty() && settling.is_empty()) {
                    return Ok(ContactChange { t: violated, stopping, settling, ..ContactChange::default() });
                }
                if stopped(self.core, self.step, violated, self.states).next().is_some() {
                    // Slips that have only turned go on in their new directions.
                    return Ok(at(violated));
                }
                return breaking(self.core, self.step, violated, self.states);
            };
            self.step.states_at(&self.core.model, closing, self.states);
            if closing >= violated || self.penetrating().is_none() {
                return Ok(at(closing));
            }
            match self.first_violation(closing)? {
                Some(earlier) if earlier < violated => violated = earlier,
                _ => return Ok(at(closing)),
            }
        }
    }

    /// The first violation: the end of an interval of 1e-13 of the step, at whose start the set is valid and at whose
    /// end it is violated.
    fn first_violation(&mut self, limit: f64) -> Result<Option<f64>, SimulationError> {
        let start = self.step.t;
        let (mut valid, mut violated) = match self.first_violation_interval(start, limit)? {
            Some(interval) => interval,
            None if self.violations(limit)?.is_empty() => return Ok(None),
            None => (start, limit),
        };
        if valid > start && !self.violations(valid)?.is_empty() {
            (valid, violated) = (start, valid);
        }
        loop {
            violated = self.first_violation_in((valid, violated))?;
            // Another pair may have begun to overlap earlier.
            self.step.states_at(&self.core.model, violated, self.states);
            if !self.penetrates_undetected() {
                return Ok(Some(violated));
            }
            match self.contact_penetrating_within((start, violated)) {
                Some(t) if t < violated => (valid, violated) = (start, t),
                _ => return Ok(Some(violated)),
            }
        }
    }

    /// The first of some intervals of the step at whose end a held contact has left its features or an open contact
    /// penetrates. Bodies that rock on each other may penetrate and separate again within a step, which a check at its
    /// end alone would miss. It would also miss that a moving kinematic body, or a car at the top of a loop, loses
    /// contact for a short time: if one moves, or a track presses, forces are checked too.
    fn first_violation_interval(&mut self, start: f64, limit: f64) -> Result<Option<(f64, f64)>, SimulationError> {
        let is_moved = |body| !prescribed::stands_still(&self.core.model, body, start, limit);
        let driven = self.step.active.held().iter().flat_map(|id| [id.a, id.b]).any(is_moved)
            || self.core.model.joints.drivers_of(&self.step.bodies).any(is_moved)
            || self.step.active.held().iter().any(|&id| self.core.model.joints.is_side_of_track(id));
        let first_check = start + (limit - start) / f64::from(PENETRATION_CHECKS);
        if let Some(interval) = self.approach_interval((start, first_check)) {
            return Ok(Some(interval));
        }
        let mut before = start;
        for k in 1..=PENETRATION_CHECKS {
            let t = start + (limit - start) * (f64::from(k) / f64::from(PENETRATION_CHECKS));
            self.step.states_at(&self.core.model, t, self.states);
            // Contact points may leave their features long before other contacts penetrate.
            let mut held = self.step.active.held().iter().filter(|id| !self.tolerated.contains(id));
            if k < PENETRATION_CHECKS && held.any(|&id| held_kinematics(self.core, self.states, id).is_none()) {
                return Ok(Some((before, t)));
            }
            let penetration = self.first_penetration();
            // The caller checks the end of the step for all violations.
            if penetration.contact.is_some() && k < PENETRATION_CHECKS {
                return Ok(Some((before, t)));
            }
            let is_undetected = penetration.contact.is_none() && penetration.is_undetected();
            if is_undetected && let Some(t) = self.contact_penetrating_within((before, t)) {
                return Ok(Some((before, t)));
            }
            if driven && k < PENETRATION_CHECKS && !self.violations(t)?.is_empty() {
                return Ok(Some((before, t)));
            }
            before = t;
        }
        Ok(None)
    }

    /// The contacts that violate the active set at time `t` of the step, without the tolerated ones. Only the first
    /// kind of violation found is returned.
    fn violations(&mut self, t: f64) -> Result<Vec<ContactId>, SimulationError> {
        self.step.states_at(&self.core.model, t, self.states);
        let mut touches = Vec::with_capacity(self.step.active.held().len());
        let mut left = Vec::new();
        for &id in self.step.active.held() {
            let is_tolerated = self.tolerated.contains(&id);
            let kinematics = if is_tolerated {
                contact_kinematics::kinematics(&self.core.model, self.states, id)
            } else {
                held_kinematics(self.core, self.states, id)
            };
            match kinematics {
                Some(kinematics) => touches.push(held_touch(self.step, id, kinematics)),
                None => left.push(id),
            }
        }
        if left.is_empty() {
            left.extend(self.penetrating());
        }
        if left.is_empty() {
            left.extend(stopped(self.core, self.step, t, self.states).filter(|id| !self.tolerated.contains(id)));
            left.extend(
                settled(self.core, self.step, t, self.states)
                    .map(|(id, _)| id)
                    .filter(|id| !self.tolerated.contains(id)),
            );
        }
        if left.is_empty() {
            left = breaking_contacts(self.core, self.step, t, self.states, &touches, &self.tolerated)?;
        }
        Ok(left)
    }

    /// The time of the first violation between a valid time and a violated one. The violation at the end is traced back
    /// to its start, and only there all other conditions are checked again: in a large group that check is most of the
    /// work.
    fn first_violation_in(&mut self, (valid, mut violated): (f64, f64)) -> Result<f64, SimulationError> {
        let mut violation = self.violation_at(violated)?;
        // Each search ends before the one of the last violation.
        loop {
            let bracket = close_in((valid, violated), |t| {
                let is_violated = match violation {
                    Some(violation) => self.is_violated(violation, t)?,
                    None => !self.violations(t)?.is_empty(),
                };
                Ok::<_, SimulationError>(if is_violated { Side::After } else { Side::Before })
            })?;
            violated = bracket.after;
            if violation.is_none() || bracket.before <= valid {
                return Ok(violated);
            }
            match self.violation_at(bracket.before)? {
                Some(earlier) => (violated, violation) = (bracket.before, Some(earlier)),
                None => return Ok(violated),
            }
        }
    }

    /// A violation at a time, if there is one.
    fn violation_at(&mut self, t: f64) -> Result<Option<Violation>, SimulationError> {
        let Some(&id) = self.violations(t)?.first() else { return Ok(None) };
        let kind = [Violation::Leaves(id), Violation::Penetrates(id.a, id.b), Violation::Stops, Violation::Breaks];
        for violation in kind {
            if self.is_violated(violation, t)? {
                return Ok(Some(violation));
            }
        }
        Ok(None)
    }

    /// Whether this violation is present at a time.
    fn is_violated(&mut self, violation: Violation, t: f64) -> Result<bool, SimulationError> {
        self.step.states_at(&self.core.model, t, self.states);
        match violation {
            Violation::Leaves(id) => {
                let is_held = self.step.active.holds(id) && !self.tolerated.contains(&id);
                Ok(is_held && held_kinematics(self.core, self.states, id).is_none())
            }
            Violation::Penetrates(a, b) => Ok(self.penetrates((a, b))),
            Violation::Stops => Ok(stopped(self.core, self.step, t, self.states)
                .chain(settled(self.core, self.step, t, self.states).map(|(id, _)| id))
                .any(|id| !self.tolerated.contains(&id))),
            Violation::Breaks => {
                let touches = self.step.active.held().iter().map(|&id| {
                    let kinematics = contact_kinematics::kinematics(&self.core.model, self.states, id)?;
                    Some(held_touch(self.step, id, kinematics))
                });
                match touches.collect::<Option<Vec<_>>>() {
                    Some(touches) => {
                        Ok(!breaking_contacts(self.core, self.step, t, self.states, &touches, &self.tolerated)?
                            .is_empty())
                    }
                    // A contact has left its features.
                    None => Ok(true),
                }
            }
        }
    }

    /// When a contact that had a gap at the start of the step closes within it: the time of zero separation, which is
    /// before the time at which the penetration is detected.
    fn closing_time(&mut self, violated: f64) -> Option<f64> {
        self.step.states_at(&self.core.model, violated, self.states);
        // Also a tolerated contact may close.
        let tolerated = std::mem::take(&mut self.tolerated);
        let penetrating = self.penetrating();
        self.tolerated = tolerated;
        let id = penetrating?;
        let touch = TOUCH_RELATIVE * tolerances::pair_size(&self.core.model, id.a, id.b);
        let start = self.step.t;
        let mut separation = |t: f64| {
            self.step.states_at(&self.core.model, t, self.states);
            contact_kinematics::kinematics(&self.core.model, self.states, id)
                .map(|kinematics| ContactEvent::Closing.value(&kinematics))
        };
        if separation(start)? <= touch {
            return None;
        }
        let bracket = close_in((start, violated), |t| separation(t).map(Side::of).ok_or(()));
        bracket.ok().map(|bracket| bracket.after)
    }
}

/// A violation of the active set of a group.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Violation {
    /// A held contact that leaves its features.
    Leaves(ContactId),
    /// A pair with a penetrating contact that is not held.
    Penetrates(usize, usize),
    /// The slip of a contact that slides vanishes.
    Stops,
    /// Pushing forces do not suffice: a held contact breaks, or begins to slide.
    Breaks,
}

/// An active contact of a step, with these kinematics.
fn held_touch(step: &ConstrainedStep, id: ContactId, kinematics: ContactKinematics) -> Touch {
    Touch::held(id, kinematics, step.active.modes(id))
}

/// The slips of the contacts that slide in a step, m/s.
fn slips<'a>(
    core: &'a Core,
    step: &'a ConstrainedStep,
    states: &'a [BodyState],
) -> impl Iterator<Item = (ContactId, Slide, DVec3)> + 'a {
    let slip = |(id, slide)| {
        Some((id, slide, contact_kinematics::tangential_kinematics(&core.model, states, id)?.slip_velocity))
    };
    step.active.sliding().filter_map(slip)
}

/// Whether a slip has vanished before `t` (s): it points against its direction at the start of the step, or has become
/// negligible within a step that has come to its end.
fn has_stopped(step: &ConstrainedStep, t: f64, slide: &Slide, slip: DVec3) -> bool {
    // A slip that begins to grow is zero up to rounding.
    let zero = slide.zero_speed();
    let reversed = if slide.speed > zero { 0.0 } else { -zero };
    let is_negligible = t >= step.end && slide.speed > 2.0 * zero && slip.length() <= zero;
    slide.along(slip) < reversed || is_negligible
}

/// The contacts whose slips have vanished in a step before `t` (s).
fn stopped<'a>(
    core: &'a Core,
    step: &'a ConstrainedStep,
    t: f64,
    states: &'a [BodyState],
) -> impl Iterator<Item = ContactId> + 'a {
    slips(core, step, states).filter(move |(_, slide, slip)| has_stopped(step, t, slide, *slip)).map(|(id, ..)| id)
}

/// The rotations that turn in a step and have vanished before `t` (s).
fn settled<'a>(
    core: &'a Core,
    step: &'a ConstrainedStep,
    t: f64,
    states: &'a [BodyState],
) -> impl Iterator<Item = (ContactId, Turn)> + 'a {
    step.active.turning().filter_map(move |(id, turn, slide)| {
        let normal = contact_kinematics::kinematics(&core.model, states, id)?.geometry.normal;
        let part = turn.part(contact_kinematics::relative_rotation(&core.model, states, id), normal);
        has_stopped(step, t, &slide, part).then_some((id, turn))
    })
}

/// If a slip has just vanished at `t` (s), all contacts whose slips vanish then; none if it has only turned.
fn stopping_contacts(core: &Core, step: &ConstrainedStep, t: f64, states: &mut [BodyState]) -> BTreeSet<ContactId> {
    step.states_at(&core.model, t, states);
    if stopped(core, step, t, states).next().is_none() {
        return BTreeSet::new();
    }
    slips(core, step, states).filter(|(_, slide, slip)| slide.has_vanished(*slip)).map(|(id, ..)| id).collect()
}

/// The held contacts that break under pushing forces, without the tolerated ones.
fn breaking_contacts(
    core: &mut Core,
    step: &ConstrainedStep,
    t: f64,
    states: &[BodyState],
    touches: &[Touch],
    tolerated: &BTreeSet<ContactId>,
) -> Result<Vec<ContactId>, SimulationError> {
    if touches.iter().all(cannot_break) {
        return Ok(Vec::new());
    }
    let forces = forces_of(core, step, t, states, touches)?;
    if forces.jams {
        return Ok(sliding(touches).filter(|id| !tolerated.contains(id)).collect());
    }
    let opens = touches.iter().zip(forces.opening_margins());
    let opens = opens.filter(|&(_, margin)| margin < 0.0).map(|(touch, _)| touch.id);
    let slips = forces.slipping(touches).map(|(id, _)| id);
    let turns = forces.turning(touches).map(|((id, _), _)| id);
    Ok(opens.chain(slips).chain(turns).filter(|id| !tolerated.contains(id)).collect())
}

/// Whether no force can end the mode of a contact: a joint whose friction slides is pressed whatever happens, and goes
/// on until its slip vanishes.
fn cannot_break(touch: &Touch) -> bool {
    let slides = matches!(touch.modes.friction, Some(FrictionMode::Sliding(_)));
    slides && matches!(touch.id.feature, Feature::JointFriction(_))
}

/// The contacts that slide.
fn sliding(touches: &[Touch]) -> impl Iterator<Item = ContactId> + '_ {
    touches.iter().filter(|touch| matches!(touch.modes.friction, Some(FrictionMode::Sliding(_)))).map(|touch| touch.id)
}

/// The kinematics of a held contact, if its point lies on its features and has not jumped to a point at which the
/// bodies approach or separate.
fn held_kinematics(core: &Core, states: &[BodyState], id: ContactId) -> Option<ContactKinematics> {
    let tolerance = TOUCH_RELATIVE * tolerances::pair_size(&core.model, id.a, id.b);
    let kinematics = contact_kinematics::kinematics(&core.model, states, id)?;
    let is_on_features = ContactEvent::Leaving.value(&kinematics) >= -tolerance;
    let stays = !rate_exceeds_drift(&core.model, states, id, &kinematics, core.settings.step_error())
        && (is_on_features || contact_set::holds_beyond_border(&core.model, states, id));
    stays.then_some(kinematics)
}

/// When the forces of contacts that break by `violated` (s) reach zero: their accelerations grow from zero and are
/// extrapolated back from two times just after the break. The contacts are recorded, because at the instant itself they
/// cannot be distinguished from contacts that hold.
fn breaking(
    core: &mut Core,
    step: &ConstrainedStep,
    violated: f64,
    states: &mut [BodyState],
) -> Result<ContactChange, SimulationError> {
    let late = (violated + EXTRAPOLATION * (step.end - step.t)).min(step.end);
    let mut openings = Vec::with_capacity(2);
    let (mut departing, mut slipping, mut turning) = (BTreeSet::new(), BTreeMap::new(), BTreeMap::new());
    for t in [violated, late] {
        step.states_at(&core.model, t, states);
        let contacts: Vec<Touch> = step
            .active
            .held()
            .iter()
            .filter_map(|&id| {
                let kinematics = contact_kinematics::kinematics(&core.model, states, id)?;
                Some(held_touch(step, id, kinematics))
            })
            .collect();
        let forces = forces_of(core, step, t, states, &contacts)?;
        if forces.jams {
            return Ok(ContactChange { t: violated, ..ContactChange::default() });
        }
        let opening = contacts.iter().zip(forces.opening_margins()).filter(|&(_, margin)| margin < 0.0);
        departing.extend(opening.map(|(contact, _)| contact.id));
        slipping.extend(forces.slipping(&contacts));
        turning.extend(forces.turning(&contacts));
        openings.push(forces.largest_opening(&contacts));
    }
    let (first, second) = (openings[0], openings[1]);
    let begins_to_turn = !turning.is_empty();
    let change = ContactChange { t: violated, departing, slipping, turning, ..ContactChange::default() };
    // Where kinetic friction is below static friction, the slip accelerates at once.
    let is_sudden = |id: &ContactId| {
        friction::friction_of(&core.model, *id).is_some_and(|friction| friction.sliding.is_below(friction.at_rest))
    };
    let any = !(change.departing.is_empty() && change.slipping.is_empty());
    if !any || begins_to_turn || second <= first || change.slipping.keys().any(is_sudden) {
        return Ok(change);
    }
    let back = first * (late - violated) / (second - first);
    // Where kinetic friction is below static friction, slips do not grow from zero: they have begun at `violated`.
    let begins_at_once = change.departing.is_empty() && back > LONGEST_EXTRAPOLATION * (late - violated);
    if begins_at_once {
        return Ok(change);
    }
    let t = (violated - back.min(LONGEST_EXTRAPOLATION * (late - violated))).max(step.t);
    Ok(ContactChange { t, ..change })
}

fn forces_of(
    core: &mut Core,
    step: &ConstrainedStep,
    t: f64,
    states: &[BodyState],
    contacts: &[Touch],
) -> Result<Forces, SimulationError> {
    let forces = Forces::solve(&core.model, t, states, &step.bodies, contacts, &mut core.memory)
        .map_err(|source| SimulationError::of_response(t, source))?;
    if !forces.jams {
        core.accounts.note_solve(t, &forces.solution.report)?;
        core.note_friction(t, forces.violation);
    }
    Ok(forces)
}
