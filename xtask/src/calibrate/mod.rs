//! `cargo xtask calibrate`: the error that each run tells beside its true error, over scenes whose motion is known, and
//! `docs/error-estimates.md`, which shows them.
//!
//! | module | holds |
//! |---|---|
//! | `costs` | what estimates cost, in instructions |
//! | `page` | the document |
//! | `figure` | its figure |

mod costs;
mod figure;
mod page;

use clap::Args;
use polhode::ErrorEstimation;
use polhode_cases::calibration::{self, Known, WITHIN, judge_all};
use std::error::Error;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::time::Instant;

/// What the command takes.
#[derive(Debug, Args)]
pub(crate) struct Options {
    /// Only scenes whose names begin so.
    #[arg(long)]
    only: Option<String>,
    /// Only one scene in so many.
    #[arg(long, default_value_t = 1)]
    every: usize,
    /// Draw other random scenes: the number of the draw.
    #[arg(long, default_value_t = 0)]
    draw: u64,
    /// Write all rows to a file.
    #[arg(long)]
    json: Option<PathBuf>,
    /// How much is done to estimate errors.
    #[arg(long, value_parser = effort, default_value = "quick")]
    effort: ErrorEstimation,
    /// Find the horizons of chaotic scenes instead.
    #[arg(long)]
    horizons: bool,
    /// Count the instructions of scenes that ship instead, with estimates and without (needs valgrind).
    #[arg(long, conflicts_with = "horizons")]
    costs: bool,
    /// Write document and figure below this folder.
    #[arg(long)]
    write: Option<PathBuf>,
}

/// The effort of this name.
fn effort(name: &str) -> Result<ErrorEstimation, String> {
    let names = ErrorEstimation::ALL.map(ErrorEstimation::name);
    ErrorEstimation::from_name(name).ok_or_else(|| format!("one of {}", names.join(", ")))
}

/// Runs the scenes.
///
/// # Errors
/// When a file cannot be written.
pub(crate) fn run(options: &Options, root: &Path) -> Result<ExitCode, Box<dyn Error>> {
    let start = Instant::now();
    if options.horizons {
        return Ok(find_horizons(options, root));
    }
    if options.costs {
        return costs::print(root, options.only.as_deref().unwrap_or_default(), options.every);
    }
    let all = calibration::all(root, options.draw);
    let is_meant = |known: &&Known| options.only.as_ref().is_none_or(|only| known.name.starts_with(only.as_str()));
    let meant: Vec<&Known> = all.iter().filter(is_meant).step_by(options.every.max(1)).collect();
    let judged = judge_all(&meant, options.effort, |one| println!("{one}"));
    print!("{}", calibration::summary(&judged));
    println!("{} scenes, {:.0} s", meant.len(), start.elapsed().as_secs_f64());
    if let Some(path) = &options.json {
        fs::write(path, serde_json::to_string_pretty(&calibration::json(&judged))?)?;
    }
    if let Some(folder) = &options.write {
        page::write(&root.join(folder), &judged)?;
    }
    Ok(ExitCode::SUCCESS)
}

/// Prints the true and the told horizons of chaotic scenes.
fn find_horizons(options: &Options, root: &Path) -> ExitCode {
    let only = options.only.as_deref().unwrap_or_default();
    let found = calibration::horizons(root, only, options.effort, |one| println!("{one}"));
    let reached = found.iter().filter(|one| one.true_s.is_some()).count();
    let right = found.iter().filter(|one| one.is_right()).count();
    println!("{} scenes, {reached} reach their horizon, {right} tell it within a factor of {WITHIN}", found.len());
    ExitCode::SUCCESS
}
