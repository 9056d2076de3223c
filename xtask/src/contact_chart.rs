//! The chart at the head of `docs/accuracy-and-cost.md`: contact, error against time, by every method; the same with
//! one method highlighted for the page of that method; and the table of their best.

use polhode_view::plot::cost_panels::{CostPanel, CostPanels, PanelBand, PanelCurve, PanelPoint};
use serde_json::Value;
use std::fmt::Write as _;

/// Microseconds in a second.
const MICRO: f64 = 1e6;

/// Differences of laws below this are rounding: the laws are one law in that scene.
const SAME_LAW: f64 = 1e-9;

/// How to read the chart, and one with highlighted methods.
const HOW_TO_READ: &str =
    "a line is a method from its cheapest setting to its dearest; lower is more accurate, further left is faster";
const HOW_TO_READ_ONE: &str =
    "a line is a method from its cheapest setting to its dearest; a thin one ends at the error that a run told";

/// What selects an impact law: such a candidate shows a law, and is no method of its own.
pub(crate) const LAW_KEY: &str = "method.impact";

/// Methods that have a page of their own, and what the page is of.
pub(crate) const PAGES: [(&str, &[&str]); 6] = [
    ("accurate", &["accurate"]),
    ("stepped", &["stepped"]),
    ("fast", &["fast"]),
    ("penalty", &["penalty"]),
    ("micro-collisions", &["micro-collisions"]),
    ("thesis-forces", &["thesis", "heuristic", "guesses"]),
];

/// A scene of the chart: what its panel says, and its study as `polhode cost --json` gives it.
#[derive(Debug)]
pub(crate) struct ContactStudy<'a> {
    /// What happens in it.
    pub(crate) title: &'a str,
    /// Errors and times.
    pub(crate) study: &'a Value,
}

/// The chart; the methods of a page stand out where one is given.
pub(crate) fn svg(studies: &[ContactStudy<'_>], page: Option<&[&str]>) -> String {
    let panels: Vec<CostPanel> = studies.iter().map(panel).collect();
    let stands_out = |name: &&String| page.is_some_and(|members| members.contains(&name.as_str()));
    let names = panels.iter().flat_map(|panel| &panel.curves).map(|curve| &curve.name);
    let highlighted = names.filter(stands_out).cloned().collect();
    let chart = CostPanels {
        title: "Where bodies touch: how wrong each method is, and how long it takes".to_owned(),
        subtitle: if page.is_some() { HOW_TO_READ_ONE } else { HOW_TO_READ }.to_owned(),
        across: "seconds of computing for each simulated second".to_owned(),
        up: "error (1: unrelated to the right motion)".to_owned(),
        panels,
        highlighted,
    };
    chart.svg()
}

fn panel(contact: &ContactStudy<'_>) -> CostPanel {
    let mut curves: Vec<PanelCurve> = Vec::new();
    for candidate in methods(contact.study) {
        let name = word(candidate, "method");
        let estimated = candidate["estimated_error"].as_f64();
        let point = PanelPoint { seconds: seconds(candidate), error: error(candidate), estimated };
        match curves.iter_mut().find(|curve| curve.name == name) {
            Some(curve) => curve.points.push(point),
            None => curves.push(PanelCurve { name: name.to_owned(), points: vec![point] }),
        }
    }
    CostPanel { title: contact.title.to_owned(), curves: merged(curves), band: band(contact.study) }
}

/// The tier `thesis` finds forces by its heuristic where nothing else is asked for: with the same errors, setting by
/// setting, both are one curve.
fn merged(mut curves: Vec<PanelCurve>) -> Vec<PanelCurve> {
    let place = |name: &str| curves.iter().position(|curve| curve.name == name);
    if let (Some(tier), Some(heuristic)) = (place("thesis"), place("heuristic")) {
        let errors = |at: usize| curves[at].points.iter().map(|point| point.error.to_bits()).collect::<Vec<_>>();
        let (one, other) = (errors(tier), errors(heuristic));
        if one.starts_with(&other) || other.starts_with(&one) {
            curves.remove(heuristic);
        }
    }
    curves
}

/// How far the limits of other laws are from that of the scene's.
fn band(study: &Value) -> Option<PanelBand> {
    let all = study["candidates"].as_array().into_iter().flatten();
    let differences = all.filter_map(|candidate| candidate["law_difference"].as_f64());
    let differing: Vec<f64> = differences.filter(|difference| *difference > SAME_LAW).collect();
    let least = differing.iter().copied().reduce(f64::min)?;
    let most = differing.iter().copied().reduce(f64::max)?;
    Some(PanelBand { errors: [least, most], text: "laws of contact differ by this much".to_owned() })
}

/// Candidates that ran and are methods.
fn methods(study: &Value) -> impl Iterator<Item = &Value> {
    let is_method = |candidate: &&Value| candidate["changes"][LAW_KEY].is_null() && candidate["error"].is_number();
    study["candidates"].as_array().into_iter().flatten().filter(is_method)
}

/// What each method reaches at best in each scene, and how long that takes.
pub(crate) fn table(studies: &[ContactStudy<'_>]) -> String {
    let mut text = "| method |".to_owned();
    for contact in studies {
        let _ = write!(text, " {} |", word(contact.study, "scene"));
    }
    let _ = writeln!(text, "\n|---|{}", "---|".repeat(studies.len()));
    let mut names: Vec<&str> = Vec::new();
    for candidate in studies.iter().flat_map(|contact| candidates(contact.study)) {
        let name = word(candidate, "method");
        if candidate["changes"][LAW_KEY].is_null() && !names.contains(&name) {
            names.push(name);
        }
    }
    for name in names {
        let _ = write!(text, "| {name} |");
        for contact in studies {
            let _ = write!(text, " {} |", best(contact.study, name));
        }
        text.push('\n');
    }
    text
}

fn candidates(study: &Value) -> impl Iterator<Item = &Value> {
    study["candidates"].as_array().into_iter().flatten()
}

/// The smallest error of a method, what that run told of its error, the shortest time that reaches it, and how far its
/// law is from the scene's; or why there is none.
fn best(study: &Value, method: &str) -> String {
    let own = methods(study).filter(|candidate| word(candidate, "method") == method);
    let Some(best) = own.min_by(|a, b| error(a).total_cmp(&error(b)).then(seconds(a).total_cmp(&seconds(b)))) else {
        let mut failed = candidates(study).filter(|candidate| word(candidate, "method") == method);
        return reason(failed.next().map_or("", |candidate| word(candidate, "failure"))).to_owned();
    };
    let law = best["law_difference"].as_f64().filter(|difference| *difference > SAME_LAW);
    let law = law.map_or_else(String::new, |difference| format!("; law {difference:.1e}"));
    let told = best["estimated_error"].as_f64().map_or_else(String::new, |told| format!(" (told {told:.1e})"));
    let sign = if best["error"].as_f64().is_some_and(|own| own < error(best)) { "<= " } else { "" };
    format!("{sign}{:.1e}{told} in {:.1e}{law}", error(best), seconds(best))
}

/// Why a method did not run, in a word or two.
fn reason(failure: &str) -> &'static str {
    if failure.contains("friction") {
        "no friction"
    } else if failure.contains("guesses are accepted") {
        "too many contacts"
    } else if failure.starts_with("left out") {
        "too slow"
    } else {
        "refused"
    }
}

/// Error, or that of its reference where that is larger.
fn error(candidate: &Value) -> f64 {
    candidate["known_error"].as_f64().unwrap_or(f64::NAN)
}

/// Time for each simulated second, s.
fn seconds(candidate: &Value) -> f64 {
    candidate["us_per_simulated_s"].as_f64().unwrap_or(f64::NAN) / MICRO
}

fn word<'a>(value: &'a Value, key: &str) -> &'a str {
    value[key].as_str().unwrap_or_default()
}

