//! What is printed: a line for each run, and a summary.

use super::judged::{Finding, Judged};
use super::summary::{GOALS, Shares, tiers, worst};
use serde_json::{Value, json};
use std::fmt::{self, Write as _};

/// Runs that are named as the worst.
const WORST: usize = 10;

impl fmt::Display for Judged {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{:58} {:16} ", self.name, self.tier.name())?;
        match &self.finding {
            Finding::Compared(compared) => {
                write!(f, "true {:8.1e} ", compared.truth)?;
                match (compared.told, compared.ratio()) {
                    (Some(told), Some(ratio)) if ratio.is_finite() => write!(f, "told {told:8.1e} ratio {ratio:8.1e}"),
                    (Some(told), _) => write!(f, "told {told:8.1e}"),
                    _ => write!(f, "not told"),
                }
            }
            Finding::Unjudged(why) => write!(f, "not judged: {why}"),
            Finding::Refused(why) => write!(f, "not taken: {why}"),
            Finding::Failed(why) => write!(f, "failed: {why}"),
            Finding::Late => write!(f, "ended: very many steps"),
        }
    }
}

/// Shares of each tier and of all, as rows of words.
pub fn share_rows(judged: &[Judged]) -> Vec<Vec<String>> {
    let row = |name: &str, rows: &[&Judged]| {
        let shares = Shares::of(rows.iter().copied());
        let count = |is: fn(&Finding) -> bool| rows.iter().filter(|one| is(&one.finding)).count().to_string();
        let percent = shares.met.map(|part| format!("{:.1} %", 100.0 * part));
        let mut cells = vec![name.to_owned(), shares.compared.to_string(), shares.untold.to_string()];
        cells.extend(percent);
        cells.push(count(|finding| matches!(finding, Finding::Unjudged(_))));
        cells.push(count(|finding| matches!(finding, Finding::Refused(_))));
        cells.push(count(|finding| matches!(finding, Finding::Failed(_) | Finding::Late)));
        cells
    };
    let mut rows: Vec<Vec<String>> = Vec::new();
    for tier in tiers(judged) {
        rows.push(row(tier.name(), &judged.iter().filter(|one| one.tier == tier).collect::<Vec<_>>()));
    }
    rows.push(row("all", &judged.iter().collect::<Vec<_>>()));
    let [low, far, high] = GOALS.map(|goal| format!("{:.0} %", 100.0 * goal));
    let blank = String::new;
    rows.push(vec!["goal".to_owned(), blank(), blank(), low, far, high, blank(), blank(), blank()]);
    rows
}

/// What the columns of [`share_rows`] are.
pub const SHARE_COLUMNS: [&str; 9] = [
    "tier",
    "runs compared",
    "tell none",
    ">= 1/10 of the true one",
    ">= 1/100",
    "<= 100 times",
    "truth unknown",
    "not taken",
    "failed or late",
];

/// The summary: shares, what failed, and the worst.
pub fn summary(judged: &[Judged]) -> String {
    let mut text = String::new();
    let rows = share_rows(judged);
    let head: Vec<String> = SHARE_COLUMNS.map(str::to_owned).to_vec();
    let all: Vec<&Vec<String>> = std::iter::once(&head).chain(&rows).collect();
    let width = |column: usize| all.iter().map(|row| row[column].len()).max().unwrap_or_default();
    let widths: Vec<usize> = (0..head.len()).map(width).collect();
    for row in &all {
        let cells: Vec<String> = row.iter().zip(&widths).map(|(cell, width)| format!("{cell:>width$}")).collect();
        let _ = writeln!(text, "{}", cells.join("  "));
    }
    let failed: Vec<&Judged> = judged.iter().filter(|one| matches!(one.finding, Finding::Failed(_))).collect();
    let _ = writeln!(text, "failed: {}", failed.len());
    for one in failed {
        let _ = writeln!(text, "  {one}");
    }
    let _ = writeln!(text, "worst:");
    for one in worst(judged, WORST) {
        let _ = writeln!(text, "  {one}");
    }
    text
}

/// The rows for programs.
pub fn json(judged: &[Judged]) -> Value {
    let row = |one: &Judged| {
        let (truth, told) = one.compared().map_or((None, None), |found| (Some(found.truth), found.told));
        let why = match &one.finding {
            Finding::Compared(_) => None,
            Finding::Unjudged(why) => Some(format!("not judged: {why}")),
            Finding::Refused(why) => Some(format!("not taken: {why}")),
            Finding::Failed(why) => Some(format!("failed: {why}")),
            Finding::Late => Some("very many steps".to_owned()),
        };
        let until_s = one.compared().map(|found| found.until_s);
        let tier = one.tier.name();
        json!({ "scene": one.name, "tier": tier, "true": truth, "told": told, "until_s": until_s, "why": why,
            "wall_s": one.wall_s })
    };
    Value::Array(judged.iter().map(row).collect())
}
