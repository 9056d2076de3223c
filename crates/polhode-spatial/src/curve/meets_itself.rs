//! Whether a curve comes near itself: a point there would have two places on it.

use super::error::CurveError;
use super::piecewise::Curve;
use super::span::Span;
use glam::DVec3;

/// Least distance of two parts of a curve, as a part of its length (no unit, 1e-9 to 1e-3): far above the rounding of a
/// point that is held on it, and far below what a drawing shows.
const LEAST_DISTANCE: f64 = 1e-6;

/// Two places of a curve near each other.
#[derive(Debug, Clone, Copy)]
struct Meeting {
    distance_m: f64,
    /// Arc lengths, m.
    at_m: [f64; 2],
}

/// A part of a curve between two arc lengths, m.
#[derive(Debug, Clone, Copy)]
struct Part {
    from: f64,
    to: f64,
    start: DVec3,
    end: DVec3,
    sagitta: f64,
}

impl Part {
    fn halves(&self, curve: &Curve) -> [Self; 2] {
        let middle = self.middle_m();
        let point = curve.at(middle).point;
        let sagitta = 0.25 * self.sagitta;
        [Self { to: middle, end: point, sagitta, ..*self }, Self { from: middle, start: point, sagitta, ..*self }]
    }

    fn radius(&self) -> f64 {
        0.5 * (self.end - self.start).length() + self.sagitta
    }

    /// Arc length between the ends, m.
    fn middle_m(&self) -> f64 {
        0.5 * (self.from + self.to)
    }

    fn middle(&self) -> DVec3 {
        (self.start + self.end) * 0.5
    }
}

impl Curve {
    /// # Errors
    /// When two parts of the curve that do not follow each other are nearer than a millionth of its length.
    pub(super) fn check_distance_from_itself(&self) -> Result<(), CurveError> {
        let least_m = LEAST_DISTANCE * self.length;
        let part = |span: &Span| Part {
            from: span.arc,
            to: span.arc + span.length,
            start: span.start,
            end: span.end,
            sagitta: span.sagitta,
        };
        let parts: Vec<Part> = self.spans.iter().map(part).collect();
        let last = parts.len() - 1;
        for (i, first) in parts.iter().enumerate() {
            for (j, second) in parts.iter().enumerate().skip(i + 2) {
                if self.is_closed && i == 0 && j == last {
                    continue;
                }
                let found = self.near(first, second, least_m);
                if let Some(Meeting { distance_m, at_m: [first_m, second_m] }) = found {
                    return Err(CurveError::MeetsItself { distance_m, first_m, second_m, least_m });
                }
            }
        }
        Ok(())
    }

    /// A place at which two parts are nearer than `least` (m).
    fn near(&self, first: &Part, second: &Part, least: f64) -> Option<Meeting> {
        let distance = (first.middle() - second.middle()).length();
        let (a, b) = (first.radius(), second.radius());
        if distance - a - b > least {
            return None;
        }
        let (larger, middle) = if a >= b { (first, first.middle_m()) } else { (second, second.middle_m()) };
        // A part with no arc length between its ends is not halved.
        if a + b < 0.1 * least || !(middle > larger.from && middle < larger.to) {
            let at_m = [first, second].map(Part::middle_m);
            return Some(Meeting { distance_m: distance, at_m });
        }
        if a >= b {
            first.halves(self).iter().find_map(|half| self.near(half, second, least))
        } else {
            second.halves(self).iter().find_map(|half| self.near(first, half, least))
        }
    }
}
