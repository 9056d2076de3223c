//! When the held contacts of a moving group cease to be the right ones.
//!
//! Within a step the set of held contacts is frozen. It is right as long as (a) every held contact lies on its
//! features (margin), (b) no other contact of the bodies it holds together penetrates, and (c) forces that only push
//! can hold it: the complementarity problem over it has `chi'' = 0` everywhere. The first instant at which one of
//! these fails is found by bisection on the dense output of the step, to 1e-13 of the step.

use super::engine::Engine;
use super::hold::Forces;
use super::trial::{GroupTrial, Trial};
use crate::SimulationError;
use crate::interaction::contact_set::{ContactId, Hold, Touch};
use crate::world::TOUCH_RELATIVE;
use polhode_dynamics::BodyState;
use std::collections::BTreeSet;

/// Bisections of a step or a part of it: 2^-44 is below 1e-13.
pub(super) const BISECTIONS: usize = 44;

/// How far after the opening of a contact its acceleration is measured again, as a fraction of the step: long enough
/// to tell its growth from rounding, so short that the growth is linear.
const EXTRAPOLATION: f64 = 1e-5;

/// Longest extrapolation back, in units of the distance of the two times: beyond it the growth is not linear.
const LONGEST_EXTRAPOLATION: f64 = 100.0;

/// Intervals of a step at whose ends contacts that are not held are looked for.
pub(super) const DIP_SAMPLES: u32 = 8;

impl Engine {
    /// The first time in the trial at which the held contacts of some group cease to be right.
    ///
    /// # Errors
    /// When contact forces cannot be found.
    pub(super) fn locate_contact_change(&mut self, trial: &Trial) -> Result<Option<f64>, SimulationError> {
        let mut states = self.states.clone();
        let mut limit = trial.end();
        let mut found = None;
        self.departing.clear();
        for group in &trial.groups {
            let mut tolerated = BTreeSet::new();
            let mut wrong = self.first_wrong(group, trial.t, limit, &tolerated, &mut states)?;
            while let Some(t) = wrong.filter(|&t| self.puts_up() && self.is_stall(t)) {
                let before = tolerated.len();
                tolerated.extend(self.violations(group, t, &tolerated, &mut states)?);
                if tolerated.len() == before {
                    break;
                }
                limit = limit.min(self.looks_again());
                found = Some(limit);
                wrong = self.first_wrong(group, trial.t, limit, &tolerated, &mut states)?;
            }
            let Some(wrong) = wrong else { continue };
            let change = self.change_before(group, trial, wrong, &tolerated, &mut states)?;
            limit = change;
            found = Some(change);
        }
        Ok(found)
    }

    /// The time of the change that shows at `wrong`: when the contact closes that has sunk in by then, or the force of
    /// one that opens reaches zero. What has sunk in most visibly at `wrong` need not have been the first to: where
    /// another contact has sunk in by the time found, it is located in turn.
    fn change_before(
        &mut self,
        group: &GroupTrial,
        trial: &Trial,
        mut wrong: f64,
        tolerated: &BTreeSet<ContactId>,
        states: &mut [BodyState],
    ) -> Result<f64, SimulationError> {
        loop {
            self.departing.clear();
            let Some(closing) = self.closing_time(group, trial.t, wrong, states) else {
                return Ok(self.opening_time(group, trial, wrong, states)?.unwrap_or(wrong));
            };
            group.states_at(closing, states);
            if closing >= wrong || self.penetrating(group, states, tolerated).is_none() {
                return Ok(closing);
            }
            match self.first_wrong(group, trial.t, closing, tolerated, states)? {
                Some(earlier) if earlier < wrong => wrong = earlier,
                _ => return Ok(closing),
            }
        }
    }

    /// The end of the shortest interval, to 1e-13 of the step, at whose start the set is right and at whose end wrong.
    fn first_wrong(
        &mut self,
        group: &GroupTrial,
        start: f64,
        limit: f64,
        tolerated: &BTreeSet<ContactId>,
        states: &mut [BodyState],
    ) -> Result<Option<f64>, SimulationError> {
        let (mut right, mut wrong) = match self.first_dip(group, start, limit, tolerated, states) {
            Some(interval) => interval,
            None if self.violations(group, limit, tolerated, states)?.is_empty() => return Ok(None),
            None => (start, limit),
        };
        let mut suspect = None;
        loop {
            for _ in 0..BISECTIONS {
                let middle = 0.5 * (right + wrong);
                if middle <= right || middle >= wrong {
                    break;
                }
                if self.is_wrong(group, middle, tolerated, states, &mut suspect)? {
                    wrong = middle;
                } else {
                    right = middle;
                }
            }
            // Another pair may have come to overlap before.
            group.states_at(wrong, states);
            if !self.sunk(group, states, tolerated).is_unseen() {
                return Ok(Some(wrong));
            }
            match self.first_seen_sinking(group, (start, wrong), tolerated, states) {
                Some(t) if t < wrong => (right, wrong) = (start, t),
                _ => return Ok(Some(wrong)),
            }
        }
    }

    /// The first of some intervals of the step at whose end a contact that is not held has sunk in: bodies that rock on
    /// each other may sink and rise again within a step, and its end would not show it.
    fn first_dip(
        &self,
        group: &GroupTrial,
        start: f64,
        limit: f64,
        tolerated: &BTreeSet<ContactId>,
        states: &mut [BodyState],
    ) -> Option<(f64, f64)> {
        let mut before = start;
        for k in 1..=DIP_SAMPLES {
            let t = start + (limit - start) * (f64::from(k) / f64::from(DIP_SAMPLES));
            group.states_at(t, states);
            let sunk = self.first_sunk(group, states, tolerated);
            // What is wrong at the end is looked for there, with all else.
            if sunk.contact.is_some() && k < DIP_SAMPLES {
                return Some((before, t));
            }
            let unseen = sunk.contact.is_none() && sunk.is_unseen();
            if unseen && let Some(t) = self.first_seen_sinking(group, (before, t), tolerated, states) {
                return Some((before, t));
            }
            before = t;
        }
        None
    }

