//! Reading back a trajectory that a run of a scene has written.
//!
//! Every kind that [`output`](mod@crate::output) writes can be read: CSV, JSON and NPY, by the ending of the name, also
//! with `.partial` behind it. A file is read sample by sample, whatever its size, and held against the scene: every
//! sample has every body of the scene once, times ascend, every number is finite, and nothing is missing at the end.
//!
//! | module | holds |
//! |---|---|
//! | `error` | [`TrajectoryError`], with the place in the file |
//! | `expected` | what the scene expects of a sample |
//! | `csv_samples`, `json_samples`, `npy_samples` | the samples of each kind of file |
//! | `counted_bytes` | bytes with the line and column that they stand at |
//! | `reader` | [`TrajectoryReader`]: any of them |

mod counted_bytes;
mod csv_samples;
mod error;
mod expected;
mod json_samples;
mod npy_samples;
mod reader;

pub use crate::trajectory_rows::Velocities;
pub use error::{FilePlace, TRAJECTORY_ENDINGS, TrajectoryError};
pub use reader::{TrajectoryReader, is_trajectory};
