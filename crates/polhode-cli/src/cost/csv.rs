//! The table as CSV (RFC 4180): one row for every candidate, also for those that failed.

use polhode_scene::csv::quoted;
use polhode_study::study::{Entry, Measured, Study};
use std::fmt::Write as _;

/// The columns. Errors are relative, angles in rad; an empty field is what was not measured.
const COLUMNS: [&str; 28] = [
    "method",
    "setting",
    "changes",
    "reference",
    "reference_error",
    "error",
    "estimated_error",
    "law",
    "law_difference",
    "position_error",
    "attitude_error_rad",
    "position_error_mm",
    "attitude_error_deg",
    "final_position_error",
    "final_attitude_error_rad",
    "final_velocity_error",
    "energy_error",
    "time_ratio",
    "time_ratio_low",
    "time_ratio_high",
    "us_per_simulated_s",
    "time_s",
    "rounds",
    "instructions",
    "steps",
    "pareto",
    "base",
    "failure",
];

/// The whole file.
pub(super) fn text(study: &Study) -> String {
    let mut text = format!("{}\n", COLUMNS.join(","));
    for (number, entry) in study.entries.iter().enumerate() {
        let mut fields = described(study, entry);
        match &entry.outcome {
            Ok(measured) => fields.extend(numbers(study, entry, measured)),
            Err(_) => fields.resize(fields.len() + NUMBERS, String::new()),
        }
        fields.push((study.base == Some(number)).to_string());
        fields.push(entry.outcome.as_ref().err().cloned().unwrap_or_default());
        let quoted: Vec<_> = fields.iter().map(|field| quoted(field)).collect();
        let _ = writeln!(text, "{}", quoted.join(","));
    }
    text
}

fn described(study: &Study, entry: &Entry) -> Vec<String> {
    let changes: Vec<_> =
        entry.candidate.changes.iter().map(|change| format!("{}={}", change.key, change.value)).collect();
    let reference = study.references.get(entry.reference);
    vec![
        entry.candidate.series.clone(),
        entry.candidate.rung.clone(),
        changes.join(" "),
        reference.map_or("", |reference| reference.kind.word()).to_owned(),
        reference.map_or(String::new(), |reference| digits(reference.error)),
    ]
}

/// Columns from `error` to `pareto`.
const NUMBERS: usize = 21;

fn numbers(study: &Study, entry: &Entry, measured: &Measured) -> [String; NUMBERS] {
    let errors = &measured.errors;
    let [millimetres, degrees] = study.errors_in_units(entry, errors);
    let [low, high] = measured.timing.spread;
    [
        digits(errors.headline()),
        measured.estimated.map_or(String::new(), digits),
        // Empty where it is the scene's.
        measured.law.map_or("", |other| other.law.name()).to_owned(),
        measured.law.map_or(String::new(), |other| digits(other.difference)),
        digits(errors.position),
        digits(errors.attitude),
        // Without a reference there is no length.
        if millimetres.is_finite() { digits(millimetres) } else { String::new() },
        digits(degrees),
        digits(errors.final_position),
        digits(errors.final_attitude),
        digits(errors.final_velocity),
        digits(measured.energy_error),
        digits(measured.timing.ratio),
        digits(low),
        digits(high),
        digits(study.microseconds(measured)),
        digits(measured.timing.seconds),
        measured.timing.rounds.to_string(),
        measured.instructions.map_or(String::new(), |count| count.to_string()),
        measured.steps.to_string(),
        measured.on_front.to_string(),
    ]
}

/// The fewest digits that give the same bits when read.
fn digits(number: f64) -> String {
    format!("{number:?}")
}

#[cfg(test)]
mod tests {
    //! Every row has every column, failures too, and what needs quotes has them.
    use super::*;
    use polhode::scene::Integrator;
    use polhode_study::Solver;
    use polhode_study::candidate::{Candidate, change};
    use polhode_study::difference::Errors;
    use polhode_study::options::Counting;
    use polhode_study::timing::Timing;

    #[test]
    fn rows_of_a_run_and_of_a_failure() {
        let candidate = |rung: &str| Candidate {
            series: "cf4".to_owned(),
            rung: rung.to_owned(),
            changes: vec![change("method.integrator", "cf4"), change("method.step", "0.1")],
            growth: None,
        };
        let measured = Measured {
            errors: Errors { position: 0.25, attitude: 0.5, ..Errors::default() },
            energy_error: 1e-9,
            steps: 10,
            solver: Solver { integrator: Integrator::Cf4, closed_form: false },
            law: None,
            estimated: Some(0.75),
            timing: Timing { ratio: 0.75, spread: [0.5, 1.0], seconds: 0.001, rounds: 3 },
            instructions: None,
            on_front: true,
        };
        let failure = "refused, \"why\"".to_owned();
        let study = Study {
            scene: "test".to_owned(),
            duration_s: 1.0,
            references: Vec::new(),
            entries: vec![
                Entry { candidate: candidate("step 0.1"), reference: 0, outcome: Ok(measured) },
                Entry { candidate: candidate(""), reference: 0, outcome: Err(failure) },
            ],
            base: Some(0),
            counting: Counting::Time,
            samples: 1,
        };
        let text = text(&study);
        let rows: Vec<_> = text.lines().collect();
        assert_eq!(rows[0], COLUMNS.join(","));
        let changes = "method.integrator=cf4 method.step=0.1";
        let numbers =
            "0.5,0.75,,,0.25,0.5,,28.64788975654116,0.0,0.0,0.0,1e-9,0.75,0.5,1.0,750.0,0.001,3,,10,true,true,";
        assert_eq!(rows[1], format!("cf4,step 0.1,{changes},,,{numbers}"));
        assert_eq!(rows[2], format!("cf4,,{changes},,,,,,,,,,,,,,,,,,,,,,,,false,\"refused, \"\"why\"\"\""));
    }
}
