//! The files that a run writes: trajectories, events, pictures, plots, and CSV on stdout.

use crate::abandoned;
use crate::args::RunOutputArgs;
use crate::checkpoints::Checkpoints;
use crate::failure::{self, Failure};
use crate::heading::Heading;
use crate::inputs;
use crate::interrupt::Interrupt;
use crate::pictures::{ENDINGS, Kind, Options, Pictures};
use crate::plots::{Plots, is_plot};
use crate::scene::STANDARD;
use polhode::{ErrorEstimation, Observer, Plan, RunReport, Simulation};
use polhode_scene::{CsvStream, LoadedScene, OutputError, Outputs, page_report_json, shown_failure, shown_outcome};
use polhode_view::FrameSource;
use serde_json::Value;
use std::io::{self, BufWriter, Stdout};
use std::path::{Path, PathBuf};

/// All that a run is written to.
pub(crate) struct RunFiles {
    outputs: Outputs,
    pictures: Pictures,
    plots: Plots,
    /// CSV on stdout.
    stream: Option<CsvStream<BufWriter<Stdout>>>,
}

/// Whether a path stands for stdout.
pub(crate) fn is_stdout(path: &Path) -> bool {
    path.as_os_str() == STANDARD
}

impl RunFiles {
    /// Opens what is asked for of a run of a scene, whose error is estimated so; `inputs` are the files that it is made
    /// from.
    ///
    /// # Errors
    /// When an output would replace an input, is named twice, is of no known kind or cannot be opened.
    pub(crate) fn create(
        asked: &RunOutputArgs,
        inputs: &[PathBuf],
        (loaded, estimation): (&LoadedScene, ErrorEstimation),
        checkpoints: &Checkpoints,
        interrupt: &Interrupt,
    ) -> Result<Self, Failure> {
        check_stdout(asked)?;
        let (to_stdout, output): (Vec<_>, Vec<_>) = asked.output.iter().cloned().partition(|path| is_stdout(path));
        let tables: Vec<&Path> =
            asked.events.iter().chain(&asked.joints).chain(&asked.contacts).map(PathBuf::as_path).collect();
        check_names(&output, &tables, inputs, checkpoints)?;
        let is_picture = |path: &&PathBuf| Kind::of(path).is_some();
        let shown: Vec<PathBuf> = output.iter().filter(is_picture).cloned().collect();
        let plotted: Vec<PathBuf> = output.iter().filter(|path| is_plot(path)).cloned().collect();
        let is_trajectory = |path: &&PathBuf| !is_picture(path) && !is_plot(path);
        let trajectories: Vec<PathBuf> = output.iter().filter(is_trajectory).cloned().collect();
        let wanted = (&asked.plot[..], asked.against.as_deref());
        let plots = interrupt.remove(|| Plots::create(&plotted, wanted, loaded), Plots::temporary)?;
        let heading = Heading::of(std::iter::once(loaded));
        let create = || Pictures::create(&shown, &heading, Options::default());
        let mut pictures = interrupt.remove(create, |pictures| pictures.temporary().to_vec())?;
        let create = || {
            let create = match estimation {
                ErrorEstimation::Off => Outputs::create,
                _ => Outputs::create_with_errors,
            };
            let outputs = create(&loaded.scene, &trajectories, asked.events.as_deref())?;
            let outputs = match &asked.joints {
                Some(path) => outputs.with_joints(path, loaded.joint_names())?,
                None => outputs,
            };
            match &asked.contacts {
                Some(path) => outputs.with_contacts(path),
                None => Ok(outputs),
            }
        };
        let outputs = interrupt.keep(create, Outputs::unfinished).map_err(|error| match error {
            OutputError::Ending { .. } => Failure::Usage(format!("error: {error}, {ENDINGS}, .svg, or - for stdout")),
            error => error.into(),
        })?;
        abandoned::note(&outputs.left_behind());
        pictures.begin_run(loaded, loaded.scene.name(), FrameSource::Simulation)?;
        let begin = |_| {
            let out = BufWriter::new(io::stdout());
            match estimation {
                ErrorEstimation::Off => CsvStream::begin(&loaded.scene, out),
                _ => CsvStream::begin_with_errors(&loaded.scene, out),
            }
        };
        let stream = to_stdout.first().map(begin).transpose()?;
        Ok(Self { outputs, pictures, plots, stream })
    }

