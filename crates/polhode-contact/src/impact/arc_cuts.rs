//! Cutting what fails first: how long all parts of two bodies stay clear of each other, when the time that can be proved for
//! a part grows as the part shrinks.
//!
//! The part with the shortest time is replaced by smaller ones, until all parts are clear for the whole window or cutting
//! gains no more. Rings that nearly touch all around, or bodies so fast that the bounds overflow, would be cut in vain in
//! one window after the other: a search may cut finely a few times, and coarsely in every window, so that its work is
//! bounded by how often it looks.

use std::cmp::Ordering;
use std::collections::BinaryHeap;

/// Cutting the arc that fails first must lengthen its time by this factor for another cut of it.
const GAIN: f64 = 1.25;

/// Cuts at most in one window: rings that touch while nearly in one plane have to be cut finely.
const MOST: u32 = 2048;

/// Cuts that every window may make. Of windows that need more, few gain anything.
const EACH: u32 = 256;

/// Cuts beyond those in all windows of a search together.
const SPARE: u32 = 4096;

/// A part of two bodies, and how long it stays clear, s. The one that fails first is the greatest.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Piece<P> {
    pub(crate) part: P,
    pub(crate) clear: f64,
}

impl<P> Ord for Piece<P> {
    fn cmp(&self, other: &Self) -> Ordering {
        other.clear.total_cmp(&self.clear)
    }
}

impl<P> PartialOrd for Piece<P> {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl<P> PartialEq for Piece<P> {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other) == Ordering::Equal
    }
}

impl<P> Eq for Piece<P> {}

/// The cuts of one search.
#[derive(Debug)]
pub(crate) struct Cuts {
    /// How many may still be made beyond those that every window may make.
    spare: u32,
    made: u32,
}

impl Cuts {
    pub(crate) const fn new() -> Self {
        Self { spare: SPARE, made: 0 }
    }

    /// How many were made.
    pub(crate) const fn made(&self) -> u32 {
        self.made
    }

    /// How long all of some pieces stay clear, s, at most `window`: the one that fails first is cut (`cut` adds its parts
    /// to a list) until all are clear for the whole window, cutting gains no more or there are no cuts left.
    pub(crate) fn clear<P>(
        &mut self,
        pieces: Vec<Piece<P>>,
        window: f64,
        mut cut: impl FnMut(&P, &mut Vec<Piece<P>>),
    ) -> f64 {
        let mut pieces = BinaryHeap::from(pieces);
        let mut parts = Vec::new();
        let most = MOST.min(EACH + self.spare);
        let mut made = 0;
        while made < most {
            let Some(Piece { part, clear }) = pieces.peek().filter(|worst| worst.clear < window) else { break };
            cut(part, &mut parts);
            made += 1;
            let better = parts.iter().map(|piece| piece.clear).fold(f64::INFINITY, f64::min);
            let enough = *clear > 0.0 && better < GAIN * clear;
            pieces.pop();
            pieces.extend(parts.drain(..));
            if enough {
                break;
            }
        }
        self.made = self.made.saturating_add(made);
        self.spare -= made.saturating_sub(EACH);
        pieces.peek().map_or(window, |worst| worst.clear.min(window))
    }
}
