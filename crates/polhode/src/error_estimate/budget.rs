//! What references may take of the work of a run.

use crate::scene::ErrorEstimation;

/// Units of work (`crate::model::work`) that references may take at once, however short the run is: a part of what a
/// program takes to read a scene and start.
const CREDIT: f64 = 800.0;

/// Part of what they may take in the rest of the run that references may take before (no unit, 0 to 0.3): to begin
/// costs more than to go on.
const AHEAD: f64 = 0.15;

/// Part of the run that it has come through at least when its rest is foreseen (no unit, 0.001 to 0.1).
const FORESEEN_AFTER: f64 = 0.01;

/// Comparisons that a reference must be able to make, at the cost of the last one of its kind, to begin.
pub(crate) const LEAST_COMPARISONS: f64 = 8.0;

/// What references may have taken by now, in units of work.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Allowed {
    /// Those that are to begin.
    pub(crate) at_once: f64,
    /// Those that run.
    pub(crate) ahead: f64,
    /// What they may take in the rest of the run, besides.
    pub(crate) of_rest: f64,
}

/// What references may have taken when the run has taken `own` units, so many of them to begin, and has come through
/// this part of its duration.
pub(crate) fn allowed(effort: ErrorEstimation, (own, beginning): (u64, u64), part: f64) -> Allowed {
    let at_once = effort.share() * own as f64 + CREDIT;
    let part = part.max(FORESEEN_AFTER);
    let rest = effort.share() * own.saturating_sub(beginning) as f64 * ((1.0 - part) / part).max(0.0);
    Allowed { at_once, ahead: at_once + AHEAD * rest, of_rest: rest }
}
