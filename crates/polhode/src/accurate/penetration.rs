//! Penetration of bodies in contact at points that no held contact covers.
//!
//! An open contact that penetrates and closes is found among the contacts of the pair as long as its point lies on its
//! features. Where features end, as at the bend of a ridge, this holds only up to a depth of some 1e-11 of the bodies'
//! size. A step is checked at a few times only. By then the penetration may be so deep that no contact shows where it
//! began. The separation of the pair, taken over all its parts and axes, still shows it: an interval at whose end the
//! pair penetrates deeper than all its contacts is bisected until the contact is found.
//!
//! Limit: a penetration that begins and ends between two checks is not found.

use super::step_search::StepSearch;
use crate::collision::touch::Pair;
use crate::collision::{contact_kinematics, contact_set};
use crate::constraint::locator::{Side, close_in};
use crate::identity::contact_id::ContactId;
use crate::model::tolerances;
use std::convert::Infallible;

/// Depth at which an open contact counts as penetrating, relative to size: a quarter of what a step aims at
/// (`Settings::penetration_aim`, 1e-12).
pub(super) const PENETRATING_RELATIVE: f64 = 2.5e-13;

/// If two bodies overlap deeper than each of their contacts, by more than this many such depths, they penetrate at a
/// point that no contact shows: three quarters of what a step aims at.
const UNDETECTED_DEPTHS: f64 = 3.0;

/// Penetration of a pair in contact besides its held contacts.
pub(super) struct Penetration {
    /// An open contact that penetrates and closes.
    pub(super) contact: Option<ContactId>,
    /// Without such a contact: the overlap of the bodies minus the largest penetration of their contacts, in units of
    /// the depth at which a contact counts as penetrating.
    excess_depths: f64,
}

impl Penetration {
    /// Whether the pair overlaps at a point that none of its contacts shows.
    pub(super) fn is_undetected(&self) -> bool {
        self.excess_depths > UNDETECTED_DEPTHS
    }
}

