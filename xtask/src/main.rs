//! Development tasks of the workspace. `cargo xtask verify` runs everything that a release needs; `cargo xtask cost`
//! regenerates the figures and tables of `docs/accuracy-and-cost.md`.
//!
//! | module | holds |
//! |---|---|
//! | [`verify`] | the command: steps in order, table, exit code |
//! | [`cost`] | the command: what accuracy costs, from shipped scenes |
//! | [`house`] | rules of the house, checked from `cargo metadata` and the sources |
//! | [`commands`] | child processes: formatting, lints, docs, tests |
//! | [`cases`] | validation cases, one file per group |
//! | [`golden`] | golden trajectories |
//! | [`mod@reference`] | the values that cases are compared with |
//! | [`row`], [`table`] | one result, and how results are printed |
//! | [`readme`] | the example of the README, as a test |
//! | [`known`] | rows that are known to fail, with the reason |

mod cases;
mod commands;
mod cost;
mod golden;
mod house;
mod known;
mod readme;
mod reference;
mod row;
mod table;
mod verify;

use clap::{Parser, Subcommand};
use std::process::ExitCode;

/// Development tasks.
#[derive(Debug, Parser)]
#[command(name = "xtask", bin_name = "cargo xtask")]
struct Arguments {
    #[command(subcommand)]
    task: Task,
}

#[derive(Debug, Subcommand)]
enum Task {
    /// Runs everything that a release needs and prints one table of results.
    Verify(verify::Options),
    /// Regenerates figures and tables of docs/accuracy-and-cost.md.
    Cost(cost::Options),
}

fn main() -> ExitCode {
    let outcome = match Arguments::parse().task {
        Task::Verify(options) => verify::run(&options),
        Task::Cost(options) => verify::workspace_root().and_then(|root| cost::run(&options, &root)),
    };
    match outcome {
        Ok(code) => code,
        Err(error) => {
            eprintln!("error: {error}");
            ExitCode::from(verify::EXIT_USAGE)
        }
    }
}
