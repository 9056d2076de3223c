//! What the checks of pages in a browser found, as rows.

use super::node::{Node, complaint};
use super::pages;
use polhode_cases::row::Row;
use polhode_cases::{CaseResult, Context};
use serde::Deserialize;
use std::collections::BTreeSet;
use std::path::Path;

/// Committed pictures of the pages that the program writes.
const PICTURES: &str = "fixtures/pictures/viewer";
/// Exit codes of the checks: all passed, and some failed.
const CHECKED: [Option<i32>; 2] = [Some(0), Some(1)];

/// What is done with committed pictures.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Aim {
    /// Pages are compared with them, and checked otherwise.
    Check,
    /// Those that are others are written anew.
    Record,
}

/// A line that the checks print.
#[derive(Debug, Deserialize)]
#[serde(untagged)]
enum Line {
    /// A check.
    Check { kind: String, page: String, what: String, good: bool, detail: String },
    /// A number that decides nothing.
    Figure { figure: String, page: String, number: Option<f64>, unit: String },
}

/// All checks of one kind.
#[derive(Debug, Default)]
struct Kind {
    words: String,
    count: usize,
    pages: BTreeSet<String>,
    failures: Vec<String>,
}

/// Writes the pages, opens them in the browser and tells what was found.
pub(super) fn rows(case: &str, context: &Context, node: &Node, browser: &Path, aim: Aim) -> CaseResult {
    let folder = tempfile::tempdir()?;
    let written = pages::write(context, folder.path())?;
    let mut command = node.script("test/browser.mjs");
    command.env("CHROMIUM", browser).args(["--json", "--synthetic", "--pictures"]).arg(context.root.join(PICTURES));
    if aim == Aim::Record {
        command.arg("--record");
    }
    let output = command.args(written).output()?;
    if !CHECKED.contains(&output.status.code()) {
        return Err(format!("the checks in the browser broke off: {}", complaint(&output)).into());
    }
    let text = String::from_utf8(output.stdout)?;
    let lines: Vec<Line> = text.lines().map(serde_json::from_str).collect::<Result<_, _>>()?;
    Ok(match aim {
        Aim::Check => judged(case, lines),
        Aim::Record => written_anew(case, lines),
    })
}

/// A row for each kind of check, and one for each figure.
fn judged(case: &str, lines: Vec<Line>) -> Vec<Row> {
    let (mut kinds, mut figures) = (Vec::<Kind>::new(), Vec::new());
    for line in lines {
        match line {
            Line::Check { kind, page, what, good, detail } => {
                let place = kinds.iter().position(|known| known.words == kind).unwrap_or_else(|| {
                    kinds.push(Kind { words: kind, ..Kind::default() });
                    kinds.len() - 1
                });
                let known = &mut kinds[place];
                known.count += 1;
                if !good {
                    known.failures.push(format!("{page}: {what} ({detail})"));
                }
                known.pages.insert(page);
            }
            Line::Figure { figure, page, number, unit } => {
                let number = number.unwrap_or(f64::NAN);
                figures.push(Row::info(case, &format!("{page}: {figure}, {unit}"), "", number.round()));
            }
        }
    }
    let rows = kinds.into_iter().map(|kind| {
        let quantity = format!("{}: {} checks of {} pages", kind.words, kind.count, kind.pages.len());
        let measured = if kind.failures.is_empty() { "none fails".to_owned() } else { kind.failures.join("; ") };
        Row::exact(case, &quantity, "none fails", measured)
    });
    rows.chain(figures).collect()
}

/// A row for each committed picture.
fn written_anew(case: &str, lines: Vec<Line>) -> Vec<Row> {
    let pictures = lines.into_iter().filter_map(|line| match line {
        Line::Check { page, detail, .. } => Some(Row::info(case, &format!("picture of {page}"), "", detail)),
        Line::Figure { .. } => None,
    });
    pictures.collect()
}

#[cfg(test)]
mod tests {
    //! A kind of check passes exactly when all of its checks do, and its row names those that do not.
    use super::*;
    use polhode_cases::row::Verdict;

    #[test]
    fn a_row_for_each_kind() -> Result<(), serde_json::Error> {
        let text = r#"{"kind":"keys","page":"a","what":"w","good":true,"detail":""}
            {"kind":"blank","page":"a","what":"c","good":true,"detail":"9 colours"}
            {"figure":"time","page":"a","number":12.4,"unit":"ms"}
            {"kind":"keys","page":"b","what":"w","good":false,"detail":"no"}"#;
        let lines = text.lines().map(serde_json::from_str).collect::<Result<_, _>>()?;
        let rows = judged("viewer", lines);
        let verdicts: Vec<Verdict> = rows.iter().map(|row| row.verdict).collect();
        assert_eq!(verdicts, [Verdict::Fails, Verdict::Ok, Verdict::Info]);
        assert_eq!(rows[0].quantity, "keys: 2 checks of 2 pages");
        assert_eq!(rows[0].measured, "b: w (no)".into());
        Ok(())
    }
}
