//! The shipped scenes with their runs, and what is shown of them.

use super::groups::{self, Groups};
use super::selection::{FILE, Selection, Still};
use polhode_cases::{Context, Run};
use polhode_scene::LoadedScene;
use std::collections::BTreeMap;
use std::error::Error;
use std::sync::Arc;

/// A shipped scene with its run.
#[derive(Debug)]
pub(super) struct Shown {
    /// What its file says.
    pub(super) loaded: LoadedScene,
    /// Its run.
    pub(super) run: Arc<Run>,
}

/// All shipped scenes.
#[derive(Debug)]
pub(super) struct ShownScenes {
    /// Which stills there are.
    pub(super) selection: Selection,
    /// The scenes in groups.
    pub(super) groups: Groups,
    /// The scenes by name.
    pub(super) scenes: BTreeMap<String, Shown>,
}

impl ShownScenes {
    /// Loads and runs every shipped scene, unless it has been run; `tell` is told the name of each.
    ///
    /// # Errors
    /// When a scene is refused, does not run to its end, or a still is of a scene that does not ship.
    pub(super) fn new(context: &Context, tell: impl Fn(&str)) -> Result<Self, Box<dyn Error>> {
        let selection = Selection::read(&context.root)?;
        let groups = Groups::read(&context.root)?;
        let mut scenes = BTreeMap::new();
        for name in context.shipped.names()? {
            tell(&name);
            let loaded = polhode_scene::load_with(&context.shipped.path(&name), &[]);
            let loaded = loaded.map_err(|error| format!("{name}: {error}"))?;
            let run = context.shipped.run(&name)?;
            scenes.insert(name, Shown { loaded, run });
        }
        if let Some(group) = groups.groups.iter().find(|group| !scenes.contains_key(&group.moving)) {
            return Err(format!("{}: there is no scene {}", groups::FILE, group.moving).into());
        }
        match selection.stills.iter().find(|still| !scenes.contains_key(still.scene())) {
            Some(still) => Err(format!("{FILE}: {}: there is no scene {}", still.name, still.scene()).into()),
            None => Ok(Self { selection, groups, scenes }),
        }
    }

    /// The scene of a still.
    pub(super) fn of_still(&self, still: &Still) -> Option<&Shown> {
        self.scenes.get(still.scene())
    }

    /// Names of scenes that have no still of their own.
    pub(super) fn unseen(&self) -> Vec<String> {
        self.scenes.keys().filter(|name| self.selection.still(name).is_none()).cloned().collect()
    }
}
