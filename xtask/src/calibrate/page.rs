//! `docs/error-estimates.md`.

use super::figure;
use polhode_cases::calibration::{self, FAR_TOO_LOW, GOALS, Judged, ROUNDING, SHARE_COLUMNS, TOO_HIGH, TOO_LOW};
use std::collections::BTreeMap;
use std::error::Error;
use std::fmt::Write as _;
use std::fs;
use std::path::Path;

/// The document and its figure, below the folder of documents.
const DOCUMENT: &str = "error-estimates.md";
const FIGURE: &str = "figures/error-estimates.svg";
/// Runs that are named as the worst.
const WORST: usize = 10;

/// Where scenes come from, by what their names begin with.
const SOURCES: [(&str, &str); 14] = [
    ("closed form", "contact and friction in closed form: slides, rolls, bounces, landings"),
    ("throws", "bodies thrown at walls, with friction and restitution"),
    ("slopes", "boxes on slopes that slide or stay"),
    ("shots", "balls that slip and come to roll, and balls on a turntable"),
    ("rotations", "free rotations computed to 40 digits"),
    ("tops", "heavy tops that precess steadily"),
    ("joints", "pendulums, chains, a loop and a Cardan joint, by their own equations"),
    ("impacts", "balls that meet head on, and rows of balls"),
    ("seams", "bodies that slide over the seams of tiles"),
    ("still", "structures in which nothing moves"),
    ("mechanism", "random mechanisms, by the tier `accurate` at its tightest"),
    ("contacts", "random scenes of contacts, likewise"),
    ("reported", "scenes that were once reported as wrong, likewise"),
    ("shipped", "scenes that ship, likewise"),
];

/// Writes document and figure below a folder.
///
/// # Errors
/// When a file cannot be written.
pub(super) fn write(folder: &Path, judged: &[Judged]) -> Result<(), Box<dyn Error>> {
    let figure = folder.join(FIGURE);
    if let Some(parent) = figure.parent() {
        fs::create_dir_all(parent)?;
    }
    fs::write(figure, figure::svg(judged))?;
    fs::write(folder.join(DOCUMENT), document(judged))?;
    Ok(())
}

fn document(judged: &[Judged]) -> String {
    let [low, far, high] = GOALS.map(|goal| 100.0 * goal);
    let mut text = format!(
        "# How right told errors are\n\n\
         A run tells its own error. Here it stands beside the true one, over scenes whose motion is known.\n\
         `cargo xtask calibrate --write docs` makes this page, and `cargo xtask calibrate --only joints` prints the \
         rows of some scenes.\n\n\
         ![told errors against true ones](figures/error-estimates.svg)\n\n\
         The true error is the largest distance of any point of a body from where it belongs, of the size of the body, \
         over all\nsamples \
         before the horizon of the run. It should be told to at least {TOO_LOW} of itself in {low} % of all runs, to \
         at least\n{FAR_TOO_LOW} in {far} %, and to at most {TOO_HIGH} times itself in {high} %. An \
         error\nbelow {ROUNDING:e} is rounding: it needs not be told, and counts as that where more is told.\n\n"
    );
    table(&mut text, &SHARE_COLUMNS, &calibration::share_rows(judged));
    text.push_str("\nRuns that tell their errors worst:\n\n");
    let number = |number: f64| format!("{number:.1e}");
    let rows = calibration::worst(judged, WORST).into_iter().filter_map(|one| {
        let found = one.compared()?;
        let told = found.told.map_or_else(|| "none".to_owned(), number);
        Some(vec![one.name.clone(), one.tier.name().to_owned(), number(found.truth), told])
    });
    table(&mut text, &["scene", "tier", "true", "told"], &rows.collect::<Vec<_>>());
    text.push_str("\nWhere the scenes come from:\n\n");
    table(&mut text, &["source", "what", "scenes"], &sources(judged));
    text.push_str(
        "\nWhat is known from runs is known from two: one at a tolerance of 1e-13 and a step of 3 ms, and one of the \
         scene turned, moved and\nin another order, or at another step. Samples count as long as the two differ by \
         less than a third of the error that is judged.\n",
    );
    text
}

/// Rows of the table of sources.
fn sources(judged: &[Judged]) -> Vec<Vec<String>> {
    let mut scenes: BTreeMap<&str, Vec<&str>> = BTreeMap::new();
    for one in judged {
        let names = scenes.entry(one.name.split('/').next().unwrap_or_default()).or_default();
        if names.last() != Some(&one.name.as_str()) {
            names.push(&one.name);
        }
    }
    let count = |source: &str| scenes.get(source).map_or(0, Vec::len).to_string();
    SOURCES.iter().map(|(source, what)| vec![(*source).to_owned(), (*what).to_owned(), count(source)]).collect()
}

/// Appends a table.
fn table(text: &mut String, columns: &[&str], rows: &[Vec<String>]) {
    let _ = writeln!(text, "| {} |\n|{}", columns.join(" | "), "---|".repeat(columns.len()));
    for row in rows {
        let _ = writeln!(text, "| {} |", row.join(" | "));
    }
}
