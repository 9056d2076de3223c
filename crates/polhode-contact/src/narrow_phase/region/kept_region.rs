//! The list of contact features of two faces that lie on each other, kept for nearby poses.
//!
//! `face_pair.rs` chooses the features by the signed distances of the corners of each face from the sides of the other,
//! and by their heights above it. As long as no corner has moved by as much as the least of these distances and heights
//! ([`Drift`] bounds the motion of corners), the features are the same: the list is reused, and the geometry of every
//! contact is evaluated at the new pose.

use crate::narrow_phase::axis::drift::Drift;
use crate::narrow_phase::region::face_pair;
use crate::narrow_phase::region::pair_buffers::PairBuffers;
use crate::shape::polyhedron::ConvexPolyhedron;
use crate::{ContactFeature, Side};

/// The contact features of a pair of faces.
#[derive(Debug, Clone, Default)]
pub(crate) struct KeptRegion {
    /// A face of A and one of B, and the reach, m; none when some distance is zero within the tolerance, so that the
    /// list holds at no other pose.
    chosen: Option<((u32, u32), f64)>,
    drift: Drift,
    /// By how much the distances from the sides and planes of A's face and of B's may change, m.
    clearances: [f64; 2],
    features: Vec<ContactFeature>,
}

impl KeptRegion {
    /// Resets the memory; the buffers stay allocated.
    pub(crate) fn forget(&mut self) {
        self.chosen = None;
    }

    /// Replaces the features of the buffers by those that [`face_pair::collect`] finds, sorted. B must have been
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
