//! The figure at the head of `docs/accuracy-and-cost.md`: what an error costs in every scene, by every method.

use polhode_view::plot::dot_chart::{Cell, Dot, DotChart, Row};
use serde_json::Value;

/// Errors that are asked for, one column each.
const TARGETS: [f64; 3] = [1e-3, 1e-6, 1e-9];

/// The figure of these studies, as `polhode cost --json` gives them.
pub(crate) fn svg(studies: &[Value]) -> String {
    let chart = DotChart {
        title: "What an error costs: microseconds of computing for each simulated second".to_owned(),
        subtitle:
            "every method at its cheapest setting that reaches the error; the cheapest is ringed and named; one machine"
                .to_owned(),
        across: "microseconds for each simulated second".to_owned(),
        columns: TARGETS.map(|target| format!("error at most {target:e}")).to_vec(),
        rows: studies.iter().map(row).collect(),
    };
    chart.svg()
}

fn row(study: &Value) -> Row {
    Row {
        name: word(study, "scene").to_owned(),
        note: format!("{} s simulated", short(study["duration_s"].as_f64().unwrap_or(f64::NAN))),
        cells: TARGETS.map(|target| cell(study, target)).to_vec(),
    }
}

/// A duration, without a fraction where that is below a thousandth.
fn short(seconds: f64) -> String {
    if seconds < 1000.0 { seconds.to_string() } else { format!("{seconds:.0}") }
}

/// Every method that reaches a target, at its cheapest.
fn cell(study: &Value, target: f64) -> Cell {
    let reaches = |candidate: &&Value| candidate["known_error"].as_f64().is_some_and(|error| error <= target);
    let mut cheapest: Vec<&Value> = Vec::new();
    for candidate in study["candidates"].as_array().into_iter().flatten().filter(reaches) {
        match cheapest.iter_mut().find(|other| word(other, "method") == word(candidate, "method")) {
            Some(other) if cost(candidate) < cost(other) => *other = candidate,
            Some(_) => {}
            None => cheapest.push(candidate),
        }
    }
    let number = |candidate: &&Value| cost(candidate);
    let best = (0..cheapest.len()).min_by(|&a, &b| number(&cheapest[a]).total_cmp(&number(&cheapest[b])));
    let text = best.map_or_else(String::new, |best| {
        let ties = cheapest.iter().enumerate().filter(|(other, _)| *other != best);
        match ties.filter(|(_, other)| is_tie(other, cheapest[best])).count() {
            0 => word(cheapest[best], "method").to_owned(),
            1 => format!("{} and 1 tie", word(cheapest[best], "method")),
            ties => format!("{} and {ties} ties", word(cheapest[best], "method")),
        }
    });
    let dot = |candidate: &&Value| Dot {
        method: word(candidate, "method").to_owned(),
        value: candidate["us_per_simulated_s"].as_f64().unwrap_or(f64::NAN),
    };
    Cell { dots: cheapest.iter().map(dot).collect(), best, text }
}

/// Whether the ranges that hold the middle half of the rounds overlap, as `polhode cost` calls it.
fn is_tie(a: &Value, b: &Value) -> bool {
    let end = |candidate: &Value, which: usize| candidate["time_ratio_spread"][which].as_f64().unwrap_or(f64::NAN);
    end(a, 0) <= end(b, 1) && end(b, 0) <= end(a, 1)
}

fn cost(candidate: &Value) -> f64 {
    candidate["time_ratio"].as_f64().unwrap_or(f64::INFINITY)
}

fn word<'a>(value: &'a Value, key: &str) -> &'a str {
    value[key].as_str().unwrap_or_default()
}

#[cfg(test)]
mod tests {
    //! The cheapest setting of every method is found, and ties are counted.
    use super::*;
    use serde_json::json;

    fn candidate(method: &str, error: f64, time: f64) -> Value {
        json!({
            "method": method, "known_error": error, "time_ratio": time, "time_ratio_spread": [0.9 * time, 1.1 * time],
            "us_per_simulated_s": 100.0 * time,
        })
    }

    #[test]
    fn a_cell_has_every_method_that_reaches_the_target() {
        let study = json!({ "candidates": [
            candidate("rk4", 1e-4, 1.0), candidate("rk4", 1e-7, 4.0), candidate("rk4", 1e-9, 16.0),
            candidate("cf4", 1e-7, 4.1), candidate("euler", 1e-2, 0.1), { "method": "exact", "failure": "refused" },
        ] });
        let cell = cell(&study, 1e-6);
        let dots: Vec<_> = cell.dots.iter().map(|dot| (dot.method.as_str(), dot.value)).collect();
        assert_eq!(dots, [("rk4", 400.0), ("cf4", 100.0 * 4.1)]);
        assert_eq!((cell.best, cell.text.as_str()), (Some(0), "rk4 and 1 tie"));
        assert!(super::cell(&study, 1e-12).dots.is_empty());
    }
}
