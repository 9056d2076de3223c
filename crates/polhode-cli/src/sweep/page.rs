//! The page of a sweep: all that is needed to make it again and to judge it, in one file that needs nothing else.
//!
//! Nothing in it depends on the hour, the machine or the number of workers, so that the same command gives the same
//! bytes.

use crate::cost::html::escaped;
use crate::text::number;
use crate::text::sweep::{INDEX_COLUMNS, band_cells, band_columns, index_cells, method};
use polhode_study::sweep::{Findings, OfMeasure, Sweep, Values};
use polhode_view::plot::scale::{Mark, Scale};
use polhode_view::plot::svg::{Anchor, Type};
use polhode_view::plot::{Ink, Stroke, Svg};
use std::fmt::Write as _;

const STYLE: &str = "body{font:15px/1.45 sans-serif;max-width:60em;margin:2em auto;padding:0 1em;color:#1f2328}\
svg{max-width:100%;height:auto}table{border-collapse:collapse;margin:.6em 0}th{border-bottom:2px solid #888}\
th,td{padding:.15em .8em;text-align:left;font-variant-numeric:tabular-nums}\
pre,code{font-family:monospace;overflow-wrap:anywhere;white-space:pre-wrap}\
@media(prefers-color-scheme:dark){body{background:#0d1117;color:#e6edf3}}";

/// Size of a histogram, pixels.
const SIZE: [f64; 2] = [640.0, 220.0];

/// What the sweep was made from.
pub(super) struct Made<'a> {
    /// The name of the scene.
    pub(super) scene: &'a str,
    /// Its text, and what the command line changes.
    pub(super) told: &'a str,
    /// What the first line of the table says.
    pub(super) digest: &'a str,
}

/// The whole page.
pub(super) fn page(sweep: &Sweep, findings: &Findings, made: &Made<'_>) -> String {
    let title = escaped(&format!("sweep of {}", made.scene));
    let mut page = format!(
        "<!DOCTYPE html>\n<html lang=\"en\">\n<meta charset=\"utf-8\">\n<title>{title}</title>\n\
         <style>{STYLE}</style>\n<h1>{title}</h1>\n"
    );
    origin(&mut page, sweep, findings, made);
    page.push_str("<h2>What was varied</h2>\n");
    let varied = sweep.varied().iter().map(|own| vec![own.key.clone(), words(&own.values)]).collect();
    table(&mut page, &["value", "drawn from, or values"], varied);
    page.push_str("<h2>How runs ended</h2>\n");
    let shares = findings
        .shares
        .iter()
        .map(|own| vec![own.outcome.clone(), own.count.to_string(), number(own.share), number(own.standard_error)]);
    table(&mut page, &["outcome", "runs", "share", "standard error"], shares.collect());
    let largest = if findings.largest_error.is_nan() { "not known".to_owned() } else { number(findings.largest_error) };
    let _ = writeln!(page, "<p>Largest error that a run told of itself, of a body's size: {largest}.</p>");
    if let Some(reason) = &findings.reason {
        let _ = writeln!(page, "<p>First reason: {}</p>", escaped(reason));
    }
    page.push_str("<h2>What was measured</h2>\n");
    let cells = |own: &OfMeasure| band_cells(sweep, &own.name, own.band.as_ref());
    table(&mut page, &band_columns(sweep), findings.measures.iter().map(cells).collect());
    for own in &findings.measures {
        of_measure(&mut page, own);
    }
    let _ = write!(page, "<h2>The scene</h2>\n<pre>{}</pre>\n</html>\n", escaped(made.told));
    page
}

/// What makes it again.
fn origin(page: &mut String, sweep: &Sweep, findings: &Findings, made: &Made<'_>) {
    page.push_str("<h2>How it was made</h2>\n");
    let line = |name: &str, value: String| vec![name.to_owned(), value];
    let rows = vec![
        line("command", command_line(std::env::args().skip(1))),
        line("polhode", env!("CARGO_PKG_VERSION").to_owned()),
        line("seed", sweep.seed().to_string()),
        line("runs", format!("{}, of them {} draws or points of a grid", findings.rows, findings.draws)),
        line("sweep", made.digest.to_owned()),
        line("table, BLAKE2b-256", findings.table_hash.clone()),
    ];
    table(page, &["", ""], rows);
    page.push_str(
        "<p>The hash is that of the bytes of the CSV table (<code>b2sum -l 256 table.csv</code>). The same command \
         gives the same table and the same page, byte by byte, on any machine and for any number of workers.</p>\n",
    );
}

/// The command without what does not change a bit of the table: the number of workers, and how much is said.
fn command_line(arguments: impl Iterator<Item = String>) -> String {
    let (mut words, mut is_skipped) = (vec!["polhode".to_owned()], false);
    for word in arguments {
        let skips = std::mem::replace(&mut is_skipped, word == "--workers");
        if skips || word.starts_with("--workers") || word == "-q" || word == "--quiet" {
            continue;
        }
        let is_plain = word.chars().all(|c| c.is_ascii_alphanumeric() || "-_./=:,@+%".contains(c));
        words.push(if is_plain { word } else { format!("'{}'", word.replace('\'', "'\\''")) });
    }
    words.join(" ")
}

