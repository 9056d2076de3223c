//! The rows of an entry: each number beside what was published, and whether it is what was found last.

use super::entry::Entry;
use super::record::Record;
use crate::cases::{CaseResult, Context, guarded};
use crate::row::{Row, Value};
use std::error::Error;

/// What names of cases begin with.
pub const CASE: &str = "atlas";

/// What is read out of runs for an entry, in the order of its quantities.
///
/// # Errors
/// When it cannot be read, or the readings give more or fewer numbers than the entry has quantities.
pub fn measure(entry: &Entry, context: &Context) -> Result<Vec<Value>, Box<dyn Error>> {
    let mut found = Vec::new();
    for reading in &entry.readings {
        found.extend(reading.values(context)?);
    }
    if found.len() != entry.quantities.len() {
        let (found, asked) = (found.len(), entry.quantities.len());
        return Err(format!("{}: readings give {found} values, and there are {asked} quantities", entry.name).into());
    }
    Ok(found)
}

/// The rows of an entry.
pub fn check(entry: &Entry, record: &Record, context: &Context) -> Vec<Row> {
    let case = format!("{CASE} {}", entry.name);
    guarded(&case, || rows(&case, entry, record, context))
}

fn rows(case: &str, entry: &Entry, record: &Record, context: &Context) -> CaseResult {
    let found = measure(entry, context)?;
    let mut rows: Vec<Row> = entry
        .published
        .iter()
        .zip(entry.quantities.iter().zip(&found))
        .map(|(published, (quantity, found))| published.row(case, quantity, found.clone()))
        .collect();
    let recorded = record.found.get(&entry.name);
    let mut same = Row::exact(case, "numbers are those recorded", true, recorded == Some(&found));
    let remedy = "cargo xtask atlas --record takes what is found now; look at what it changes";
    same.note = (recorded != Some(&found)).then(|| format!("recorded {recorded:?}, found {found:?}: {remedy}"));
    rows.push(same);
    Ok(rows)
}
