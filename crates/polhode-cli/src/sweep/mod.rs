//! `polhode sweep`: many runs of a scene with other values, and what is measured of each.
//!
//! The table is written row by row, in the order of the runs: after a kill the same command goes on behind its last
//! whole line. A shard writes a file of its own beside the table, which the command without `--shard` takes over. A
//! table as Parquet is made of its CSV when all rows are there.
//!
//! | module | holds |
//! |---|---|
//! | `page` | the page of a sweep |

mod page;

use crate::args::SweepArgs;
use crate::failure::{self, Failure};
use crate::inputs;
use crate::interrupt::Interrupt;
use crate::progress::Progress;
use crate::scene::{self, SceneText};
use crate::stdout;
use crate::text::sweep::{json, table};
use crate::verbosity::{self, Verbosity};
use polhode_scene::{AtomicFile, Override};
use polhode_study::sweep::{
    Gathered, Measure, Parquet, Record, Row, Sensitivities, Sweep, SweepError, SweepScene, Varied, path_of_shard,
    shards_of,
};
use std::fs;
use std::io::Write as _;
use std::num::NonZeroU64;
use std::ops::Range;
use std::path::{Path, PathBuf};

/// Runs the sweep and writes its table; exit code 1 when no run was completed.
pub(crate) fn sweep(args: &SweepArgs, interrupt: &Interrupt) -> Result<(), Failure> {
    let text = SceneText::of(&args.scene.scene)?;
    let given = scene::overrides(&args.scene.changes)?;
    let load = |changes: &[Override]| text.load(changes);
    let is_stopped = || interrupt.has_come();
    let effects = scene::effects(&args.scene.changes);
    let own = SweepScene { load: &load, given: &given, effects, is_stopped: &is_stopped };
    let sweep = planned(args, &own)?;
    sweep.check(&own)?;
    let told = told(&text, &given, effects)?;
    let digest = sweep.digest(&told);
    let runs = match args.shard {
        None => 0..sweep.runs(),
        Some([number, of]) => sweep.shard(number, of)?,
    };
    let report = args.report.as_deref().map(|path| opened_page(path, args, &text)).transpose()?;
    interrupt.wait_for_steps();
    let mut gathered = Gathered::new(&sweep, &digest);
    let output = args.output.as_deref().map(|path| Output::new(path, args.shard));
    let mut record = match &output {
        None => None,
        Some(output) => Some(opened(args, output, (&sweep, &digest, &runs), &mut gathered)?),
    };
    let whole = Whole { args, sweep: &sweep, runs, interrupt };
    whole.compute(&own, &mut record, &mut gathered)?;
    if let Some((path, csv)) = output.as_ref().filter(|_| args.shard.is_none()).and_then(Output::parquet) {
        Parquet::of(path, (&sweep, &digest))?.write(csv)?;
    }
    ended(args, (&sweep, &gathered, &digest), output.as_ref(), report.map(|file| (file, told)))
}

/// A sweep, or a shard of it.
struct Whole<'a> {
    args: &'a SweepArgs,
    sweep: &'a Sweep,
    runs: Range<u64>,
    interrupt: &'a Interrupt,
}

impl Whole<'_> {
    /// Computes the rows that are not there yet; they go to the file, or to stdout.
    fn compute(
        &self,
        scene: &SweepScene<'_>,
        record: &mut Option<Record>,
        gathered: &mut Gathered<'_>,
    ) -> Result<(), Failure> {
        let first = record.as_ref().map_or(self.runs.start, Record::next);
        let mut progress = Progress::new("reading the scene");
        progress.phase("runs", (self.runs.end - first) as usize);
        let is_shown = record.is_none() && !self.args.json;
        if is_shown {
            stdout::text(&format!("{}\n", self.sweep.columns_line()))?;
        }
        let mut closed = None;
        let computed = self.sweep.compute(scene, first..self.runs.end, self.args.workers, |row: Row| {
            progress.part_done();
            gathered.add(&row);
            match record {
                Some(record) => record.append(&row),
                None if !is_shown => Ok(()),
                None => stdout::text(&format!("{}\n", row.line())).map_err(|failure| {
                    closed = Some(failure);
                    SweepError::Stopped
                }),
            }
        });
        progress.clear();
        match (closed, computed) {
            (Some(failure), _) => Err(failure),
            (None, Err(SweepError::Stopped)) => {
                let (done, all) = (gathered.rows(), self.runs.end - self.runs.start);
                let next = if self.args.output.is_some() { "; the same command goes on from there" } else { "" };
                let said = format!("{done} of {all} runs are finished{next}");
                Err(Failure::Interrupted(said, self.interrupt.code()))
            }
            (None, computed) => Ok(computed?),
        }
    }
}

