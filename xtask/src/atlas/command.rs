//! The command: numbers measured on all processors, compared with those recorded, and the page.

use super::page::{self, DOCUMENT};
use crate::verify::EXIT_FAILED;
use clap::Args;
use polhode_cases::atlas::{Entry, Record, groups, measure, peer_runs};
use polhode_cases::row::Value;
use polhode_cases::{Amount, Context};
use std::error::Error;
use std::fs;
use std::path::Path;
use std::process::ExitCode;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::{Mutex, PoisonError};

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

/// What became of an entry: numbers and words, or why there are none.
type Found = Result<Vec<Value>, String>;

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
    for (entry, found) in entries.iter().zip(measured(&entries, &context)) {
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

/// What is found of each entry, in their order.
fn measured(entries: &[&Entry], context: &Context) -> Vec<Found> {
    let found: Vec<Mutex<Found>> = entries.iter().map(|_| Mutex::new(Err("not measured".to_owned()))).collect();
    let next = AtomicUsize::new(0);
    let work = || {
        while let Some((entry, place)) = {
            let number = next.fetch_add(1, Ordering::Relaxed);
            entries.get(number).zip(found.get(number))
        } {
            let own = measure(entry, context).map_err(|error| error.to_string());
            eprintln!("atlas: {}", entry.name);
            *place.lock().unwrap_or_else(PoisonError::into_inner) = own;
        }
    };
    std::thread::scope(|scope| {
        let others = std::thread::available_parallelism().map_or(0, |all| all.get() - 1);
        (0..others).for_each(|_| drop(scope.spawn(work)));
        work();
    });
    found.into_iter().map(|place| place.into_inner().unwrap_or_else(PoisonError::into_inner)).collect()
}
