//! Which contacts two faces that lie on each other have, kept for poses nearby.
//!
//! `face_pair.rs` chooses them by signed distances of the corners of each face from the sides of the other, and by their
//! heights above it. A pose at which no corner has moved by as much as the least of these distances and heights has the same
//! contacts ([`Drift`] says how far corners move): the list is taken over as it is, and every contact measured anew.

use crate::narrow_phase::axis::drift::Drift;
use crate::narrow_phase::region::face_pair;
use crate::narrow_phase::region::pair_buffers::PairBuffers;
use crate::shape::polyhedron::ConvexPolyhedron;
use crate::{ContactFeature, Side};

/// The contacts of a pair of faces.
#[derive(Debug, Clone, Default)]
pub(crate) struct KeptRegion {
    /// A face of A and one of B, and the reach, m; nothing when the choice is too narrow to hold at other poses.
    chosen: Option<((u32, u32), f64)>,
    drift: Drift,
    /// How much heights above the sides and planes of A and of B may change, m.
    clearances: [f64; 2],
    features: Vec<ContactFeature>,
}

impl KeptRegion {
    /// Forgets everything but the buffers.
    pub(crate) fn forget(&mut self) {
        self.chosen = None;
    }

    /// The features that [`face_pair::collect`] finds, sorted, instead of those that the buffers held. B must have been
    /// placed.
    pub(crate) fn collect(
        &mut self,
        buffers: &mut PairBuffers,
        a: &ConvexPolyhedron,
        b: &ConvexPolyhedron,
        pair: (u32, u32),
        (tolerance, reach): (f64, f64),
        upper: Side,
    ) {
        let changes = self.drift.changes(&buffers.search.x_ab);
        if self.chosen == Some((pair, reach)) && (0..2).all(|k| changes[k] < self.clearances[k]) {
            buffers.features.clone_from(&self.features);
            return;
        }
        buffers.features.clear();
        face_pair::collect(buffers, a, b, pair, (tolerance, reach), upper);
        buffers.features.sort_unstable();
        self.clearances = buffers.face_pair.clearances;
        self.chosen = self.clearances.into_iter().all(|clearance| clearance > 0.0).then_some((pair, reach));
        if self.chosen.is_some() {
            self.drift = Drift::since(a, b, &buffers.search.x_ab);
            self.features.clone_from(&buffers.features);
        }
    }
}
