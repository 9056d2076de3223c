//! The table for people.

use crate::text::{Table, number};
use polhode_study::candidate::Candidate;
use polhode_study::options::Counting;
use polhode_study::reference::{Kind, Reference};
use polhode_study::study::{Entry, Measured, Study, confirms};
use std::fmt::Write as _;

/// Reference, table, what was left out, and the candidate that reaches a target.
pub(super) fn page(study: &Study, target: Option<f64>) -> String {
    let mut page = format!("scene {}, {} s\n\n{}\n", study.scene, study.duration_s, notes(study));
    let mut table = Table::default();
    table.cells(columns(study));
    for entry in &study.entries {
        if let Ok(measured) = &entry.outcome {
            table.cells(row(study, entry, measured));
        }
    }
    if study.base.is_some() {
        page.push_str(&table.print());
        page.push_str(
            "  * on the Pareto front: none is both cheaper and more accurate (an error above 1 is no answer)\n",
        );
    }
    let failures = failures(study);
    if !failures.is_empty() {
        page.push_str(if study.base.is_some() { "\nnot in the table\n" } else { "none of the candidates ran\n" });
        let mut reasons = Table::default();
        for (names, reason) in failures {
            reasons.row([&names, &reason]);
        }
        page.push_str(&reasons.print());
    }
    if let Some(target) = target
        && let Some(entry) = study.cheapest(target)
    {
        let _ = write!(page, "\n{}\n\n{}", reached(study, entry, target), entry.candidate.toml());
    }
    page
}

/// What failed, and why: neighbours of one series that share a reason stand in one row.
fn failures(study: &Study) -> Vec<(String, String)> {
    let mut rows: Vec<(&Candidate, &Candidate, &String)> = Vec::new();
    for entry in &study.entries {
        let Err(reason) = &entry.outcome else { continue };
        match rows.last_mut() {
            Some((first, last, shared)) if first.series == entry.candidate.series && *shared == reason => {
                *last = &entry.candidate;
            }
            _ => rows.push((&entry.candidate, &entry.candidate, reason)),
        }
    }
    let names = |first: &Candidate, last: &Candidate| {
        if first == last { first.name() } else { format!("{} ... {}", first.name(), last.rung) }
    };
    rows.into_iter().map(|(first, last, reason)| (names(first, last), reason.clone())).collect()
}

/// What the numbers mean: reference, scales, unit of time.
pub(super) fn notes(study: &Study) -> String {
    let mut lines = Table::default();
    for (number_of, reference) in study.references.iter().enumerate() {
        let model: Vec<_> = reference.model.iter().map(|change| format!("{}={}", change.key, change.value)).collect();
        let of = if model.is_empty() { String::new() } else { format!(" of {}", model.join(" ")) };
        lines.row([&format!("reference{of}"), &described(reference)]);
        lines.row(["its own error", &format!("at most about {:.1e}: {}", reference.error, reference.basis)]);
        match study.closest_other(number_of) {
            Some((error, name)) if confirms(error) => {
                let what = format!("by {name} to {error:.1e}: the closest that integrates in another way");
                lines.row(["confirmed", &what]);
            }
            Some((error, name)) => {
                let what = format!("the closest that integrates in another way, {name}, differs by {error:.1e}");
                lines.row(["not confirmed", &what]);
            }
            None => {}
        }
    }
    if let Some(first) = study.references.first() {
        let scales = &first.scales;
        let meaning = format!(
            "largest of position (of {} m, {}) and attitude (rad), over {} samples",
            number(scales.length_m),
            scales.length_is,
            study.samples
        );
        lines.row(["error", &meaning]);
    }
    for other in study.other_laws() {
        let what = format!(
            "the limit of {} differs from that of the scene's law by {}: no error of the methods, but it counts for a \
             target",
            other.law.name(),
            short(other.difference)
        );
        lines.row(["law", &what]);
    }
    lines.row(["estimated", ESTIMATED]);
    lines.row(["velocity", VELOCITY]);
    lines.row(["energy", ENERGY]);
    let time = format!("relative to {}: median of interleaved rounds, without preparing the scene", study.base_name());
    lines.row(["time", &time]);
    lines.row(["noise", "half of the range that holds the middle half of the rounds, of the time"]);
    lines.row(["us/s", "microseconds of computing for each simulated second, on this machine"]);
    if study.counting == Counting::Instructions {
        lines.row(["cost", "instructions executed, without starting and preparing"]);
    }
    lines.print()
}

/// What the column `estimated` is.
const ESTIMATED: &str = "the error that the run tells of itself, by runs beside it (--error quick), in the measure of \
     the error; empty where that would have taken too long";

