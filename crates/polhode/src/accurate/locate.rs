//! When the held contacts of an island cease to be the right ones.
//!
//! Within a step the set of held contacts is frozen. It is right as long as (a) every held contact lies on its
//! features (margin) and its place does not jump to where the bodies approach or part, (b) no other contact of the bodies it holds together penetrates, and (c) forces that only push
//! can hold it: the complementarity problem over it has `chi'' = 0` everywhere. The first instant at which one of
//! these fails is found by the locator of events (`crate::interaction::locator`) on the dense output of the step, to 1e-13 of
//! the step.

use super::constrained_step::ConstrainedStep;
use super::engine::Engine;
use super::hold::Forces;
use super::pace::Pace;
use crate::SimulationError;
use crate::collision::contact_set::{ContactId, Hold, Touch};
use crate::core::Core;
use crate::interaction::constraint::ContactEvent;
use crate::interaction::locator::{Side, close_in};
use crate::interaction::projection::moves_apart;
use crate::world::TOUCH_RELATIVE;
use polhode_contact::ContactKinematics;
use polhode_dynamics::BodyState;
use std::collections::BTreeSet;

/// How far after the opening of a contact its acceleration is measured again, as a fraction of the step: long enough
/// to tell its growth from rounding, so short that the growth is linear.
const EXTRAPOLATION: f64 = 1e-5;

/// Longest extrapolation back, in units of the distance of the two times: beyond it the growth is not linear.
const LONGEST_EXTRAPOLATION: f64 = 100.0;

/// What is wrong earlier than what was suspected, at the most, before the time found is taken as it is.
const MOST_SUSPECTS: usize = 16;

/// Intervals of a step at whose ends held contacts are checked for leaving their features, and others for penetration.
pub(super) const PENETRATION_CHECKS: u32 = 8;

/// When and how the held contacts of an island cease to be right.
#[derive(Debug, Default)]
pub(super) struct ContactChange {
    /// s.
    pub(super) t: f64,
    /// Contacts whose forces have been found to reach zero then.
    pub(super) departing: BTreeSet<ContactId>,
}

