//! Binary space partition: space is halved by planes in any direction.
//!
//! The splitting plane is perpendicular to the direction of largest variance of the boxes' centres, at their median;
//! where that split is not worth it, perpendicular to an axis (docs/REFERENCES.md, Fuchs, Kedem and Naylor 1980).
//! Planes in general directions follow oblique walls and rows, but cut more of the axis-aligned boxes: of the three
//! partitions this is the slowest in the benchmark.
//!
//! Sides are decided without a tolerance. `n . p` is summed in the same order for points and for boxes; rounded
//! products and sums are monotone in their arguments, so the rounded value of a point of a box lies between the rounded
//! bounds of the box.

use super::partition::{Cell, Split, SplitRule};
use crate::Aabb;
use glam::DVec3;

/// Steps of the power iteration for the direction of largest variance; an approximation is enough.
const POWER_ITERATIONS: usize = 6;

/// The rule of a binary space partition.
#[derive(Debug, Default)]
pub(crate) struct BinarySpacePartition {
    heights: Vec<f64>,
}

/// Points with `normal . p < offset` are on side 0, the others on side 1.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Plane {
    normal: DVec3,
    offset: f64,
}

impl SplitRule for BinarySpacePartition {
    type Split = Plane;

    fn split(&mut self, cell: &Cell<'_>) -> Option<Plane> {
        [principal_direction(cell), DVec3::X, DVec3::Y, DVec3::Z].into_iter().find_map(|normal| {
            let offset = cell.median(|middle| sum(normal * middle), &mut self.heights);
            cell.worthwhile(Plane { normal, offset })
        })
    }
}

impl Split for Plane {
    const SIDES: usize = 2;

    fn reaches(&self, aabb: &Aabb, side: usize) -> bool {
        let (at_min, at_max) = (self.normal * aabb.min(), self.normal * aabb.max());
        if side == 0 { sum(at_min.min(at_max)) < self.offset } else { sum(at_min.max(at_max)) >= self.offset }
    }
}

/// The sum of three terms in one order, for points and for the bounds of boxes.
fn sum(terms: DVec3) -> f64 {
    terms.x + terms.y + terms.z
}

/// Approximate unit direction of largest variance of the boxes' centres; an axis when they do not vary.
fn principal_direction(cell: &Cell<'_>) -> DVec3 {
    let around = Aabb::of_points(cell.middles());
    let (low, high) = (around.min(), around.max());
    let (center, scale) = (around.middle(), (high - low).max_element());
    let mut direction = high - low;
    for _ in 0..POWER_ITERATIONS {
        let length = direction.length();
        if !(length > 0.0 && length.is_finite()) {
            return DVec3::X;
        }
        direction /= length;
        let offsets = cell.middles().map(|middle| (middle - center) / scale);
        direction = offsets.map(|offset| offset * offset.dot(direction)).sum();
    }
    direction.try_normalize().unwrap_or(DVec3::X)
}
