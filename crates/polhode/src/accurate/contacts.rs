//! The touching contacts at their last evaluation, by pair.

use crate::collision::touch::{Hold, Touch};
use std::collections::{BTreeMap, BTreeSet};

/// Contacts by pair, sorted by identity.
#[derive(Debug, Clone)]
pub(super) struct Contacts {
    by_pair: BTreeMap<(usize, usize), Vec<Touch>>,
    /// Bodies that each body has contacts with.
    partners: Vec<BTreeSet<usize>>,
}

impl Contacts {
    /// No contacts yet, of this many bodies.
    pub(super) fn new(bodies: usize) -> Self {
        Self { by_pair: BTreeMap::new(), partners: vec![BTreeSet::new(); bodies] }
    }

    /// One body more.
    pub(super) fn make_room(&mut self) {
        self.partners.push(BTreeSet::new());
    }

    /// Replaces the contacts of a pair.
    pub(super) fn set(&mut self, pair: (usize, usize), contacts: Vec<Touch>) {
        let (a, b) = pair;
        if contacts.is_empty() {
            self.by_pair.remove(&pair);
            self.partners[a].remove(&b);
            self.partners[b].remove(&a);
        } else {
            self.by_pair.insert(pair, contacts);
            self.partners[a].insert(b);
            self.partners[b].insert(a);
        }
    }

    /// Contacts of a pair.
    pub(super) fn of_pair(&self, pair: (usize, usize)) -> &[Touch] {
        self.by_pair.get(&pair).map_or(&[], Vec::as_slice)
    }

    /// Whether a contact holds a pair together.
    pub(super) fn are_held(&self, pair: (usize, usize)) -> bool {
        self.of_pair(pair).iter().any(|touch| touch.hold == Hold::Held)
    }

    /// Bodies that a body has contacts with, ascending.
    pub(super) fn partners(&self, body: usize) -> impl Iterator<Item = usize> + '_ {
        self.partners[body].iter().copied()
    }

    /// All contacts.
    pub(super) fn all(&self) -> impl Iterator<Item = &Touch> {
        self.by_pair.values().flatten()
    }

    /// Number of pairs.
    pub(super) fn pairs(&self) -> usize {
        self.by_pair.len()
    }
}
