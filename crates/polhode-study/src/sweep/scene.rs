//! The scene of a sweep: loaded anew with the changes of every run, on any thread.

use polhode::Effects;
use polhode_scene::{LoadedScene, Override, SceneFileError};
use std::fmt;

/// Reads a scene with some of its values changed, on any thread.
pub type LoadAnywhere<'a> = dyn Fn(&[Override]) -> Result<LoadedScene, SceneFileError> + Sync + 'a;

/// Asked at every step of every run: whether runs are to end.
pub type IsStopped<'a> = dyn Fn() -> bool + Sync + 'a;

/// The scene of a sweep.
#[derive(Clone, Copy)]
pub struct SweepScene<'a> {
    /// Reads it.
    pub load: &'a LoadAnywhere<'a>,
    /// Changes that are the same for all runs.
    pub given: &'a [Override],
    /// Effects that are simulated.
    pub effects: Effects,
    /// Whether runs are to end; rows that are finished stay.
    pub is_stopped: &'a IsStopped<'a>,
}

impl fmt::Debug for SweepScene<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("SweepScene").field("given", &self.given).field("effects", &self.effects).finish_non_exhaustive()
    }
}

impl SweepScene<'_> {
    /// The scene with these changes besides those of all runs.
    pub(super) fn loaded(&self, changes: &[Override]) -> Result<LoadedScene, SceneFileError> {
        let all: Vec<Override> = self.given.iter().chain(changes).cloned().collect();
        (self.load)(&all)
    }
}
