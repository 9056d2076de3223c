//! The text of robot files, and why a robot file could not be used.

use super::finding::{Finding, Severity};
use crate::files::{Fault, Files};
use std::fmt::Write as _;
use std::io;
use std::path::{Path, PathBuf};
use thiserror::Error;

/// Largest robot file read, bytes: one of some hundred links has some hundred thousand.
pub const LARGEST_ROBOT_FILE: u64 = 64 << 20;

/// Most findings of a file that is refused that are shown: more do not help.
const MOST_SHOWN: usize = 20;

/// Why a robot file could not be used.
#[derive(Debug, Error)]
pub enum RobotFileError {
    /// The file could not be read.
    #[error("cannot read {}: {source}", path.display())]
    Read {
        /// The file.
        path: PathBuf,
        /// Why.
        source: io::Error,
    },
    /// The file is larger than any robot.
    #[error("{} is larger than {limit} bytes, which no robot is", path.display())]
    TooLarge {
        /// The file.
        path: PathBuf,
        /// The largest size accepted, bytes.
        limit: u64,
    },
    /// The file is not UTF-8 text.
    #[error("{}: not a robot file: byte {offset} is not UTF-8 text", path.display())]
    NotText {
        /// The file.
        path: PathBuf,
        /// The byte, from 0.
        offset: usize,
    },
    /// The content is refused; all that was found, what refuses it first.
    #[error("{}", shown(_0))]
    Refused(Vec<Finding>),
}

impl RobotFileError {
    /// Whether reading a file failed, as opposed to what stands in it.
    pub fn is_input_output(&self) -> bool {
        matches!(self, Self::Read { .. })
    }

    /// What was found in the content.
    pub fn findings(&self) -> &[Finding] {
        match self {
            Self::Refused(findings) => findings,
            _ => &[],
        }
    }
}

/// What refuses a file, below each other.
fn shown(findings: &[Finding]) -> String {
    let refusing: Vec<&Finding> = findings.iter().filter(|finding| finding.severity() == Severity::Refused).collect();
    let mut text = String::new();
    for (number, finding) in refusing.iter().take(MOST_SHOWN).enumerate() {
        let line = if number == 0 { "" } else { "\n" };
        let _ = write!(text, "{line}{finding}");
    }
    if refusing.len() > 1 {
        let more = if refusing.len() > MOST_SHOWN { " are shown; there are more" } else { "" };
        let _ = write!(text, "\n{} errors{more}", refusing.len().min(MOST_SHOWN));
    }
    text
}

/// The text of a robot file.
pub(super) fn text_of(files: Files, path: &Path) -> Result<String, RobotFileError> {
    let bytes = files.bounded(path, LARGEST_ROBOT_FILE).map_err(|fault| match fault {
        Fault::Io(source) => RobotFileError::Read { path: path.to_owned(), source },
        Fault::TooLarge => RobotFileError::TooLarge { path: path.to_owned(), limit: LARGEST_ROBOT_FILE },
    })?;
    String::from_utf8(bytes)
        .map_err(|error| RobotFileError::NotText { path: path.to_owned(), offset: error.utf8_error().valid_up_to() })
}
