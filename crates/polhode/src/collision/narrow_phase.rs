//! The narrow phase of the facade, with its memory: whoever needs contacts or the separation of two bodies asks here.
//!
//! What is remembered of a pair says which features need not be looked at; answers are the same, bit for bit, with it and
//! without. It is a cache and no part of the state: a copy of the world begins without, and snapshots do not hold it.

use crate::world::World;
use polhode_contact::{Manifold, PairMemory, Workspace, near_manifold_with, separation};
use polhode_dynamics::BodyState;
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
}

impl World {
    /// What `read` makes of the contacts of two bodies with a separation of at most `reach` (m), as
    /// [`polhode_contact::near_manifold`] gives them; none for a body without a shape.
    pub(crate) fn manifold_of<T>(
        &self,
        states: &[BodyState],
        (a, b): (usize, usize),
        reach: f64,
        read: impl FnOnce(&Manifold) -> T,
    ) -> Option<T> {
        let (shape_a, shape_b) = self.shapes(a, b)?;
        // Who asks again while he reads an answer is answered without the memory.
        let (mut memory, mut none) = (self.narrow_phase.remembered.try_borrow_mut(), Remembered::default());
        let Remembered { workspace, pairs, found } = memory.as_deref_mut().unwrap_or(&mut none);
        if pairs.len() > MOST_PAIRS_PER_BODY * self.bodies.len() {
            pairs.clear();
        }
        let memory = pairs.entry((a, b)).or_default();
        let (pose_a, pose_b) = (&states[a].pose, &states[b].pose);
        near_manifold_with(workspace, memory, (shape_a, pose_a), (shape_b, pose_b), reach, found);
        Some(read(found))
    }

    /// The signed separation of two bodies, m, found afresh and at any distance: what a pair is judged by when it is placed,
    /// by a scene or a program, or looked at where a step began, far from the poses that the memory is of. None for a body
    /// without a shape.
    pub(crate) fn separation_afresh(&self, states: &[BodyState], a: usize, b: usize) -> Option<f64> {
        let (shape_a, shape_b) = self.shapes(a, b)?;
        Some(separation(shape_a, &states[a].pose, shape_b, &states[b].pose))
    }
}
