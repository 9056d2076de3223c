//! What the program prints: one line for each scene file.
//!
//! ```text
//! 0123456789abcdef SCENE.toml
//! failed SCENE.toml: why
//! ```
//!
//! A line that is neither is none of the program's; [`Line::read`] then gives nothing.

use crate::hash::hash_words;
use std::fmt;

/// First word of the line of a scene that has no hash.
const FAILED: &str = "failed";

/// Between the file of such a scene and the reason.
const BECAUSE: &str = ": ";

/// A line that the program prints.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Line {
    /// The scene file was run.
    Hash {
        /// The file, as it was given to the program.
        file: String,
        /// The strict hash of its run.
        hash: u64,
    },
    /// The scene file could not be run to its end.
    Failed {
        /// The file, as it was given to the program.
        file: String,
        /// Why.
        reason: String,
    },
}

impl Line {
    /// The line of a file for which there is an error: the reason is put into one line.
    pub fn failed(file: &str, reason: &dyn fmt::Display) -> Self {
        let reason = reason.to_string();
        let lines: Vec<&str> = reason.lines().map(str::trim).filter(|line| !line.is_empty()).collect();
        Self::Failed { file: file.to_owned(), reason: lines.join(" ") }
    }

    /// Reads a line back that the program printed.
    pub fn read(line: &str) -> Option<Self> {
        let (first, rest) = line.trim_end().split_once(' ')?;
        if first == FAILED {
            let (file, reason) = rest.split_once(BECAUSE)?;
            return Some(Self::Failed { file: file.to_owned(), reason: reason.to_owned() });
        }
        let hash = u64::from_str_radix(first, 16).ok().filter(|&hash| hash_words(hash) == first)?;
        Some(Self::Hash { file: rest.to_owned(), hash })
    }

    /// The file that the line is about.
    pub fn file(&self) -> &str {
        match self {
            Self::Hash { file, .. } | Self::Failed { file, .. } => file,
        }
    }
}

impl fmt::Display for Line {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Hash { file, hash } => write!(f, "{} {file}", hash_words(*hash)),
            Self::Failed { file, reason } => write!(f, "{FAILED} {file}{BECAUSE}{reason}"),
        }
    }
}

#[cfg(test)]
mod tests {
    //! What is printed is read back; what others print is not taken for it.
    use super::*;

    #[test]
    fn a_line_is_read_as_it_was_printed() {
        let hash = Line::Hash { file: "a folder/box.toml".to_owned(), hash: 0x00ab_cdef };
        assert_eq!(hash.to_string(), "0000000000abcdef a folder/box.toml");
        let failed = Line::failed("box.toml", &"no mass\n\n  at line 3: mass");
        assert_eq!(failed.to_string(), "failed box.toml: no mass at line 3: mass");
        for line in [hash, failed] {
            assert_eq!(Line::read(&format!("{line}\n")), Some(line));
        }
    }

    #[test]
    fn other_lines_are_not_taken_for_a_hash() {
        for line in ["", "warning: slow", "abc box.toml", "0000000000ABCDEF box.toml", "failed", "0000000000abcdef"] {
            assert_eq!(Line::read(line), None, "{line}");
        }
    }
}
