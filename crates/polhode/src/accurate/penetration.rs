//! Bodies held together that come to overlap elsewhere.
//!
//! A contact that is not held, penetrates and closes shows by itself as long as it stands on its features: that is for
//! some 1e-11 of the bodies' size where features end, as at the bend of a ridge. A trial is checked at a few times only, and
//! by then the bodies may overlap so much more that none of their contacts shows where the penetration began. The separation
//! of the pair does, which is that of its parts along all axes: an interval at whose end it is below those of all contacts
//! is bisected until the contact shows.
//!
//! Fails where bodies come to overlap and part again between two checks.

use super::constrained_step::ConstrainedStep;
use super::engine::Engine;
use crate::collision::contact_set::ContactId;
use crate::core::Core;
use crate::interaction::locator::{Side, close_in};
use polhode_dynamics::BodyState;
use std::collections::BTreeSet;
use std::convert::Infallible;

/// Depth at which a contact that is not held counts as penetrating, relative to size: a quarter of what a run is
/// judged by (1e-12).
pub(super) const PENETRATION_RELATIVE: f64 = 2.5e-13;

/// Bodies that overlap by this many such depths more than any of their contacts penetrate somewhere else: three quarters of
/// what a run is judged by.
const DEEP: f64 = 3.0;

/// How far a pair that is held together penetrates beside the contacts that hold it.
pub(super) struct Penetration {
    /// A contact that is not held, penetrates and closes.
    pub(super) contact: Option<ContactId>,
    /// Without such a contact: how much more the bodies overlap than any of their contacts, held or parting, in units of the
    /// depth at which a contact counts as penetrating.
    excess_depths: f64,
}

impl Penetration {
    /// Whether the pair overlaps where no contact shows it.
    pub(super) fn is_unseen(&self) -> bool {
        self.excess_depths > DEEP
    }
}

impl Engine {
    /// A contact of the group's touching pairs that is not held, penetrates and closes.
    pub(super) fn penetrating(
        &self,
        core: &Core,
        step: &ConstrainedStep,
        states: &[BodyState],
        tolerated: &BTreeSet<ContactId>,
    ) -> Option<ContactId> {
        self.penetrations(core, step, states, tolerated).find_map(|penetration| penetration.contact)
    }

    /// Whether some pair of the group overlaps where no contact shows it.
    pub(super) fn penetrates_unseen(
        &self,
        core: &Core,
        step: &ConstrainedStep,
        states: &[BodyState],
        tolerated: &BTreeSet<ContactId>,
    ) -> bool {
        self.penetrations(core, step, states, tolerated).any(|penetration| penetration.is_unseen())
    }

    /// The penetration of the first pair of the group with a penetrating contact; without one, that of the pair that overlaps
    /// most where no contact shows it.
    pub(super) fn first_penetration(
        &self,
        core: &Core,
        step: &ConstrainedStep,
        states: &[BodyState],
        tolerated: &BTreeSet<ContactId>,
    ) -> Penetration {
        let mut excess_depths = 0.0_f64;
        for penetration in self.penetrations(core, step, states, tolerated) {
            if penetration.contact.is_some() {
                return penetration;
            }
            // A NaN compares as nothing, and is found where it comes from.
            excess_depths = excess_depths.max(penetration.excess_depths);
        }
        Penetration { contact: None, excess_depths }
    }

    /// Whether a contact of one pair that is not held penetrates and closes.
    pub(super) fn penetrates(
        &self,
        core: &Core,
        step: &ConstrainedStep,
        pair: (usize, usize),
        states: &[BodyState],
        tolerated: &BTreeSet<ContactId>,
    ) -> bool {
        self.penetration_of_pair(core, step, pair, states, tolerated).contact.is_some()
    }

