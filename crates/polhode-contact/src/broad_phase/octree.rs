//! Octree: space is halved across all three axes at once.
//!
//! The planes go through the middle of the bounds of the boxes' centres (docs/REFERENCES.md, Meagher 1982), so that
//! empty space costs no levels. An axis along which the centres have a small extent is not split: a flat layer of boxes
//! would only be cut in two. No library is used: those of octrees store points, or boxes with integer coordinates.

use super::partition::{Cell, Split, SplitRule};
use crate::Aabb;
use glam::DVec3;

/// Axes along which the extent of the centres is less than this fraction of the largest one are not split.
const SPLIT_SPREAD: f64 = 0.25;

/// The rule of an octree.
#[derive(Debug, Default)]
pub(crate) struct Octree;

/// The point where three axis-aligned planes meet; bit k of a side is set above the plane across axis k. A plane at
/// infinity has everything below it.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Octants {
    center: DVec3,
}

impl SplitRule for Octree {
    type Split = Octants;

    fn split(&mut self, cell: &Cell<'_>) -> Option<Octants> {
        let around = Aabb::of_points(cell.middles());
        let spread = around.max() - around.min();
        let mut center = around.middle();
        for axis in 0..3 {
            if spread[axis] < SPLIT_SPREAD * spread.max_element() {
                center[axis] = f64::INFINITY;
            }
        }
        cell.worthwhile(Octants { center })
    }
}

impl Split for Octants {
    const SIDES: usize = 8;

    fn reaches(&self, aabb: &Aabb, side: usize) -> bool {
        let (min, max, center) = (aabb.min(), aabb.max(), self.center);
        (0..3).all(|axis| if side >> axis & 1 == 0 { min[axis] < center[axis] } else { max[axis] >= center[axis] })
    }
}
