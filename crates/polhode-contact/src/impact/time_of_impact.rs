//! Time of impact: the first time at which two moving shapes, clear (separated) before, touch.
//!
//! Conservative advancement on the true motion (docs/REFERENCES.md, Mirtich 1996): from a time at which the pair is
//! clear, second-order bounds (`impact_bounds.rs`) along the best separating axes give a time for which it certainly
//! stays clear. The search advances by this time and evaluates the separation again. Near a touch at which the bodies
//! approach, the remaining time decreases quadratically, so that a few evaluations bring the separation to rounding
//! ([`crate::clearance::resolution`]). The time found is never late, except for rounding, and no touch is missed,
//! however fast the bodies spin. For motions in closed form it is more accurate than the rounded poses
//! (`fine_time.rs`). For a torus the distance is that of `narrow_phase/axis/ring.rs`, with the limits stated there.
//!
//! Two shapes without parts are searched in `pair_impact.rs`; compounds and meshes are searched part by part
//! (`composite_impact.rs`).
//!
//! A pair that touches at the start (separation up to [`crate::clearance::touch_tolerance`]) has no gap to bound. The
//! search then evaluates the separation at the times `t0 + (t1 - t0) 2^-j`:
//!
//! - From the first of these times at which the pair is clear and the rigorous search advances by a fair part of the
//!   time since the start (`LEAST_PROGRESS`), it continues. Before, the separation grows so slowly that bounds of
//!   second order cannot tell it from a touch: the touch goes on.
//! - If the pair overlaps by more than the tolerance at one of them, the start of this overlap is bracketed and
//!   located.
//! - At the end of the interval, and before the pair separates again, an overlap by a small part of the tolerance
//!   (`CLOSED` in `pair_impact.rs`) already counts as an impact. At the end, the next search would take the overlap as
//!   its start; before a separation, no later time would show that the pair has touched.
//! - A pair that neither separates nor overlaps has no impact.
//!
//! Between these times the search is not rigorous: a pair that separates and touches again between two of them is
//! missed.

use crate::Shape;
use crate::impact::composite_impact::{Parts, find_composite};
use crate::impact::pair_impact::find_in_parts;
use crate::narrow_phase::dispatch::separation::separation_with;
use crate::narrow_phase::dispatch::workspace::Workspace;
use crate::narrow_phase::parts::compound_pair::is_composite;
use polhode_spatial::Motion;

pub use crate::impact::impact_error::ImpactError;
pub use crate::impact::impact_report::ImpactReport;
pub use crate::impact::impact_search::ImpactSearch;

/// First time in `(t0, t1]` (s) at which the pair, clear before, touches; none without an impact.
///
/// # Errors
/// See [`ImpactError`].
pub fn time_of_impact(
    shape_a: &Shape,
    motion_a: &dyn Motion,
    shape_b: &Shape,
    motion_b: &dyn Motion,
    t0: f64,
    t1: f64,
    settings: &ImpactSearch,
) -> Result<Option<f64>, ImpactError> {
    search([shape_a, shape_b], [motion_a, motion_b], (t0, t1), settings, Parts::All).map(|report| report.time)
}

/// As [`time_of_impact`], with the separation and the amount of work.
///
/// # Errors
/// See [`ImpactError`].
pub fn find_impact(
    shape_a: &Shape,
    motion_a: &dyn Motion,
    shape_b: &Shape,
    motion_b: &dyn Motion,
    t0: f64,
    t1: f64,
    settings: &ImpactSearch,
) -> Result<ImpactReport, ImpactError> {
    let (shapes, motions) = ([shape_a, shape_b], [motion_a, motion_b]);
    let mut report = search(shapes, motions, (t0, t1), settings, Parts::All)?;
    if report.time.is_none() && shapes.into_iter().any(is_composite) {
        let end = motions.map(|motion| motion.pose(t1));
        report.separation = separation_with(&mut Workspace::default(), shape_a, &end[0], shape_b, &end[1]);
        report.evaluations = report.evaluations.saturating_add(1);
    }
    Ok(report)
}

/// The impact and the separation there; without an impact the separation at the end of the interval, for shapes without
/// parts only.
fn search(
    shapes: [&Shape; 2],
    motions: [&dyn Motion; 2],
    (t0, t1): (f64, f64),
    settings: &ImpactSearch,
    parts: Parts,
) -> Result<ImpactReport, ImpactError> {
    if !(t0.is_finite() && t1.is_finite() && t0 <= t1) {
        return Err(ImpactError::Interval { t0, t1 });
    }
    if shapes.into_iter().any(is_composite) {
        return find_composite(shapes, motions, (t0, t1), settings, parts);
    }
    match parts {
        Parts::All => find_in_parts(shapes, shapes, motions, (t0, t1), settings),
        Parts::Clear => Ok(ImpactReport { time: None, separation: f64::INFINITY, evaluations: 0, cuts: 0 }),
    }
}

/// First time in `(t0, t1]` (s) at which two parts that are clear of each other at `t0` touch while their bodies
/// approach. It is for bodies that stay in contact with other parts, at least one body a compound or a triangle mesh;
/// for other shapes there is no such time.
///
/// # Errors
/// See [`ImpactError`].
pub fn time_of_further_impact(
    shape_a: &Shape,
    motion_a: &dyn Motion,
    shape_b: &Shape,
    motion_b: &dyn Motion,
    t0: f64,
    t1: f64,
    settings: &ImpactSearch,
) -> Result<Option<f64>, ImpactError> {
    search([shape_a, shape_b], [motion_a, motion_b], (t0, t1), settings, Parts::Clear).map(|report| report.time)
}
