//! The runs beside a run (which are an `S` too), and what is known by them.

use super::course::Course;
use crate::report::run_error::{BodyError, ReferenceKind};
use crate::scene::ErrorEstimation;
use polhode_dynamics::BodyState;

/// A run beside a run.
#[derive(Debug)]
pub(crate) struct Reference<S> {
    pub(crate) kind: ReferenceKind,
    pub(crate) run: Box<S>,
    /// The run with which a disturbed one is compared; none where that is the run itself or the one by other steps.
    pub(crate) partner: Option<Box<S>>,
    /// When it began, s.
    pub(crate) begun_s: f64,
    /// How many of its kind began before it.
    pub(crate) number: u32,
    /// Whether it began with the run.
    pub(crate) is_whole: bool,
    /// The errors of the bodies where it began.
    pub(crate) base: Vec<BodyError>,
    /// What its distance is multiplied by (no unit).
    pub(crate) weight: f64,
    /// How often it has been compared.
    pub(crate) comparisons: u32,
    /// The errors since then that its distance from the run says.
    pub(crate) since: Vec<BodyError>,
}

/// How a reference begins; the fields are those of [`Reference`].
#[derive(Debug)]
pub(crate) struct ReferenceBegin {
    pub(crate) begun_s: f64,
    pub(crate) number: u32,
    pub(crate) is_whole: bool,
    pub(crate) base: Vec<BodyError>,
    pub(crate) weight: f64,
}

impl<S> Reference<S> {
    /// Whether it is a piece by another method.
    pub(crate) fn is_piece_by_method(&self) -> bool {
        self.kind == ReferenceKind::OtherMethod && !self.is_whole
    }

    /// The errors of the bodies of the run that it says.
    pub(crate) fn errors(&self) -> Vec<BodyError> {
        let base = |body: usize| self.base.get(body).copied().unwrap_or_default();
        self.since.iter().enumerate().map(|(body, since)| base(body).plus(*since)).collect()
    }

    /// A reference that begins.
    pub(crate) fn new(kind: ReferenceKind, run: Box<S>, begin: ReferenceBegin) -> Self {
        let ReferenceBegin { begun_s, number, is_whole, base, weight } = begin;
        Self { kind, run, partner: None, begun_s, number, is_whole, base, weight, comparisons: 0, since: Vec::new() }
    }
}

/// How much of a run a reference accompanies.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Part {
    /// All of it, from its start.
    Whole,
    /// A piece.
    Piece,
}

/// Where references begin.
#[derive(Debug, Clone)]
pub(crate) struct StartOfRun {
    /// When, s.
    pub(crate) t_s: f64,
    pub(crate) states: Vec<BodyState>,
    /// Which bodies rested then.
    pub(crate) rested: Vec<bool>,
}

/// The runs beside a run.
#[derive(Debug)]
pub(crate) struct References<S> {
    pub(crate) effort: ErrorEstimation,
    /// The start of the run; none before it, and after an action of a program, which later runs would not repeat.
    pub(crate) start: Option<StartOfRun>,
    /// The run at the last comparison; none before it, and after an action.
    pub(crate) before: Option<StartOfRun>,
    pub(crate) running: Vec<Reference<S>>,
    pub(crate) course: Course,
    /// Errors of the bodies at the comparison before the last one; empty where there was none.
    pub(crate) errors_before: Vec<BodyError>,
}

impl<S> References<S> {
    /// None yet, for an estimate of this effort.
    pub(crate) fn new(effort: ErrorEstimation) -> Self {
        let (running, errors_before) = (Vec::new(), Vec::new());
        Self { effort, start: None, before: None, running, course: Course::default(), errors_before }
    }

    /// The whole reference by other steps.
    pub(crate) fn by_steps(&self) -> Option<&Reference<S>> {
        self.running.iter().find(|own| own.kind == ReferenceKind::OtherSteps && own.is_whole)
    }

    /// Whether a reference of this kind runs.
    pub(crate) fn runs(&self, kind: ReferenceKind) -> bool {
        self.running.iter().any(|own| own.kind == kind)
    }
}

impl<S> Default for References<S> {
    /// None, and no estimate.
    fn default() -> Self {
        Self::new(ErrorEstimation::Off)
    }
}
