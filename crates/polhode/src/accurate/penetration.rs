//! Bodies held together that come to overlap elsewhere.
//!
//! A contact that is not held, has sunk in and closes says so by itself, as long as it stands on its features: that is for
//! some 1e-11 of the bodies' size where features end, as at the bend of a ridge. A trial is looked at some times only, and
//! by then the bodies may overlap so much more that no contact of theirs tells where they came in. The separation of the
//! pair does, which is that of its parts along all axes: an interval at whose end it is below those of all contacts
//! is bisected until the contact shows.
//!
//! Fails where bodies come to overlap and part again between two looks.

use super::constrained_step::ConstrainedStep;
use super::engine::Engine;
use crate::collision::contact_set::ContactId;
use crate::core::Core;
use crate::interaction::locator::{Side, close_in};
use polhode_contact::separation;
use polhode_dynamics::BodyState;
use std::collections::BTreeSet;
use std::convert::Infallible;

/// Depth at which a contact that is not held counts as penetrating, relative to size: a quarter of what a run is
/// judged by (1e-12).
const PENETRATION_RELATIVE: f64 = 2.5e-13;

/// Bodies that overlap by this many such depths more than any contact says have come in somewhere: by what a run is judged
/// by.
const DEEP: f64 = 4.0;

/// How far pairs that are held together overlap beside the contacts that hold them.
pub(super) struct Sunk {
    /// A contact that is not held, penetrates and closes.
    pub(super) contact: Option<ContactId>,
    /// Of pairs without such a contact: how much more the bodies overlap than any contact of theirs, held or parting, in units
    /// of the depth at which a contact counts as penetrating.
    depths: f64,
}

impl Sunk {
    /// Whether some pair has come to overlap where no contact shows it.
    pub(super) fn is_unseen(&self) -> bool {
        self.depths > DEEP
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
        step.held_pairs().into_iter().find_map(|pair| self.sunk_pair(core, step, pair, states, tolerated).contact)
    }

    /// How far the group's touching pairs overlap where no contact is held.
    pub(super) fn sunk(
        &self,
        core: &Core,
        step: &ConstrainedStep,
        states: &[BodyState],
        tolerated: &BTreeSet<ContactId>,
    ) -> Sunk {
        let mut all = Sunk { contact: None, depths: 0.0 };
        for pair in step.held_pairs() {
            let sunk = self.sunk_pair(core, step, pair, states, tolerated);
            all.contact = all.contact.or(sunk.contact);
            // A NaN compares as nothing, and is found where it comes from.
            all.depths = all.depths.max(sunk.depths);
        }
        all
    }

    /// As [`Self::sunk`], up to the first pair with a contact that says so: then nothing is said of what is unseen.
    pub(super) fn first_sunk(
        &self,
        core: &Core,
        step: &ConstrainedStep,
        states: &[BodyState],
        tolerated: &BTreeSet<ContactId>,
    ) -> Sunk {
        let mut all = Sunk { contact: None, depths: 0.0 };
        for pair in step.held_pairs() {
            let sunk = self.sunk_pair(core, step, pair, states, tolerated);
            if sunk.contact.is_some() {
                return sunk;
            }
            all.depths = all.depths.max(sunk.depths);
        }
        all
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
        self.sunk_pair(core, step, pair, states, tolerated).contact.is_some()
    }

    fn sunk_pair(
        &self,
        core: &Core,
        step: &ConstrainedStep,
        (a, b): (usize, usize),
        states: &[BodyState],
        tolerated: &BTreeSet<ContactId>,
    ) -> Sunk {
        let depth = PENETRATION_RELATIVE * core.world.pair_size(a, b) + core.world.rounding(states, a, b);
        // The same reach as everywhere, so that the same contacts are seen as when the event is resolved.
        let (separation, contacts) = core.world.pair(states, a, b, core.world.touch_distance(states, a, b));
        // What parts already needs no contact: it leaves by itself, unless it has come in since the step began.
        let came_in = || separation < -depth && !self.overlapped(core, (a, b), depth);
        let closing = contacts.iter().filter(|touch| {
            touch.kinematics.geometry.separation < -depth
                && (touch.kinematics.separation_rate < 0.0 || self.was_clear(core, touch.id, depth) || came_in())
        });
        let not_held = |id: &ContactId| step.held.binary_search(id).is_err() && !tolerated.contains(id);
        let contact = closing.map(|touch| touch.id).find(not_held);
        if contact.is_some() || separation >= -depth {
            return Sunk { contact, depths: 0.0 };
        }
        let held = step.held.iter().filter(|id| (id.a, id.b) == (a, b));
        let held = held.filter_map(|&id| Some(core.world.kinematics(states, id)?.geometry.separation));
        let found = contacts.iter().map(|touch| touch.kinematics.geometry.separation);
        Sunk { contact, depths: (held.chain(found).fold(0.0, f64::min) - separation) / depth }
    }

    /// Whether a contact was clear of its features at the start of the step.
    fn was_clear(&self, core: &Core, id: ContactId, depth: f64) -> bool {
        core.world.kinematics(&self.states, id).is_some_and(|k| k.geometry.separation > depth)
    }

    /// Whether two bodies overlapped at the start of the step. What has swung through another one since then is nearest to
    /// the way out on its far side, by features that were never clear.
    fn overlapped(&self, core: &Core, (a, b): (usize, usize), depth: f64) -> bool {
        core.world.shapes(a, b).is_some_and(|(shape_a, shape_b)| {
            separation(shape_a, &self.states[a].pose, shape_b, &self.states[b].pose) < -depth
        })
    }

    /// A time at which the contact shows through which the bodies have come to overlap within an interval: once they
    /// overlap deeply it may have left its features, and nothing else tells where they came in.
    pub(super) fn first_seen_sinking(
        &self,
        core: &Core,
        step: &ConstrainedStep,
        interval: (f64, f64),
        tolerated: &BTreeSet<ContactId>,
        states: &mut [BodyState],
    ) -> Option<f64> {
        let closed_in = close_in(interval, |t| {
            step.states_at(&core.world, t, states);
            let sunk = self.first_sunk(core, step, states, tolerated);
            Ok::<_, Infallible>(match sunk.contact {
                Some(_) => Side::Here,
                None if sunk.depths > 1.0 => Side::After,
                None => Side::Before,
            })
        });
        closed_in.ok().and_then(|bracket| bracket.here)
    }
}
