//! No broad phase: every box is compared with every other.
//!
//! It takes n (n - 1)/2 comparisons. The other methods are tested against it, and it is the fastest for a few dozen
//! boxes.

use super::{BroadPhase, BroadPhaseError, begin};
use crate::Aabb;

/// Every box against every other.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct AllPairs;

impl BroadPhase for AllPairs {
    fn pairs(&mut self, boxes: &[Aabb], pairs: &mut Vec<(u32, u32)>) -> Result<(), BroadPhaseError> {
        begin(boxes, pairs)?;
        for (i, first) in boxes.iter().enumerate() {
            let others = boxes.iter().enumerate().skip(i + 1);
            pairs.extend(others.filter(|(_, second)| first.overlaps(second)).map(|(j, _)| (i as u32, j as u32)));
        }
        Ok(())
    }
}
