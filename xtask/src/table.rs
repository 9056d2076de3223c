//! How results are printed: one table for people, one array of objects for programs.

use polhode_cases::row::{Row, Value, Verdict};
use serde::Serialize;
use std::fmt::Write as _;

/// Numbers of rows by verdict.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub(crate) struct Counts {
    /// Within the tolerance.
    pub(crate) passed: usize,
    /// Outside the tolerance, or passing although marked as known to fail.
    pub(crate) failed: usize,
    /// Failing for a known reason.
    pub(crate) known: usize,
    /// Shown, not judged.
    pub(crate) info: usize,
    /// Not measured here.
    pub(crate) skipped: usize,
}

impl Counts {
    /// Of these rows.
    pub(crate) fn of(rows: &[Row]) -> Self {
        let count = |wanted: fn(Verdict) -> bool| rows.iter().filter(|row| wanted(row.verdict)).count();
        Self {
            passed: count(|v| v == Verdict::Ok),
            failed: count(Verdict::fails_the_run),
            known: count(|v| v == Verdict::FailsKnown),
            info: count(|v| v == Verdict::Info),
            skipped: count(|v| v == Verdict::Skipped),
        }
    }

    /// The closing line: `N passed, M failed`, and `, K skipped` when there are any.
    pub(crate) fn closing_line(&self) -> String {
        let mut line = format!("{} passed, {} failed", self.passed, self.failed);
        if self.skipped > 0 {
            let _ = write!(line, ", {} skipped", self.skipped);
        }
        line
    }

    /// The line before it, with everything that is neither passed nor failed.
    pub(crate) fn summary_line(&self) -> String {
        let rows = self.passed + self.failed + self.known + self.info + self.skipped;
        format!("{rows} rows: {} known failures, {} for information", self.known, self.info)
    }
}

/// Widest column of free text, characters.
const WIDEST_COLUMN: usize = 58;

/// The table with its header.
pub(crate) fn render(rows: &[Row]) -> String {
    let header = ["case", "quantity", "reference", "measured", "error", "tolerance", "verdict"].map(str::to_owned);
    let cells: Vec<[String; 7]> = std::iter::once(header).chain(rows.iter().map(cells_of)).collect();
    let mut widths = [0; 7];
    for line in &cells {
        for (width, cell) in widths.iter_mut().zip(line) {
            *width = (*width).max(cell.chars().count());
        }
    }
    let mut text = String::new();
    for (number, line) in cells.iter().enumerate() {
        let padded: Vec<String> = line.iter().zip(widths).map(|(cell, width)| format!("{cell:<width$}")).collect();
        let _ = writeln!(text, "{}", padded.join("  ").trim_end());
        if number == 0 {
            let _ = writeln!(text, "{}", widths.map(|width| "-".repeat(width)).join("  "));
        }
    }
    for row in rows.iter().filter(|row| row.note.is_some()) {
        let note = row.note.as_deref().unwrap_or_default();
        let _ = writeln!(text, "{}: {}, {}: {note}", row.verdict.word(), row.case, row.quantity);
    }
    text
}

fn cells_of(row: &Row) -> [String; 7] {
    [
        row.case.clone(),
        shortened(&row.quantity),
        row.reference.as_ref().map_or_else(String::new, words),
        words(&row.measured),
        if matches!(row.verdict, Verdict::Info | Verdict::Skipped) { String::new() } else { error_words(row.error) },
        row.tolerance.words(),
        row.verdict.word().to_owned(),
    ]
}

fn error_words(error: f64) -> String {
    if error == 0.0 {
        "0".to_owned()
    } else if error.is_finite() {
        format!("{error:.1e}")
    } else {
        "differs".to_owned()
    }
}

/// A value in a few characters; the JSON output has all digits.
pub(crate) fn words(value: &Value) -> String {
    match value {
        Value::Flag(flag) => flag.to_string(),
        Value::Count(count) => count.to_string(),
        Value::Number(number) => number_words(*number),
        Value::Flags(flags) => list(flags, |flag| if *flag { "yes".to_owned() } else { "no".to_owned() }),
        Value::Numbers(numbers) => list(numbers, |number| number_words(*number)),
        Value::Text(text) => shortened(text),
    }
}

/// Numbers of a list that are shown; the rest is counted.
const SHOWN_OF_LIST: usize = 3;

