//! Adaptive subdivision: how long two bodies certainly stay clear of each other, from bounds for their parts.
//!
//! The time for which a part is certainly clear grows as the part gets smaller. So the part with the shortest time is
//! replaced by smaller parts, until all parts are clear for the whole window or a subdivision gains too little.
//!
//! For rings that nearly touch all around, and for bodies so fast that the bounds overflow, subdivision gains nothing.
//! To bound the work, every window may use a small number of cuts, and only a few windows of one search may use many.

use std::cmp::Ordering;
use std::collections::BinaryHeap;

/// Subdivision continues while cutting the part with the shortest time lengthens this time by at least this factor.
const GAIN: f64 = 1.25;

/// Number of cuts that every window may use. Few windows gain from more.
const EACH: u32 = 256;

/// Number of additional cuts, for all windows of a search together. Rings that touch while nearly coplanar need many.
const SPARE: u32 = 4096;

/// A part of two bodies, and how long it certainly stays clear, s. In the order, a shorter time is greater, so that
/// the heap gives the part with the shortest time first.
#[derive(Debug, Clone, Copy)]
pub(crate) struct ClearPart<P> {
    pub(crate) part: P,
    pub(crate) clear: f64,
}

impl<P> Ord for ClearPart<P> {
    fn cmp(&self, other: &Self) -> Ordering {
        other.clear.total_cmp(&self.clear)
    }
}

impl<P> PartialOrd for ClearPart<P> {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl<P> PartialEq for ClearPart<P> {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other) == Ordering::Equal
    }
}

impl<P> Eq for ClearPart<P> {}

/// Counts the cuts of one search.
#[derive(Debug)]
pub(crate) struct Cuts {
    /// Remaining additional cuts.
    spare: u32,
    made: u32,
}

impl Cuts {
    pub(crate) const fn new() -> Self {
        Self { spare: SPARE, made: 0 }
    }

    /// Number of cuts so far.
    pub(crate) const fn made(&self) -> u32 {
        self.made
    }

    /// How long all parts certainly stay clear, s, at most `window`. The part with the shortest time is replaced by
    /// smaller ones, which `cut` adds to a list, until all are clear for the whole window, a cut gains too little, or
    /// no cuts are left.
    pub(crate) fn clear<P>(
        &mut self,
        parts: Vec<ClearPart<P>>,
        window: f64,
        mut cut: impl FnMut(&P, &mut Vec<ClearPart<P>>),
    ) -> f64 {
        let mut parts = BinaryHeap::from(parts);
        let mut smaller = Vec::new();
        let most = EACH + self.spare;
        let mut made = 0;
        while made < most {
            let Some(ClearPart { part, clear }) = parts.peek().filter(|worst| worst.clear < window) else { break };
            cut(part, &mut smaller);
            made += 1;
            let better = smaller.iter().map(|part| part.clear).fold(f64::INFINITY, f64::min);
            let enough = *clear > 0.0 && better < GAIN * clear;
            parts.pop();
            parts.extend(smaller.drain(..));
            if enough {
                break;
            }
        }
        self.made = self.made.saturating_add(made);
        self.spare -= made.saturating_sub(EACH);
        parts.peek().map_or(window, |worst| worst.clear.min(window))
    }
}
