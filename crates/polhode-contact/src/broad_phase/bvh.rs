//! A hierarchy of bounding boxes, parry3d's, refitted from call to call.
//!
//! A binary tree whose leaves are the boxes and whose inner nodes bound their children; it is traversed against itself,
//! and a pair of nodes that do not overlap is not followed further. At each call the leaves are moved, a part of the
//! tree is rebuilt by the surface-area heuristic, and inner nodes are refitted to their children (as rapier3d does).
//! The tree is rebuilt when the number of boxes changes. While no box moves far, the tree is not used at all
//! (`candidates.rs`).

use super::candidates::Candidates;
use super::far_boxes::{self, FarBoxes};
use super::pair_collector::{PairCollector, PairSearch, Sorted};
use super::{AllPairs, BroadPhase, BroadPhaseError, begin};
use crate::Aabb;
use crate::backend::AabbTree;

/// Up to this many boxes are compared with each other without a tree: at most 496 comparisons.
const FEW: usize = 32;

/// A bounding-volume hierarchy. The pairs depend on the boxes alone, not on the tree's history: leaves are the boxes
/// themselves, and the result is sorted.
#[derive(Debug, Default, Clone)]
pub struct Bvh {
    candidates: Candidates,
    search: Sorted<TreeSearch>,
}

/// The tree, and the far boxes that are not in it.
#[derive(Debug, Default, Clone)]
struct TreeSearch {
    tree: AabbTree,
    boxes: FarBoxes,
}

impl BroadPhase for Bvh {
    fn pairs(&mut self, boxes: &[Aabb], pairs: &mut Vec<(u32, u32)>) -> Result<(), BroadPhaseError> {
        begin(boxes, pairs)?;
        if boxes.len() <= FEW {
            return AllPairs.pairs(boxes, pairs);
        }
        if !self.candidates.hold(boxes) {
            if !self.candidates.grow(boxes) {
                return self.search.pairs(boxes, pairs);
            }
            self.search.pairs(&self.candidates.grown, &mut self.candidates.pairs)?;
        }
        self.candidates.overlapping(boxes, pairs);
        Ok(())
    }
}

impl PairSearch for TreeSearch {
    fn search(&mut self, boxes: &[Aabb], found: &mut PairCollector) {
        if far_boxes::are_near(boxes) {
            self.tree.set(boxes);
            self.tree.overlaps(&mut |i, j| found.push(i, j));
            return;
        }
        self.boxes.set(boxes);
        self.boxes.pairs(boxes, found);
        if self.boxes.near.len() > 1 {
            let index = &self.boxes.index;
            self.tree.set(&self.boxes.near);
            self.tree.overlaps(&mut |i, j| found.push(index[i as usize], index[j as usize]));
        }
    }
}
