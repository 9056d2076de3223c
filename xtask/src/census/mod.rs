//! `cargo xtask census`: which method answers each solve of rows, what it costs, and what the next one would have
//! given.
//!
//! The scenes that the project ships, some heaps, and random scenes and mechanisms run for a bounded time each, in
//! every tier that solves for rows. The solvers of `polhode-response` count what they do (`polhode_response::census`);
//! that exists with the feature `census` alone, and this program builds itself with it where it has been built without.
//!
//! | module | holds |
//! |---|---|
//! | `options` | what is run |
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
mod options;
#[cfg(feature = "census")]
mod replay;
#[cfg(feature = "census")]
mod runs;
#[cfg(feature = "census")]
mod subjects;
#[cfg(feature = "census")]
mod table;

pub(crate) use options::Options;

use std::error::Error;
use std::process::ExitCode;

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
