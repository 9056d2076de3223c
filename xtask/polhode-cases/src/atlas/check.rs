//! The rows of an entry: each number beside what was published, and whether it is what was found last.

use super::entry::Entry;
use super::record::Record;
use crate::cases::{CaseResult, Context, guarded};
use crate::row::{Row, Value};
use polhode::{Executor, Task};
use polhode_study::Threads;
use std::error::Error;

/// What names of cases begin with.
pub const CASE: &str = "atlas";

/// What is read out of runs for an entry, in the order of its quantities.
///
/// # Errors
/// When it cannot be read, or the readings give more or fewer numbers than the entry has quantities.
fn measure(entry: &Entry, context: &Context) -> Result<Vec<Value>, Box<dyn Error>> {
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

/// What is read for each entry, or why nothing is; on all processors.
pub fn measure_all(entries: &[&Entry], context: &Context) -> Vec<Result<Vec<Value>, String>> {
    let mut found: Vec<Result<Vec<Value>, String>> = entries.iter().map(|_| Ok(Vec::new())).collect();
    let task = |(entry, place): (&&Entry, &mut Result<Vec<Value>, String>)| {
        *place = measure(entry, context).map_err(|error| error.to_string());
        eprintln!("{CASE}: {}", entry.name);
    };
    let tasks = entries.iter().zip(&mut found).map(|both| Box::new(move || task(both)) as Task<'_>);
    Threads::of_machine().run(tasks.collect());
    found
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