    /// What is wrong with the held contacts of a group at time `t` of its trial: the contacts of the first kind of
    /// violation found, those tolerated left out.
    fn violations(
        &mut self,
        group: &GroupTrial,
        t: f64,
        tolerated: &BTreeSet<ContactId>,
        states: &mut [BodyState],
    ) -> Result<Vec<ContactId>, SimulationError> {
        group.states_at(t, states);
        let mut touches = Vec::with_capacity(group.held.len());
        let mut left = Vec::new();
        for &id in &group.held {
            let tolerance = TOUCH_RELATIVE * self.world.pair_size(id.a, id.b);
            match self.world.kinematics(states, id) {
                Some(kinematics) if kinematics.geometry.margin >= -tolerance || tolerated.contains(&id) => {
                    touches.push(Touch { id, kinematics, hold: Hold::Held, known: true });
                }
                _ => left.push(id),
            }
        }
        if left.is_empty() {
            left.extend(self.penetrating(group, states, tolerated));
        }
        if left.is_empty() {
            let forces = self.forces_of(group, t, states, &touches)?;
            let opens = touches.iter().zip(&forces.solution.residual_accelerations);
            let opens = opens.filter(|&(touch, &w)| w > forces.opening && !tolerated.contains(&touch.id));
            left.extend(opens.map(|(touch, _)| touch.id));
        }
        Ok(left)
    }

    /// Whether anything is wrong with the held contacts of a group at a time. The pair of what was wrong last is asked
    /// first: where it penetrates, nothing else need be asked, and in a large group that is most of the work.
    fn is_wrong(
        &mut self,
        group: &GroupTrial,
        t: f64,
        tolerated: &BTreeSet<ContactId>,
        states: &mut [BodyState],
        suspect: &mut Option<(usize, usize)>,
    ) -> Result<bool, SimulationError> {
        group.states_at(t, states);
        if suspect.is_some_and(|pair| self.penetrates(group, pair, states, tolerated)) {
            return Ok(true);
        }
        let first = self.violations(group, t, tolerated, states)?.first().map(|id| (id.a, id.b));
        *suspect = first.or(*suspect);
        Ok(first.is_some())
    }

    fn forces_of(
        &mut self,
        group: &GroupTrial,
        t: f64,
        states: &[BodyState],
        touches: &[Touch],
    ) -> Result<Forces, SimulationError> {
        let forces = Forces::solve(&self.world, t, states, &group.bodies, touches, &mut self.solver)
            .map_err(|source| self.response_error(source))?;
        self.note_solve(&forces.solution.report)?;
        Ok(forces)
    }

    /// When the forces of contacts that open after `wrong` reach zero: their accelerations, which grow from zero, are
    /// extrapolated back from two times just after. The contacts are noted, because at that instant nothing but the
    /// past tells them from those that hold.
    fn opening_time(
        &mut self,
        group: &GroupTrial,
        trial: &Trial,
        wrong: f64,
        states: &mut [BodyState],
    ) -> Result<Option<f64>, SimulationError> {
        let late = (wrong + EXTRAPOLATION * (trial.end() - trial.t)).min(trial.end());
        let mut openings = Vec::with_capacity(2);
        for t in [wrong, late] {
            group.states_at(t, states);
            let touches: Vec<Touch> = group
                .held
                .iter()
                .filter_map(|&id| {
                    let kinematics = self.world.kinematics(states, id)?;
                    Some(Touch { id, kinematics, hold: Hold::Held, known: true })
                })
                .collect();
            let forces = self.forces_of(group, t, states, &touches)?;
            let accelerations = forces.solution.residual_accelerations;
            let opening = touches.iter().zip(&accelerations).filter(|&(_, &w)| w > forces.opening);
            self.departing.extend(opening.map(|(touch, _)| touch.id));
            openings.push(accelerations.iter().fold(0.0f64, |most, &w| most.max(w)));
        }
        let (first, second) = (openings[0], openings[1]);
        if self.departing.is_empty() || second <= first {
            return Ok(None);
        }
        let back = first * (late - wrong) / (second - first);
        Ok(Some((wrong - back.min(LONGEST_EXTRAPOLATION * (late - wrong))).max(trial.t)))
    }

    /// When a contact that was clear at the start of the step closes within it: the time at which its separation is
    /// zero, not that at which it shows as penetration.
    fn closing_time(&self, group: &GroupTrial, start: f64, wrong: f64, states: &mut [BodyState]) -> Option<f64> {
        group.states_at(wrong, states);
        let id = self.penetrating(group, states, &BTreeSet::new())?;
        let mut separation = |t: f64| {
            group.states_at(t, states);
            Some(self.world.kinematics(states, id)?.geometry.separation)
        };
        let (mut open, mut closed) = (start, wrong);
        if separation(open)? <= TOUCH_RELATIVE * self.world.pair_size(id.a, id.b) {
            return None;
        }
        for _ in 0..BISECTIONS {
            let middle = 0.5 * (open + closed);
            if separation(middle)? > 0.0 {
                open = middle;
            } else {
                closed = middle;
            }
        }
        Some(closed)
    }
}
