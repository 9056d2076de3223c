//! Recursive partitions of space: what the octree, the k-d tree and the binary space partition have in common.
//!
//! Space is divided recursively by planes; a box goes to every side that it overlaps, and the boxes of each leaf cell
//! are compared. A box on a plane is then in two cells, and two boxes may share several cells. Their pair is reported
//! by the cell that contains the lowest corner of their intersection; its coordinates are coordinates of the boxes, so
//! that rounding cannot put it on another side than the boxes. Cells are built anew at every call: that costs about as
//! much as an update when everything moves, and the result does not depend on earlier calls. The methods differ in the
//! planes they choose ([`SplitRule`]).

use super::far_boxes::FarBoxes;
use super::pair_collector::{PairCollector, PairSearch};
use crate::Aabb;
use glam::DVec3;
use std::fmt::Debug;

/// Cells with at most this many boxes are not split further: a split costs several passes over them.
const LEAF_BOXES: usize = 16;

/// A split is worthwhile when it leaves at most this fraction of the comparisons: as that of the larger side is one of
/// them, there are at most about a hundred levels of a million boxes.
const WORTHWHILE: f64 = 0.8;

/// A division of a cell into sides; every point lies on exactly one of them.
pub(crate) trait Split: Copy + Debug + Send {
    /// How many sides there are.
    const SIDES: usize;

    /// Whether a box overlaps a side.
    fn reaches(&self, aabb: &Aabb, side: usize) -> bool;
}

/// How a method divides cells.
pub(crate) trait SplitRule: Debug + Default + Send {
    /// Its kind of division.
    type Split: Split;

    /// The first worthwhile division of a cell; none when there is none.
    fn split(&mut self, cell: &Cell<'_>) -> Option<Self::Split>;
}

/// The boxes of a cell.
pub(crate) struct Cell<'a> {
    boxes: &'a [Aabb],
    members: &'a [u32],
}

impl Cell<'_> {
    pub(crate) fn boxes(&self) -> impl Iterator<Item = &Aabb> {
        self.members.iter().map(|&member| &self.boxes[member as usize])
    }

    /// Centres of the boxes, m.
    pub(crate) fn middles(&self) -> impl Iterator<Item = DVec3> {
        self.boxes().map(Aabb::middle)
    }

    /// Median of a measure (m) of the boxes' centres. `buffer` is for sorting.
    pub(crate) fn median(&self, measure: impl Fn(DVec3) -> f64, buffer: &mut Vec<f64>) -> f64 {
        buffer.clear();
        buffer.extend(self.middles().map(measure));
        *buffer.select_nth_unstable_by(self.members.len() / 2, f64::total_cmp).1
    }

    /// Returns a division if its sides need clearly fewer comparisons than the whole cell.
    pub(crate) fn worthwhile<S: Split>(&self, split: S) -> Option<S> {
        let square = |n: usize| n as f64 * n as f64;
        let count = |side: usize| self.boxes().filter(|aabb| split.reaches(aabb, side)).count();
        let parts: f64 = (0..S::SIDES).map(|side| square(count(side))).sum();
        (parts <= WORTHWHILE * square(self.members.len())).then_some(split)
    }
}

/// A partition of space by a rule.
#[derive(Debug)]
pub(crate) struct Partition<R: SplitRule> {
    rule: R,
    boxes: FarBoxes,
    /// Boxes of the cells from the root to the current one, one cell after the other.
    members: Vec<u32>,
    /// Divisions from the root to the current cell, and the side taken.
    path: Vec<(R::Split, usize)>,
}

impl<R: SplitRule> Default for Partition<R> {
    fn default() -> Self {
        Self { rule: R::default(), boxes: FarBoxes::default(), members: Vec::new(), path: Vec::new() }
    }
}

impl<R: SplitRule> PairSearch for Partition<R> {
    fn search(&mut self, boxes: &[Aabb], found: &mut PairCollector) {
        self.boxes.set(boxes);
        self.boxes.pairs(boxes, found);
        self.members.clear();
        self.members.extend(0..self.boxes.near.len() as u32);
        self.path.clear();
        self.visit(0, found);
    }
}

impl<R: SplitRule> Partition<R> {
    /// Finds the pairs of a cell, whose boxes are the members from `start` on.
    fn visit(&mut self, start: usize, found: &mut PairCollector) {
        let end = self.members.len();
        let cell = Cell { boxes: &self.boxes.near, members: &self.members[start..] };
        let may_split = end - start > LEAF_BOXES;
        let Some(split) = (if may_split { self.rule.split(&cell) } else { None }) else {
            self.compare_all(start, found);
            return;
        };
        for side in 0..R::Split::SIDES {
            for member in start..end {
                if split.reaches(&self.boxes.near[self.members[member] as usize], side) {
                    self.members.push(self.members[member]);
                }
            }
            if self.members.len() > end + 1 {
                self.path.push((split, side));
                self.visit(end, found);
                self.path.pop();
            }
            self.members.truncate(end);
        }
    }

    /// Compares all boxes of a cell, and reports the pairs that belong to it.
    fn compare_all(&self, start: usize, found: &mut PairCollector) {
        let members = &self.members[start..];
        let FarBoxes { near, index, .. } = &self.boxes;
        for (k, &i) in members.iter().enumerate() {
            let a = &near[i as usize];
            for &j in &members[k + 1..] {
                let b = &near[j as usize];
                if a.overlaps(b) && self.owns(a.min().max(b.min())) {
                    found.push(index[i as usize], index[j as usize]);
                }
            }
        }
    }

    /// Whether the current cell contains a point.
    fn owns(&self, point: DVec3) -> bool {
        let here = Aabb::of_point(point);
        self.path.iter().all(|(split, side)| split.reaches(&here, *side))
    }
}