    /// Begins at the present time of a simulation.
    pub(crate) fn begin(&mut self, loaded: &LoadedScene, simulation: &Simulation) {
        self.plots.begin(loaded, simulation);
        self.pictures.begin_simulation(loaded, simulation);
    }

    /// All who are told of the run.
    pub(crate) fn observers(&mut self) -> Vec<&mut dyn Observer> {
        let mut all: Vec<&mut dyn Observer> = vec![&mut self.outputs, &mut self.pictures, &mut self.plots];
        all.extend(self.stream.as_mut().map(|stream| stream as &mut dyn Observer));
        all
    }

    /// Completes all files and moves them to their names.
    ///
    /// # Errors
    /// When something cannot be written, or drawing is stopped.
    pub(crate) fn finish(mut self, report: &RunReport, interrupt: &Interrupt) -> Result<(), Failure> {
        if let Err(error) = self.stream.take().map_or(Ok(()), CsvStream::finish) {
            // The run has stopped there: the files are not whole either.
            let failure = Failure::from(error);
            self.keep(&report.plan, "stdout was closed", interrupt);
            return Err(failure);
        }
        interrupt.move_kept(|| self.outputs.finish())?;
        show(self.pictures, &shown_outcome(report), &page_report_json(report), interrupt)?;
        self.plots.finish(report)
    }

    /// Keeps what has been written of a run that did not come to its end, says where, and lets pictures and plots say
    /// why. What goes wrong here is told, but is not why the run ended.
    pub(crate) fn keep(self, plan: &Plan, why: &str, interrupt: &Interrupt) {
        let told = interrupt.move_kept(|| {
            self.outputs.keep_partial().map_err(Failure::from).map(|paths| {
                for path in paths {
                    failure::note(&format!("note: what was computed is in {}", path.display()));
                }
            })
        });
        let shown = show(self.pictures, &shown_failure(why), &Value::Null, interrupt);
        let plotted = self.plots.finish_stopped(plan, why);
        let streamed = self.stream.map_or(Ok(()), CsvStream::finish).map_err(Failure::from);
        for other in [told, shown, plotted, streamed].into_iter().filter_map(Result::err) {
            failure::note(other.message());
        }
    }
}

/// Completes what shows the run, whether it has ended well or not: a page says itself where the run stopped.
fn show(mut pictures: Pictures, outcome: &str, report: &Value, interrupt: &Interrupt) -> Result<(), Failure> {
    pictures.end_run(outcome)?;
    pictures.finish(report, interrupt)
}

/// That stdout is asked for by one thing at the most, and is there where a report is to go.
fn check_stdout(asked: &RunOutputArgs) -> Result<(), Failure> {
    if asked.json {
        crate::stdout::expect_open()?;
    }
    let count = asked.output.iter().filter(|path| is_stdout(path)).count();
    let refused = if asked.joints.as_deref().is_some_and(is_stdout) {
        "error: --joints -: only trajectories go to stdout, by -o -; give a file"
    } else if asked.contacts.as_deref().is_some_and(is_stdout) {
        "error: --contacts -: only trajectories go to stdout, by -o -; give a file"
    } else if asked.events.as_deref().is_some_and(is_stdout) {
        "error: --events -: only trajectories go to stdout, by -o -; give a file"
    } else if count > 1 {
        "error: -o - is named twice: every output needs a place of its own"
    } else if count == 1 && asked.json {
        "error: -o - and --json both want stdout: write one of them to a file"
    } else {
        return Ok(());
    };
    Err(Failure::Usage(refused.to_owned()))
}

/// That outputs are none of the inputs, and have names of their own.
fn check_names(
    output: &[PathBuf],
    tables: &[&Path],
    inputs: &[PathBuf],
    checkpoints: &Checkpoints,
) -> Result<(), Failure> {
    let all: Vec<&Path> = output.iter().map(PathBuf::as_path).chain(tables.iter().copied()).collect();
    for (number, &path) in all.iter().enumerate() {
        inputs::check_output(path, inputs.iter().map(PathBuf::as_path))?;
        let is_named = |other: &&Path| inputs::is_same(path, other);
        if checkpoints.path().iter().any(is_named) || all[..number].iter().any(is_named) {
            let what = format!("error: {} is named twice: every output needs a file of its own", path.display());
            return Err(Failure::Usage(what));
        }
    }
    Ok(())
}
