//! Walls: bodies thrown at walls of any azimuth, and bodies that touch one without pressing, against closed forms.
//!
//! What bears no normal force is held by no friction, at once or later. The scenes and their closed forms are in
//! `random_throws`; a run must end well, with the state of the closed form, and with forces within the cones of
//! friction.

use super::random_throws::Throw;
use super::{CaseResult, Context, Run};
use crate::row::Row;
use polhode::{Effects, Outcome};

const CASE: &str = "walls";

/// Throws of a full run.
const THROWS: usize = 4000;

/// Largest error of a state, m, m/s and rad/s: bodies of some 0.1 m to 1 m, speeds of some m/s.
const ERROR: f64 = 1e-9;

/// All rows.
pub(super) fn rows(context: &Context) -> CaseResult {
    let count = context.amount.of(THROWS);
    let (mut largest, mut worst, mut ill, mut violation) = (0.0, String::new(), Vec::new(), 0.0f64);
    for seed in 0..count as u64 {
        let throw = Throw::random(seed)?;
        let name = || format!("{} (throw {seed})", throw.name);
        let run = match Run::of(&throw.scene, Effects::Planned) {
            Ok(run) => run,
            Err(error) => {
                ill.push(format!("{}: {error}", name()));
                continue;
            }
        };
        let error = throw.error(&run.last("body")?);
        if error > largest {
            (largest, worst) = (error, name());
        }
        if run.report.outcome != Outcome::Completed {
            ill.push(name());
        }
        violation = violation.max(run.report.certificate.max_friction_violation_of_limit);
    }
    let largest_error = format!("{count} throws: largest error of a state, m, m/s, rad/s; {worst}");
    Ok(vec![
        Row::at_most(CASE, &largest_error, ERROR, largest),
        Row::exact(CASE, &format!("{count} throws: those that do not end well"), "none", none_or(&ill)),
        Row::at_most(CASE, &format!("{count} throws: violation of friction's law, of its limit"), 1.0, violation),
    ])
}

/// Some names in one line.
fn none_or(names: &[String]) -> String {
    if names.is_empty() { "none".to_owned() } else { names.join("; ") }
}
