//! Boxes that are infinite or so far away that arithmetic on them would overflow, separated from the others.

use super::pair_collector::PairCollector;
use crate::Aabb;

/// Boxes with a coordinate beyond this (m) are compared with every other box: tree costs multiply three lengths and
/// plane distances add three products, and neither may overflow.
const FARTHEST: f64 = 1e60;

/// Whether all boxes are within [`FARTHEST`].
pub(crate) fn are_near(boxes: &[Aabb]) -> bool {
    boxes.iter().all(is_near)
}

fn is_near(aabb: &Aabb) -> bool {
    aabb.min().min_element() >= -FARTHEST && aabb.max().max_element() <= FARTHEST
}

/// All boxes of a call in two groups.
#[derive(Debug, Clone, Default)]
pub(crate) struct FarBoxes {
    /// Boxes whose coordinates are safe to compute with.
    pub(crate) near: Vec<Aabb>,
    /// Number of each of them among all boxes.
    pub(crate) index: Vec<u32>,
    far: Vec<u32>,
}

impl FarBoxes {
    /// Sorts the boxes into the two groups.
    pub(crate) fn set(&mut self, boxes: &[Aabb]) {
        self.near.clear();
        self.index.clear();
        self.far.clear();
        for (i, aabb) in boxes.iter().enumerate() {
            if is_near(aabb) {
                self.near.push(*aabb);
                self.index.push(i as u32);
            } else {
                self.far.push(i as u32);
            }
        }
    }

    /// Adds the overlapping pairs of which at least one box is far.
    pub(crate) fn pairs(&self, boxes: &[Aabb], pairs: &mut PairCollector) {
        for (k, &i) in self.far.iter().enumerate() {
            let others = self.index.iter().chain(&self.far[k + 1..]);
            for &j in others.filter(|&&j| boxes[i as usize].overlaps(&boxes[j as usize])) {
                pairs.push(i, j);
            }
        }
    }
}
