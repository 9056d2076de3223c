//! Removal of duplicate contacts: one contact for each place and normal.
//!
//! Several parts may have a contact at the same place. The one that is within its features is preferred to one beyond
//! their border, which the next part has there. Otherwise the order of preference depends only on the features of the
//! bodies, not on which body is called A: a vertex-face contact first, then one on a face, then one on an edge; then
//! the higher face, vertex and edge number, then the feature of the upper body.

use crate::narrow_phase::region::upward::is_upward;
use crate::{Contact, ContactFeature, Side, SurfaceFeature};
use polhode_spatial::unit_vector::SAME_DIRECTION;
use std::cmp::Ordering;

/// Contacts of different parts, and a contact and a feature of a part, are at the same place when they are nearer than
/// this many place tolerances. Each of the two may deviate from the exact place by some tolerances: this limit is wider
/// than that within one pair of parts (`region/same_place.rs`).
pub(crate) const SAME_PLACE_OF_PARTS: f64 = 8.0;

/// Buffers of [`SamePlaces::keep_one_each`].
#[derive(Debug, Clone, Default)]
pub(crate) struct SamePlaces {
    order: Vec<usize>,
    dropped: Vec<bool>,
}

impl SamePlaces {
    /// Keeps one contact for each place and normal, in the order of features.
    pub(crate) fn keep_one_each(&mut self, contacts: &mut Vec<Contact>, tolerance: f64) {
        let Self { order, dropped } = self;
        contacts.sort_unstable_by_key(|contact| contact.feature);
        contacts.dedup_by_key(|contact| contact.feature);
        order.clear();
        order.extend(0..contacts.len());
        order.sort_unstable_by(|&i, &j| {
            contacts[i].geometry.point.x.total_cmp(&contacts[j].geometry.point.x).then(i.cmp(&j))
        });
        dropped.clear();
        dropped.resize(contacts.len(), false);
        for (k, &i) in order.iter().enumerate() {
            let first = contacts[i];
            for &j in &order[k + 1..] {
                let second = contacts[j];
                if second.geometry.point.x - first.geometry.point.x > tolerance {
                    break;
                }
                let alike = (first.geometry.normal - second.geometry.normal).length() <= SAME_DIRECTION;
                if alike
                    && !dropped[i]
                    && !dropped[j]
                    && first.geometry.point.distance(second.geometry.point) <= tolerance
                {
                    dropped[if is_preferred(&first, &second, tolerance) { j } else { i }] = true;
                }
            }
        }
        let mut index = 0;
        contacts.retain(|_| {
            index += 1;
            !dropped[index - 1]
        });
    }
}

/// A face is preferred to an edge, and an edge to other features: at the border of a part the next part continues the
/// face.
const fn rank_of(feature: SurfaceFeature) -> u32 {
    match feature {
        SurfaceFeature::Face(_) => 2,
        SurfaceFeature::Edge(_) => 1,
        _ => 0,
    }
}

/// Whether the first of two contacts at the same place is kept; margins are known to `tolerance` (m).
fn is_preferred(first: &Contact, second: &Contact, tolerance: f64) -> bool {
    let is_within = |contact: &Contact| contact.geometry.margin >= -tolerance;
    if is_within(first) != is_within(second) {
        return is_within(first);
    }
    let upper = |contact: &Contact| if is_upward(contact.geometry.normal) { Side::A } else { Side::B };
    let rank = |contact: &Contact| match contact.feature {
        ContactFeature::VertexFace { vertex_of, vertex, face } => (3, face, vertex, vertex_of == upper(contact)),
        ContactFeature::Smooth { center_of, center, against } => {
            let number = match against {
                SurfaceFeature::Face(number) | SurfaceFeature::Edge(number) | SurfaceFeature::Vertex(number) => number,
                _ => 0,
            };
            (rank_of(against), number, center, center_of == upper(contact))
        }
        ContactFeature::EdgeEdge { edge_a, edge_b }
        | ContactFeature::Spheres { center_a: edge_a, center_b: edge_b } => {
            let turned = upper(contact) == Side::A;
            (0, edge_a.max(edge_b), edge_a.min(edge_b), (edge_a > edge_b) == turned)
        }
        ContactFeature::SphereSphere => (0, 0, 0, true),
        ContactFeature::Elements { a, b } => {
            let kind = rank_of(a).max(rank_of(b));
            let (a, b) = (a.number(), b.number());
            (kind, a.max(b), a.min(b), (a > b) == (upper(contact) == Side::A))
        }
    };
    rank(first).cmp(&rank(second)) != Ordering::Less
}
