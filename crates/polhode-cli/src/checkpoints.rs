//! When and where a run is kept to be continued.

use crate::args::CheckpointArgs;
use crate::failure::Failure;
use polhode::Simulation;
use polhode_scene::{Checkpoint, Override, checkpoint};
use std::cell::Cell;
use std::path::{Path, PathBuf};

/// The checkpoints of one run, one written over the other.
pub(crate) struct Checkpoints {
    /// Where they are written; nowhere unless it was asked for.
    path: Option<PathBuf>,
    every_s: Option<f64>,
    scene: PathBuf,
    overrides: Vec<Override>,
    /// Whether one has been written.
    is_written: Cell<bool>,
}

impl Checkpoints {
    /// As the command line asks; `default` is where they are written unless it says.
    ///
    /// # Errors
    /// When the time between them is not positive, or something else stands where they are to be written.
    pub(crate) fn new(
        args: &CheckpointArgs,
        default: &Path,
        scene: &Path,
        overrides: Vec<Override>,
    ) -> Result<Self, Failure> {
        if let Some(every) = args.checkpoint_every.filter(|every| !(every.is_finite() && *every > 0.0)) {
            let what = format!("error: --checkpoint-every {every}: a positive number of seconds is needed");
            return Err(Failure::Usage(what));
        }
        let wanted = args.checkpoint_every.map(|_| default.to_owned());
        let path = args.checkpoint.clone().or(wanted);
        if let Some(path) = &path {
            checkpoint::check_place(path)?;
        }
        let (every_s, scene, is_written) = (args.checkpoint_every, scene.to_owned(), Cell::new(false));
        Ok(Self { path, every_s, scene, overrides, is_written })
    }

    /// Where they are written.
    pub(crate) fn path(&self) -> Option<&Path> {
        self.path.as_deref()
    }

    /// When the next one is due after `t`, s.
    pub(crate) fn next_s(&self, t: f64) -> f64 {
        self.every_s.map_or(f64::INFINITY, |every| {
            let next = ((t / every).floor() + 1.0) * every;
            // The quotient may round to the multiple below.
            if next > t { next } else { next + every }
        })
    }

    /// Writes one at the end of a run that had no step end at which one was due, as a run at rest has none; what to say
    /// of it.
    ///
    /// # Errors
    /// As [`Checkpoints::write`].
    pub(crate) fn write_at_end(&self, simulation: &Simulation) -> Result<Option<String>, Failure> {
        if self.is_written.get() { Ok(None) } else { self.write(simulation) }
    }

    /// Writes one, if it was asked for; what to say of it.
    ///
    /// # Errors
    /// When it cannot be written.
    pub(crate) fn write(&self, simulation: &Simulation) -> Result<Option<String>, Failure> {
        let Some(path) = &self.path else { return Ok(None) };
        Checkpoint::new(&self.scene, &self.overrides, simulation.snapshot())?.write(path)?;
        self.is_written.set(true);
        Ok(Some(format!("note: checkpoint of t = {} s in {}", simulation.time(), path.display())))
    }
}
