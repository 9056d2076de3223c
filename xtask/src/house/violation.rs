//! A place that breaks a rule, and what to do about it.

use super::rust_source::RustSource;

/// A place that breaks a rule.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Violation {
    /// File, relative to the workspace, with the line where there is one.
    pub(super) place: String,
    /// What is wrong and what to do.
    pub(super) what: String,
}

impl Violation {
    /// In line `line` of a file, counted from 0.
    pub(super) fn at_line(source: &RustSource, line: usize, what: impl Into<String>) -> Self {
        Self { place: format!("{}:{}", source.path(), line + 1), what: what.into() }
    }

    /// In a file as a whole.
    pub(super) fn in_file(path: impl Into<String>, what: impl Into<String>) -> Self {
        Self { place: path.into(), what: what.into() }
    }
}
