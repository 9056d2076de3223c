//! Runs of a shipped scene with some of its values changed.

use crate::cases::{Run, movement_m};
use crate::row::Value;
use polhode::{Effects, Outcome};
use polhode_scene::{LoadedScene, Override};
use polhode_study::sweep::{Measure, Sweep, SweepScene};
use serde::Deserialize;
use std::error::Error;
use std::num::NonZeroUsize;
use std::path::{Path, PathBuf};

/// What errors name as the place of a value that is changed.
const ORIGIN: &str = "atlas";

/// Words of an outcome that keeps what the method promises.
const COMPLETED: &str = "completed";

/// A scene file, and what is changed in it.
#[derive(Debug, Clone)]
pub(super) struct SceneRun {
    path: PathBuf,
    set: Vec<Override>,
}

/// Whether bodies move: `stands` where no point of a body has moved by more at any sample, else `falls`.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Moves {
    /// The distance, m.
    pub by_m: f64,
}

impl SceneRun {
    pub(super) fn new(path: &Path, set: &[String]) -> Result<Self, Box<dyn Error>> {
        let change = |text: &String| Override::parse(ORIGIN, text).ok_or_else(|| format!("`{text}` has no `=`"));
        Ok(Self { path: path.to_owned(), set: set.iter().map(change).collect::<Result<_, _>>()? })
    }

    /// The scene.
    pub(super) fn loaded(&self) -> Result<LoadedScene, Box<dyn Error>> {
        Ok(self.load(&self.set)?)
    }

    /// The scene with these values changed.
    fn load(&self, changes: &[Override]) -> Result<LoadedScene, polhode_scene::SceneFileError> {
        polhode_scene::load_with(&self.path, changes)
    }
}

/// What a sweep measures of the run.
pub(super) fn measured(run: &SceneRun, measures: &[String]) -> Result<Vec<Value>, Box<dyn Error>> {
    let measures = measures.iter().map(|text| Measure::parse(text)).collect();
    let sweep = Sweep::new(Vec::new(), None, 0, measures)?;
    let mut given = run.set.clone();
    given.push(Override::new(ORIGIN, "method.error", "off"));
    let load = |changes: &[Override]| run.load(changes);
    let scene = SweepScene { load: &load, given: &given, effects: Effects::Planned, is_stopped: &|| false };
    let mut rows = Vec::new();
    sweep.compute(&scene, 0..1, NonZeroUsize::MIN, |row| {
        rows.push(row);
        Ok(())
    })?;
    let row = rows.pop().ok_or("the run gave nothing")?;
    if row.outcome != COMPLETED {
        return Err(format!("the run is {}: {}", row.outcome, row.reason).into());
    }
    Ok(row.measured.into_iter().map(Value::Number).collect())
}

/// Whether bodies have moved in the run.
pub(super) fn moved(run: &SceneRun, moves: &Moves) -> Result<Vec<Value>, Box<dyn Error>> {
    let run = Run::of(&run.loaded()?.scene, Effects::Planned)?;
    if run.report.outcome != Outcome::Completed {
        let why = run.report.warnings.first().map_or("", String::as_str);
        return Err(format!("the run is not completed: {why}").into());
    }
    let first = run.record.samples.first().ok_or("the run has no sample")?;
    let most = run.record.samples.iter().map(|sample| movement_m(&run.scene, first, sample)).fold(0.0, f64::max);
    Ok(vec![Value::Text(if most <= moves.by_m { "stands" } else { "falls" }.to_owned())])
}