impl StepSearch<'_> {
    /// An open contact of the group's touching pairs that penetrates and closes.
    pub(super) fn penetrating(&self) -> Option<ContactId> {
        self.penetrations().find_map(|penetration| penetration.contact)
    }

    /// Whether some pair of the group overlaps at a point that none of its contacts shows.
    pub(super) fn penetrates_undetected(&self) -> bool {
        self.penetrations().any(|penetration| penetration.is_undetected())
    }

    /// The penetration of the first pair of the group with a penetrating contact. Without such a pair, the largest
    /// overlap that no contact shows.
    pub(super) fn first_penetration(&self) -> Penetration {
        let mut excess_depths = 0.0_f64;
        for penetration in self.penetrations() {
            if penetration.contact.is_some() {
                return penetration;
            }
            // `max` ignores NaN, which is detected where it arises.
            excess_depths = excess_depths.max(penetration.excess_depths);
        }
        Penetration { contact: None, excess_depths }
    }

    /// Whether an open contact of one pair penetrates and closes.
    pub(super) fn penetrates(&self, pair: (usize, usize)) -> bool {
        self.penetration_of_pair(pair).contact.is_some()
    }

    /// The penetrations of the group's touching pairs, in their order.
    fn penetrations(&self) -> impl Iterator<Item = Penetration> + '_ {
        let of_pair = move |pair| self.penetration_of_pair(pair);
        self.step.watched_pairs(&self.core.model).into_iter().map(of_pair)
    }

    fn penetration_of_pair(&self, (a, b): (usize, usize)) -> Penetration {
        let depth = PENETRATING_RELATIVE * tolerances::pair_size(&self.core.model, a, b)
            + tolerances::rounding(&self.core.model, self.states, a, b);
        // The same reach as in the resolution of the event, so that both find the same contacts.
        let reach = tolerances::touch_distance(&self.core.model, self.states, a, b);
        let Some(pair) = contact_set::penetrating_pair(&self.core.model, self.states, (a, b), reach, depth) else {
            return Penetration { contact: None, excess_depths: 0.0 };
        };
        let Pair { separation, contacts, .. } = pair;
        // A separating contact is left open, because it ends the penetration by itself, unless the penetration began
        // within the step.
        let began_in_step = || separation < -depth && !self.overlapped((a, b), depth);
        let closing = contacts.iter().filter(|touch| {
            touch.kinematics.geometry.separation < -depth
                && (touch.kinematics.separation_rate < 0.0 || self.was_clear(touch.id, depth) || began_in_step())
        });
        let not_held = |id: &ContactId| !self.step.active.holds(*id) && !self.tolerated.contains(id);
        let contact = closing.map(|touch| touch.id).find(not_held);
        if contact.is_some() || separation >= -depth {
            return Penetration { contact, excess_depths: 0.0 };
        }
        let held = self.step.active.held().iter().filter(|id| (id.a, id.b) == (a, b));
        let held = held.filter_map(|&id| {
            Some(contact_kinematics::kinematics(&self.core.model, self.states, id)?.geometry.separation)
        });
        let found = contacts.iter().map(|touch| touch.kinematics.geometry.separation);
        let shown = held.chain(found).fold(0.0, f64::min);
        Penetration { contact, excess_depths: (shown - separation) / depth }
    }

    /// Whether a contact had a gap at the start of the step.
    fn was_clear(&self, id: ContactId, depth: f64) -> bool {
        contact_kinematics::kinematics(&self.core.model, self.start, id).is_some_and(|k| k.geometry.separation > depth)
    }

    /// Whether two bodies overlapped at the start of the step. If one has passed into the other since then, its nearest
    /// features may be on the far side, where there was never a gap.
    fn overlapped(&self, (a, b): (usize, usize), depth: f64) -> bool {
        contact_set::separation_without_memory(&self.core.model, self.start, a, b)
            .is_some_and(|separation| separation < -depth)
    }

    /// An interval from `start` at whose end a contact penetrates that approaches at `start` and would close before
    /// `end` (s). If it separated again before the next check, the penetration would be missed. It is checked after the
    /// predicted time to closing, and after two, four, eight times as long.
    pub(super) fn approach_interval(&mut self, (start, end): (f64, f64)) -> Option<(f64, f64)> {
        self.step.states_at(&self.core.model, start, self.states);
        let mut closing = Vec::new();
        for (a, b) in self.step.watched_pairs(&self.core.model) {
            let travel = (tolerances::point_speed(&self.core.model, self.start, a)
                + tolerances::point_speed(&self.core.model, self.start, b))
                * (end - start);
            let reach = travel + tolerances::touch_distance(&self.core.model, self.states, a, b);
            let contacts = contact_set::contacts_of_pair(&self.core.model, self.states, a, b, reach);
            let open = contacts.iter().filter(|touch| !self.step.active.holds(touch.id));
            let wait = open.filter_map(|touch| {
                let (gap, rate) = (touch.kinematics.geometry.separation, touch.kinematics.separation_rate);
                (gap > 0.0 && rate < 0.0).then(|| gap / -rate).filter(|&wait| start + wait < end)
            });
            closing.extend(wait.reduce(f64::min).map(|wait| (wait, (a, b))));
        }
        closing.sort_by(|x, y| x.0.total_cmp(&y.0));
        for (wait, pair) in closing {
            let mut t = start + wait;
            while t > start && t < end {
                self.step.states_at(&self.core.model, t, self.states);
                if self.penetrates(pair) {
                    return Some((start, t));
                }
                t = start + 2.0 * (t - start);
            }
        }
        None
    }

    /// A time within an interval at which the contact that began to penetrate is found. At larger depths its point may
    /// have left its features, and nothing else shows where the penetration began.
    pub(super) fn contact_penetrating_within(&mut self, interval: (f64, f64)) -> Option<f64> {
        let closed_in = close_in(interval, |t| {
            self.step.states_at(&self.core.model, t, self.states);
            let penetration = self.first_penetration();
            Ok::<_, Infallible>(match penetration.contact {
                Some(_) => Side::Here,
                None if penetration.excess_depths > 1.0 => Side::After,
                None => Side::Before,
            })
        });
        closed_in.ok().and_then(|bracket| bracket.here)
    }
}