/// The sweep that is asked for: of what is varied, or of what the scene says is uncertain.
fn planned(args: &SweepArgs, scene: &SweepScene<'_>) -> Result<Sweep, Failure> {
    let measures = args.measure.iter().map(|text| Measure::parse(text)).collect();
    let draws = args.random.and_then(NonZeroU64::new);
    if args.vary.is_empty() {
        let asked = args.sensitivities.map_or(Sensitivities::Planned, Sensitivities::from);
        return Ok(Sweep::uncertain(scene, draws, args.seed, measures, asked)?);
    }
    let varied: Vec<Varied> = args.vary.iter().map(|text| Varied::parse(text)).collect::<Result<_, _>>()?;
    let sweep = Sweep::new(varied, draws, args.seed, measures)?;
    let uncertain = (scene.load)(scene.given).map_or(0, |loaded| loaded.uncertain().len());
    if uncertain > 0 {
        let name = args.scene.scene.display();
        failure::remark(&format!("note: {name}: {uncertain} uncertain values are not drawn, because of --vary"));
    }
    Ok(sweep)
}

/// Where the table goes.
struct Output {
    /// Its rows.
    csv: PathBuf,
    /// The table as Parquet, if it is asked for.
    parquet: Option<PathBuf>,
}

impl Output {
    fn new(path: &Path, shard: Option<[u64; 2]>) -> Self {
        let is_parquet = path.extension().is_some_and(|ending| ending == "parquet");
        let whole = if is_parquet { path.with_extension("parquet.csv") } else { path.to_owned() };
        let csv = shard.map_or_else(|| whole.clone(), |[number, of]| path_of_shard(&whole, number, of));
        Self { csv, parquet: is_parquet.then(|| path.to_owned()) }
    }

    /// The file of Parquet, if it is asked for, and the rows that it is made of.
    fn parquet(&self) -> Option<(&Path, &Path)> {
        Some((self.parquet.as_deref()?, &self.csv))
    }

    /// What was asked for.
    fn path(&self) -> &Path {
        self.parquet.as_deref().unwrap_or(&self.csv)
    }
}

/// The file of the table, or of the shard, behind the rows that it has.
fn opened(
    args: &SweepArgs,
    output: &Output,
    (sweep, digest, runs): (&Sweep, &str, &Range<u64>),
    gathered: &mut Gathered<'_>,
) -> Result<Record, Failure> {
    if let Some(parquet) = &output.parquet {
        // What is there already is that of this sweep, or nothing is computed.
        Parquet::of(parquet, (sweep, digest))?;
    }
    let path = &output.csv;
    let mut record = Record::open(path, (sweep, digest), runs.clone(), |row| gathered.add(row))?;
    if args.shard.is_none() {
        for [number, of] in shards_of(path) {
            let shard = path_of_shard(path, number, of);
            record.take_over(&shard, (sweep, digest), sweep.shard(number, of)?, |row| gathered.add(row))?;
        }
    }
    Ok(record)
}

/// The file of the page, before anything is computed.
fn opened_page(path: &Path, args: &SweepArgs, text: &SceneText<'_>) -> Result<AtomicFile, Failure> {
    inputs::check_output(path, text.file().into_iter().chain(args.output.as_deref()))?;
    AtomicFile::create(path)
        .map_err(|error| Failure::InputOutput(format!("error: cannot write {}: {error}", path.display())))
}

/// Tells what was found, and writes the page.
fn ended(
    args: &SweepArgs,
    (sweep, gathered, digest): (&Sweep, &Gathered<'_>, &str),
    output: Option<&Output>,
    report: Option<(AtomicFile, String)>,
) -> Result<(), Failure> {
    let findings = gathered.findings();
    if let Some((mut file, told)) = report {
        let scene = args.scene.scene.display().to_string();
        let page = page::page(sweep, &findings, &page::Made { scene: &scene, told: &told, digest });
        let written = file.write_all(page.as_bytes()).and_then(|()| file.commit());
        written.map_err(|error| {
            Failure::InputOutput(format!("error: cannot write {}: {error}", file.target().display()))
        })?;
    }
    if args.json {
        stdout::json(&json(sweep, &findings))?;
    } else if let Some(output) = output.filter(|_| verbosity::asked() != Verbosity::Quiet) {
        stdout::text(&table(sweep, &findings, &args.scene.scene, output.path()))?;
    }
    if gathered.rows() > 0 && findings.draws > 0 && gathered.completed() == 0 {
        return Err(Failure::Check("error: no run was completed: the column `reason` says why".to_owned()));
    }
    Ok(())
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