fn words(values: &Values) -> String {
    match values {
        Values::Drawn(drawn) => drawn.to_string(),
        Values::Listed(values) => values.join(", "),
    }
}

/// A measure: its distribution, and what it hangs on.
fn of_measure(page: &mut String, own: &OfMeasure) {
    let _ = writeln!(page, "<h3>{}</h3>", escaped(&own.name));
    page.push_str(&histogram(own));
    if let Some(indices) = &own.indices {
        table(page, &INDEX_COLUMNS, index_cells(indices));
        let _ = writeln!(page, "<p>{}.</p>", escaped(&method(indices)));
    }
}

/// How often values lie in each of equal ranges; lines stand at 5, 50 and 95 %.
fn histogram(own: &OfMeasure) -> String {
    let Some(band) = own.band.filter(|band| band.most > band.least && (band.most - band.least).is_finite()) else {
        return String::new();
    };
    let known: Vec<f64> = own.values.iter().copied().filter(|value| value.is_finite()).collect();
    // Sturges' rule: as many ranges as a binomial distribution of so many values has.
    let count = (usize::BITS - known.len().saturating_sub(1).leading_zeros()) as usize + 1;
    let width = (band.most - band.least) / count as f64;
    let mut counts = vec![0_usize; count];
    for value in &known {
        counts[(((value - band.least) / width) as usize).min(count - 1)] += 1;
    }
    let across = Scale::linear_within([band.least, band.most].into_iter());
    let up = Scale::count(counts.iter().map(|own| *own as f64));
    let (left, right, top, bottom) = (56.0, SIZE[0] - 16.0, 12.0, SIZE[1] - 40.0);
    let place =
        |value: f64, share: f64| [left + (right - left) * across.part(value), bottom - (bottom - top) * up.part(share)];
    let mut svg = Svg::new(SIZE, &own.name);
    let small = Type::new(12.0, Ink::Faint);
    for (part, mark) in up.marks(5) {
        let y = bottom - (bottom - top) * part;
        svg.line(&[[left, y], [right, y]], Stroke::new(Ink::Grid, 1.0));
        svg.text([left - 6.0, y], &label(&mark), small.anchor(Anchor::End));
    }
    for (number, count) in counts.iter().enumerate() {
        let [low, high] = [number, number + 1].map(|edge| band.least + width * edge as f64);
        let ([x0, y0], [x1, y1]) = (place(low, 0.0), place(high, *count as f64));
        svg.polygon(&[[x0 + 0.5, y0], [x1 - 0.5, y0], [x1 - 0.5, y1], [x0 + 0.5, y1]], Ink::Blue);
    }
    for quantile in band.quantiles {
        let [x, _] = place(quantile, 0.0);
        svg.line(&[[x, top], [x, bottom]], Stroke::new(Ink::Vermilion, 1.5).dashed(5.0, 3.0));
    }
    for (part, mark) in across.marks(6) {
        let x = left + (right - left) * part;
        svg.line(&[[x, bottom], [x, bottom + 4.0]], Stroke::new(Ink::Faint, 1.0));
        svg.text([x, bottom + 13.0], &label(&mark), small.anchor(Anchor::Middle));
    }
    let said = "runs in each range; dashes: 5, 50 and 95 %";
    svg.text([0.5 * (left + right), SIZE[1] - 9.0], said, small.anchor(Anchor::Middle));
    svg.finish()
}

fn label(mark: &Mark) -> String {
    match mark {
        Mark::Number(text) => text.clone(),
        _ => String::new(),
    }
}

/// A table; the heading is left out where it is empty.
fn table(page: &mut String, columns: &[&str], rows: Vec<Vec<String>>) {
    page.push_str("<table>\n");
    if columns.iter().any(|column| !column.is_empty()) {
        let heads = format!("<th>{}</th>", columns.join("</th><th>"));
        let _ = writeln!(page, "<tr>{heads}</tr>");
    }
    for row in rows {
        let cells: Vec<String> = row.iter().map(|cell| escaped(cell)).collect();
        let _ = writeln!(page, "<tr><td>{}</td></tr>", cells.join("</td><td>"));
    }
    page.push_str("</table>\n");
}

#[cfg(test)]
mod tests {
    //! The command of a page says what the table hangs on, and nothing else.
    use super::*;

    #[test]
    fn the_command_has_no_workers() {
        let words = ["-q", "sweep", "a.toml", "--workers", "2", "--workers=3", "--vary", "m=normal(1, 2)"];
        let line = command_line(words.into_iter().map(str::to_owned));
        assert_eq!(line, "polhode sweep a.toml --vary 'm=normal(1, 2)'");
    }
}
