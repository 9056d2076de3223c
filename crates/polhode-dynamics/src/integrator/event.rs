//! Location of events: the first time within a step at which a function of the states changes its sign.
//!
//! The step is sampled at [`SAMPLES`] + 1 equally spaced times; the first interval whose ends have different signs is
//! closed in by ITP: each estimate is the secant's, moved towards the middle and held within a range that shrinks as
//! bisection would, so that it needs at most one evaluation more than bisection and few for a smooth function.
//! Source: docs/REFERENCES.md, Oliveira and Takahashi 2021. How it fails: two changes of sign between neighbouring
//! samples are not seen; a jump through zero is located like a zero.

use super::{IntegrationError, Integrator};
use crate::{BodyState, FreeMotion};

/// Width to which an event is closed in, relative to the step: a hundred times the rounding of a time within it.
pub const RESOLUTION: f64 = 1e-13;

/// Closest times that can be told apart, relative to the time: two roundings.
const SPACING: f64 = 2.0 * f64::EPSILON;

/// Intervals of a step that are looked at for a change of sign: an oscillation of the function with a period above an
/// eighth of the step is seen whole.
pub const SAMPLES: u32 = 16;

/// ITP's parameters: how far the estimate moves to the middle, `K1 |b - a|^2 / (b0 - a0)`, and by how many evaluations
/// it may fall behind bisection.
const K1: f64 = 0.2;
const SLACK: f64 = 1.0;

/// A function of time (s) and states whose change of sign is the event.
pub type EventFunction<'f> = dyn FnMut(f64, &[BodyState]) -> f64 + 'f;

/// The first time after `from` (s, the start of the integrator's last step, or a time within it) and up to
/// [`Integrator::time`] at which `event` has changed its sign, within [`RESOLUTION`] of the step or the rounding of the
/// time; nothing when it does
/// not. At the time returned `event` is zero or has its new sign, so that a search from there does not find it again.
/// A zero at `from` itself is no event. The states come from [`Integrator::states_within`], to the method's order.
///
/// # Errors
/// Those of [`Integrator::states_within`], and [`IntegrationError::NotFinite`] when `event` gives NaN.
pub fn locate(
    integrator: &mut dyn Integrator,
    motion: &FreeMotion<'_>,
    from: f64,
    event: &mut EventFunction<'_>,
) -> Result<Option<f64>, IntegrationError> {
    let to = integrator.time();
    let mut states = integrator.states().to_vec();
    let mut value = |t: f64| -> Result<f64, IntegrationError> {
        integrator.states_within(motion, t, &mut states)?;
        let y = event(t, &states);
        if y.is_nan() { Err(IntegrationError::NotFinite { t }) } else { Ok(y) }
    };
    let mut last = (from, value(from)?);
    for k in 1..=SAMPLES {
        let t = if k == SAMPLES { to } else { from + (to - from) * (f64::from(k) / f64::from(SAMPLES)) };
        let next = (t, value(t)?);
        if last.1 != 0.0 && next.1 * last.1.signum() <= 0.0 {
            let width = (RESOLUTION * (to - from).abs()).max(SPACING * from.abs().max(to.abs()));
            return close_in(last, next, width, &mut value).map(Some);
        }
        last = next;
    }
    Ok(None)
}

/// The end of the bracket that has the new sign, when the bracket is as narrow as `width` (s): after at most [`SLACK`]
/// evaluations more than bisection needs.
fn close_in(
    start: (f64, f64),
    end: (f64, f64),
    width: f64,
    value: &mut dyn FnMut(f64) -> Result<f64, IntegrationError>,
) -> Result<f64, IntegrationError> {
    let (mut a, mut b) = (start, end);
    let span = (b.0 - a.0).abs();
    let halvings = libm::ceil(libm::log2((span / width).max(1.0))) + SLACK;
    let mut reach = 0.5 * width * libm::exp2(halvings);
    loop {
        let gap = (b.0 - a.0).abs();
        if gap <= width || b.1 == 0.0 {
            return Ok(b.0);
        }
        let inside = estimate(a, b, K1 * gap * gap / span, reach - 0.5 * gap);
        // A secant that all but hits an end is moved off it, to where the other side of the zero must be.
        let margin = 0.5 * width * (b.0 - a.0).signum();
        let t = if (inside - a.0).abs() < margin.abs() {
            a.0 + margin
        } else if (b.0 - inside).abs() < margin.abs() {
            b.0 - margin
        } else {
            inside
        };
        reach *= 0.5;
        // No time is left between the ends.
        if t == a.0 || t == b.0 {
            return Ok(b.0);
        }
        let y = value(t)?;
        if y * a.1.signum() > 0.0 {
            a = (t, y);
        } else {
            b = (t, y);
        }
    }
}

/// ITP's next time: interpolate, truncate by `truncation`, project to within `radius` of the middle.
fn estimate(a: (f64, f64), b: (f64, f64), truncation: f64, radius: f64) -> f64 {
    let middle = a.0 + 0.5 * (b.0 - a.0);
    let secant = a.0 + (b.0 - a.0) * (a.1 / (a.1 - b.1));
    let towards = (middle - secant).signum();
    let moved = if truncation <= (middle - secant).abs() { secant + towards * truncation } else { middle };
    // Written so that NaN (infinite values at both ends) falls to the middle.
    if (moved - middle).abs() <= radius {
        moved
    } else if secant.is_finite() {
        middle - towards * radius.max(0.0)
    } else {
        middle
    }
}
