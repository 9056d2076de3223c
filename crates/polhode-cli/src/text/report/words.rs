//! How numbers, bodies and places are told.

use crate::text::table::number;
use polhode::{BodyId, PairAt, RunReport};

/// Most bodies listed: more are for a file to hold.
pub(super) const MOST_BODIES: usize = 50;

/// A measured number in as many digits as say something: two.
pub(super) fn about(value: f64) -> String {
    format!("{value:.1e}").parse().map_or_else(|_| number(value), number)
}

/// The name of a body.
pub(super) fn name(report: &RunReport, body: BodyId) -> &str {
    report.bodies.get(body.index()).map_or("", |body| body.name.as_str())
}

/// Which bodies, and when.
pub(super) fn place(report: &RunReport, at: PairAt) -> String {
    let (a, b) = (name(report, at.body_a), name(report, at.body_b));
    // A joint with the world has one body.
    let bodies = if at.body_a == at.body_b { a.to_owned() } else { format!("{a} and {b}") };
    format!("{bodies} at t = {} s", number(at.t_s))
}

/// What is not listed.
pub(super) fn rest(count: usize, elsewhere: &str) -> String {
    if count > MOST_BODIES { format!("  and {} more: see {elsewhere}\n", count - MOST_BODIES) } else { String::new() }
}

pub(super) fn joule(value: f64) -> String {
    format!("{} J", number(value))
}
