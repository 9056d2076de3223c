//! Pairs that may overlap while no box has moved far.
//!
//! All boxes are blown up, and the pairs of which the blown-up boxes overlap are the candidates. As long as every box is
//! inside its blown-up one, no other pair can overlap, and only the candidates need be compared. How long that is depends
//! on the motion alone; where it is too short to pay, boxes are left as they are for a while.

use crate::Aabb;

/// Boxes are blown up on every side by this share of their shortest side: so little that cubes have only 1.25^3 = 1.95 times as
/// many candidates as pairs, so much that bodies stay inside for some steps while these move them by a few hundredths of
/// their size.
const GROWTH: f64 = 0.125;

/// Candidates that hold for fewer calls than this, the one that searches for them included, cost more than they save.
const SHORTEST_LIFE: u32 = 3;

/// So many searches are made without candidates after some that did not hold.
const WAIT: u32 = 16;

/// Blown-up boxes and the pairs of them that overlap.
#[derive(Debug, Clone, Default)]
pub(crate) struct Candidates {
    /// Blown-up boxes; none when candidates do not pay.
    pub(crate) grown: Vec<Aabb>,
    /// Those of which the blown-up boxes overlap, sorted.
    pub(crate) pairs: Vec<(u32, u32)>,
    /// Calls for which these have held.
    life: u32,
    /// Searches for which boxes are left as they are.
    wait: u32,
}

impl Candidates {
    /// Whether no pairs of these boxes but the candidates can overlap.
    pub(crate) fn hold(&mut self, boxes: &[Aabb]) -> bool {
        let hold = self.grown.len() == boxes.len() && self.grown.iter().zip(boxes).all(|(g, b)| g.encloses(b));
        self.life = self.life.saturating_add(u32::from(hold));
        hold
    }

    /// Blows the boxes up, for a new search for candidates; false when candidates do not pay.
    pub(crate) fn grow(&mut self, boxes: &[Aabb]) -> bool {
        let same_count = self.grown.len() == boxes.len();
        self.grown.clear();
        if same_count && self.life < SHORTEST_LIFE {
            self.wait = WAIT;
        }
        if self.wait > 0 {
            self.wait -= 1;
            return false;
        }
        self.grown.extend(boxes.iter().map(grown));
        self.life = 1;
        true
    }

    /// Adds the candidates that overlap to a list.
    pub(crate) fn overlapping(&self, boxes: &[Aabb], pairs: &mut Vec<(u32, u32)>) {
        let overlap = |&&(i, j): &&(u32, u32)| boxes[i as usize].overlaps(&boxes[j as usize]);
        pairs.extend(self.pairs.iter().filter(overlap));
    }
}

/// A box blown up by a share of its shortest side; itself where that is no number.
fn grown(aabb: &Aabb) -> Aabb {
    let shortest = (aabb.max() - aabb.min()).min_element();
    aabb.inflated(GROWTH * shortest).unwrap_or(*aabb)
}
