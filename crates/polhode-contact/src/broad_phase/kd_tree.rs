//! k-d tree: space is halved across one axis, at the median of the boxes' centres.
//!
//! The axis is the one with the largest extent of the centres for which the split is worthwhile (docs/REFERENCES.md,
//! Bentley 1975). Planes follow the boxes, so that clusters and a wide range of sizes cost a few more levels, not more
//! comparisons. No library is used: those of k-d trees (such as kiddo) store points, not boxes.

use super::partition::{Cell, Split, SplitRule};
use crate::Aabb;

/// The rule of a k-d tree.
#[derive(Debug, Default)]
pub(crate) struct KdTree {
    heights: Vec<f64>,
}

/// A plane across an axis: side 0 lies below it, side 1 at it and above.
#[derive(Debug, Clone, Copy)]
pub(crate) struct AxisPlane {
    axis: usize,
    at: f64,
}

impl SplitRule for KdTree {
    type Split = AxisPlane;

    fn split(&mut self, cell: &Cell<'_>) -> Option<AxisPlane> {
        let around = Aabb::of_points(cell.middles());
        let spread = around.max() - around.min();
        let mut axes = [0, 1, 2];
        axes.sort_by(|&a, &b| spread[b].total_cmp(&spread[a]));
        axes.into_iter().find_map(|axis| {
            let at = cell.median(|middle| middle[axis], &mut self.heights);
            cell.worthwhile(AxisPlane { axis, at })
        })
    }
}

impl Split for AxisPlane {
    const SIDES: usize = 2;

    fn reaches(&self, aabb: &Aabb, side: usize) -> bool {
        if side == 0 { aabb.min()[self.axis] < self.at } else { aabb.max()[self.axis] >= self.at }
    }
}
