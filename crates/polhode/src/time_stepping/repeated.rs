//! A step that is made again with better rows, while bodies overlap at its end.
//!
//! The rows of a step's problems are those of features that are near each other at its start, linear in the motion.
//! Bodies that turn within the step, or that others deflect, may meet at features that were not among them, or sooner
//! than their rows say. So the step is looked at from its end: where bodies overlap there by more than
//! [`SHARE_OF_SIZE`] of the smaller one,
//!
//! - features that are no rows yet become rows, with their gap at the start;
//! - a row of a gap `g` whose contact ends with the overlap `d` may close by `g - d` only, as in a secant method:
//!   turning by an angle `w h` makes it wrong by `(w h)^2` of the size, and every further step with it by `w h` times
//!   what was left.
//!
//! and the step is made again from its start. Rows that are added, and gaps that become smaller, take energy at most,
//! where moving bodies out of each other would give some. What is left after [`MOST_TIMES`] is removed and told.

use super::contacts::{FreeAccelerations, NearContact, Span, kinematics_at_point, near_contact};
use super::drift;
use super::middle::Stops;
use super::step::{Substep, TimeStepper};
use crate::accounting::time_step_report::TimeStepReport;
use crate::collision::contact_set;
use crate::identity::contact_id::ContactId;
use crate::model::states_of::{set_states, states_of};
use crate::model::{Model, prescribed, tolerances};
use polhode_dynamics::BodyState;
use polhode_response::ResponseError;
use std::collections::BTreeMap;

/// The overlap at the end of a step, as a part of the size of the smaller body, that is removed by moving the bodies
/// (no unit, 1e-5 to 5e-4): half of what the tier promises (1e-3).
pub(crate) const SHARE_OF_SIZE: f64 = 5e-4;

/// How often a step is made again (2 to 8), for bodies that overlap at its end or for pairs that were not expected to
/// meet: each time may deflect others.
pub(crate) const MOST_TIMES: usize = 4;

/// The parts of a step after which features that meet are looked for, where those at its end cannot be: bodies have
/// then passed them.
const PARTS: [f64; 3] = [0.5, 0.25, 0.125];

impl TimeStepper {
    /// Makes a step of some bodies with these contacts and pairs, several times where bodies overlap at its end. Where
    /// slips end within it, the states are those at its start.
    ///
    /// # Errors
    /// When a number is not finite; the states are then those at its start.
    pub(super) fn step_by(
        &mut self,
        model: &Model,
        states: &mut [BodyState],
        bodies: &[usize],
        (mut near, pairs): (Vec<NearContact>, &[(usize, usize)]),
        (interval, stops): (Substep, Stops<'_>),
    ) -> Result<TimeStepReport, ResponseError> {
        let start = states_of(states, bodies);
        self.cones_at_start.forget();
        for time in 0..=MOST_TIMES {
            let made = self.make_step(model, states, bodies, (near.clone(), pairs), (interval, stops));
            let made = made.inspect_err(|_| set_states(states, bodies, &start))?;
            if !made.report.stops.is_empty() {
                set_states(states, bodies, &start);
                prescribed::prescribe_members(model, pairs, interval.t, states);
                return Ok(made.report);
            }
            let end = states_of(states, bodies);
            let deep = made.overlaps.deeper_than(model, states, SHARE_OF_SIZE);
            let search = Search { model, bodies, pairs, interval, unseen_bounce: self.unseen_bounce };
            let is_last = deep.is_empty() || time == MOST_TIMES;
            if is_last || !search.improve(states, &mut near, (&start, &made.struck), &deep) {
                set_states(states, bodies, &end);
                prescribed::prescribe_members(model, pairs, interval.t + interval.h, states);
                let removed = self.remove_overlaps(model, states, bodies, made);
                return removed.inspect_err(|_| set_states(states, bodies, &start));
            }
        }
        Ok(TimeStepReport::new(self.about))
    }
}

/// Looks for better rows of a step.
struct Search<'a> {
    model: &'a Model,
    bodies: &'a [usize],
    pairs: &'a [(usize, usize)],
    interval: Substep,
    unseen_bounce: f64,
}

impl Search<'_> {
    /// Makes the contacts of a step such that these overlaps at its end (m), each of a contact, become smaller, and
    /// sets the states to those at its start. Returns whether anything has changed.
    fn improve(
        &self,
        states: &mut [BodyState],
        near: &mut Vec<NearContact>,
        (start, struck): (&[BodyState], &[BodyState]),
        deep: &[(ContactId, f64)],
    ) -> bool {
        let Self { model, bodies, pairs, interval, .. } = *self;
        set_states(states, bodies, start);
        prescribed::prescribe_members(model, pairs, interval.t, states);
        let mut any = false;
        let mut unknown: BTreeMap<(usize, usize), Vec<ContactId>> = BTreeMap::new();
        for &(id, overlap) in deep {
            if let Ok(place) = near.binary_search_by(|contact| contact.id.cmp(&id)) {
                any |= near[place].keep_off(overlap);
            } else {
                unknown.entry((id.a, id.b)).or_default().push(id);
            }
        }
        let mut found = Vec::new();
        for (pair, ids) in unknown {
            let mut of_pair = self.usable(states, near, ids);
            for part in PARTS {
                if !of_pair.is_empty() {
                    break;
                }
                let met = self.met_after(states, (start, struck), pair, part);
                of_pair = self.usable(states, near, met);
            }
            found.extend(of_pair);
        }
        any |= !found.is_empty();
        near.extend(found);
        near.sort_by_key(|contact| contact.id);
        any
    }

    /// Those of these contacts that are not known yet and do not penetrate now.
    fn usable(&self, states: &[BodyState], near: &[NearContact], ids: Vec<ContactId>) -> Vec<NearContact> {
        let Self { model, bodies, interval, unseen_bounce, .. } = *self;
        let span = Span { h: interval.h, unseen_bounce };
        let free = FreeAccelerations::with_fields(model, interval.t, states, bodies);
        let usable = |id: ContactId| {
            near.binary_search_by(|contact| contact.id.cmp(&id)).err()?;
            let kinematics = kinematics_at_point(model, states, id)?;
            let touches_or_is_apart =
                kinematics.geometry.separation >= -tolerances::touch_distance(model, states, id.a, id.b);
            touches_or_is_apart.then(|| near_contact(model, states, &free, id, kinematics, span))
        };
        ids.into_iter().filter_map(usable).collect()
    }

    /// The contacts of a pair that penetrate after this part of the step, as the bodies fly after its impacts.
    fn met_after(
        &self,
        states: &mut [BodyState],
        (start, struck): (&[BodyState], &[BodyState]),
        (a, b): (usize, usize),
        part: f64,
    ) -> Vec<ContactId> {
        let Self { model, bodies, interval, .. } = *self;
        for body in [a, b] {
            if let Ok(place) = bodies.binary_search(&body) {
                states[body] = drift(model, body, &struck[place], part * interval.h);
            }
        }
        prescribed::prescribe_members(model, &[(a, b)], interval.t + part * interval.h, states);
        let met = contact_set::contacts_of_pair(model, states, a, b, tolerances::touch_distance(model, states, a, b));
        for body in [a, b] {
            if let Ok(place) = bodies.binary_search(&body) {
                states[body] = start[place];
            }
        }
        prescribed::prescribe_members(model, &[(a, b)], interval.t, states);
        met.into_iter().map(|touch| touch.id).collect()
    }
}
