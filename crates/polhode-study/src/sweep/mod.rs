//! Sweeps: a scene is run with other values, and something is measured of each run.
//!
//! Values of lists are combined (a grid, the last key fastest), others are drawn from distributions. Draws come first,
//! then the grid, so that the first rows of more draws are those of fewer. What a run is depends on its number and
//! nothing else, so that the table is the same for any number of workers and of shards.
//!
//! | module | holds |
//! |---|---|
//! | `varied` | [`Varied`]: a key and its values |
//! | `distribution` | [`Distribution`]: what values are drawn from |
//! | `measure` | [`Measure`]: what the table has of each run |
//! | `plan` | [`Sweep`]: which runs there are |
//! | `scene` | [`SweepScene`]: the scene of a sweep |
//! | `run` | one run, and all of them on several threads |
//! | `record` | [`Record`]: the file in which finished runs are kept |
//! | `error` | [`SweepError`] |

mod distribution;
mod error;
mod measure;
mod plan;
mod record;
mod run;
mod scene;
mod varied;

pub use distribution::Distribution;
pub(crate) use distribution::share;
pub use error::SweepError;
pub use measure::Measure;
pub(crate) use plan::MOST_RUNS;
pub use plan::Sweep;
pub use record::{Record, path_of_shard, shards_of};
pub use run::Row;
pub use scene::{IsStopped, LoadAnywhere, SweepScene};
pub use varied::{Values, Varied};
