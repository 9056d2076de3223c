//! What a sweep has found, in a few lines: how runs ended, the band of each measure, and what it hangs on.

use super::table::{Table, number};
use polhode_study::sweep::{Band, Findings, Index, Indices, Method, Sweep};
use serde_json::{Value, json};
use std::fmt::Write as _;
use std::path::Path;

/// The lines.
pub(crate) fn table(sweep: &Sweep, findings: &Findings, scene: &Path, path: &Path) -> String {
    let mut text = format!("sweep of {}: {} runs, in {}\n", scene.display(), findings.rows, path.display());
    if sweep.is_uncertain() {
        let _ = writeln!(text, "of them {} draws, whose outcomes and band are:", findings.draws);
    }
    text.push_str(&outcomes(sweep, findings));
    if let Some(reason) = &findings.reason {
        let _ = writeln!(text, "  first reason: {reason}");
    }
    if !findings.measures.is_empty() {
        text.push('\n');
        text.push_str(&bands(sweep, findings));
    }
    for own in &findings.measures {
        if let Some(indices) = &own.indices {
            let _ = write!(text, "\nwhat {} hangs on\n{}  {}\n", own.name, hangs_on(indices), method(indices));
        }
    }
    text
}

/// How runs ended.
fn outcomes(sweep: &Sweep, findings: &Findings) -> String {
    let mut all = Table::default();
    for own in &findings.shares {
        let mut cells = vec![own.outcome.clone(), own.count.to_string()];
        if sweep.is_drawn() {
            cells.push(format!("share {} +- {}", number(own.share), number(own.standard_error)));
        }
        all.cells(cells);
    }
    if !findings.largest_error.is_nan() {
        all.row(["largest estimated error", &format!("{} of a body's size", number(findings.largest_error))]);
    }
    all.print()
}

/// The names of the columns of a band.
pub(crate) fn band_columns(sweep: &Sweep) -> Vec<&'static str> {
    let (mut all, after) = (vec!["measure", "mean", "standard error"], ["least", "most"]);
    if sweep.is_drawn() {
        all.extend(["deviation", "5 %", "50 %", "95 %"]);
    }
    all.extend(after);
    all
}

/// The cells of a band.
pub(crate) fn band_cells(sweep: &Sweep, name: &str, band: Option<&Band>) -> Vec<String> {
    let Some(own) = band else { return vec![name.to_owned(), "none".to_owned()] };
    let of = |value: Option<f64>| value.map_or_else(String::new, number);
    let mut cells = vec![name.to_owned(), number(own.mean), of(own.standard_error)];
    if sweep.is_drawn() {
        cells.push(of(own.deviation));
        cells.extend(own.quantiles.map(number));
    }
    cells.extend([own.least, own.most].map(number));
    cells
}

fn bands(sweep: &Sweep, findings: &Findings) -> String {
    let mut all = Table::default();
    all.cells(band_columns(sweep).into_iter().map(str::to_owned).collect());
    for own in &findings.measures {
        all.cells(band_cells(sweep, &own.name, own.band.as_ref()));
    }
    all.print()
}

/// The names of the columns of what a measure hangs on.
pub(crate) const INDEX_COLUMNS: [&str; 5] = ["value", "first-order", "total", "derivative", "by its deviation"];

/// The cells of what a measure hangs on, one row for each value.
pub(crate) fn index_cells(indices: &Indices) -> Vec<Vec<String>> {
    let of = |index: Option<Index>| index.map_or_else(String::new, |own| with_error(own.value, own.error));
    let row = |own: &polhode_study::sweep::OfKey| {
        let derivative = own.derivative.map_or_else(String::new, |own| with_error(own.value, own.error));
        let by_deviation = own.derivative.map_or_else(String::new, |own| number(own.by_deviation));
        vec![own.key.clone(), of(own.first), of(own.total), derivative, by_deviation]
    };
    indices.keys.iter().map(row).collect()
}

fn hangs_on(indices: &Indices) -> String {
    let mut all = Table::default();
    all.row(INDEX_COLUMNS);
    for cells in index_cells(indices) {
        all.cells(cells);
    }
    all.print()
}

/// A number and its error.
fn with_error(value: f64, error: f64) -> String {
    if error.is_nan() { number(value) } else { format!("{} +- {error:.1e}", number(value)) }
}

/// How indices were found, and how sure they are.
pub(crate) fn method(indices: &Indices) -> String {
    match &indices.method {
        Method::Nodes { counts, unexplained } => {
            let grid = counts.iter().map(usize::to_string).collect::<Vec<_>>().join(" x ");
            let sure = if unexplained.is_nan() {
                "how well the polynomial through them fits is not known: more draws would tell".to_owned()
            } else {
                format!("the polynomial through them leaves {unexplained:.1e} of the variance of the draws")
            };
            format!("indices by a grid of {grid} Gauss nodes; {sure}; +- is a bound; derivatives at the middle")
        }
        Method::Mixed { draws, left_out } => {
            let out = if *left_out == 0 { String::new() } else { format!(", {left_out} of them left out") };
            format!("indices by {draws} mixed draws (Saltelli, Jansen){out}; +- is the standard error")
        }
        Method::None(why) => format!("no indices: {why}"),
        _ => String::new(),
    }
}

/// What was found, as JSON.
pub(crate) fn json(sweep: &Sweep, findings: &Findings) -> Value {
    let index = |own: Option<Index>| own.map(|own| json!({ "value": own.value, "error": own.error }));
    let of_key = |own: &polhode_study::sweep::OfKey| {
        let derivative = own.derivative.map(|own| {
            json!({ "value": own.value, "error": own.error, "middle": own.middle, "by_deviation": own.by_deviation })
        });
        json!({ "key": own.key, "first": index(own.first), "total": index(own.total), "derivative": derivative })
    };
    let band = |own: &Band| {
        json!({
            "count": own.count, "mean": own.mean, "standard_error": own.standard_error, "deviation": own.deviation,
            "quantiles": { "0.05": own.quantiles[0], "0.5": own.quantiles[1], "0.95": own.quantiles[2] },
            "least": own.least, "most": own.most,
        })
    };
    let measures = findings.measures.iter().map(|own| {
        let indices = own
            .indices
            .as_ref()
            .map(|own| json!({ "method": method(own), "values": own.keys.iter().map(of_key).collect::<Vec<_>>() }));
        json!({ "name": own.name, "band": own.band.as_ref().map(band), "hangs_on": indices })
    });
    let shares = findings.shares.iter().map(|own| {
        json!({
            "outcome": own.outcome, "count": own.count, "share": own.share, "standard_error": own.standard_error,
        })
    });
    json!({
        "runs": findings.rows,
        "draws": findings.draws,
        "seed": sweep.seed(),
        "outcomes": shares.collect::<Vec<_>>(),
        "largest_error": Some(findings.largest_error).filter(|own| !own.is_nan()),
        "first_reason": findings.reason,
        "measures": measures.collect::<Vec<_>>(),
        "table_blake2b_256": findings.table_hash,
    })
}
