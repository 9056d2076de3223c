//! Development tasks of the workspace. `cargo xtask verify` runs everything that a release needs; `cargo xtask cost`
//! regenerates the figures and tables of `docs/accuracy-and-cost.md`; `cargo xtask gallery` shows the shipped scenes;
//! `cargo xtask atlas` shows published results beside those of the engine;
//! `cargo xtask house --counts` counts how far the design is kept; `cargo xtask cross` compares the bits of golden
//! trajectories on other platforms; `cargo xtask licences` writes the licence texts of what a wheel of the Python
//! package contains; `cargo xtask import-rigid-ipc` takes over scenes of another project's suite.
//!
//! | module | holds |
//! |---|---|
//! | [`atlas`] | the command: published results, and the page that shows them |
//! | [`book`] | README and book: what they print is run |
//! | [`verify`] | the command: which steps, table, exit code |
//! | [`schedule`] | which steps run beside each other, and how long each takes |
//! | [`calibrate`] | the command: errors that runs tell beside their true errors |
//! | [`census`] | the command: which method answers each solve of rows, and what the next one would give |
//! | [`cost`] | the command: what accuracy costs, from shipped scenes |
//! | [`cross`] | the command: golden trajectories on other platforms, bit by bit |
//! | [`friction`] | the command: frictional contact problems of other programs |
//! | [`cost_summary`], [`contact_chart`] | its figures of all scenes, and of contact by every method |
//! | [`narrow_phase`] | the command: separating axes against GJK |
//! | [`house`] | rules and counts of the house, from `cargo metadata` and the sources |
//! | [`commands`] | child processes: formatting, lints, docs, tests |
//! | [`golden`] | golden trajectories |
//! | [`gallery`] | the command: stills, document and page of all shipped scenes |
//! | [`table`] | how results are printed |
//! | [`chain_costs`] | the command: the time of a step of chains against their length |
//! | [`tier_costs`] | the command: the processor time of heaps in the tiers, which the plan estimates |
//! | [`viewer`] | pages in a real browser |
//! | [`playground`] | the command: the engine for pages; and what is committed of it, run |
//! | [`python`] | the Python package: built, installed, tested |
//! | [`findings`] | what historical and approximate methods are known to err by |
//! | [`known`] | rows that are known to fail, with the reason |

mod atlas;
mod book;
mod calibrate;
mod census;
mod chain_costs;
mod commands;
mod contact_chart;
mod cost;
mod cost_summary;
mod cross;
mod findings;
mod friction;
mod gallery;
mod golden;
mod house;
mod known;
mod narrow_phase;
mod playground;
mod python;
mod schedule;
mod table;
mod tier_costs;
mod verify;
mod viewer;

use clap::{Parser, Subcommand};
use polhode_cases::{elastic_table, random_scenes, rigid_ipc, tiers_agree};
use polhode_oracles::random_scene;
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
    /// Checks the rules of the house, or counts how far its design is kept (`--counts`).
    House(house::Options),
    /// Compares the strict hashes of golden trajectories on x86-64, aarch64 and wasm32.
    Cross(cross::Options),
    /// Writes a scene of the Rigid IPC suite as one of ours, with its meshes beside it.
    ImportRigidIpc(rigid_ipc::Options),
    /// Solves frictional contact problems of other programs (`.dat` files).
    SolveFriction(friction::Options),
    /// Writes stills, document and page of all shipped scenes.
    Gallery(gallery::Options),
    /// Builds the engine for pages and the scripts of pages, which are committed.
    Playground,
    /// Measures the published results of the atlas, and writes docs/atlas.md.
    Atlas(atlas::Options),
    /// Writes the licence texts of what a wheel of the Python package contains.
    Licences,
    /// Regenerates the comparison of narrow phases in docs/accuracy-and-cost.md.
    NarrowPhase,
    /// Measures impacts of elastic rectangles on finer and finer meshes, for docs/elastic-body.md.
    Elastic(elastic_table::Options),
    /// Measures the processor time of heaps in the tiers, from which the plan chooses a tier.
    TierCosts(tier_costs::Options),
    /// Counts which method answers each solve of rows, and what the next one would have given.
    Census(census::Options),
    /// Measures the time of a step of chains against their length.
    ChainCosts(chain_costs::Options),
    /// Writes the random scene of a seed as a scene file.
    RandomScene(random_scene::Options),
    /// Judges random scenes, and prints a line for each that is not right.
    JudgeScenes(random_scenes::Options),
    /// Compares the error that each run tells with its true error, on scenes whose motion is known.
    Calibrate(calibrate::Options),
    /// Judges tiers by each other on random mechanisms, and prints a line for each that is not right.
    Judge(tiers_agree::Options),
}

impl Task {
    /// Whether it tells how long something takes: that is said of a release build.
    fn tells_times(&self) -> bool {
        match self {
            Self::Cost(_)
            | Self::SolveFriction(_)
            | Self::NarrowPhase
            | Self::Elastic(_)
            | Self::TierCosts(_)
            | Self::ChainCosts(_) => true,
            Self::Verify(_)
            | Self::House(_)
            | Self::Cross(_)
            | Self::ImportRigidIpc(_)
            | Self::Atlas(_)
            | Self::Census(_)
            | Self::Gallery(_)
            | Self::Playground
            | Self::Licences
            | Self::RandomScene(_)
            | Self::JudgeScenes(_)
            | Self::Calibrate(_)
            | Self::Judge(_) => false,
        }
    }
}

fn main() -> ExitCode {
    let task = Arguments::parse().task;
    let outcome = match task {
        _ if cfg!(debug_assertions) && task.tells_times() => commands::go_on_in_release(),
        Task::Verify(options) => verify::run(&options),
        Task::House(options) => verify::workspace_root().and_then(|root| house::run(&options, &root)),
        Task::ImportRigidIpc(options) => rigid_ipc::run(&options),
        Task::Cost(options) => verify::workspace_root().and_then(|root| cost::run(&options, &root)),
        Task::Cross(options) => verify::workspace_root().and_then(|root| cross::run(&options, &root)),
        Task::SolveFriction(options) => friction::run(&options),
        Task::Gallery(options) => verify::workspace_root().and_then(|root| gallery::run(&options, &root)),
        Task::Playground => verify::workspace_root().and_then(|root| playground::run(&root)),
        Task::Atlas(options) => verify::workspace_root().and_then(|root| atlas::run(&options, &root)),
        Task::Licences => verify::workspace_root().and_then(|root| python::write_licences(&root)),
        Task::NarrowPhase => verify::workspace_root().and_then(|root| narrow_phase::run(&root)),
        Task::Elastic(options) => verify::workspace_root().and_then(|root| elastic_table::run(&options, &root)),
        Task::TierCosts(options) => tier_costs::run(&options),
        Task::Census(options) => census::run(&options),
        Task::ChainCosts(options) => chain_costs::run(&options),
        Task::RandomScene(options) => random_scene::run(&options),
        Task::JudgeScenes(options) => random_scenes::run(&options),
        Task::Calibrate(options) => verify::workspace_root().and_then(|root| calibrate::run(&options, &root)),
        Task::Judge(options) => tiers_agree::run(&options),
    };
    match outcome {
        Ok(code) => code,
        Err(error) => {
            eprintln!("error: {error}");
            ExitCode::from(verify::EXIT_USAGE)
        }
    }
}