#[cfg(test)]
mod tests {
    //! The chart has a curve for every method, laws are a band and no curve, and what did not run says why.
    use super::*;
    use serde_json::json;

    fn study() -> Value {
        let ran = |method: &str, error: f64, micro: f64, law: Option<f64>| {
            json!({ "method": method, "changes": {}, "error": error, "known_error": error, "us_per_simulated_s": micro,
                "law_difference": law, "estimated_error": 2.0 * error })
        };
        json!({ "scene": "box", "candidates": [
            ran("accurate", 1e-14, 1e3, None),
            ran("fast", 0.3, 1e2, Some(0.07)), ran("fast", 0.02, 1e4, Some(0.07)),
            ran("thesis", 0.5, 1e3, Some(1e-14)), ran("thesis", 0.1, 1e4, Some(1e-14)),
            ran("heuristic", 0.5, 1e3, Some(1e-14)),
            ran("guesses", 0.5, 2e2, Some(1e-14)),
            { "method": "penalty", "changes": {}, "failure": "left out: about 9 s a run" },
            { "method": "pulse", "changes": { "method.impact": "pulse" }, "error": 1e-9, "known_error": 1e-9,
                "us_per_simulated_s": 1.0, "law_difference": 0.02 },
        ] })
    }

    #[test]
    fn methods_are_curves_and_laws_are_a_band() {
        let study = study();
        let panel = panel(&ContactStudy { title: "A box falls", study: &study });
        let names: Vec<&str> = panel.curves.iter().map(|curve| curve.name.as_str()).collect();
        assert_eq!(names, ["accurate", "fast", "thesis", "guesses"]);
        let point = |seconds, error| PanelPoint { seconds, error, estimated: Some(2.0 * error) };
        assert_eq!(panel.curves[1].points, [point(1e-4, 0.3), point(1e-2, 0.02)]);
        assert_eq!(panel.band.map(|band| band.errors), Some([0.02, 0.07]));
    }

    #[test]
    fn the_table_has_the_best_of_each_and_reasons() {
        let study = study();
        let text = table(&[ContactStudy { title: "A box falls", study: &study }]);
        for line in [
            "| method | box |\n",
            "| fast | 2.0e-2 (told 4.0e-2) in 1.0e-2; law 7.0e-2 |\n",
            "| penalty | too slow |\n",
        ] {
            assert!(text.contains(line), "{line}\n{text}");
        }
        assert!(!text.contains("pulse"));
    }
}
