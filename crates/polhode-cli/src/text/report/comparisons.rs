//! The runs with which a run was compared.

use super::words::about;
use crate::text::table::{Table, number};
use polhode::{ReferenceReport, RunError};

/// All of them in a line: of each, by which method, and for how long. What was begun and followed for no time at all
/// is left out.
pub(super) fn in_a_line(error: &RunError, simulated_s: f64) -> Option<String> {
    error.largest?;
    let told = error.references.iter().filter(|reference| reference.covered_s > 0.0).map(|reference| {
        let ReferenceReport { kind, method, covered_s, .. } = reference;
        let of = number(simulated_s);
        let length =
            if *covered_s >= simulated_s { format!("all {of}") } else { format!("{} of {of}", about(*covered_s)) };
        format!("{} ({method}), over {length} s", kind.name())
    });
    let told: Vec<String> = told.collect();
    (!told.is_empty()).then(|| told.join("; "))
}

/// With what a run was compared, for how long, at which cost, and how far it was from it.
pub(super) fn all(error: &RunError, simulated_s: f64) -> String {
    if error.references.is_empty() {
        return String::new();
    }
    let mut table = Table::default();
    for reference in &error.references {
        let ReferenceReport { kind, method, covered_s, work, largest_distance, ended, .. } = reference;
        let apart = if *largest_distance > 0.0 {
            format!("at most {} of a body's size apart", about(*largest_distance))
        } else {
            "no difference".to_owned()
        };
        let ended = ended.as_ref().map_or_else(String::new, |why| format!("; it was ended: {why}"));
        let told = format!(
            "{method}; for {} of {} s, at {} of the work of the run: {apart}{ended}",
            number(*covered_s),
            number(simulated_s),
            about(*work)
        );
        table.row([kind.name(), &told]);
    }
    format!("compared with\n{}", table.print())
}
