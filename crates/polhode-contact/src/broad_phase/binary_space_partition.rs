//! Binary space partition: space is halved by planes in any direction.
//!
//! A plane stands across the direction in which the boxes' middles vary most, where as many lie on one side as on the
//! other; where that is not worth it, across an axis (docs/REFERENCES.md, Fuchs, Kedem and Naylor 1980). Planes in general directions follow
//! walls and rows that stand askew, and cut more of the boxes, which stand along the axes: of the partitions this is
//! the slowest on the boxes of the bench.
//!
//! Sides are decided without a tolerance: `n . p` is summed in one order for points and for boxes, every rounded
//! product and sum grows with its arguments, so that the rounded value of a point of a box lies between the rounded
//! bounds of the box.

use super::far_boxes::FarBoxes;
use super::pair_collector::PairCollector;
use super::partition::{LEAF_BOXES, MOST_LEVELS, compare_all, is_worthwhile, middle, middles};
use super::{BroadPhase, BroadPhaseError, begin};
use crate::Aabb;
use glam::DVec3;

/// Multiplications by the covariance that bring a direction close to that of the largest variance; it need not be met.
const POWER_ITERATIONS: usize = 6;

/// Points with `normal . p < offset` lie below, the others above.
#[derive(Debug, Clone, Copy)]
struct Plane {
    normal: DVec3,
    offset: f64,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Half {
    Below,
    Above,
}

/// A binary space partition.
#[derive(Debug, Clone, Default)]
pub struct BinarySpacePartition {
    boxes: FarBoxes,
    /// Boxes of the cells from the root to the present one, one cell after the other.
    members: Vec<u32>,
    /// Planes from the root to the present cell, and the half taken.
    path: Vec<(Plane, Half)>,
    heights: Vec<f64>,
    found: PairCollector,
}

impl BroadPhase for BinarySpacePartition {
    fn pairs(&mut self, boxes: &[Aabb], pairs: &mut Vec<(u32, u32)>) -> Result<(), BroadPhaseError> {
        begin(boxes, pairs)?;
        self.boxes.set(boxes);
        self.found.clear();
        self.boxes.pairs(boxes, &mut self.found);
        self.members.clear();
        self.members.extend(0..self.boxes.near.len() as u32);
        self.path.clear();
        self.visit(0);
        self.found.sort_into(boxes.len(), pairs);
        Ok(())
    }
}

impl BinarySpacePartition {
    /// Finds the pairs of a cell, whose boxes are the members from `start` on.
    fn visit(&mut self, start: usize) {
        let end = self.members.len();
        let may_split = end - start > LEAF_BOXES && self.path.len() < MOST_LEVELS as usize;
        let plane = if may_split { self.plane(start) } else { None };
        let Some(plane) = plane else {
            let boxes = (&self.boxes.near[..], &self.boxes.index[..]);
            let owns = |point: DVec3| self.path.iter().all(|&(plane, half)| plane.half(point) == half);
            compare_all(boxes, &self.members[start..], owns, &mut self.found);
            return;
        };
        for half in [Half::Below, Half::Above] {
            for member in start..end {
                if plane.reaches(&self.boxes.near[self.members[member] as usize], half) {
                    self.members.push(self.members[member]);
                }
            }
            self.path.push((plane, half));
            self.visit(end);
            self.path.pop();
            self.members.truncate(end);
        }
    }

    /// The plane that splits the members from `start` on; none when no split is worth it.
    fn plane(&mut self, start: usize) -> Option<Plane> {
        let (members, near) = (&self.members[start..], &self.boxes.near);
        for normal in [principal_direction(near, members), DVec3::X, DVec3::Y, DVec3::Z] {
            self.heights.clear();
            self.heights.extend(members.iter().map(|&member| height(normal, middle(&near[member as usize]))));
            let offset = *self.heights.select_nth_unstable_by(members.len() / 2, f64::total_cmp).1;
            let plane = Plane { normal, offset };
            let count = |half| members.iter().filter(|&&member| plane.reaches(&near[member as usize], half)).count();
            if is_worthwhile(members.len(), &[count(Half::Below), count(Half::Above)]) {
                return Some(plane);
            }
        }
        None
    }
}

impl Plane {
    fn half(&self, point: DVec3) -> Half {
        if height(self.normal, point) < self.offset { Half::Below } else { Half::Above }
    }

    fn reaches(&self, aabb: &Aabb, half: Half) -> bool {
        let (at_min, at_max) = (self.normal * aabb.min(), self.normal * aabb.max());
        let sum = |terms: DVec3| terms.x + terms.y + terms.z;
        match half {
            Half::Below => sum(at_min.min(at_max)) < self.offset,
            Half::Above => sum(at_min.max(at_max)) >= self.offset,
        }
    }
}

/// `n . p`, summed as the bounds of a box are.
fn height(normal: DVec3, point: DVec3) -> f64 {
    let terms = normal * point;
    terms.x + terms.y + terms.z
}

/// About the direction in which the middles of boxes vary most: unit, or an axis when they do not vary.
fn principal_direction(boxes: &[Aabb], members: &[u32]) -> DVec3 {
    let (low, high) = middles(boxes, members);
    let (center, scale) = (0.5 * low + 0.5 * high, (high - low).max_element());
    let mut direction = high - low;
    for _ in 0..POWER_ITERATIONS {
        let length = direction.length();
        if !(length > 0.0 && length.is_finite()) {
            return DVec3::X;
        }
        direction /= length;
        let offsets = members.iter().map(|&member| (middle(&boxes[member as usize]) - center) / scale);
        direction = offsets.map(|offset| offset * offset.dot(direction)).sum();
    }
    direction.try_normalize().unwrap_or(DVec3::X)
}
