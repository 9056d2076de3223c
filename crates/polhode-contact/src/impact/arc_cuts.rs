//! Cutting what fails first: how long all parts of two bodies stay clear of each other, when the time that can be proved for
//! a part grows as the part shrinks.
//!
//! The part with the shortest time is replaced by smaller ones, until all parts are clear for the whole window or cutting
//! gains no more.

use std::cmp::Ordering;
use std::collections::BinaryHeap;

/// Cutting the arc that fails first must lengthen its time by this factor for another cut of it.
const GAIN: f64 = 1.25;

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

/// How long all of some pieces stay clear, s, at most `window`: the one that fails first is cut (`cut` adds its parts to a
/// list) until all are clear for the whole window or cutting gains no more, `most` times at most.
pub(crate) fn cut_worst<P>(
    pieces: Vec<Piece<P>>,
    (window, most): (f64, u32),
    mut cut: impl FnMut(&P, &mut Vec<Piece<P>>),
) -> f64 {
    let mut pieces = BinaryHeap::from(pieces);
    let mut parts = Vec::new();
    for _ in 0..most {
        let Some(Piece { part, clear }) = pieces.peek().filter(|worst| worst.clear < window) else { break };
        cut(part, &mut parts);
        let better = parts.iter().map(|piece| piece.clear).fold(f64::INFINITY, f64::min);
        let enough = *clear > 0.0 && better < GAIN * clear;
        pieces.pop();
        pieces.extend(parts.drain(..));
        if enough {
            break;
        }
    }
    pieces.peek().map_or(window, |worst| worst.clear.min(window))
}
