//! `cargo xtask census`: which method answers each solve of rows, what it costs, and what the next one would have given.
//!
//! The scenes that the project ships, some heaps, and random scenes and mechanisms run for a bounded time each, in every tier that
//! solves for rows. The solvers of `polhode-response` count what they do (`polhode_response::census`); that exists with the
//! feature `census` alone, and this program builds itself with it where it has been built without.
//!
//! | module | holds |
//! |---|---|
//! | `asks` | what is asked for, by the file that asks |
//! | `subjects` | the scenes |
//! | `runs` | one run, bounded |
//! | `table` | the tables |
//! | `dump` | the problems themselves, a file each |
//! | `replay` | such files solved again, by each chain |

#[cfg(feature = "census")]
mod asks;
#[cfg(feature = "census")]
mod dump;
#[cfg(feature = "census")]
mod replay;
#[cfg(feature = "census")]
mod runs;
#[cfg(feature = "census")]
mod subjects;
#[cfg(feature = "census")]
mod table;

use clap::Args;
use std::error::Error;
use std::path::PathBuf;
use std::process::ExitCode;

/// What is run. A build without the feature `census` calls cargo again with it.
#[derive(Debug, Args)]
pub(crate) struct Options {
    /// Shipped scenes, from the first on; all when left out.
    #[arg(long)]
    scenes: Option<usize>,
    /// Random scenes: half of them mechanisms, half of them scenes of contacts.
    #[arg(long, default_value_t = 100)]
    random: u64,
    /// The first seed of each.
    #[arg(long, default_value_t = 0)]
    first: u64,
    /// Only scenes whose name contains this.
    #[arg(long)]
    only: Option<String>,
    /// Tiers beside that of the scene itself.
    #[arg(long, value_delimiter = ',', default_values_t = ["accurate", "stepped", "micro-collisions", "thesis"].map(str::to_owned))]
    tiers: Vec<String>,
    /// The longest time of a run, s.
    #[arg(long, default_value_t = 3.0)]
    seconds: f64,
    /// Scenes that run beside each other.
    #[arg(long, default_value_t = 1)]
    threads: usize,
    /// Write problems into this folder: of each kind of solve the first ones, and those of the largest residuals.
    #[arg(long)]
    dump: Option<PathBuf>,
    /// How many of each kind.
    #[arg(long, default_value_t = 4)]
    keep: usize,
    /// Ask what a chain finds without methods, such as "friction: yielding-newton newton-from-zero"; may be repeated.
    #[arg(long)]
    without: Vec<String>,
    /// Solve the problems of such a folder again, by each chain, in the place of running scenes.
    #[arg(long)]
    replay: Option<PathBuf>,
}

/// Runs the scenes and prints the tables.
///
/// # Errors
/// When scenes cannot be read, or problems not be written.
#[cfg(feature = "census")]
pub(crate) fn run(options: &Options) -> Result<ExitCode, Box<dyn Error>> {
    use polhode_response::census;
    if let Some(folder) = &options.replay {
        replay::run(folder)?;
        return Ok(ExitCode::SUCCESS);
    }
    census::leave_out(options.without.iter().map(|text| left_out(text)).collect::<Result<_, _>>()?);
    if options.dump.is_some() {
        census::keep_problems(options.keep);
    }
    let subjects = subjects::all(options)?;
    let ends = runs::all(&subjects, options);
    let counted = census::take();
    println!("{} scenes; runs {ends}.\n", subjects.len());
    table::print(&counted);
    if let Some(folder) = &options.dump {
        let files = dump::write(&counted, folder)?;
        println!("\n{files} problems in {}", folder.display());
    }
    Ok(ExitCode::SUCCESS)
}

/// A chain and methods, from words.
#[cfg(feature = "census")]
fn left_out(text: &str) -> Result<polhode_response::census::LeftOut, Box<dyn Error>> {
    use polhode_response::census::{Chain, LeftOut};
    let (chain, methods) = text.split_once(':').ok_or("--without asks for a chain, a colon and methods")?;
    let named = Chain::ALL.iter().find(|own| own.name() == chain.trim());
    let chain = *named.ok_or_else(|| format!("no chain is named {chain}"))?;
    Ok(LeftOut { chain, methods: methods.split_whitespace().map(str::to_owned).collect() })
}

/// Goes on in a build with the feature, with the same arguments.
///
/// # Errors
/// When cargo cannot be run.
#[cfg(not(feature = "census"))]
pub(crate) fn run(_: &Options) -> Result<ExitCode, Box<dyn Error>> {
    crate::commands::go_on_with(&["--features", "census"])
}