impl Engine {
    /// The first time in a step, up to `limit` (s), at which its held contacts cease to be right.
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
        let change = self.change_within(core, step, limit, pace, &mut states);
        self.restore_scratch(core, states, &step.bodies);
        change
    }

    fn change_within(
        &self,
        core: &mut Core,
        step: &ConstrainedStep,
        mut limit: f64,
        pace: &Pace,
        states: &mut [BodyState],
    ) -> Result<Option<ContactChange>, SimulationError> {
        let longest = core.settings.step_s;
        let mut tolerated = BTreeSet::new();
        let mut found = None;
        let mut wrong = self.first_wrong(core, step, limit, &tolerated, states)?;
        while let Some(t) = wrong.filter(|&t| pace.is_backing_off() && pace.is_stall(t, longest)) {
            let before = tolerated.len();
            tolerated.extend(self.violations(core, step, t, &tolerated, states)?);
            if tolerated.len() == before {
                break;
            }
            limit = limit.min(pace.retry_time(longest));
            found = Some(ContactChange { t: limit, departing: BTreeSet::new() });
            wrong = self.first_wrong(core, step, limit, &tolerated, states)?;
        }
        let mut pairs: Vec<_> = tolerated.iter().map(|id: &ContactId| (id.a, id.b)).collect();
        pairs.dedup();
        for (a, b) in pairs {
            let names = core.world.pair_names(a, b);
            core.accounts.tolerate(step.t, format!("contacts of {names} that no longer hold were kept for a moment"));
        }
        match wrong {
            Some(wrong) => self.change_before(core, step, wrong, &tolerated, states).map(Some),
            None => Ok(found),
        }
    }

    /// The time of the change that shows at `wrong`: when the contact closes that penetrates by then, or the force of
    /// one that opens reaches zero. What penetrates most visibly at `wrong` need not have been the first to: where
    /// another contact penetrates by the time found, it is located in turn.
    fn change_before(
        &self,
        core: &mut Core,
        step: &ConstrainedStep,
        mut wrong: f64,
        tolerated: &BTreeSet<ContactId>,
        states: &mut [BodyState],
    ) -> Result<ContactChange, SimulationError> {
        let at = |t: f64| ContactChange { t, departing: BTreeSet::new() };
        loop {
            let Some(closing) = self.closing_time(core, step, wrong, states) else {
                return opening(core, step, wrong, states);
            };
            step.states_at(&core.world, closing, states);
            if closing >= wrong || self.penetrating(core, step, states, tolerated).is_none() {
                return Ok(at(closing));
            }
            match self.first_wrong(core, step, closing, tolerated, states)? {
                Some(earlier) if earlier < wrong => wrong = earlier,
                _ => return Ok(at(closing)),
            }
        }
    }

    /// The end of the shortest interval, to 1e-13 of the step, at whose start the set is right and at whose end wrong.
    fn first_wrong(
        &self,
        core: &mut Core,
        step: &ConstrainedStep,
        limit: f64,
        tolerated: &BTreeSet<ContactId>,
        states: &mut [BodyState],
    ) -> Result<Option<f64>, SimulationError> {
        let start = step.t;
        let (mut right, mut wrong) = match self.first_wrong_interval(core, step, start, limit, tolerated, states)? {
            Some(interval) => interval,
            None if self.violations(core, step, limit, tolerated, states)?.is_empty() => return Ok(None),
            None => (start, limit),
        };
        if right > start && !self.violations(core, step, right, tolerated, states)?.is_empty() {
            (right, wrong) = (start, right);
        }
        loop {
            wrong = self.first_of_suspects(core, step, (right, wrong), tolerated, states)?;
            // Another pair may have come to overlap before.
            step.states_at(&core.world, wrong, states);
            if !self.penetrates_unseen(core, step, states, tolerated) {
                return Ok(Some(wrong));
            }
            match self.penetration_shown_within(core, step, (start, wrong), tolerated, states) {
                Some(t) if t < wrong => (right, wrong) = (start, t),
                _ => return Ok(Some(wrong)),
            }
        }
    }

    /// The first of some intervals of the step at whose end a held contact has left its features or a contact that is not held
    /// penetrates: bodies that rock on
    /// each other may penetrate and part again within a step, and its end would not show it. Nor would it show that a kinematic
    /// body has left what it carries for a moment: where one moves, forces are looked at too.
    fn first_wrong_interval(
        &self,
        core: &mut Core,
        step: &ConstrainedStep,
        start: f64,
        limit: f64,
        tolerated: &BTreeSet<ContactId>,
        states: &mut [BodyState],
    ) -> Result<Option<(f64, f64)>, SimulationError> {
        let mut members = step.held.iter().flat_map(|id| [id.a, id.b]);
        let driven = members.any(|body| !core.world.stands_still(body, start, limit));
        let first_look = start + (limit - start) / f64::from(PENETRATION_CHECKS);
        if let Some(interval) = self.interval_of_approach(core, step, (start, first_look), tolerated, states) {
            return Ok(Some(interval));
        }
        let mut before = start;
        for k in 1..=PENETRATION_CHECKS {
            let t = start + (limit - start) * (f64::from(k) / f64::from(PENETRATION_CHECKS));
            step.states_at(&core.world, t, states);
            // Contacts may leave their features long before others penetrate.
            let mut held = step.held.iter().filter(|id| !tolerated.contains(id));
            if k < PENETRATION_CHECKS && held.any(|&id| held_kinematics(core, states, id).is_none()) {
                return Ok(Some((before, t)));
            }
            let penetration = self.first_penetration(core, step, states, tolerated);
            // What is wrong at the end is looked for there, with all else.
            if penetration.contact.is_some() && k < PENETRATION_CHECKS {
                return Ok(Some((before, t)));
            }
            let unseen = penetration.contact.is_none() && penetration.is_unseen();
            if unseen && let Some(t) = self.penetration_shown_within(core, step, (before, t), tolerated, states) {
                return Ok(Some((before, t)));
            }
            if driven && k < PENETRATION_CHECKS && !self.violations(core, step, t, tolerated, states)?.is_empty() {
                return Ok(Some((before, t)));
            }
            before = t;
        }
        Ok(None)
    }

    /// What is wrong with the held contacts of a group at time `t` of its trial: the contacts of the first kind of
    /// violation found, those tolerated left out.
    fn violations(
        &self,
        core: &mut Core,
        step: &ConstrainedStep,
        t: f64,
        tolerated: &BTreeSet<ContactId>,
        states: &mut [BodyState],
    ) -> Result<Vec<ContactId>, SimulationError> {
        step.states_at(&core.world, t, states);
        let mut touches = Vec::with_capacity(step.held.len());
        let mut left = Vec::new();
        for &id in &step.held {
            let is_tolerated = tolerated.contains(&id);
            let kinematics =
                if is_tolerated { core.world.kinematics(states, id) } else { held_kinematics(core, states, id) };
            match kinematics {
                Some(kinematics) => touches.push(Touch { id, kinematics, hold: Hold::Held, known: true }),
                None => left.push(id),
            }
        }
        if left.is_empty() {
            left.extend(self.penetrating(core, step, states, tolerated));
        }
        if left.is_empty() {
            left = opening_contacts(core, step, t, states, &touches, tolerated)?;
        }
        Ok(left)
    }

    /// The end of the shortest interval between two times, at the first of which nothing is wrong and at whose end something is. What
    /// is wrong at the end is followed to where it begins, and all else is asked only there: in a large group that is most of
    /// the work.
    fn first_of_suspects(
        &self,
        core: &mut Core,
        step: &ConstrainedStep,
        (right, mut wrong): (f64, f64),
        tolerated: &BTreeSet<ContactId>,
        states: &mut [BodyState],
    ) -> Result<f64, SimulationError> {
        let mut suspect = self.suspect(core, step, wrong, tolerated, states)?;
        for _ in 0..MOST_SUSPECTS {
            let bracket = close_in((right, wrong), |t| {
                let is_wrong = match suspect {
                    Some(suspect) => self.shows(core, step, suspect, t, tolerated, states)?,
                    None => !self.violations(core, step, t, tolerated, states)?.is_empty(),
                };
                Ok::<_, SimulationError>(if is_wrong { Side::After } else { Side::Before })
            })?;
            wrong = bracket.after;
            if suspect.is_none() || bracket.before <= right {
                break;
            }
            match self.suspect(core, step, bracket.before, tolerated, states)? {
                Some(earlier) => (wrong, suspect) = (bracket.before, Some(earlier)),
                None => break,
            }
        }
        Ok(wrong)
    }

    /// What is wrong at a time, if anything is.
    fn suspect(
        &self,
        core: &mut Core,
        step: &ConstrainedStep,
        t: f64,
        tolerated: &BTreeSet<ContactId>,
        states: &mut [BodyState],
    ) -> Result<Option<Suspect>, SimulationError> {
        let Some(&id) = self.violations(core, step, t, tolerated, states)?.first() else { return Ok(None) };
        let kind = [Suspect::Leaves(id), Suspect::Penetrates(id.a, id.b), Suspect::Opens];
        for suspect in kind {
            if self.shows(core, step, suspect, t, tolerated, states)? {
                return Ok(Some(suspect));
            }
        }
        Ok(None)
    }

    /// Whether what is suspected is wrong at a time.
    fn shows(
        &self,
        core: &mut Core,
        step: &ConstrainedStep,
        suspect: Suspect,
        t: f64,
        tolerated: &BTreeSet<ContactId>,
        states: &mut [BodyState],
    ) -> Result<bool, SimulationError> {
        step.states_at(&core.world, t, states);
        match suspect {
            Suspect::Leaves(id) => {
                let is_held = step.held.binary_search(&id).is_ok() && !tolerated.contains(&id);
                Ok(is_held && held_kinematics(core, states, id).is_none())
            }
            Suspect::Penetrates(a, b) => Ok(self.penetrates(core, step, (a, b), states, tolerated)),
            Suspect::Opens => {
                let touches = step.held.iter().map(|&id| {
                    let kinematics = core.world.kinematics(states, id)?;
                    Some(Touch { id, kinematics, hold: Hold::Held, known: true })
                });
                match touches.collect::<Option<Vec<_>>>() {
                    Some(touches) => Ok(!opening_contacts(core, step, t, states, &touches, tolerated)?.is_empty()),
                    // A contact has left its features.
                    None => Ok(true),
                }
            }
        }
    }

    /// When a contact that was clear at the start of the step closes within it: the time at which its separation is
    /// zero, not that at which it shows as penetration.
    fn closing_time(&self, core: &Core, step: &ConstrainedStep, wrong: f64, states: &mut [BodyState]) -> Option<f64> {
        step.states_at(&core.world, wrong, states);
        let id = self.penetrating(core, step, states, &BTreeSet::new())?;
        let mut separation = |t: f64| {
            step.states_at(&core.world, t, states);
            core.world.kinematics(states, id).map(|kinematics| ContactEvent::Closing.value(&kinematics))
        };
        if separation(step.t)? <= TOUCH_RELATIVE * core.world.pair_size(id.a, id.b) {
            return None;
        }
        let bracket = close_in((step.t, wrong), |t| separation(t).map(Side::of).ok_or(()));
        bracket.ok().map(|bracket| bracket.after)
    }
}

