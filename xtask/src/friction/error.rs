//! Why a problem file is refused: file, line, what was found and what is accepted.

use polhode::response::ResponseError;
use std::path::PathBuf;

/// Why a frictional contact problem cannot be taken from a file.
#[derive(Debug, thiserror::Error)]
pub(crate) enum ProblemFileError {
    /// The file cannot be read.
    #[error("{}: {source}", path.display())]
    Read {
        /// The file.
        path: PathBuf,
        /// Why.
        source: std::io::Error,
    },
    /// Something in it.
    #[error("{}:{line}: {fault}", path.display())]
    At {
        /// The file.
        path: PathBuf,
        /// The line, from 1.
        line: usize,
        /// What is wrong there.
        fault: Fault,
    },
}

impl ProblemFileError {
    /// Whether the file itself could not be read.
    pub(crate) fn is_reading(&self) -> bool {
        matches!(self, Self::Read { .. })
    }
}

/// What is wrong in a line.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub(crate) enum Fault {
    /// The file ends before its numbers do.
    #[error("the file ends here, but {expected} more {} {what} must \
        follow", if *expected == 1 { "number of" } else { "numbers of" })]
    CutOff {
        /// What is missing.
        what: &'static str,
        /// How many numbers of it.
        expected: usize,
    },
    /// Numbers are left over.
    #[error(
        "{count} more numbers than the counts of the file ask for begin here; a single flag may follow the coefficients"
    )]
    LeftOver {
        /// How many.
        count: usize,
    },
    /// A count is not what the others ask for.
    #[error("{what} must be {expected}, found {found}")]
    Count {
        /// Which count.
        what: &'static str,
        /// What is accepted.
        expected: String,
        /// What was found.
        found: String,
    },
    /// A number is NaN or infinite.
    #[error("{what}: {found} is not a finite number")]
    NotFinite {
        /// Where it stands.
        what: &'static str,
        /// The text.
        found: String,
    },
    /// A text is no number.
    #[error("{what}: expected a number, found `{found}`")]
    NoNumber {
        /// Where it stands.
        what: &'static str,
        /// The text.
        found: String,
    },
    /// A coefficient of friction is negative.
    #[error("the coefficient of friction of contact {contact} must be at least 0, found {value}")]
    Friction {
        /// The contact, from 0.
        contact: usize,
        /// The coefficient.
        value: f64,
    },
    /// The matrix is refused: not symmetric, a negative diagonal.
    #[error(transparent)]
    Matrix(#[from] ResponseError),
}
