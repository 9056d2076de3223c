//! What is known of the error of a run so far: plain data, which a snapshot holds as they are.

use super::growth::Growth;
use crate::identity::body_id::BodyId;
use crate::report::run_error::{BodyError, LargestError, ReferenceKind, ReferenceReport};
use serde::{Deserialize, Serialize};

/// What is known of the references of one kind.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub(crate) struct OfKind {
    /// By which method and steps, in words.
    pub(crate) method: String,
    /// References begun.
    pub(crate) begun: u32,
    /// Whether one has failed.
    pub(crate) has_failed: bool,
    /// How long they have run, s.
    pub(crate) covered_s: f64,
    /// The largest distance of a body from them, of its size.
    pub(crate) largest: f64,
    /// Why the last one ended, in words.
    pub(crate) ended: Option<String>,
    /// Units of work of those that have ended, and of the last one in a second of motion.
    pub(crate) spent: u64,
    pub(crate) per_second: f64,
}

/// The largest error so far.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
struct Largest {
    relative: f64,
    error: BodyError,
    body: usize,
    t_s: f64,
}

/// What pieces by another method say of the errors of the bodies.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub(crate) struct Pieces {
    /// The errors at the last comparison; empty before the first piece.
    pub(crate) errors: Vec<BodyError>,
    /// What contact has added to them in the time that was covered, per second.
    rates: Vec<BodyError>,
    /// Events of the run at the last comparison.
    pub(crate) events: u64,
    /// Whether bodies have met or touched since the comparison before.
    pub(crate) had_contact: bool,
}

impl Pieces {
    /// Notes the end of a piece, which has found these errors, so much of them since it began; `length_s` seconds of
    /// `covered_s` were its own.
    pub(crate) fn note_end(&mut self, errors: Vec<BodyError>, since: &[BodyError], (length_s, covered_s): (f64, f64)) {
        self.errors = errors;
        if length_s <= 0.0 {
            return;
        }
        self.rates.resize(since.len(), BodyError::default());
        let before_s = (covered_s - length_s).max(0.0);
        for (rate, since) in self.rates.iter_mut().zip(since) {
            *rate = rate.times(before_s).plus(*since).times(1.0 / (before_s + length_s));
        }
    }

    /// The errors of so many bodies a time (s) after the last comparison, over which no piece has run: the motion has
    /// amplified them by `growth`, and where there was contact it has added as much as in the pieces. None before the
    /// first one.
    pub(crate) fn grown(&self, growth: f64, since_s: f64, bodies: usize) -> Option<Vec<BodyError>> {
        let in_contact_s = if self.had_contact { since_s } else { 0.0 };
        (!self.errors.is_empty()).then(|| grown((&self.errors, growth), (&self.rates, in_contact_s), bodies))
    }
}

/// So many errors, amplified, and what was added to them at these rates (per second) in a time (s).
fn grown((errors, growth): (&[BodyError], f64), (rates, time_s): (&[BodyError], f64), bodies: usize) -> Vec<BodyError> {
    let of = |list: &[BodyError], body: usize| list.get(body).copied().unwrap_or_default();
    (0..bodies).map(|body| of(errors, body).times(growth).plus(of(rates, body).times(time_s))).collect()
}

/// The error of a run so far.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub(crate) struct Course {
    /// Whether the first references have been begun.
    pub(crate) has_begun: bool,
    /// When they began, s.
    pub(crate) start_s: f64,
    /// Units of work that the beginning of the run took.
    pub(crate) beginning: u64,
    /// When the run was compared last, and when it is to be compared next, s.
    pub(crate) compared_s: f64,
    pub(crate) next_s: f64,
    /// Where the bodies were when the first references began, m.
    pub(crate) start: Vec<[f64; 3]>,
    /// Errors of the bodies at the last comparison, and how fast they grew in the last piece, per second.
    pub(crate) errors: Vec<BodyError>,
    pub(crate) rates: Vec<BodyError>,
    pub(crate) pieces: Pieces,
    largest: Option<Largest>,
    /// When an error first exceeded what is promised, s.
    pub(crate) exceeds_s: Option<f64>,
    /// By the number of the kind.
    kinds: [OfKind; ReferenceKind::ALL.len()],
    pub(crate) growth: Growth,
}

impl Course {
    /// Whether the first references began at this time (s).
    pub(crate) fn has_begun_at(&self, t: f64) -> bool {
        self.has_begun && self.start_s == t
    }

    /// What is known of a kind.
    pub(crate) fn of(&self, kind: ReferenceKind) -> &OfKind {
        &self.kinds[kind as usize]
    }

    /// The same, to be changed.
    pub(crate) fn of_mut(&mut self, kind: ReferenceKind) -> &mut OfKind {
        &mut self.kinds[kind as usize]
    }

    /// Units of work of the references that have ended.
    pub(crate) fn spent(&self) -> u64 {
        self.kinds.iter().map(|own| own.spent).sum()
    }

    /// The errors of so many bodies a time (s) after the last comparison, over which no reference has run: the motion
    /// has amplified them by `growth`.
    pub(crate) fn grown(&self, growth: f64, since_s: f64, bodies: usize) -> Vec<BodyError> {
        grown((&self.errors, growth), (&self.rates, since_s), bodies)
    }

    /// The errors of the bodies at `t` (s), of bodies of these sizes (m), of which so much is promised, relative to
    /// their sizes.
    pub(crate) fn note(&mut self, t: f64, errors: Vec<BodyError>, sizes: &[f64], promised: f64) {
        if self.growth.horizon_s.is_none_or(|horizon| t < horizon) {
            for (body, (error, &size)) in errors.iter().zip(sizes).enumerate() {
                let relative = error.of_size(size);
                if self.largest.is_none_or(|largest| relative > largest.relative) {
                    self.largest = Some(Largest { relative, error: *error, body, t_s: t });
                }
                if relative > promised {
                    self.exceeds_s = self.exceeds_s.or(Some(t));
                }
            }
        }
        self.errors = errors;
        self.compared_s = t;
    }

    /// The largest error so far.
    pub(crate) fn largest(&self) -> Option<LargestError> {
        self.largest.map(|Largest { relative, error, body, t_s }| LargestError {
            relative,
            error,
            body: BodyId::new(body),
            t_s,
        })
    }

    /// What a report says of the references that have been begun, by a run that has taken `own` units of work, beside
    /// which those of each kind that run now have taken so many.
    pub(crate) fn references(&self, own: u64, running: impl Fn(ReferenceKind) -> u64) -> Vec<ReferenceReport> {
        let report = |kind: ReferenceKind| {
            let OfKind { method, covered_s, largest, ended, spent, .. } = self.of(kind).clone();
            let work = (spent + running(kind)) as f64 / own.max(1) as f64;
            ReferenceReport { kind, method, covered_s, work, largest_distance: largest, ended }
        };
        let told = |kind: &ReferenceKind| self.of(*kind).begun > 0 || self.of(*kind).ended.is_some();
        ReferenceKind::ALL.into_iter().filter(told).map(report).collect()
    }
}