/// What the column `velocity` is.
pub(super) const VELOCITY: &str =
    "largest error of a velocity at the end, of the largest speed of the run: 0 where all have come to rest";

/// What the column `energy` is.
pub(super) const ENERGY: &str = "what integration lost or made of the energy, of the largest energy of the run";

fn described(reference: &Reference) -> String {
    let of = match reference.kind {
        Kind::Exact => "the exact solution, in closed form",
        Kind::Finest => "the finest solution",
    };
    format!("{}: {of} ({})", reference.kind.word(), reference.method)
}

fn columns(study: &Study) -> Vec<String> {
    let mut columns = vec![
        "",
        "method",
        "setting",
        "error",
        "estimated",
        "law",
        "mm",
        "degrees",
        "velocity",
        "energy",
        "time",
        "noise",
    ];
    if study.counting == Counting::Instructions {
        columns.push("instructions");
    }
    columns.extend(["us/s", "steps"]);
    columns.into_iter().map(str::to_owned).collect()
}

fn row(study: &Study, entry: &Entry, measured: &Measured) -> Vec<String> {
    let floor = study.references.get(entry.reference).map_or(0.0, |reference| reference.error);
    let errors = &measured.errors;
    let [millimetres, degrees] = study.errors_in_units(entry, errors);
    let mut cells = vec![
        if measured.on_front { "*" } else { "" }.to_owned(),
        entry.candidate.series.clone(),
        entry.candidate.rung.clone(),
        at_most(errors.headline(), floor),
        measured.estimated.map_or_else(String::new, short),
        measured.law.map_or_else(String::new, |law| short(law.difference)),
        short(millimetres),
        short(degrees),
        short(errors.final_velocity),
        short(measured.energy_error),
        ratio(measured.timing.ratio),
        noise(measured),
    ];
    cells.extend(measured.instructions.map(|count| count.to_string()));
    cells.extend([ratio(study.microseconds(measured)), measured.steps.to_string()]);
    cells
}

/// An error; below what is known about the reference, that.
pub(super) fn at_most(error: f64, floor: f64) -> String {
    if error <= floor { format!("<={floor:.1e}") } else { short(error) }
}

fn short(error: f64) -> String {
    if error == 0.0 { "0".to_owned() } else { format!("{error:.2e}") }
}

/// Ratios below this are written with an exponent.
const SMALL_RATIO: f64 = 0.01;

/// A ratio in two or three digits.
pub(super) fn ratio(ratio: f64) -> String {
    if ratio >= 100.0 {
        format!("{ratio:.0}")
    } else if ratio >= 1.0 {
        format!("{ratio:.2}")
    } else if ratio >= SMALL_RATIO {
        format!("{ratio:.3}")
    } else {
        format!("{ratio:.1e}")
    }
}

/// Half of the range that holds the middle half of the rounds, relative.
fn noise(measured: &Measured) -> String {
    let [low, high] = measured.timing.spread;
    format!("{:.0} %", 50.0 * (high - low) / measured.timing.ratio)
}

/// A length in few digits.
pub(super) fn short_length(length_m: f64) -> String {
    number(format!("{length_m:.2e}").parse().unwrap_or(length_m))
}

/// Which candidate reaches a target, at what cost, and which others are as cheap within the noise of timing.
pub(super) fn reached(study: &Study, entry: &Entry, target: f64) -> String {
    let Ok(measured) = &entry.outcome else { return String::new() };
    let error = study.known_error(entry).unwrap_or(f64::NAN);
    let mut text = format!(
        "cheapest method with an error of at most {target:e}: {}, error {error:.1e}, {} of the time of {}, {} us for \
         each simulated second",
        entry.candidate.name(),
        ratio(measured.timing.ratio),
        study.base_name(),
        ratio(study.microseconds(measured))
    );
    let ties = study.ties(target);
    if !ties.is_empty() {
        let names: Vec<String> = ties.iter().take(MOST_TIES).map(|entry| entry.candidate.name()).collect();
        let more = if ties.len() > MOST_TIES { format!(" and {} more", ties.len() - MOST_TIES) } else { String::new() };
        let _ = write!(
            text,
            "\nties with it, as cheap within the noise of timing or the same run: {}{more}",
            names.join(", ")
        );
    }
    text
}

/// Ties that are named at the most.
const MOST_TIES: usize = 6;

/// That no candidate ran, and why the first did not.
pub(super) fn none_ran(study: &Study) -> String {
    let first = failures(study).into_iter().next();
    let why = first.map_or_else(String::new, |(name, reason)| format!(": {name}: {reason}"));
    format!("error: none of the {} candidates ran{why}", study.entries.len())
}
