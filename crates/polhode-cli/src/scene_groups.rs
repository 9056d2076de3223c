//! The shipped scenes in groups: `fixtures/groups.toml`, which is inside the program.

use crate::failure::Failure;
use serde::Deserialize;
use std::collections::BTreeMap;

/// All groups.
#[derive(Debug, Deserialize)]
pub(crate) struct SceneGroups {
    /// The groups, in their order.
    pub(crate) groups: Vec<SceneGroup>,
    /// Scenes that show a fault, each with the scene without it.
    wrong: BTreeMap<String, String>,
}

/// A group.
#[derive(Debug, Deserialize)]
pub(crate) struct SceneGroup {
    /// What it is called.
    pub(crate) title: String,
    /// What its scenes show.
    pub(crate) about: String,
    /// Names of its scenes, without those that show a fault.
    pub(crate) scenes: Vec<String>,
}

impl SceneGroups {
    /// Reads the text of their file.
    ///
    /// # Errors
    /// When the file that is inside the program is none.
    pub(crate) fn read(text: &str) -> Result<Self, Failure> {
        toml::from_str(text).map_err(|error| Failure::Check(format!("error: the groups of scenes: {error}")))
    }

    /// The scenes that show a fault which a scene has not.
    pub(crate) fn wrong_versions<'a>(&'a self, right: &'a str) -> impl Iterator<Item = &'a str> {
        self.wrong.iter().filter(move |(_, own)| *own == right).map(|(name, _)| name.as_str())
    }
}
