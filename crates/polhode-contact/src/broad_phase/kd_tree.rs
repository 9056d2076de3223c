//! k-d tree: space is halved across one axis, where as many boxes' middles lie on one side as on the other.
//!
//! The axis is the one along which the middles spread most and on which the split is worth it (docs/REFERENCES.md,
//! Bentley 1975). Planes follow the boxes, so that clusters and wide spreads of sizes cost a few levels more, not more
//! comparisons. Libraries of k-d trees (kiddo and its like) hold points, not boxes.

use super::far_boxes::FarBoxes;
use super::pair_collector::PairCollector;
use super::partition::{AxisCell, LEAF_BOXES, MOST_LEVELS, compare_all, is_worthwhile, middle, middles};
use super::{BroadPhase, BroadPhaseError, begin};
use crate::Aabb;

/// A k-d tree.
#[derive(Debug, Clone, Default)]
pub struct KdTree {
    boxes: FarBoxes,
    /// Boxes of the cells from the root to the present one, one cell after the other.
    members: Vec<u32>,
    /// Middles of the boxes of the present cell on one axis.
    middles: Vec<f64>,
    found: PairCollector,
}

impl BroadPhase for KdTree {
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

impl KdTree {
    /// Finds the pairs of a cell, whose boxes are the members from `start` on.
    fn visit(&mut self, start: usize, cell: AxisCell, level: u32) {
        let end = self.members.len();
        let plane = if end - start > LEAF_BOXES && level < MOST_LEVELS { self.plane(start) } else { None };
        let Some((axis, at)) = plane else {
            let boxes = (&self.boxes.near[..], &self.boxes.index[..]);
            compare_all(boxes, &self.members[start..], |point| cell.contains(point), &mut self.found);
            return;
        };
        let (mut below, mut above) = (cell, cell);
        below.high[axis] = at;
        above.low[axis] = at;
        for member in start..end {
            if self.boxes.near[self.members[member] as usize].min()[axis] < at {
                self.members.push(self.members[member]);
            }
        }
        self.visit(end, below, level + 1);
        self.members.truncate(end);
        for member in start..end {
            if self.boxes.near[self.members[member] as usize].max()[axis] >= at {
                self.members.push(self.members[member]);
            }
        }
        self.visit(end, above, level + 1);
        self.members.truncate(end);
    }

    /// Axis and place of the plane that splits the members from `start` on; none when no split is worth it.
    fn plane(&mut self, start: usize) -> Option<(usize, f64)> {
        let (members, near) = (&self.members[start..], &self.boxes.near);
        let (low, high) = middles(near, members);
        let spread = high - low;
        let mut axes = [0, 1, 2];
        axes.sort_by(|&a, &b| spread[b].total_cmp(&spread[a]));
        for axis in axes {
            self.middles.clear();
            self.middles.extend(members.iter().map(|&member| middle(&near[member as usize])[axis]));
            let half = members.len() / 2;
            let at = *self.middles.select_nth_unstable_by(half, f64::total_cmp).1;
            let below = members.iter().filter(|&&member| near[member as usize].min()[axis] < at).count();
            let above = members.iter().filter(|&&member| near[member as usize].max()[axis] >= at).count();
            if is_worthwhile(members.len(), &[below, above]) {
                return Some((axis, at));
            }
        }
        None
    }
}
