//! What was found last: `fixtures/atlas/recorded.json`, by the names of the entries.

use super::entry::FOLDER;
use crate::row::Value;
use std::collections::BTreeMap;
use std::error::Error;
use std::path::{Path, PathBuf};

/// The file.
const FILE: &str = "recorded.json";

/// What was found last.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Record {
    /// Numbers and words of each entry.
    pub found: BTreeMap<String, Vec<Value>>,
}

impl Record {
    fn path(root: &Path) -> PathBuf {
        root.join(FOLDER).join(FILE)
    }

    /// Reads it; nothing where there is no file.
    ///
    /// # Errors
    /// When it cannot be understood.
    pub fn read(root: &Path) -> Result<Self, Box<dyn Error>> {
        let path = Self::path(root);
        if !path.exists() {
            return Ok(Self::default());
        }
        let text = std::fs::read_to_string(&path).map_err(|error| format!("{}: {error}", path.display()))?;
        Ok(Self { found: serde_json::from_str(&text).map_err(|error| format!("{}: {error}", path.display()))? })
    }

    /// Writes it.
    ///
    /// # Errors
    /// When the file cannot be written.
    pub fn write(&self, root: &Path) -> Result<(), Box<dyn Error>> {
        Ok(std::fs::write(Self::path(root), serde_json::to_string_pretty(&self.found)? + "\n")?)
    }
}
