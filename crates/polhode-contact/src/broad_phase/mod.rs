//! Broad phase: which pairs of bounding boxes share a point.
//!
//! | module | method, or what methods share |
//! |---|---|
//! | `bvh` | hierarchy of bounding boxes, refitted only when some box has moved far (default) |
//! | `voxel_grid` | uniform cells in a hash table |
//! | `octree` | space halved along three axes at once |
//! | `kd_tree` | space halved along one axis, at the median |
//! | `binary_space_partition` | space halved by planes in any direction |
//! | `sweep_and_prune` | intervals on one axis, kept in order from call to call |
//! | `all_pairs` | `none` in scenes: every box against every other |
//! | `partition` | what the three partitions of space share |
//! | `pair_collector` | the sorting of pairs |
//! | `far_boxes` | boxes whose coordinates would overflow, apart from the others |
//! | `candidates` | pairs of boxes that have hardly moved |
//! | `method` | the broad phases by name |
//!
//! All give the same pairs in the same order, whatever the earlier calls were, so that the methods differ in time
//! alone. Boxes may be infinite, of any sizes, flat, or coincident. After the first calls no method allocates, unless
//! there are more boxes, or pairs that overlap or nearly do, than ever before.

mod all_pairs;
mod binary_space_partition;
mod bvh;
mod candidates;
mod far_boxes;
mod kd_tree;
mod method;
mod octree;
mod pair_collector;
mod partition;
mod sweep_and_prune;
mod voxel_grid;

pub use all_pairs::AllPairs;
pub use bvh::Bvh;
pub use method::{BroadPhaseMethod, UnknownBroadPhase};

use crate::Aabb;
use thiserror::Error;

/// Why pairs cannot be found.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Error)]
pub enum BroadPhaseError {
    /// More boxes than indices.
    #[error("{count} boxes are given, at most {limit} are possible")]
    TooManyBoxes {
        /// How many were given.
        count: usize,
        /// How many are possible.
        limit: usize,
    },
}

/// A way to find the pairs of boxes that overlap.
pub trait BroadPhase: std::fmt::Debug + Send {
    /// Replaces the content of `pairs` by all pairs `(i, j)`, `i < j`, of boxes that share a point, sorted, each once.
    /// The memory of the buffer is reused.
    ///
    /// # Errors
    /// When there are more boxes than indices; `pairs` is then empty.
    fn pairs(&mut self, boxes: &[Aabb], pairs: &mut Vec<(u32, u32)>) -> Result<(), BroadPhaseError>;
}

/// Empties the result, and fails when there are more boxes than a `u32` can number.
fn begin(boxes: &[Aabb], pairs: &mut Vec<(u32, u32)>) -> Result<(), BroadPhaseError> {
    pairs.clear();
    match u32::try_from(boxes.len()) {
        Ok(_) => Ok(()),
        Err(_) => Err(BroadPhaseError::TooManyBoxes { count: boxes.len(), limit: u32::MAX as usize }),
    }
}
