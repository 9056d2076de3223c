//! Pairs that may overlap while no box has moved far.
//!
//! All boxes are enlarged, and the pairs whose enlarged boxes overlap are the candidates. As long as every box is
//! inside its enlarged box, no other pair can overlap, and only the candidates need be compared. How long that lasts
//! depends on the motion alone; where it is too short to pay, searches are made without candidates for a while.

use crate::Aabb;

/// Boxes are enlarged on every side by this fraction of their shortest side: little enough that cubes have only 1.25^3
/// = 1.95 times as many candidates as pairs, enough that bodies stay inside for some steps that move them by a few
/// hundredths of their size.
const GROWTH: f64 = 0.125;

/// Candidates that are valid for fewer calls than this, including the call that finds them, cost more than they save.
const SHORTEST_LIFE: u32 = 3;

/// Number of searches without candidates after candidates that were valid too briefly.
const WAIT: u32 = 16;

/// Enlarged boxes and the pairs of them that overlap.
#[derive(Debug, Clone, Default)]
pub(crate) struct Candidates {
    /// Enlarged boxes; empty when candidates do not pay.
    pub(crate) grown: Vec<Aabb>,
    /// Pairs whose enlarged boxes overlap, sorted.
    pub(crate) pairs: Vec<(u32, u32)>,
    /// Calls for which these have been valid.
    life: u32,
    /// Searches still to be made without candidates.
    wait: u32,
}

impl Candidates {
    /// Whether the candidates are valid: no other pairs of these boxes can overlap.
    pub(crate) fn hold(&mut self, boxes: &[Aabb]) -> bool {
        let hold = self.grown.len() == boxes.len() && self.grown.iter().zip(boxes).all(|(g, b)| g.encloses(b));
        self.life = self.life.saturating_add(u32::from(hold));
        hold
    }

    /// Enlarges the boxes for a new search for candidates; false when candidates do not pay.
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

/// A box enlarged by a fraction of its shortest side; unchanged where that is NaN.
fn grown(aabb: &Aabb) -> Aabb {
    let shortest = (aabb.max() - aabb.min()).min_element();
    aabb.inflated(GROWTH * shortest).unwrap_or(*aabb)
}
