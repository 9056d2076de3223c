//! The point of a curve nearest to another one: its foot.
//!
//! A span is at most its sagitta from its chord, so that distances from chords bound those from spans; balls around
//! some spans that follow each other say which need no look at all. In each span that may hold the
//! nearest point the foot is the zero of `g(u) = (p - c(u)).c'(u)`, by Newton's iteration within a bracket. Of all feet
//! the nearest is taken, of equal ones the first. So it depends on the point alone, and not on what was asked before.

use super::piecewise::Curve;
use super::place::CurvePoint;
use super::span::{Block, Span};
use glam::DVec3;

/// Newton's iteration ends when it changes the parameter by less than this part of it and of its range (no unit):
/// rounding.
const STEP_RELATIVE: f64 = 4.0 * f64::EPSILON;

/// A foot in a span.
#[derive(Debug, Clone, Copy)]
struct Foot {
    span: usize,
    u: f64,
    distance: f64,
}

impl Curve {
    /// The place nearest to a point (m). Beyond the ends of an open curve it lies on the straight continuation.
    pub fn nearest(&self, to: DVec3) -> CurvePoint {
        let to_chord = |span: &Span| distance_from_chord(to, span.start, span.end);
        let farthest_in = |block: &Block| {
            let own = self.spans[block.range.clone()].iter();
            own.fold(f64::INFINITY, |least, span| (to_chord(span) + span.sagitta).min(least))
        };
        let first = self.blocks.iter().min_by(|x, y| x.least_distance(to).total_cmp(&y.least_distance(to)));
        let from_first = first.map_or(f64::INFINITY, farthest_in);
        // What is skipped is farther than something else.
        let near = || self.blocks.iter().filter(|block| !block.is_farther(to, from_first));
        let nearest = near().map(farthest_in).fold(from_first, f64::min);
        let mut best: Option<Foot> = None;
        for number in near().flat_map(|block| block.range.clone()) {
            let span = &self.spans[number];
            if to_chord(span) - span.sagitta > nearest {
                continue;
            }
            let foot = self.foot_in(number, to);
            if best.is_none_or(|best| foot.distance < best.distance) {
                best = Some(foot);
            }
        }
        // Only a point that is not finite has no foot.
        let Foot { span, u, .. } = best.unwrap_or(Foot { span: 0, u: self.spans[0].from, distance: f64::NAN });
        self.beyond_end(to, span, u).unwrap_or_else(|| self.at_parameter(span, u))
    }

    /// The place on the straight continuation, if a foot at the end of an open curve is beyond it.
    fn beyond_end(&self, to: DVec3, number: usize, u: f64) -> Option<CurvePoint> {
        let span = &self.spans[number];
        let is_start = number == 0 && u <= span.from;
        let is_end = number + 1 == self.spans.len() && u >= span.to;
        if self.is_closed || !(is_start || is_end) {
            return None;
        }
        let end = self.at_parameter(number, u);
        let beyond = end.tangent.dot(to - end.point);
        let is_beyond = if is_start { beyond < 0.0 } else { beyond > 0.0 };
        is_beyond.then(|| CurvePoint {
            point: end.point + end.tangent * beyond,
            curvature: DVec3::ZERO,
            curvature_rate: DVec3::ZERO,
            arc: if is_start { beyond } else { self.length + beyond },
            ..end
        })
    }

    /// The foot in a span, or its nearer end.
    fn foot_in(&self, number: usize, to: DVec3) -> Foot {
        let span = &self.spans[number];
        let piece = &self.stretches[span.piece].piece;
        let at = |u: f64| piece.at(u, span.known());
        let g = |u: f64| {
            let jet = at(u);
            let way = to - jet.point;
            (way.dot(jet.first), way.dot(jet.second) - jet.first.length_squared())
        };
        let found = |u: f64| Foot { span: number, u, distance: (to - at(u).point).length() };
        let (at_start, at_end) = (g(span.from).0, g(span.to).0);
        if at_start <= 0.0 {
            return found(span.from);
        }
        if at_end >= 0.0 {
            return found(span.to);
        }
        let (mut low, mut high) = (span.from, span.to);
        let mut u = low + (high - low) * (at_start / (at_start - at_end));
        // Each step replaces an end of the bracket by a place within it, near a simple zero by Newton's quadratic
        // steps: they end when a step is rounding of the parameter and of its range.
        loop {
            let (value, slope) = g(u);
            if value > 0.0 {
                low = u;
            } else if value < 0.0 {
                high = u;
            } else {
                break;
            }
            let newton = u - value / slope;
            let next = if newton > low && newton < high { newton } else { 0.5 * (low + high) };
            let change = (next - u).abs();
            u = next;
            if change <= STEP_RELATIVE * (u.abs() + (span.to - span.from)) {
                break;
            }
        }
        found(u)
    }
}

/// Distance of a point from the segment of two others, m.
fn distance_from_chord(point: DVec3, start: DVec3, end: DVec3) -> f64 {
    let (way, chord) = (point - start, end - start);
    let part = (way.dot(chord) / chord.length_squared()).clamp(0.0, 1.0);
    (way - chord * part).length()
}
