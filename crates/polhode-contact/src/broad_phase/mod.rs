//! Broad phase: which pairs of bounding boxes overlap.

use crate::Aabb;
use crate::backend::AabbTree;
use thiserror::Error;

/// Boxes that reach farther than this (m) are kept out of the tree, whose cost function squares and multiplies
/// lengths, and are compared with every box.
const FARTHEST: f64 = 1e60;

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
pub trait BroadPhase {
    /// All pairs `(i, j)`, `i < j`, of boxes that share a point, sorted, each once.
    ///
    /// # Errors
    /// When there are more boxes than indices.
    fn pairs(&mut self, boxes: &[Aabb]) -> Result<Vec<(u32, u32)>, BroadPhaseError>;
}

/// A bounding-volume hierarchy that is refitted from call to call. The pairs depend on the boxes alone, not on the
/// tree's history: every candidate is tested against the boxes themselves and the result is sorted.
#[derive(Default, Clone)]
pub struct Bvh {
    tree: AabbTree,
    bounded: Vec<Aabb>,
    /// Index of each bounded box among all.
    index: Vec<u32>,
    unbounded: Vec<u32>,
}

impl std::fmt::Debug for Bvh {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Bvh")
            .field("bounded", &self.bounded.len())
            .field("unbounded", &self.unbounded.len())
            .finish_non_exhaustive()
    }
}

impl BroadPhase for Bvh {
    fn pairs(&mut self, boxes: &[Aabb]) -> Result<Vec<(u32, u32)>, BroadPhaseError> {
        if u32::try_from(boxes.len()).is_err() {
            return Err(BroadPhaseError::TooManyBoxes { count: boxes.len(), limit: u32::MAX as usize });
        }
        self.bounded.clear();
        self.index.clear();
        self.unbounded.clear();
        for (i, aabb) in boxes.iter().enumerate() {
            if aabb.min().abs().max(aabb.max().abs()).max_element() <= FARTHEST {
                self.bounded.push(*aabb);
                self.index.push(i as u32);
            } else {
                self.unbounded.push(i as u32);
            }
        }
        let mut pairs = Vec::new();
        for (k, &i) in self.unbounded.iter().enumerate() {
            let others = self.index.iter().chain(&self.unbounded[k + 1..]);
            pairs.extend(others.filter(|&&j| boxes[i as usize].overlaps(&boxes[j as usize])).map(|&j| ordered(i, j)));
        }
        if self.bounded.len() > 1 {
            self.tree.set(&self.bounded);
            let (bounded, index) = (&self.bounded, &self.index);
            self.tree.overlaps(&mut |i, j| {
                if bounded[i as usize].overlaps(&bounded[j as usize]) {
                    pairs.push(ordered(index[i as usize], index[j as usize]));
                }
            });
        }
        pairs.sort_unstable();
        Ok(pairs)
    }
}

fn ordered(i: u32, j: u32) -> (u32, u32) {
    if i < j { (i, j) } else { (j, i) }
}
