//! Trajectories and events out.
//!
//! A run is watched by [`Outputs`], which streams every sample to all files asked for. Nothing half-written ever stands
//! under a file's name: a file grows under a temporary name in the same folder and is moved to its own when it is
//! complete. When a run fails, what it had computed is kept under the name with `.partial` at its end, and what stood
//! under the name before stays.
//!
//! | module | holds |
//! |---|---|
//! | `atomic_file` | a file that appears when it is complete |
//! | `csv`, `npy`, `json` | the kinds of trajectory |
//! | `events` | events as CSV |
//! | `outputs` | [`Outputs`]: the observer |

pub mod atomic_file;
mod csv;
mod events;
mod json;
mod npy;
mod outputs;

pub use atomic_file::AtomicFile;
pub use csv::COLUMNS;
pub use events::EVENT_COLUMNS;
pub use npy::{NPY_WIDTH, npy_row};
pub use outputs::{OutputError, Outputs};

use polhode::BodySample;
use std::io::{self, Seek, Write};

/// Where a trajectory is written to.
pub(crate) trait Sink: Write + Seek {}

impl<T: Write + Seek> Sink for T {}

/// A kind of trajectory file.
pub(crate) trait TrajectoryFormat: std::fmt::Debug {
    /// Writes what stands before the first sample.
    fn begin(&mut self, out: &mut dyn Sink) -> io::Result<()>;

    /// Writes all bodies at time `t` (s), in the order of the scene.
    fn sample(&mut self, out: &mut dyn Sink, t: f64, bodies: &[BodySample]) -> io::Result<()>;

    /// Writes what stands after the last sample; what has been written is then a complete file.
    fn end(&mut self, out: &mut dyn Sink) -> io::Result<()>;
}

/// The numbers of a sample in the order of the columns `px` to `wz`.
pub(crate) fn numbers(sample: &BodySample) -> [f64; 13] {
    let p = sample.pose.translation;
    let [qw, qx, qy, qz] = sample.pose.rotation.to_wxyz();
    let (v, w) = (sample.velocity.linear, sample.velocity.angular);
    [p.x, p.y, p.z, qw, qx, qy, qz, v.x, v.y, v.z, w.x, w.y, w.z]
}
