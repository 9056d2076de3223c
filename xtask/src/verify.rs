//! `cargo xtask verify`: everything that a release needs, in an order that finds cheap mistakes first.
//!
//! 1. rules of the house (seconds), 2. formatting, lints, documentation and tests by cargo, 3. validation cases,
//! 4. golden trajectories.
//!
//! Every step runs even when an earlier one failed, so that one run shows everything that is
//! wrong. Progress goes to stderr, the table (or, with `--json`, the array) to stdout.

use crate::cases::{self, Amount, Context};
use crate::row::Row;
use crate::table::{self, Counts};
use crate::{commands, golden, house, known};
use clap::Args;
use std::error::Error;
use std::path::PathBuf;
use std::process::ExitCode;
use std::time::Instant;

/// Name of the rules of the house, as of a case.
const HOUSE: &str = "house";
/// Exit code when a row fails.
const EXIT_FAILED: u8 = 1;
/// Exit code when the command cannot be understood or run.
pub(crate) const EXIT_USAGE: u8 = 2;

/// What to verify and how to print it.
#[derive(Debug, Args)]
pub(crate) struct Options {
    /// Rewrite the golden trajectories and print the largest change of each.
    #[arg(long)]
    bless: bool,
    /// Run only the cases whose name contains PATTERN (whatever the case of its letters), and nothing of cargo's.
    #[arg(long, value_name = "PATTERN")]
    only: Option<String>,
    /// Print the rows as JSON instead of a table.
    #[arg(long)]
    json: bool,
    /// Run random cases at full count instead of 1 % of it.
    #[arg(long)]
    full: bool,
}

/// Runs the command.
///
/// # Errors
/// When it cannot start: no case of that name, no reference values, no workspace.
pub(crate) fn run(options: &Options) -> Result<ExitCode, Box<dyn Error>> {
    let root = workspace_root()?;
    if let Some(code) = golden::in_snapshot_environment(options.bless)? {
        return Ok(code);
    }
    let amount = if options.full { Amount::Full } else { Amount::Part };
    let context = Context::new(&root, amount)?;
    let selected =
        |name: &str| options.only.as_ref().is_none_or(|pattern| name.to_lowercase().contains(&pattern.to_lowercase()));
    let scenes = context.shipped.names()?;
    let mut rows = Vec::new();
    if !options.bless {
        if selected(HOUSE) {
            rows.extend(timed(HOUSE, || house::check(&root)));
        }
        if options.only.is_none() {
            for check in commands::CHECKS {
                rows.extend(timed(&check.name(), || vec![check.run(&root)]));
            }
        }
        for case in cases::ALL.iter().filter(|case| selected(case.name)) {
            rows.extend(timed(case.name, || case.run(&context)));
        }
    }
    for (scene, name) in scenes.iter().map(|scene| (scene, golden::case_name(scene))) {
        if selected(&name) {
            rows.extend(timed(&name, || golden::check(&context, scene)));
        }
    }
    if rows.is_empty() {
        return Err(no_such_case(options, &scenes).into());
    }
    print(&rows, options)?;
    let failed = rows.iter().any(|row| row.verdict.fails_the_run());
    Ok(if failed { ExitCode::from(EXIT_FAILED) } else { ExitCode::SUCCESS })
}

fn no_such_case(options: &Options, scenes: &[String]) -> String {
    let cases = std::iter::once(HOUSE).chain(cases::ALL.iter().map(|case| case.name)).map(str::to_owned);
    let names: Vec<String> = cases.chain(scenes.iter().map(|scene| golden::case_name(scene))).collect();
    let pattern = options.only.as_deref().unwrap_or_default();
    format!("no case contains \"{pattern}\"; the cases are: {}", names.join(", "))
}

/// Runs one step with its name, time and number of failures on stderr.
fn timed(name: &str, step: impl FnOnce() -> Vec<Row>) -> Vec<Row> {
    eprint!("{name} ...");
    let start = Instant::now();
    let mut rows = step();
    known::mark(&mut rows);
    let failures = rows.iter().filter(|row| row.verdict.fails_the_run()).count();
    let seconds = start.elapsed().as_secs_f64();
    if failures == 0 {
        eprintln!(" {seconds:.1} s");
    } else {
        eprintln!(" {seconds:.1} s, {failures} of {} rows fail", rows.len());
    }
    rows
}

fn print(rows: &[Row], options: &Options) -> Result<(), Box<dyn Error>> {
    let counts = Counts::of(rows);
    if options.json {
        println!("{}", table::json(rows)?);
        eprintln!("{}\n{}", counts.summary_line(), counts.closing_line());
    } else {
        print!("{}", table::render(rows));
        println!("{}\n{}", counts.summary_line(), counts.closing_line());
    }
    Ok(())
}

/// The folder of the workspace: that of this program's manifest, one up.
pub(crate) fn workspace_root() -> Result<PathBuf, Box<dyn Error>> {
    let manifest =
        std::env::var_os("CARGO_MANIFEST_DIR").map_or_else(|| PathBuf::from(env!("CARGO_MANIFEST_DIR")), PathBuf::from);
    Ok(manifest.parent().ok_or("the manifest of xtask has no folder above it")?.to_owned())
}
