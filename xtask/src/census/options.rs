//! What a census runs.

use clap::Args;
use std::path::PathBuf;

/// The tiers that solve for rows.
const TIERS: [&str; 4] = ["accurate", "stepped", "micro-collisions", "thesis"];

/// What is run. A build without the feature `census` calls cargo again with it.
#[derive(Debug, Args)]
pub(crate) struct Options {
    /// Shipped scenes, from the first on; all when left out.
    #[arg(long)]
    pub(super) scenes: Option<usize>,
    /// Random scenes: half of them mechanisms, half of them scenes of contacts.
    #[arg(long, default_value_t = 100)]
    pub(super) random: u64,
    /// The first seed of each.
    #[arg(long, default_value_t = 0)]
    pub(super) first: u64,
    /// Only scenes whose name contains this.
    #[arg(long)]
    pub(super) only: Option<String>,
    /// Tiers beside that of the scene itself.
    #[arg(long, value_delimiter = ',', default_values_t = TIERS.map(str::to_owned))]
    pub(super) tiers: Vec<String>,
    /// The longest time of a run, s.
    #[arg(long, default_value_t = 3.0)]
    pub(super) seconds: f64,
    /// Scenes that run beside each other.
    #[arg(long, default_value_t = 1)]
    pub(super) threads: usize,
    /// Write problems into this folder: of each kind of solve the first ones, and those of the largest residuals.
    #[arg(long)]
    pub(super) dump: Option<PathBuf>,
    /// How many of each kind.
    #[arg(long, default_value_t = 4)]
    pub(super) keep: usize,
    /// Ask what a chain finds without methods, such as "friction: yielding-newton newton-from-zero"; may be repeated.
    #[arg(long)]
    pub(super) without: Vec<String>,
    /// Solve the problems of such a folder again, by each chain, in the place of running scenes.
    #[arg(long)]
    pub(super) replay: Option<PathBuf>,
}
