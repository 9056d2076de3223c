//! What changes at the contacts of an island where its active set ceases to be valid.

use crate::collision::turn::Turn;
use crate::identity::contact_id::ContactId;
use polhode_spatial::DVec3;
use std::collections::{BTreeMap, BTreeSet};

/// The end of the validity of an island's active set. At the instant itself the contacts that change cannot be
/// distinguished from the others: forces and slips pass through zero there.
#[derive(Debug, Clone, Default)]
pub(super) struct ContactChange {
    /// s.
    pub(super) t: f64,
    /// Contacts that break then: their forces reach zero.
    pub(super) departing: BTreeSet<ContactId>,
    /// Contacts whose slip vanishes then.
    pub(super) stopping: BTreeSet<ContactId>,
    /// Contacts whose slips turn and nearly vanish.
    pub(super) fading: BTreeSet<ContactId>,
    /// Contacts that can stick no longer, and the direction in which they begin to slide (unit vectors, world).
    pub(super) slipping: BTreeMap<ContactId, DVec3>,
    /// Rotations that vanish then.
    pub(super) settling: BTreeSet<(ContactId, Turn)>,
    /// Rotations that friction can hold no longer, and the direction in which they begin (unit vectors, world).
    pub(super) turning: BTreeMap<(ContactId, Turn), DVec3>,
    /// Joints whose bodies run off the ends of their tracks then.
    pub(super) running_off: BTreeSet<usize>,
    /// Joints that break then.
    pub(super) breaking: BTreeSet<usize>,
}

impl ContactChange {
    /// Adds the changes of another island at the same time.
    pub(super) fn include(&mut self, other: &Self) {
        self.departing.extend(other.departing.iter().copied());
        self.stopping.extend(other.stopping.iter().copied());
        self.fading.extend(other.fading.iter().copied());
        self.slipping.extend(other.slipping.iter().map(|(&id, &direction)| (id, direction)));
        self.settling.extend(other.settling.iter().copied());
        self.running_off.extend(&other.running_off);
        self.breaking.extend(&other.breaking);
        self.turning.extend(other.turning.iter().map(|(&turn, &direction)| (turn, direction)));
    }
}
