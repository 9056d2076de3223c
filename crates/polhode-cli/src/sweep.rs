//! `polhode sweep`: many runs of a scene with other values, and what is measured of each.
//!
//! The table is written row by row, in the order of the runs: after a kill the same command goes on behind its last
//! whole line. A shard writes a file of its own beside the table, which the command without `--shard` takes over.

use crate::args::SweepArgs;
use crate::failure::Failure;
use crate::interrupt::Interrupt;
use crate::progress::Progress;
use crate::scene::{self, SceneText};
use crate::stdout;
use crate::text::sweep::{Summary, table};
use crate::verbosity::{self, Verbosity};
use polhode_scene::Override;
use polhode_study::sweep::{Measure, Record, Row, Sweep, SweepError, SweepScene, Varied, path_of_shard, shards_of};
use std::fs;
use std::num::NonZeroU64;
use std::ops::Range;
use std::path::Path;

/// Runs the sweep and writes its table; exit code 1 when no run was completed.
pub(crate) fn sweep(args: &SweepArgs, interrupt: &Interrupt) -> Result<(), Failure> {
    let varied: Vec<Varied> = args.vary.iter().map(|text| Varied::parse(text)).collect::<Result<_, _>>()?;
    let measures = args.measure.iter().map(|text| Measure::parse(text)).collect();
    let sweep = Sweep::new(varied, args.random.and_then(NonZeroU64::new), args.seed, measures)?;
    let text = SceneText::of(&args.scene.scene)?;
    let given = scene::overrides(&args.scene.changes)?;
    let load = |changes: &[Override]| text.load(changes);
    let is_stopped = || interrupt.has_come();
    let effects = scene::effects(&args.scene.changes);
    let own = SweepScene { load: &load, given: &given, effects, is_stopped: &is_stopped };
    sweep.check(&own)?;
    let digest = sweep.digest(&told(&text, &given, effects)?);
    let runs = match args.shard {
        None => 0..sweep.runs(),
        Some([number, of]) => sweep.shard(number, of)?,
    };
    interrupt.wait_for_steps();
    let mut summary = Summary::new(&sweep);
    let path = args.output.as_deref().map(|path| match args.shard {
        Some([number, of]) => path_of_shard(path, number, of),
        None => path.to_owned(),
    });
    let mut record = match &path {
        None => None,
        Some(path) => Some(opened(args, path, (&sweep, &digest, &runs), &mut summary)?),
    };
    let first = record.as_ref().map_or(runs.start, Record::next);
    let mut progress = Progress::new("reading the scene");
    progress.phase("runs", (runs.end - first) as usize);
    if record.is_none() {
        stdout::text(&format!("{}\n", sweep.columns_line()))?;
    }
    let mut closed = None;
    let computed = sweep.compute(&own, first..runs.end, args.workers, |row: Row| {
        progress.part_done();
        summary.add(&row);
        match &mut record {
            Some(record) => record.append(&row),
            None => stdout::text(&format!("{}\n", row.line())).map_err(|failure| {
                closed = Some(failure);
                SweepError::Stopped
            }),
        }
    });
    progress.clear();
    if let Some(failure) = closed {
        return Err(failure);
    }
    match computed {
        Err(SweepError::Stopped) => {
            let (done, all) = (summary.runs(), runs.end - runs.start);
            let next = if args.output.is_some() { "; the same command goes on from there" } else { "" };
            return Err(Failure::Interrupted(format!("{done} of {all} runs are finished{next}"), interrupt.code()));
        }
        computed => computed?,
    }
    if let Some(path) = path.filter(|_| verbosity::asked() != Verbosity::Quiet) {
        stdout::text(&table(&summary, &args.scene.scene, &path))?;
    }
    if summary.runs() > 0 && summary.completed() == 0 {
        return Err(Failure::Check("error: no run was completed: the column `reason` says why".to_owned()));
    }
    Ok(())
}

/// The file of the table, or of the shard, behind the rows that it has.
fn opened(
    args: &SweepArgs,
    path: &Path,
    (sweep, digest, runs): (&Sweep, &str, &Range<u64>),
    summary: &mut Summary,
) -> Result<Record, Failure> {
    if path.extension().is_some_and(|ending| ending == "parquet") {
        let what = "a table is written as CSV; `ph.sweep(save=...)` in Python writes Parquet";
        return Err(Failure::Usage(format!("error: {}: {what}", path.display())));
    }
    let mut record = Record::open(path, (sweep, digest), runs.clone(), |row| summary.add(row))?;
    if args.shard.is_none() {
        for [number, of] in shards_of(path) {
            let shard = path_of_shard(path, number, of);
            record.take_over(&shard, (sweep, digest), sweep.shard(number, of)?, |row| summary.add(row))?;
        }
    }
    Ok(record)
}

/// What the scene is made of, as text: two sweeps of one text are one sweep.
fn told(text: &SceneText<'_>, given: &[Override], effects: polhode::Effects) -> Result<String, Failure> {
    let own = match text {
        SceneText::File(path) => {
            let read =
                fs::read(path).map_err(|error| Failure::InputOutput(format!("error: {}: {error}", path.display())))?;
            String::from_utf8_lossy(&read).into_owned()
        }
        SceneText::Stdin(text) => text.clone(),
        SceneText::Example(_, text) => (*text).to_owned(),
    };
    let changes: Vec<String> = given.iter().map(|own| format!("{}={}", own.key, own.value)).collect();
    Ok(format!("{own}\n{}\n{effects:?}", changes.join("\n")))
}

impl From<SweepError> for Failure {
    fn from(error: SweepError) -> Self {
        match error {
            SweepError::Scene(error) => error.into(),
            SweepError::Foreign { .. } | SweepError::File { .. } => Self::InputOutput(format!("error: {error}")),
            error => Self::Usage(format!("error: {error}")),
        }
    }
}
