//! Spans: parts of the pieces of a curve that turn by little, in which a nearest point is unique.

use super::error::CurveError;
use super::piece::{Jet, Stretch};
use glam::DVec3;
use std::ops::Range;

/// Most angle by which a span turns, rad (0.05 to 0.5): the nearest point to one within two radii of curvature is
/// unique there.
const MOST_TURNING: f64 = 0.25;

/// Arc lengths of a span as a whole and by halves agree to this part of it (no unit, 1e-15 to 1e-12).
const ARC_LENGTH_RELATIVE: f64 = 2e-15;

/// Most spans of a curve.
const MOST_SPANS: usize = 8_000;

/// Samples of the curvature within a span.
const CURVATURE_SAMPLES: u32 = 8;

/// By how much the curvature of a span may exceed that of its samples (no unit).
const CURVATURE_SAFETY: f64 = 1.25;

/// A speed below this part of that over the whole span is a cusp (no unit, 1e-9 to 1e-3).
const CUSP: f64 = 1e-6;

/// A part of a piece.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Span {
    /// Number of the piece.
    pub(super) piece: usize,
    /// Range of the parameter.
    pub(super) from: f64,
    pub(super) to: f64,
    /// Its ends, m.
    pub(super) start: DVec3,
    pub(super) end: DVec3,
    /// Arc length from the start of the curve to its start, m.
    pub(super) arc: f64,
    /// Its own arc length, m.
    pub(super) length: f64,
    /// Farthest distance of its points from its chord, at most, m.
    pub(super) sagitta: f64,
}

impl Span {
    /// A place of its piece at which the point is known.
    pub(super) fn known(&self) -> (f64, DVec3) {
        (self.from, self.start)
    }
}

/// How many spans a block has.
const BLOCK: usize = 8;

/// By how much the ball of a block is larger than its spans (no unit): rounding.
const BLOCK_SAFETY: f64 = 1.0 + 1e-9;

/// Some spans that follow each other, in a ball.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Block {
    pub(super) range: Range<usize>,
    center: DVec3,
    radius: f64,
}

impl Block {
    fn new(first: usize, spans: &[Span]) -> Self {
        let ends = || spans.iter().flat_map(|span| [span.start, span.end]);
        let low = ends().fold(DVec3::INFINITY, DVec3::min);
        let high = ends().fold(DVec3::NEG_INFINITY, DVec3::max);
        let center = (low + high) * 0.5;
        let to_ends = ends().fold(0.0, |most: f64, end| most.max((end - center).length()));
        let sagitta = spans.iter().fold(0.0, |most: f64, span| most.max(span.sagitta));
        Self { range: first..first + spans.len(), center, radius: (to_ends + sagitta) * BLOCK_SAFETY }
    }

    /// Distance of its spans from a point, at least, m: below zero where it may be in the ball.
    pub(super) fn least_distance(&self, to: DVec3) -> f64 {
        (to - self.center).length() - self.radius
    }

    /// Whether its spans are farther from a point than this distance (m).
    pub(super) fn is_farther(&self, to: DVec3, distance: f64) -> bool {
        self.least_distance(to) > distance
    }
}

/// The spans in blocks.
pub(super) fn blocks(spans: &[Span]) -> Vec<Block> {
    spans.chunks(BLOCK).enumerate().map(|(number, own)| Block::new(number * BLOCK, own)).collect()
}

/// The spans of a curve of these stretches, the first of which begins at `start` (m).
///
/// # Errors
/// When the curve has a cusp, or turns too often.
pub(super) fn spans(stretches: &[Stretch], start: DVec3) -> Result<Vec<Span>, CurveError> {
    let mut found = Vec::new();
    let (mut point, mut arc) = (start, 0.0);
    for (number, Stretch { piece, from, to }) in stretches.iter().enumerate() {
        point = piece.first_point(*from, point);
        // The last range is taken first.
        let mut open = vec![(*from, *to)];
        while let Some((from, to)) = open.pop() {
            let jet = |part: f64| piece.at(from + (to - from) * part, (from, point));
            let length = piece.arc_length((from, to));
            let middle = 0.5 * (from + to);
            let [first, second] = [(from, middle), (middle, to)].map(|half| piece.arc_length(half));
            let samples: Vec<Jet> =
                (0..=CURVATURE_SAMPLES).map(|k| jet(f64::from(k) / f64::from(CURVATURE_SAMPLES))).collect();
            let slowest = samples.iter().fold(f64::INFINITY, |least, jet| jet.speed().min(least));
            let curvature =
                samples.iter().fold(0.0, |most: f64, jet| most.max(jet.curvature().length())) * CURVATURE_SAFETY;
            let turning = curvature * length;
            let is_fine = turning <= MOST_TURNING && (first + second - length).abs() <= ARC_LENGTH_RELATIVE * length;
            if is_fine && slowest * (to - from) >= CUSP * length {
                let end = jet(1.0).point;
                let sagitta = 0.125 * curvature * length * length;
                found.push(Span { piece: number, from, to, start: point, end, arc, length, sagitta });
                (point, arc) = (end, arc + length);
                if found.len() > MOST_SPANS {
                    return Err(CurveError::TooWinding { most: MOST_SPANS });
                }
                continue;
            }
            if middle <= from || middle >= to || !length.is_finite() || open.len() > 60 {
                return Err(CurveError::Cusp { arc_m: arc });
            }
            open.push((middle, to));
            open.push((from, middle));
        }
    }
    Ok(found)
}
