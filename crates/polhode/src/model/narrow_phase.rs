//! The narrow phase with a memory of each pair. All contacts of two bodies are computed here, through
//! [`Model::manifold_of`](crate::model::Model::manifold_of).
//!
//! The memory of a pair tells which features need not be examined; answers have the same bits with it and without it.
//! It is a cache and no part of the state: a copy of the world has an empty one, and snapshots do not hold it.

use polhode_contact::{Manifold, PairMemory, Shape, Workspace, near_manifold_with};
use polhode_spatial::Pose;
use std::collections::BTreeMap;
use std::sync::{Mutex, PoisonError};

/// Largest number of pairs in the memory per body of the world. When it is exceeded, most pairs are no longer near, and
/// the whole memory is cleared.
const MOST_PAIRS_PER_BODY: usize = 32;

/// The narrow phase, with the memory of all pairs.
#[derive(Debug, Default)]
pub(crate) struct NarrowPhase {
    /// Whoever finds it in use computes without the memory: no thread waits for another one.
    remembered: Mutex<Remembered>,
}

#[derive(Debug, Default)]
struct Remembered {
    workspace: Workspace,
    pairs: BTreeMap<(usize, usize), PairMemory>,
    found: Manifold,
}

impl Clone for NarrowPhase {
    /// One with an empty memory.
    fn clone(&self) -> Self {
        Self::default()
    }
}

impl NarrowPhase {
    /// Clears the memory of all pairs of a body, whose shape has changed or been removed.
    pub(crate) fn forget(&mut self, body: usize) {
        self.remembered
            .get_mut()
            .unwrap_or_else(PoisonError::into_inner)
            .pairs
            .retain(|&(a, b), _| a != body && b != body);
    }

    /// Passes the manifold of a pair (contacts with a separation of at most `reach`, m, as
    /// [`polhode_contact::near_manifold`] gives them) to `read` and returns its result. `bodies` is the number of
    /// bodies of the world.
    pub(crate) fn read<T>(
        &self,
        pair: (usize, usize),
        (a, b): ((&Shape, &Pose), (&Shape, &Pose)),
        (reach, bodies): (f64, usize),
        read: impl FnOnce(&Manifold) -> T,
    ) -> T {
        // A nested call, from within `read`, computes without the memory.
        let (mut memory, mut none) = (self.remembered.try_lock(), Remembered::default());
        let Remembered { workspace, pairs, found } = memory.as_deref_mut().unwrap_or(&mut none);
        if pairs.len() > MOST_PAIRS_PER_BODY * bodies {
            pairs.clear();
        }
        let memory = pairs.entry(pair).or_default();
        near_manifold_with(workspace, memory, a, b, reach, found);
        read(found)
    }
}