/// What may be wrong with the held contacts of a group.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Suspect {
    /// A held contact that leaves its features.
    Leaves(ContactId),
    /// A pair of which a contact that is not held penetrates.
    Penetrates(usize, usize),
    /// Forces that only push cannot hold the contacts.
    Opens,
}

/// The held contacts that open under forces that only push, those tolerated left out.
fn opening_contacts(
    core: &mut Core,
    step: &ConstrainedStep,
    t: f64,
    states: &[BodyState],
    touches: &[Touch],
    tolerated: &BTreeSet<ContactId>,
) -> Result<Vec<ContactId>, SimulationError> {
    let forces = forces_of(core, step, t, states, touches)?;
    let opens = touches.iter().zip(forces.holding());
    let opens = opens.filter(|&(touch, holding)| holding < 0.0 && !tolerated.contains(&touch.id));
    Ok(opens.map(|(touch, _)| touch.id).collect())
}

/// A held contact that lies on its features and whose place has not jumped to where the bodies approach or part.
fn held_kinematics(core: &Core, states: &[BodyState], id: ContactId) -> Option<ContactKinematics> {
    let tolerance = TOUCH_RELATIVE * core.world.pair_size(id.a, id.b);
    let kinematics = core.world.kinematics(states, id)?;
    let stays = ContactEvent::Leaving.value(&kinematics) >= -tolerance
        && !moves_apart(&core.world, states, id, &kinematics, core.settings.step_error());
    stays.then_some(kinematics)
}

