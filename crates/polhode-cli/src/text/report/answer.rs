//! The first lines of a report: did the run end, is it right, what limits it, what to do; and its warnings.

use super::comparisons;
use super::ended::Ended;
use super::limits::{cure, limit, worst};
use super::words::{about, name};
use crate::text::table::{Table, number};
use polhode::{ErrorEstimation, ReferenceKind, RunReport};
use polhode_scene::names;

/// One line for each answer. What is not to be said is left out.
pub(super) fn answer(ended: &Ended<'_>) -> String {
    let report = ended.report;
    let mut table = Table::default();
    table.row(["simulated", &simulated(report, ended.wall_s)]);
    table.row(["is it right", &right(report)]);
    if let Some(horizon_s) = report.error.horizon_s {
        let what = "rounding at the start has grown to a hundredth of a body by then";
        let t = number(horizon_s);
        table.row(["until when", &format!("what lies after t = {t} s is one of many outcomes: {what}")]);
    }
    if let Some(compared) = comparisons::in_a_line(&report.error, report.simulated_s) {
        table.row(["compared with", &compared]);
    }
    if let Some(limit) = limit(report) {
        table.row(["what limits it", &limit]);
    }
    if let Some(cure) = cure(report) {
        table.row(["what to do", &cure]);
    }
    table.print()
}

/// How far the run has come, and how it ended.
fn simulated(report: &RunReport, wall_s: f64) -> String {
    let (simulated, duration) = (number(report.simulated_s), number(report.duration_s));
    let outcome = names::outcome(report.outcome);
    format!("{simulated} of {duration} s, {outcome}; it took {} s of wall time", about(wall_s))
}

/// To how much the run is right, by which body, and when; why that is not known where it is not.
fn right(report: &RunReport) -> String {
    let Some(largest) = report.error.largest else {
        return format!("not known: {}", why_not(report));
    };
    let (position, rotation) = (largest.error.position_m, largest.error.rotation_rad);
    let parts = [(position, "m"), (rotation, "rad")].into_iter().filter(|&(error, _)| error != 0.0);
    let parts: Vec<String> = parts.map(|(error, unit)| format!("{} {unit}", about(error))).collect();
    if largest.relative == 0.0 || parts.is_empty() {
        return "yes: it does not differ from what it was compared with".to_owned();
    }
    let error = format!("estimated error {} of a body's size", about(largest.relative));
    let farthest = format!(
        "farthest off is {}, by {} at t = {} s",
        name(report, largest.body),
        parts.join(" and "),
        number(largest.t_s)
    );
    let limit = number(report.plan.promise.error);
    match report.error.exceeds_s {
        Some(t_s) => {
            format!("no: {error}, where {limit} is promised, beyond it from t = {} s on; {farthest}", number(t_s))
        }
        None if is_compared(report) => format!("yes: {error}, where {limit} is promised; {farthest}"),
        None => format!("yes, as far as it was compared: {error}, where {limit} is promised; {farthest}"),
    }
}

/// Whether the run was compared with another one for most of its time.
fn is_compared(report: &RunReport) -> bool {
    let of_run = |kind: ReferenceKind| kind != ReferenceKind::Disturbed;
    let covered = report.error.references.iter().filter(|own| of_run(own.kind)).map(|own| own.covered_s);
    2.0 * covered.sum::<f64>() >= report.simulated_s
}

/// Why an error is not known.
fn why_not(report: &RunReport) -> String {
    let error = &report.error;
    if error.estimation == ErrorEstimation::Off {
        return "the error was not estimated (--error off)".to_owned();
    }
    let failed = error.references.iter().filter_map(|reference| {
        let why = reference.ended.as_ref()?;
        Some(format!("{} ({}): {why}", reference.kind.name(), reference.method))
    });
    let failed: Vec<String> = failed.collect();
    if failed.is_empty() {
        "the run was too short to compare it with another one".to_owned()
    } else {
        format!("no run beside it came far enough: {}", failed.join("; "))
    }
}

/// What is to be known of the run before its numbers. What the first lines have said already is left out.
pub(super) fn warnings(report: &RunReport) -> String {
    let said = worst(report).map(ToString::to_string);
    let warnings: Vec<&String> = report.warnings.iter().filter(|warning| said.as_ref() != Some(*warning)).collect();
    let mut lines: Vec<String> = warnings.iter().map(|warning| format!("warning: {warning}\n")).collect();
    // What is tolerated is a warning too, where it is worth one.
    let tolerated = report.tolerated.iter().map(ToString::to_string);
    let tolerated = tolerated.filter(|tolerated| !report.warnings.contains(tolerated));
    lines.extend(tolerated.map(|tolerated| format!("tolerated: {tolerated}\n")));
    lines.extend(report.choices.iter().map(|choice| format!("chosen: {choice}\n")));
    lines.concat()
}
