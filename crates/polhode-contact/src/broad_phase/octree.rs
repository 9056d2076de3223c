//! Octree: space is halved across all three axes at once.
//!
//! The planes go through the middle of the boxes' middles (docs/REFERENCES.md, Meagher 1982), so that empty space costs no
//! levels, however far an outlier lies. An axis along which the middles spread little is left whole, as the cubic cells
//! of the textbook would pass a layer of boxes on one side. Libraries of octrees keep points, or boxes of integers.

use super::far_boxes::FarBoxes;
use super::pair_collector::PairCollector;
use super::partition::{AxisCell, LEAF_BOXES, MOST_LEVELS, compare_all, is_worthwhile, middles};
use super::{BroadPhase, BroadPhaseError, begin};
use crate::Aabb;
use glam::DVec3;

/// Axes along which the middles spread less than this share of the largest spread are not split.
const SPLIT_SPREAD: f64 = 0.25;

/// An octree.
#[derive(Debug, Clone, Default)]
pub struct Octree {
    boxes: FarBoxes,
    /// Boxes of the cells from the root to the present one, one cell after the other.
    members: Vec<u32>,
    found: PairCollector,
}

impl BroadPhase for Octree {
    fn pairs(&mut self, boxes: &[Aabb], pairs: &mut Vec<(u32, u32)>) -> Result<(), BroadPhaseError> {
        begin(boxes, pairs)?;
        self.boxes.set(boxes);
        self.found.clear();
        self.boxes.pairs(boxes, &mut self.found);
        self.members.clear();
        self.members.extend(0..self.boxes.near.len() as u32);
        self.visit(0, AxisCell::ALL, 0);
        self.found.sort_into(boxes.len(), pairs);
        Ok(())
    }
}

impl Octree {
    /// Finds the pairs of a cell, whose boxes are the members from `start` on.
    fn visit(&mut self, start: usize, cell: AxisCell, level: u32) {
        let end = self.members.len();
        let center = if end - start > LEAF_BOXES && level < MOST_LEVELS { self.center(start) } else { None };
        let Some(center) = center else {
            let boxes = (&self.boxes.near[..], &self.boxes.index[..]);
            compare_all(boxes, &self.members[start..], |point| cell.contains(point), &mut self.found);
            return;
        };
        for octant in 0..8 {
            let mut part = cell;
            for axis in 0..3 {
                if octant >> axis & 1 == 0 { part.high[axis] = center[axis] } else { part.low[axis] = center[axis] }
            }
            for member in start..end {
                if reaches(&self.boxes.near[self.members[member] as usize], center, octant) {
                    self.members.push(self.members[member]);
                }
            }
            if self.members.len() > end + 1 {
                self.visit(end, part, level + 1);
            }
            self.members.truncate(end);
        }
    }

    /// Where the planes that split the members from `start` on meet; none when the split is not worth it.
    fn center(&self, start: usize) -> Option<DVec3> {
        let (members, near) = (&self.members[start..], &self.boxes.near);
        let (low, high) = middles(near, members);
        let spread = high - low;
        let mut center = 0.5 * low + 0.5 * high;
        for axis in 0..3 {
            if spread[axis] < SPLIT_SPREAD * spread.max_element() {
                center[axis] = f64::INFINITY;
            }
        }
        let counts: [usize; 8] = std::array::from_fn(|octant| {
            members.iter().filter(|&&member| reaches(&near[member as usize], center, octant)).count()
        });
        is_worthwhile(members.len(), &counts).then_some(center)
    }
}

/// Whether a box reaches into an octant about a centre; bit k of the octant is set on the upper side of axis k.
fn reaches(aabb: &Aabb, center: DVec3, octant: usize) -> bool {
    (0..3).all(
        |axis| {
            if octant >> axis & 1 == 0 { aabb.min()[axis] < center[axis] } else { aabb.max()[axis] >= center[axis] }
        },
    )
}