/// When the forces of contacts that open after `wrong` reach zero: their accelerations, which grow from zero, are
/// extrapolated back from two times just after. The contacts are noted, because at that instant nothing but the
/// past tells them from those that hold.
fn opening(
    core: &mut Core,
    step: &ConstrainedStep,
    wrong: f64,
    states: &mut [BodyState],
) -> Result<ContactChange, SimulationError> {
    let late = (wrong + EXTRAPOLATION * (step.end - step.t)).min(step.end);
    let mut openings = Vec::with_capacity(2);
    let mut departing = BTreeSet::new();
    for t in [wrong, late] {
        step.states_at(&core.world, t, states);
        let contacts: Vec<Touch> = step
            .held
            .iter()
            .filter_map(|&id| {
                let kinematics = core.world.kinematics(states, id)?;
                Some(Touch { id, kinematics, hold: Hold::Held, known: true })
            })
            .collect();
        let forces = forces_of(core, step, t, states, &contacts)?;
        let opening = contacts.iter().zip(forces.holding()).filter(|&(_, holding)| holding < 0.0);
        departing.extend(opening.map(|(contact, _)| contact.id));
        let accelerations = forces.solution.residual_accelerations;
        openings.push(accelerations.iter().fold(0.0f64, |most, &w| most.max(w)));
    }
    let (first, second) = (openings[0], openings[1]);
    if departing.is_empty() || second <= first {
        return Ok(ContactChange { t: wrong, departing });
    }
    let back = first * (late - wrong) / (second - first);
    let t = (wrong - back.min(LONGEST_EXTRAPOLATION * (late - wrong))).max(step.t);
    Ok(ContactChange { t, departing })
}

fn forces_of(
    core: &mut Core,
    step: &ConstrainedStep,
    t: f64,
    states: &[BodyState],
    contacts: &[Touch],
) -> Result<Forces, SimulationError> {
    let forces = Forces::solve(&core.world, t, states, &step.bodies, contacts, &mut core.solver)
        .map_err(|source| Core::response_error(t, source))?;
    core.accounts.note_solve(t, &forces.solution.report)?;
    Ok(forces)
}
