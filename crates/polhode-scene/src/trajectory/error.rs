//! Why a trajectory could not be read, and where in the file.

use super::expected::CUT_OFF;
use crate::trajectory_rows::RowError;
use std::fmt;
use std::path::PathBuf;
use thiserror::Error;

/// Endings of the files that can be read.
pub const TRAJECTORY_ENDINGS: &str = ".csv, .json, .npy";

/// Why a trajectory could not be read.
#[derive(Debug, Error)]
pub enum TrajectoryError {
    /// The ending of the name says no kind of trajectory.
    #[error("{}: unknown ending of a trajectory; accepted: {}", path.display(), TRAJECTORY_ENDINGS)]
    Ending {
        /// The file.
        path: PathBuf,
    },
    /// The file could not be read.
    #[error("cannot read {}: {source}", path.display())]
    Read {
        /// The file.
        path: PathBuf,
        /// Why.
        source: std::io::Error,
    },
    /// The file is not a whole trajectory of the scene.
    #[error("{}{place}: not a trajectory of the scene: {reason}", path.display())]
    Content {
        /// The file.
        path: PathBuf,
        /// Where.
        place: FilePlace,
        /// What is wrong.
        reason: String,
    },
}

impl TrajectoryError {
    /// Whether the file is right as far as it goes, and ends too early.
    pub(super) fn is_cut_off(&self) -> bool {
        matches!(self, Self::Content { reason, .. } if reason.ends_with(CUT_OFF))
    }
}

/// A place in a file.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum FilePlace {
    /// A line of a text, from 1.
    Line(u64),
    /// A line and a column of a text, from 1.
    LineAndColumn(u64, u64),
    /// Bytes before it.
    Byte(u64),
}

impl fmt::Display for FilePlace {
    /// As it stands behind the name of the file.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Line(line) => write!(f, ":{line}"),
            Self::LineAndColumn(line, column) => write!(f, ":{line}:{column}"),
            Self::Byte(byte) => write!(f, ", byte {byte}"),
        }
    }
}

impl From<RowError> for TrajectoryError {
    fn from(error: RowError) -> Self {
        match error {
            RowError::Read { path, source } => Self::Read { path, source },
            RowError::Content { path, line, reason } => Self::Content { path, place: FilePlace::Line(line), reason },
        }
    }
}
