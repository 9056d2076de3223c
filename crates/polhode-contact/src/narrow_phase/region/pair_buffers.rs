//! Buffers for a pair of shapes without parts, kept from call to call.

use crate::ContactFeature;
use crate::narrow_phase::axis::axis_search::AxisSearch;
use crate::narrow_phase::region::face_contacts::PlacedEdges;
use crate::narrow_phase::region::placed_face::FacePairBuffers;

/// Buffers for the search for the separating axes and the contacts of a pair.
#[derive(Debug, Clone, Default)]
pub(crate) struct PairBuffers {
    pub(crate) search: AxisSearch,
    pub(crate) face_pair: FacePairBuffers,
    pub(crate) features: Vec<ContactFeature>,
    pub(crate) placed_edges: PlacedEdges,
}
