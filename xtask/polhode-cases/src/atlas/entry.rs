//! What the files of the atlas say.

use super::published::Published;
use super::reading::Reading;
use serde::Deserialize;
use std::error::Error;
use std::path::Path;

/// The folder, from the root of the workspace.
pub(super) const FOLDER: &str = "fixtures/atlas";

/// Entries of a kind.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Group {
    /// Where it stands among the others.
    pub order: u32,
    /// What it is called.
    pub title: String,
    /// What its entries have in common.
    pub about: String,
    /// Its entries.
    pub entries: Vec<Entry>,
}

/// A published result.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Entry {
    /// Its name, which `--only` selects by.
    pub name: String,
    /// Its heading.
    pub title: String,
    /// What is seen, for a reader without mechanics.
    pub plain: String,
    /// Where it was published: an entry of docs/REFERENCES.md.
    pub source: String,
    /// Where in it, and what else is to be said about the digits.
    pub place: Option<String>,
    /// What each number is.
    pub quantities: Vec<String>,
    /// Each as it is printed.
    pub published: Vec<Published>,
    /// The scene of its picture, where it is not that of the first reading.
    pub picture: Option<String>,
    /// How the numbers are read, in their order.
    pub readings: Vec<Reading>,
    /// Scenes of docs/peers.md on which other engines were run.
    #[serde(default)]
    pub peers: Vec<String>,
}

impl Entry {
    /// The scene whose picture shows it.
    pub fn scene(&self) -> Option<&str> {
        self.picture.as_deref().or_else(|| self.readings.iter().find_map(|reading| reading.scene.as_deref()))
    }
}

/// All groups in their order.
///
/// # Errors
/// When a file cannot be read or understood, two entries have one name, or an entry has not as many published values as
/// quantities; the message names it.
pub fn groups(root: &Path) -> Result<Vec<Group>, Box<dyn Error>> {
    let folder = root.join(FOLDER);
    let mut groups: Vec<Group> = Vec::new();
    for file in std::fs::read_dir(&folder).map_err(|error| format!("{}: {error}", folder.display()))? {
        let path = file?.path();
        if path.extension().is_some_and(|ending| ending == "toml") {
            let text = std::fs::read_to_string(&path).map_err(|error| format!("{}: {error}", path.display()))?;
            groups.push(toml::from_str(&text).map_err(|error| format!("{}: {error}", path.display()))?);
        }
    }
    groups.sort_by_key(|group| group.order);
    let mut names: Vec<&str> = Vec::new();
    for entry in groups.iter().flat_map(|group| &group.entries) {
        if names.contains(&entry.name.as_str()) {
            return Err(format!("{FOLDER}: two entries are named {}", entry.name).into());
        }
        if entry.quantities.len() != entry.published.len() {
            let (found, asked) = (entry.published.len(), entry.quantities.len());
            return Err(format!("{FOLDER}: {}: {asked} quantities and {found} published values", entry.name).into());
        }
        names.push(&entry.name);
    }
    Ok(groups)
}

#[cfg(test)]
mod tests {
    //! The files of the project are understood.
    #![allow(clippy::unwrap_used, reason = "a test that cannot go on has failed")]
    use super::*;

    #[test]
    fn the_files_of_the_project_are_understood() {
        let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
        assert!(!groups(&root).unwrap().is_empty());
    }
}
