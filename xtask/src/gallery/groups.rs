//! The shipped scenes in groups: `fixtures/groups.toml`, which `polhode scenes` prints too.

use super::selection::{Selection, Still};
use serde::Deserialize;
use std::collections::BTreeMap;
use std::error::Error;
use std::path::Path;

/// The file, from the root of the workspace.
pub(super) const FILE: &str = "fixtures/groups.toml";

/// All groups.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Groups {
    /// The groups, in their order.
    pub(super) groups: Vec<Group>,
    /// Scenes that show a fault, each with the scene without it.
    wrong: BTreeMap<String, String>,
}

/// A group.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Group {
    /// What it is called.
    pub(super) title: String,
    /// What its scenes show.
    pub(super) about: String,
    /// The scene of its moving picture.
    pub(super) moving: String,
    /// Names of its scenes, without those that show a fault.
    scenes: Vec<String>,
}

impl Group {
    /// Name of the file of its moving picture.
    pub(super) fn file(&self) -> String {
        format!("{}.gif", self.moving)
    }
}

impl Groups {
    /// Reads them.
    ///
    /// # Errors
    /// When the file cannot be read.
    pub(super) fn read(root: &Path) -> Result<Self, Box<dyn Error>> {
        let text = std::fs::read_to_string(root.join(FILE)).map_err(|error| format!("{FILE}: {error}"))?;
        Ok(toml::from_str(&text).map_err(|error| format!("{FILE}: {error}"))?)
    }

    /// Rows of stills of a group that show no video of the thesis: a scene that shows a fault beside the one without
    /// it, all others `columns` beside each other.
    pub(super) fn rows<'a>(&self, group: &Group, selection: &'a Selection, columns: usize) -> Vec<Vec<&'a Still>> {
        let others = selection.others();
        let still = |name: &str| others.iter().copied().find(|still| still.scene() == name);
        let mut rows = Vec::new();
        let mut row: Vec<&Still> = Vec::new();
        for name in &group.scenes {
            let Some(right) = still(name) else { continue };
            let wrong = self.wrong.iter().filter(|(_, own)| *own == name).filter_map(|(wrong, _)| still(wrong));
            let wrong: Vec<&Still> = wrong.collect();
            if wrong.is_empty() {
                row.push(right);
                if row.len() == columns {
                    rows.push(std::mem::take(&mut row));
                }
            } else {
                rows.push(wrong.into_iter().chain([right]).collect());
            }
        }
        rows.extend((!row.is_empty()).then_some(row));
        rows
    }
}
