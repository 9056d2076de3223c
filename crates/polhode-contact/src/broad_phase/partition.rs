//! What octree, k-d tree and binary space partition have in common.
//!
//! Space is halved, again and again; a box goes to every side that it reaches into, and boxes in the same last cell are
//! compared. A box on a plane is then in two cells, and two boxes may share several; their pair belongs to the cell
//! that holds the lowest corner of what they share, a point whose coordinates are coordinates of the boxes, so that no
//! rounding can put it on another side than the boxes. Cells are found anew at every call: that costs about as much as
//! mending them when everything moves, and leaves nothing of the past behind.

use super::pair_collector::PairCollector;
use crate::Aabb;
use glam::DVec3;

/// So few boxes are compared rather than split further: a split costs several passes over them.
pub(crate) const LEAF_BOXES: usize = 16;

/// Deepest cell. Splits that help halve what remains, so that cells this deep are those of clusters within clusters.
pub(crate) const MOST_LEVELS: u32 = 48;

/// A split is worth it when it leaves at most this share of the comparisons.
const WORTHWHILE: f64 = 0.8;

/// Whether sides with so many boxes need clearly fewer comparisons than `whole` boxes together.
pub(crate) fn is_worthwhile(whole: usize, sides: &[usize]) -> bool {
    let square = |n: usize| n as f64 * n as f64;
    sides.iter().map(|&n| square(n)).sum::<f64>() <= WORTHWHILE * square(whole)
}

/// A cell between planes across the axes: its lower bounds belong to it, its upper ones do not.
#[derive(Debug, Clone, Copy)]
pub(crate) struct AxisCell {
    pub(crate) low: DVec3,
    pub(crate) high: DVec3,
}

impl AxisCell {
    /// All of space that has finite coordinates.
    pub(crate) const ALL: Self = Self { low: DVec3::NEG_INFINITY, high: DVec3::INFINITY };

    pub(crate) fn contains(&self, point: DVec3) -> bool {
        point.cmpge(self.low).all() && point.cmplt(self.high).all()
    }
}

/// Lower and upper bounds of the middles of boxes.
pub(crate) fn middles(boxes: &[Aabb], members: &[u32]) -> (DVec3, DVec3) {
    let all = members.iter().map(|&member| middle(&boxes[member as usize]));
    all.fold((DVec3::INFINITY, DVec3::NEG_INFINITY), |(low, high), p| (low.min(p), high.max(p)))
}

pub(crate) fn middle(aabb: &Aabb) -> DVec3 {
    0.5 * aabb.min() + 0.5 * aabb.max()
}

/// Compares all boxes of a cell; `owns` tells whether the cell holds a point, `index` translates to the caller's
/// numbers.
pub(crate) fn compare_all(
    (boxes, index): (&[Aabb], &[u32]),
    members: &[u32],
    owns: impl Fn(DVec3) -> bool,
    found: &mut PairCollector,
) {
    for (k, &i) in members.iter().enumerate() {
        let a = &boxes[i as usize];
        for &j in &members[k + 1..] {
            let b = &boxes[j as usize];
            if a.overlaps(b) && owns(a.min().max(b.min())) {
                found.push(index[i as usize], index[j as usize]);
            }
        }
    }
}
