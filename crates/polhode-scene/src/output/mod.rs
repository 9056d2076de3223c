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
//! | `csv_stream` | a trajectory as CSV to any writer |
//! | `error_columns` | the columns of the estimated errors |
//! | `held_back` | samples whose errors are not known yet |
//! | `events` | events as CSV |
//! | `joints` | coordinates, what acts along them, loads and powers of joints as CSV |
//! | `contacts` | contact points with their forces as CSV |
//! | `outputs` | [`Outputs`]: the observer |

pub mod atomic_file;
mod contacts;
mod csv;
mod csv_stream;
mod error_columns;
mod events;
mod held_back;
mod joints;
mod json;
mod npy;
mod outputs;

pub use atomic_file::{AtomicFile, LeftBehind, Unfinished};
pub use contacts::CONTACT_COLUMNS;
pub use csv::COLUMNS;
pub use csv_stream::CsvStream;
pub use error_columns::ERROR_COLUMNS;
pub(crate) use error_columns::ErrorColumns;
pub use events::EVENT_COLUMNS;
pub use joints::JOINT_COLUMNS;
pub use npy::{NPY_WIDTH, NPY_WIDTH_WITH_ERRORS, npy_row};
pub use outputs::{OutputError, Outputs};

use polhode::{BodyError, BodySample};
use std::fs::File;
use std::io::{self, Read, Seek, SeekFrom, Write};

/// Where a trajectory is written to.
pub(crate) trait Sink: Write + Seek {}

impl<T: Write + Seek> Sink for T {}

/// A kind of trajectory file.
pub(crate) trait TrajectoryFormat: std::fmt::Debug + Send {
    /// Writes what stands before the first sample.
    fn begin(&mut self, out: &mut dyn Sink) -> io::Result<()>;

    /// Writes all bodies at time `t` (s), in the order of the scene, with their errors where the file has them.
    fn sample(
        &mut self,
        out: &mut dyn Sink,
        t: f64,
        bodies: &[BodySample],
        errors: Option<&[BodyError]>,
    ) -> io::Result<()>;

    /// Writes what stands after the last sample; what has been written is then a complete file.
    fn end(&mut self, out: &mut dyn Sink) -> io::Result<()>;

    /// Makes a complete file of one that ends anywhere, in no more room than it has.
    fn mend(&mut self, file: &mut File) -> io::Result<()>;

    /// One that mends such a file by what stands in it alone, in another thread than the one that writes.
    fn mender(&self) -> Box<dyn TrajectoryFormat>;
}

/// Cuts a file of lines behind its last whole one.
pub(crate) fn cut_to_line(file: &mut File) -> io::Result<()> {
    let mut end = file.seek(SeekFrom::End(0))?;
    let mut block = [0; BLOCK];
    while end > 0 {
        let start = end.saturating_sub(BLOCK as u64);
        let part = &mut block[..(end - start) as usize];
        file.seek(SeekFrom::Start(start))?;
        file.read_exact(part)?;
        if let Some(newline) = part.iter().rposition(|&byte| byte == b'\n') {
            end = start + newline as u64 + 1;
            break;
        }
        end = start;
    }
    file.set_len(end)?;
    file.seek(SeekFrom::End(0)).map(drop)
}

/// Bytes that are read at once when the last line is looked for.
const BLOCK: usize = 4096;

/// The numbers of a sample in the order of the columns `px` to `wz`.
pub(crate) fn numbers(sample: &BodySample) -> [f64; 13] {
    let p = sample.pose.translation;
    let [qw, qx, qy, qz] = sample.pose.rotation.to_wxyz();
    let (v, w) = (sample.velocity.linear, sample.velocity.angular);
    [p.x, p.y, p.z, qw, qx, qy, qz, v.x, v.y, v.z, w.x, w.y, w.z]
}