fn list<T>(items: &[T], word: impl Fn(&T) -> String) -> String {
    let mut shown: Vec<String> = items.iter().take(SHOWN_OF_LIST).map(word).collect();
    if items.len() > SHOWN_OF_LIST {
        shown.push(format!("+{}", items.len() - SHOWN_OF_LIST));
    }
    format!("[{}]", shown.join(" "))
}

/// Magnitudes between these are written without an exponent.
const PLAIN_NUMBERS: std::ops::Range<f64> = 1e-3..1e6;

fn number_words(number: f64) -> String {
    if number == 0.0 || (number.fract() == 0.0 && number.abs() < PLAIN_NUMBERS.end) {
        format!("{number}")
    } else if PLAIN_NUMBERS.contains(&number.abs()) {
        format!("{number:.6}")
    } else {
        format!("{number:.3e}")
    }
}

/// The first line of a text, cut at the widest column.
fn shortened(text: &str) -> String {
    let line = text.lines().next().unwrap_or_default();
    if line.chars().count() <= WIDEST_COLUMN {
        line.to_owned()
    } else {
        let kept: String = line.chars().take(WIDEST_COLUMN - 3).collect();
        format!("{kept}...")
    }
}

/// A row as a program sees it.
#[derive(Debug, Serialize)]
struct JsonRow<'a> {
    case: &'a str,
    quantity: &'a str,
    reference: Option<&'a Value>,
    measured: &'a Value,
    /// `null` where it is not finite.
    error: f64,
    /// `null` where nothing is judged.
    tolerance: f64,
    pass: bool,
    verdict: &'static str,
    #[serde(skip_serializing_if = "Option::is_none")]
    note: Option<&'a str>,
}

/// All rows as a JSON array.
///
/// # Errors
/// When a row cannot be written as JSON.
pub(crate) fn json(rows: &[Row]) -> Result<String, serde_json::Error> {
    let rows: Vec<JsonRow<'_>> = rows
        .iter()
        .map(|row| JsonRow {
            case: &row.case,
            quantity: &row.quantity,
            reference: row.reference.as_ref(),
            measured: &row.measured,
            error: row.error,
            tolerance: row.tolerance.limit(),
            pass: matches!(row.verdict, Verdict::Ok | Verdict::Info | Verdict::Skipped),
            verdict: row.verdict.word(),
            note: row.note.as_deref(),
        })
        .collect();
    serde_json::to_string_pretty(&rows)
}

#[cfg(test)]
mod tests {
    //! The closing line counts what passed and failed; the JSON has the seven keys that programs rely on.
    #![allow(clippy::unwrap_used, reason = "a test that cannot go on has failed")]
    use super::*;
    use polhode_cases::row::Tolerance;

    #[test]
    fn the_closing_line_counts_what_decides() {
        let mut known = Row::at_most("a", "known", 1.0, 2.0);
        known.mark_known("reason");
        let rows = [
            Row::at_most("a", "fine", 1.0, 0.5),
            Row::at_most("a", "bad", 1.0, 2.0),
            known,
            Row::info("a", "speed", 10.0, 9.0),
        ];
        assert_eq!(Counts::of(&rows).closing_line(), "1 passed, 1 failed");
        let skipped = [Row::skipped("a", "memory", "no such file")];
        assert_eq!(Counts::of(&skipped).closing_line(), "0 passed, 0 failed, 1 skipped");
    }

    #[test]
    fn json_rows_have_the_keys_of_the_contract() {
        let rows = [
            Row::compared("a", "b", [1.0, 2.0], [1.0, 2.5], Tolerance::Absolute(0.1)),
            Row::exact("a", "c", 1.0, f64::NAN),
        ];
        let text = json(&rows).unwrap();
        let parsed: serde_json::Value = serde_json::from_str(&text).unwrap();
        for key in ["case", "quantity", "reference", "measured", "error", "tolerance", "pass"] {
            assert!(parsed[0].get(key).is_some(), "{key} is missing");
        }
        assert_eq!(parsed[0]["pass"], false);
        assert_eq!(parsed[0]["error"], 0.5);
        assert_eq!(parsed[1]["pass"], false);
    }

    #[test]
    fn a_long_text_is_cut_to_the_column() {
        let row = Row::exact("a", &"x".repeat(200), "one", "other");
        assert!(render(&[row]).lines().all(|line| line.chars().count() < 200));
    }
}