    /// The penetrations of the group's touching pairs, in their order.
    fn penetrations<'a>(
        &'a self,
        core: &'a Core,
        step: &'a ConstrainedStep,
        states: &'a [BodyState],
        tolerated: &'a BTreeSet<ContactId>,
    ) -> impl Iterator<Item = Penetration> + 'a {
        let of_pair = move |pair| self.penetration_of_pair(core, step, pair, states, tolerated);
        step.held_pairs().into_iter().map(of_pair)
    }

    fn penetration_of_pair(
        &self,
        core: &Core,
        step: &ConstrainedStep,
        (a, b): (usize, usize),
        states: &[BodyState],
        tolerated: &BTreeSet<ContactId>,
    ) -> Penetration {
        let depth = PENETRATION_RELATIVE * core.world.pair_size(a, b) + core.world.rounding(states, a, b);
        // The same reach as everywhere, so that the same contacts are seen as when the event is resolved.
        let (separation, contacts) = core.world.pair(states, a, b, core.world.touch_distance(states, a, b));
        // What parts already needs no contact: it leaves by itself, unless it has begun to penetrate since the step began.
        let began_in_step = || separation < -depth && !self.overlapped(core, (a, b), depth);
        let closing = contacts.iter().filter(|touch| {
            touch.kinematics.geometry.separation < -depth
                && (touch.kinematics.separation_rate < 0.0 || self.was_clear(core, touch.id, depth) || began_in_step())
        });
        let not_held = |id: &ContactId| step.held.binary_search(id).is_err() && !tolerated.contains(id);
        let contact = closing.map(|touch| touch.id).find(not_held);
        if contact.is_some() || separation >= -depth {
            return Penetration { contact, excess_depths: 0.0 };
        }
        let held = step.held.iter().filter(|id| (id.a, id.b) == (a, b));
        let held = held.filter_map(|&id| Some(core.world.kinematics(states, id)?.geometry.separation));
        let found = contacts.iter().map(|touch| touch.kinematics.geometry.separation);
        let shown = held.chain(found).fold(0.0, f64::min);
        Penetration { contact, excess_depths: (shown - separation) / depth }
    }

    /// Whether a contact was clear of its features at the start of the step.
    fn was_clear(&self, core: &Core, id: ContactId, depth: f64) -> bool {
        core.world.kinematics(&self.states, id).is_some_and(|k| k.geometry.separation > depth)
    }

    /// Whether two bodies overlapped at the start of the step. What has swung through another one since then is nearest to
    /// the way out on its far side, by features that were never clear.
    fn overlapped(&self, core: &Core, (a, b): (usize, usize), depth: f64) -> bool {
        core.world.separation_afresh(&self.states, a, b).is_some_and(|separation| separation < -depth)
    }

    /// An interval from `start` at whose end a contact penetrates that approaches at `start` and would close before `end` (s):
    /// where it parts again before anybody looks, the penetration would not be seen. Its looks are at the time at which it
    /// would close, and at that twice, four times, eight times as late.
    pub(super) fn interval_of_approach(
        &self,
        core: &Core,
        step: &ConstrainedStep,
        (start, end): (f64, f64),
        tolerated: &BTreeSet<ContactId>,
        states: &mut [BodyState],
    ) -> Option<(f64, f64)> {
        step.states_at(&core.world, start, states);
        let mut closing = Vec::new();
        for (a, b) in step.held_pairs() {
            let way = (self.speed(core, a) + self.speed(core, b)) * (end - start);
            let (_, contacts) = core.world.pair(states, a, b, way + core.world.touch_distance(states, a, b));
            let free = contacts.iter().filter(|touch| step.held.binary_search(&touch.id).is_err());
            let wait = free.filter_map(|touch| {
                let (gap, rate) = (touch.kinematics.geometry.separation, touch.kinematics.separation_rate);
                (gap > 0.0 && rate < 0.0).then(|| gap / -rate).filter(|&wait| start + wait < end)
            });
            closing.extend(wait.reduce(f64::min).map(|wait| (wait, (a, b))));
        }
        closing.sort_by(|x, y| x.0.total_cmp(&y.0));
        for (wait, pair) in closing {
            let mut t = start + wait;
            while t > start && t < end {
                step.states_at(&core.world, t, states);
                if self.penetrates(core, step, pair, states, tolerated) {
                    return Some((start, t));
                }
                t = start + 2.0 * (t - start);
            }
        }
        None
    }

    /// A time at which the contact shows through which the bodies have come to overlap within an interval: once they
    /// overlap deeply it may have left its features, and nothing else tells where the penetration began.
    pub(super) fn penetration_shown_within(
        &self,
        core: &Core,
        step: &ConstrainedStep,
        interval: (f64, f64),
        tolerated: &BTreeSet<ContactId>,
        states: &mut [BodyState],
    ) -> Option<f64> {
        let closed_in = close_in(interval, |t| {
            step.states_at(&core.world, t, states);
            let penetration = self.first_penetration(core, step, states, tolerated);
            Ok::<_, Infallible>(match penetration.contact {
                Some(_) => Side::Here,
                None if penetration.excess_depths > 1.0 => Side::After,
                None => Side::Before,
            })
        });
        closed_in.ok().and_then(|bracket| bracket.here)
    }
}
