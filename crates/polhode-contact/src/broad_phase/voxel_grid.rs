//! A uniform grid of cubic cells in a hash table.
//!
//! A box is entered in every cell that it overlaps; boxes that share a cell are tested. Two boxes may share several
//! cells: their pair is reported by the cell that contains the lowest corner of their intersection. The width of a cell
//! follows the median of the boxes' largest edges, which neither a few large boxes nor a few small ones change. A box
//! that would be entered in more than a few cells is compared with all others instead. So the grid suits boxes of
//! similar sizes; with a wide spread of sizes its time tends to that of comparing all (docs/REFERENCES.md, Teschner et
//! al. 2003). No library is used: those of spatial hashing store points, or require boxes in their own storage.

use super::pair_collector::{PairCollector, PairSearch, distribute};
use crate::Aabb;
use glam::DVec3;

/// Edge of a cell in units of the boxes' typical edge: a typical box overlaps one to eight cells.
const CELL_OVER_EDGE: f64 = 2.0;

/// A box that overlaps more cells than this is compared with all boxes.
const MOST_CELLS: f64 = 64.0;

/// Coordinates of cells are clamped to plus and minus this number. Clamping keeps their order, so that boxes which
/// share a point still share a cell.
const FARTHEST_CELL: f64 = 1e9;

/// Cells narrower than this (m) would make their inverse infinite.
const NARROWEST_CELL: f64 = 1e-300;

/// Odd multipliers of the hash (2^64 over the golden ratio and two constants of the same kind), which spread
/// neighbouring cells over the table.
const HASH: [u64; 3] = [0x9E37_79B9_7F4A_7C15, 0xC2B2_AE3D_27D4_EB4F, 0x1656_67B1_9E37_79F9];

type Cell = [i32; 3];

/// A box in one of its cells.
#[derive(Debug, Clone, Copy, Default)]
struct Entry {
    cell: Cell,
    /// The cell of the box's lowest corner.
    first: Cell,
    number: u32,
}

/// A uniform grid of cells in a hash table.
#[derive(Debug, Default)]
pub(crate) struct VoxelGrid {
    entries: Vec<Entry>,
    edges: Vec<f64>,
    /// Entries by bucket of the table.
    table: Vec<Entry>,
    /// Where each bucket ends in the table.
    ends: Vec<usize>,
    /// Boxes that overlap more than [`MOST_CELLS`] cells.
    wide: Vec<u32>,
    is_wide: Vec<bool>,
}

impl PairSearch for VoxelGrid {
    fn search(&mut self, boxes: &[Aabb], found: &mut PairCollector) {
        self.enter(boxes);
        self.fill_table();
        self.wide_pairs(boxes, found);
        self.cell_pairs(boxes, found);
    }
}

impl VoxelGrid {
    /// Enters every box in its cells.
    fn enter(&mut self, boxes: &[Aabb]) {
        let per_cell = 1.0 / self.cell_width(boxes);
        self.entries.clear();
        self.wide.clear();
        self.is_wide.clear();
        for (number, aabb) in boxes.iter().enumerate() {
            let (low, high) = (cell(aabb.min() * per_cell), cell(aabb.max() * per_cell));
            let spans: f64 = (0..3).map(|k| f64::from(high[k]) - f64::from(low[k]) + 1.0).product();
            let number = number as u32;
            self.is_wide.push(spans > MOST_CELLS);
            if spans > MOST_CELLS {
                self.wide.push(number);
                continue;
            }
            for x in low[0]..=high[0] {
                for y in low[1]..=high[1] {
                    for z in low[2]..=high[2] {
                        self.entries.push(Entry { cell: [x, y, z], first: low, number });
                    }
                }
            }
        }
    }

    /// Width of a cell, m: from the median of the largest edges of boxes that have one.
    fn cell_width(&mut self, boxes: &[Aabb]) -> f64 {
        let edges = boxes.iter().map(|aabb| (aabb.max() - aabb.min()).max_element());
        self.edges.clear();
        self.edges.extend(edges.filter(|edge| edge.is_finite() && *edge > NARROWEST_CELL));
        if self.edges.is_empty() {
            return 1.0;
        }
        let half = self.edges.len() / 2;
        CELL_OVER_EDGE * *self.edges.select_nth_unstable_by(half, f64::total_cmp).1
    }

    /// Distributes the entries over a table of about twice as many buckets.
    fn fill_table(&mut self) {
        let buckets = (2 * self.entries.len()).next_power_of_two();
        self.ends.clear();
        self.ends.resize(buckets, 0);
        for entry in &self.entries {
            self.ends[bucket(entry.cell, buckets)] += 1;
        }
        distribute(&self.entries, |entry| bucket(entry.cell, buckets), &mut self.ends, &mut self.table);
    }

    fn wide_pairs(&self, boxes: &[Aabb], found: &mut PairCollector) {
        for &i in &self.wide {
            for (j, other) in boxes.iter().enumerate() {
                // Of two wide boxes the one with the lower number reports the pair.
                let is_mine = !self.is_wide[j] || i < j as u32;
                if is_mine && boxes[i as usize].overlaps(other) {
                    found.push(i, j as u32);
                }
            }
        }
    }

    fn cell_pairs(&self, boxes: &[Aabb], found: &mut PairCollector) {
        let mut start = 0;
        for &end in &self.ends {
            let bucket = &self.table[start..end];
            start = end;
            for (k, a) in bucket.iter().enumerate() {
                for b in &bucket[k + 1..] {
                    let owns =
                        |axis: usize| a.cell[axis] == b.cell[axis] && a.cell[axis] == a.first[axis].max(b.first[axis]);
                    if owns(0) && owns(1) && owns(2) && boxes[a.number as usize].overlaps(&boxes[b.number as usize]) {
                        found.push(a.number, b.number);
                    }
                }
            }
        }
    }
}

/// The cell of a point given in widths of a cell.
fn cell(point: DVec3) -> Cell {
    let cut = |x: f64| x.floor().clamp(-FARTHEST_CELL, FARTHEST_CELL) as i32;
    [cut(point.x), cut(point.y), cut(point.z)]
}

fn bucket(cell: Cell, buckets: usize) -> usize {
    let mixed = (0..3).fold(0u64, |hash, k| hash ^ (cell[k] as u64).wrapping_mul(HASH[k]));
    // The high bits are mixed best.
    ((mixed ^ (mixed >> 32)).wrapping_mul(HASH[0]) >> 32) as usize & (buckets - 1)
}
