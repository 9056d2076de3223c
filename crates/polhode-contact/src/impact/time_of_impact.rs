//! Time of impact: the first time at which two moving shapes close from clear to touching.
//!
//! Conservative advancement on the true motion (docs/REFERENCES.md, Mirtich 1996): from a time at which the pair is
//! clear, second-order bounds (`impact_bounds.rs`) along the best separating axes say for how long it certainly stays
//! clear; the search goes there and looks again. Near a touch at which the bodies approach, the remaining time falls
//! quadratically, so that a handful of evaluations brings the separation to rounding ([`crate::clearance::resolution`]).
//! The time found, of motions in closed form finer than poses are rounded (`fine_time.rs`), is never late but for the rounding, and no touch is missed, however fast the bodies spin.
//! Of a torus the distance is as `narrow_phase/axis/ring.rs` finds it.
//! Two shapes without parts are searched in `pair_impact.rs`; compounds and meshes go part by part (`composite_impact.rs`).
//!
//! A pair that touches at the start (separation up to [`crate::clearance::touch_tolerance`]) has no gap to bound. Its
//! departure is looked for at the times `t0 + (t1 - t0) 2^-j`; from the first at which it is clear the rigorous search
//! goes on, and if it overlaps at one of them by more than the tolerance, the time at which it began to is bracketed and
//! located. At the end of the interval, and where the pair opens again, a smaller overlap counts, a part of the tolerance
//! (`CLOSED`): at the end because the next search would take the overlap for its start, and before an opening because nothing
//! later shows that the pair met. A pair that neither clears nor overlaps has no impact. Between these times this start is not rigorous: a pair
//! that leaves and comes back between two of them is not seen.

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

/// First time in `(t0, t1]` at which the pair closes from clear to touching.
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
    search([shape_a, shape_b], [motion_a, motion_b], (t0, t1), settings).map(|report| report.time)
}

/// As [`time_of_impact`], with the work it took.
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
    let mut report = search(shapes, motions, (t0, t1), settings)?;
    if report.time.is_none() && shapes.into_iter().any(is_composite) {
        let end = motions.map(|motion| motion.pose(t1));
        report.separation = separation_with(&mut Workspace::default(), shape_a, &end[0], shape_b, &end[1]);
        report.evaluations = report.evaluations.saturating_add(1);
    }
    Ok(report)
}

/// The impact, and the separation there; that at the end of the interval only of shapes of one part each.
fn search(
    shapes: [&Shape; 2],
    motions: [&dyn Motion; 2],
    (t0, t1): (f64, f64),
    settings: &ImpactSearch,
) -> Result<ImpactReport, ImpactError> {
    if !(t0.is_finite() && t1.is_finite() && t0 <= t1) {
        return Err(ImpactError::Interval { t0, t1 });
    }
    if shapes.into_iter().any(is_composite) {
        return find_composite(shapes, motions, (t0, t1), settings, Parts::All);
    }
    find_in_parts(shapes, shapes, motions, (t0, t1), settings)
}

/// First time in `(t0, t1]` at which parts that are clear of each other at `t0` close and their bodies approach: for bodies
/// that touch with other parts of theirs all along, of which one at least is a compound or a triangle mesh. Others have
/// one part each, and there is no such time.
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
    let (shapes, motions) = ([shape_a, shape_b], [motion_a, motion_b]);
    if !(t0.is_finite() && t1.is_finite() && t0 <= t1) {
        return Err(ImpactError::Interval { t0, t1 });
    }
    if !shapes.into_iter().any(is_composite) {
        return Ok(None);
    }
    find_composite(shapes, motions, (t0, t1), settings, Parts::Clear).map(|report| report.time)
}
