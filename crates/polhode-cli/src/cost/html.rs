//! Figure and table as one page that needs nothing else.

use super::text;
use polhode_study::study::{Entry, Study};
use std::fmt::Write as _;

/// A click on a heading sorts by that column, a second one the other way round; numbers sort as numbers.
const SCRIPT: &str = r#"document.querySelectorAll("th").forEach((th, column) => th.addEventListener("click", () => {
  const body = document.querySelector("tbody"), up = th.dataset.up !== "1";
  th.dataset.up = up ? "1" : "0";
  const key = row => column > 1 && row.cells.length < 4 ? Infinity :
    row.cells[column].dataset.value ?? row.cells[column].textContent;
  const order = (a, b) => a - b || (isNaN(a - b) ? String(a).localeCompare(String(b)) : 0);
  [...body.rows].sort((a, b) => (up ? 1 : -1) * order(key(a), key(b))).forEach(row => body.append(row));
}));"#;

pub(super) const STYLE: &str = "body{font:15px/1.4 sans-serif;max-width:70em;margin:2em auto;padding:0 1em;color:#222}\
svg{max-width:100%;height:auto}table{border-collapse:collapse}th{cursor:pointer;border-bottom:2px solid #888}\
th,td{padding:.15em .8em;text-align:left;white-space:nowrap}td.n{text-align:right;font-variant-numeric:tabular-nums}\
tr.front{background:#fff3d0}pre{white-space:pre-wrap}\
@media(prefers-color-scheme:dark){body{background:#0d1117;color:#e6edf3}tr.front{background:#3a3010}}";

const COLUMNS: [&str; 13] = [
    "method",
    "setting",
    "error",
    "estimated",
    "law",
    "position, mm",
    "attitude, degrees",
    "velocity",
    "energy",
    "time",
    "us for each simulated s",
    "instructions",
    "steps",
];

/// The whole page; `figure` is the SVG, `elastic` what is told of an elastic body, if anything.
pub(super) fn page(study: &Study, figure: &str, elastic: &str) -> String {
    let scene = escaped(&study.scene);
    let mut rows = String::new();
    for entry in &study.entries {
        row(&mut rows, study, entry);
    }
    let mut headings = String::new();
    for column in COLUMNS {
        let _ = write!(headings, "<th>{column}</th>");
    }
    format!(
        "<!DOCTYPE html>\n<html lang=\"en\">\n<meta charset=\"utf-8\">\n<title>{scene}: what accuracy costs</title>\n\
         <style>{STYLE}</style>\n<h1>{scene}: what accuracy costs</h1>\n{figure}\n<pre>{}</pre>\n\
         <p>Rows on the Pareto front are marked: none is both cheaper and more accurate. A click on a heading \
         sorts.</p>\n\
         <table>\n<thead><tr>{headings}</tr></thead>\n<tbody>\n{rows}</tbody>\n</table>\n<pre>{}</pre>\n\
         <script>{SCRIPT}</script>\n</html>\n",
        escaped(&text::notes(study)),
        escaped(elastic)
    )
}

fn row(rows: &mut String, study: &Study, entry: &Entry) {
    let name = format!("<td>{}</td><td>{}</td>", escaped(&entry.candidate.series), escaped(&entry.candidate.rung));
    let measured = match &entry.outcome {
        Ok(measured) => measured,
        Err(reason) => {
            let _ = writeln!(rows, "<tr>{name}<td colspan=\"{}\">{}</td></tr>", COLUMNS.len() - 2, escaped(reason));
            return;
        }
    };
    let errors = &measured.errors;
    let class = if measured.on_front { " class=\"front\"" } else { "" };
    let _ = write!(rows, "<tr{class}>{name}");
    let floor = study.references.get(entry.reference).map_or(0.0, |reference| reference.error);
    let _ = write!(rows, "{}", cell(errors.headline(), &escaped(&text::at_most(errors.headline(), floor))));
    match measured.estimated {
        Some(estimated) => rows.push_str(&cell(estimated, &format!("{estimated:.2e}"))),
        None => rows.push_str("<td></td>"),
    }
    match measured.law {
        Some(other) => rows.push_str(&cell(other.difference, &format!("{:.2e}", other.difference))),
        None => rows.push_str("<td></td>"),
    }
    let [millimetres, degrees] = study.errors_in_units(entry, errors);
    for error in [millimetres, degrees, errors.final_velocity, measured.energy_error] {
        rows.push_str(&cell(error, &format!("{error:.2e}")));
    }
    rows.push_str(&cell(measured.timing.ratio, &text::ratio(measured.timing.ratio)));
    let microseconds = study.microseconds(measured);
    rows.push_str(&cell(microseconds, &text::ratio(microseconds)));
    match measured.instructions {
        Some(count) => rows.push_str(&cell(count as f64, &count.to_string())),
        None => rows.push_str("<td></td>"),
    }
    let _ = writeln!(rows, "{}</tr>", cell(measured.steps as f64, &measured.steps.to_string()));
}

fn cell(value: f64, shown: &str) -> String {
    format!("<td class=\"n\" data-value=\"{value:?}\">{shown}</td>")
}

pub(crate) fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}
