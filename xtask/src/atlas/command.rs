//! The command: numbers measured on all processors, compared with those recorded, and the page.

use super::page::{self, DOCUMENT};
use crate::verify::EXIT_FAILED;
use clap::Args;
use polhode_cases::atlas::{Entry, Record, groups, measure_all, peer_runs};
use polhode_cases::{Amount, Context};
use std::error::Error;
use std::fs;
use std::path::Path;
use std::process::ExitCode;

/// What to measure.
#[derive(Debug, Args)]
pub(crate) struct Options {
    /// Records what is found, instead of failing where it is another number than that recorded.
    #[arg(long)]
    record: bool,
    /// Measures only the entries whose name contains PATTERN.
    #[arg(long, value_name = "PATTERN")]
    only: Option<String>,
}

/// Measures the entries, and writes the page.
///
/// # Errors
/// When the files of the atlas are not understood, or a file cannot be written.
pub(crate) fn run(options: &Options, root: &Path) -> Result<ExitCode, Box<dyn Error>> {
    let context = Context::new(root, Amount::Part)?;
    let groups = groups(root)?;
    let is_meant = |entry: &&Entry| options.only.as_ref().is_none_or(|pattern| entry.name.contains(pattern.as_str()));
    let entries: Vec<&Entry> = groups.iter().flat_map(|group| &group.entries).filter(is_meant).collect();
    let mut record = Record::read(root)?;
    let mut wrong = 0;
    for (entry, found) in entries.iter().zip(measure_all(&entries, &context)) {
        match found {
            Ok(found) if options.record => drop(record.found.insert(entry.name.clone(), found)),
            Ok(found) if record.found.get(&entry.name) == Some(&found) => {}
            Ok(found) => {
                wrong += 1;
                eprintln!("{}: recorded {:?}, found {found:?}", entry.name, record.found.get(&entry.name));
            }
            Err(why) => {
                wrong += 1;
                eprintln!("{}: {why}", entry.name);
            }
        }
    }
    if options.record {
        record.found.retain(|name, _| groups.iter().flat_map(|group| &group.entries).any(|entry| entry.name == *name));
        record.write(root)?;
    }
    fs::write(root.join(DOCUMENT), page::text(&groups, &record, &peer_runs(root)?))?;
    println!("{} entries, {wrong} whose numbers are not those recorded; {DOCUMENT} is written", entries.len());
    Ok(if wrong > 0 { ExitCode::from(EXIT_FAILED) } else { ExitCode::SUCCESS })
}
