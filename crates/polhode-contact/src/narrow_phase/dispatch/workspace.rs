//! Buffers of the narrow phase, kept from call to call.

use crate::narrow_phase::parts::compound_pair::CompoundBuffers;
use crate::narrow_phase::region::pair_buffers::PairBuffers;

/// Buffers that a caller may keep from call to call, so that the narrow phase allocates nothing but its results.
#[derive(Debug, Clone, Default)]
pub struct Workspace {
    pub(crate) parts: CompoundBuffers,
}

impl Workspace {
    /// The buffers for two shapes without parts.
    pub(crate) const fn pair(&mut self) -> &mut PairBuffers {
        &mut self.parts.mesh.pair
    }
}
