//! The narrow phase of the facade, with its memory: whoever needs contacts of two bodies asks here, by
//! [`World::manifold_of`](crate::world::World::manifold_of).
//!
//! What is remembered of a pair says which features need not be looked at; answers are the same, bit for bit, with it
//! and without. It is a cache and no part of the state: a copy of the world begins without, and snapshots do not hold
//! it.

use polhode_contact::{Manifold, PairMemory, Shape, Workspace, near_manifold_with};
use polhode_spatial::Pose;
use std::cell::RefCell;
use std::collections::BTreeMap;

/// Pairs that are remembered, at the most, for each body of the world; more are of the past, and all are forgotten.
const MOST_PAIRS_PER_BODY: usize = 32;

/// What is remembered of pairs of bodies.
#[derive(Debug, Default)]
pub(crate) struct NarrowPhase {
    remembered: RefCell<Remembered>,
}

#[derive(Debug, Default)]
struct Remembered {
    workspace: Workspace,
    pairs: BTreeMap<(usize, usize), PairMemory>,
    found: Manifold,
}

impl Clone for NarrowPhase {
    /// One that remembers nothing yet.
    fn clone(&self) -> Self {
        Self::default()
    }
}

impl NarrowPhase {
    /// Another shape stands for a body, or none.
    pub(crate) fn forget(&mut self, body: usize) {
        self.remembered.get_mut().pairs.retain(|&(a, b), _| a != body && b != body);
    }

    /// What `read` makes of the contacts of a pair with a separation of at most `reach` (m), as
    /// [`polhode_contact::near_manifold`] gives them, in a world of so many bodies.
    pub(crate) fn read<T>(
        &self,
        pair: (usize, usize),
        (a, b): ((&Shape, &Pose), (&Shape, &Pose)),
        (reach, bodies): (f64, usize),
        read: impl FnOnce(&Manifold) -> T,
    ) -> T {
        // Who asks again while he reads an answer is answered without the memory.
        let (mut memory, mut none) = (self.remembered.try_borrow_mut(), Remembered::default());
        let Remembered { workspace, pairs, found } = memory.as_deref_mut().unwrap_or(&mut none);
        if pairs.len() > MOST_PAIRS_PER_BODY * bodies {
            pairs.clear();
        }
        let memory = pairs.entry(pair).or_default();
        near_manifold_with(workspace, memory, a, b, reach, found);
        read(found)
    }
}
