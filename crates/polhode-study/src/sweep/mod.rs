//! Sweeps: a scene is run with other values, and something is measured of each run.
//!
//! Values of lists are combined (a grid, the last key fastest), others are drawn from distributions. Draws come first,
//! then the grid, so that the first rows of more draws are those of fewer. What a run is depends on its number and
//! nothing else, so that the table is the same for any number of workers and of shards.
//!
//! | module | holds |
//! |---|---|
//! | `varied` | [`Varied`]: a key and its values |
//! | `distribution` | how values are drawn from a distribution |
//! | `uncertain` | the sweep of what a scene says is uncertain |
//! | `design` | [`Sensitivities`]: which runs it has, and what each is for |
//! | `gauss` | nodes and weights of Gauss's quadrature |
//! | `measure` | [`Measure`]: what the table has of each run |
//! | `plan` | [`Sweep`]: which runs there are |
//! | `scene` | [`SweepScene`]: the scene of a sweep |
//! | `run` | one run, and all of them on several threads |
//! | `record` | [`Record`]: the file in which finished runs are kept |
//! | `parquet` | [`Parquet`]: the table as Parquet |
//! | `findings` | [`Findings`]: what the rows say together |
//! | `band` | [`Band`]: mean, deviation and quantiles; shares of outcomes |
//! | `sensitivity` | [`OfKey`]: what a measure hangs on |
//! | `error` | [`SweepError`] |

mod band;
mod design;
mod distribution;
mod error;
mod findings;
mod gauss;
mod measure;
mod parquet;
mod plan;
mod record;
mod run;
mod scene;
mod sensitivity;
mod uncertain;
mod varied;

pub use band::{Band, Share};
pub use design::Sensitivities;
pub(crate) use distribution::share;
pub use error::SweepError;
pub use findings::{Findings, Gathered, OfMeasure};
pub use measure::Measure;
pub use parquet::Parquet;
pub(crate) use plan::MOST_RUNS;
pub use plan::Sweep;
pub use record::{Record, path_of_shard, shards_of};
pub use run::Row;
pub use scene::{IsStopped, LoadAnywhere, SweepScene};
pub use sensitivity::{Derivative, Index, Indices, Method, OfKey};
pub use varied::{Acts, Values, Varied};
