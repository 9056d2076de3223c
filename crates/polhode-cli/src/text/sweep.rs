//! What a sweep has found, in a few lines: how runs ended, and of each measure the mean and its standard error.

use super::table::{Table, number};
use polhode_study::sweep::{Row, Sweep};
use std::collections::BTreeMap;
use std::fmt::Write as _;
use std::path::Path;

/// What rows of a table say together.
#[derive(Debug, Clone)]
pub(crate) struct Summary {
    outcomes: BTreeMap<String, u64>,
    measures: Vec<OfMeasure>,
    /// The largest error that a run told of itself.
    largest_error: f64,
    reason: Option<String>,
}

/// A measure over all runs that have it: mean and squared deviations by Welford 1962.
#[derive(Debug, Clone)]
struct OfMeasure {
    name: String,
    count: u64,
    mean: f64,
    squares: f64,
    least: f64,
    most: f64,
}

impl OfMeasure {
    fn add(&mut self, value: f64) {
        if value.is_nan() {
            return;
        }
        self.count += 1;
        let before = value - self.mean;
        self.mean += before / self.count as f64;
        self.squares += before * (value - self.mean);
        (self.least, self.most) = (self.least.min(value), self.most.max(value));
    }

    /// The standard error of the mean; none of one run.
    fn standard_error(&self) -> Option<f64> {
        let count = self.count as f64;
        (self.count > 1).then(|| (self.squares / (count - 1.0) / count).sqrt())
    }
}

impl Summary {
    /// Of no row yet.
    pub(crate) fn new(sweep: &Sweep) -> Self {
        let measure = |name: &str| OfMeasure {
            name: name.to_owned(),
            count: 0,
            mean: 0.0,
            squares: 0.0,
            least: f64::INFINITY,
            most: f64::NEG_INFINITY,
        };
        let measures = sweep.measures().map(measure).collect();
        Self { outcomes: BTreeMap::new(), measures, largest_error: f64::NAN, reason: None }
    }

    pub(crate) fn add(&mut self, row: &Row) {
        *self.outcomes.entry(row.outcome.clone()).or_default() += 1;
        self.largest_error = self.largest_error.max(row.error);
        self.measures.iter_mut().zip(&row.measured).for_each(|(own, value)| own.add(*value));
        if self.reason.is_none() && !row.reason.is_empty() {
            self.reason = Some(format!("run {}: {}", row.run, row.reason));
        }
    }

    /// How many rows there are.
    pub(crate) fn runs(&self) -> u64 {
        self.outcomes.values().sum()
    }

    /// How many runs came to their end, degraded ones among them.
    pub(crate) fn completed(&self) -> u64 {
        self.outcomes.iter().filter(|(outcome, _)| *outcome != "failed").map(|(_, count)| count).sum()
    }
}

/// The lines.
pub(crate) fn table(summary: &Summary, scene: &Path, path: &Path) -> String {
    let mut text = format!("sweep of {}: {} runs, in {}\n", scene.display(), summary.runs(), path.display());
    let mut all = Table::default();
    for (outcome, count) in &summary.outcomes {
        all.row([outcome, &count.to_string()]);
    }
    if !summary.largest_error.is_nan() {
        all.row(["largest estimated error", &format!("{} of a body's size", number(summary.largest_error))]);
    }
    text.push_str(&all.print());
    if let Some(reason) = &summary.reason {
        let _ = writeln!(text, "  first reason: {reason}");
    }
    if !summary.measures.is_empty() {
        let mut all = Table::default();
        all.row(["measure", "mean", "standard error", "least", "most"]);
        for own in &summary.measures {
            if own.count == 0 {
                all.row([&own.name, "none", "", "", ""]);
                continue;
            }
            let error = own.standard_error().map_or_else(String::new, number);
            all.row([&own.name, &number(own.mean), &error, &number(own.least), &number(own.most)]);
        }
        text.push('\n');
        text.push_str(&all.print());
    }
    text
}
