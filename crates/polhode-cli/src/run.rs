//! `polhode run` and `polhode resume`: simulate a scene, from its start or from a checkpoint.

use crate::args::{ResumeArgs, RunArgs, RunOutputArgs};
use crate::checkpoints::Checkpoints;
use crate::failure::{self, Failure};
use crate::heading::Heading;
use crate::pictures::{self, ENDINGS, Kind, Options, Pictures};
use crate::plots::{Plots, is_plot};
use crate::watch::{Bar, Interrupt, Watch};
use crate::{cost, inputs, scene, stdout, text};
use polhode::{Observer, Outcome, RunReport, Simulation};
use polhode_scene::{Checkpoint, LoadedScene, OutputError, Outputs, load_with, scene_report_json};
use polhode_view::FrameSource;
use serde_json::Value;
use std::path::{Path, PathBuf};
use std::time::Instant;

/// Simulates, writes the files asked for and prints the report.
pub(crate) fn run(args: &RunArgs) -> Result<(), Failure> {
    let mut changes = scene::overrides(&args.scene.changes)?;
    if let Some(accuracy) = args.accuracy {
        changes.extend(cost::settings_for(&args.scene, accuracy)?);
    }
    let file = &args.scene.scene;
    let loaded = load_with(file, &changes)?;
    let checkpoints = Checkpoints::new(&args.checkpoints, &checkpoint_name(file), file, changes)?;
    let files = Files { asked: &args.output, inputs: &[file] };
    let (outputs, pictures, plots) = files.create(&loaded, &checkpoints)?;
    let started = Instant::now();
    let simulation = scene::prepare(&loaded, &args.scene.changes)?;
    Run { loaded, simulation, outputs, pictures, plots, checkpoints, started, json: args.output.json }.finish()
}

/// Continues from a checkpoint: the report is that of the whole run.
pub(crate) fn resume(args: &ResumeArgs) -> Result<(), Failure> {
    let checkpoint = Checkpoint::read(&args.from)?;
    let (loaded, simulation) = checkpoint.load(&args.from)?;
    let checkpoints = Checkpoints::new(&args.checkpoints, &args.from, &checkpoint.scene, checkpoint.overrides.clone())?;
    let inputs = [&args.from, &checkpoint.scene];
    let files = Files { asked: &args.output, inputs: &inputs };
    let (outputs, pictures, plots) = files.create(&loaded, &checkpoints)?;
    let started = Instant::now();
    Run { loaded, simulation, outputs, pictures, plots, checkpoints, started, json: args.output.json }.finish()
}

/// The files that a run writes, and those that it was made from.
struct Files<'a> {
    asked: &'a RunOutputArgs,
    inputs: &'a [&'a PathBuf],
}

impl Files<'_> {
    /// Opens the outputs.
    fn create(&self, loaded: &LoadedScene, checkpoints: &Checkpoints) -> Result<(Outputs, Pictures, Plots), Failure> {
        let RunOutputArgs { output, plot, events, .. } = self.asked;
        let all: Vec<&Path> = output.iter().chain(events).map(PathBuf::as_path).collect();
        for (number, &path) in all.iter().enumerate() {
            inputs::check_output(path, self.inputs.iter().map(|input| input.as_path()))?;
            let is_named = |other: &&Path| inputs::is_same(path, other);
            if checkpoints.path().iter().any(is_named) || all[..number].iter().any(is_named) {
                let what = format!("error: {} is named twice: every output needs a file of its own", path.display());
                return Err(Failure::Usage(what));
            }
        }
        let is_picture = |path: &&PathBuf| Kind::of(path).is_some();
        let shown: Vec<PathBuf> = output.iter().filter(is_picture).cloned().collect();
        let plotted: Vec<PathBuf> = output.iter().filter(|path| is_plot(path)).cloned().collect();
        let is_trajectory = |path: &&PathBuf| !is_picture(path) && !is_plot(path);
        let trajectories: Vec<PathBuf> = output.iter().filter(is_trajectory).cloned().collect();
        let plots = Plots::create(&plotted, plot)?;
        let mut pictures = Pictures::create(&shown, &Heading::of(std::iter::once(loaded)), Options::default())?;
        let outputs =
            Outputs::create(&loaded.scene, &trajectories, events.as_deref()).map_err(|error| match error {
                OutputError::Ending { .. } => Failure::Usage(format!("error: {error}, {ENDINGS}, .svg")),
                error => error.into(),
            })?;
        pictures.begin_run(&loaded.scene, loaded.scene.name(), FrameSource::Simulation)?;
        Ok((outputs, pictures, plots))
    }
}

/// What a run that has not kept its promise says on stderr.
fn degraded(report: &RunReport) -> String {
    let first = report.warnings.first().map_or("", String::as_str);
    format!("degraded: {}: the run has not kept what its method promises: {first}", report.scene)
}

/// The name of a scene file's checkpoint, in the present folder.
fn checkpoint_name(scene: &Path) -> PathBuf {
    let mut name = scene.file_stem().unwrap_or(scene.as_os_str()).to_owned();
    name.push(".checkpoint");
    PathBuf::from(name)
}

/// A run that is ready to go on.
struct Run {
    loaded: LoadedScene,
    simulation: Simulation,
    outputs: Outputs,
    pictures: Pictures,
    plots: Plots,
    checkpoints: Checkpoints,
    started: Instant,
    json: bool,
}

impl Run {
    /// Goes on to the end, and prints the report.
    fn finish(self) -> Result<(), Failure> {
        let Self { loaded, mut simulation, mut outputs, mut pictures, mut plots, checkpoints, started, json } = self;
        if !json {
            match stdout::text(&text::plan(&loaded, simulation.plan())) {
                // Files are still wanted when nobody reads the report.
                Err(Failure::StdoutClosed) => {}
                printed => printed?,
            }
        }
        let (bar, interrupt) = (Bar::new(loaded.scene.duration_s()), Interrupt::listen()?);
        plots.begin(&loaded.scene, &simulation);
        let observers: Vec<&mut dyn Observer> = vec![&mut outputs, &mut pictures, &mut plots];
        let mut watch = Watch { observers, bar: &bar, interrupt: &interrupt, stop_s: f64::INFINITY };
        let report = go_on(&loaded, &mut simulation, &checkpoints, &mut watch);
        bar.clear();
        match report {
            Ok(_) if simulation.time() < loaded.scene.duration_s() && interrupt.has_come() => {
                let (t, duration) = (simulation.time(), loaded.scene.duration_s());
                let said = format!("interrupted at t = {t} s of {duration} s");
                keep_partial(outputs)?;
                show(pictures, &pictures::failed(&said), &Value::Null)?;
                plots.finish_stopped(simulation.plan(), &said)?;
                if let Some(said) = checkpoints.write(&simulation)? {
                    failure::note(&said);
                }
                Err(Failure::Interrupted(said))
            }
            Ok(report) => {
                outputs.finish()?;
                show(pictures, &pictures::outcome(&report), &pictures::report_in_page(&report))?;
                plots.finish(&report)?;
                let wall_s = started.elapsed().as_secs_f64();
                if json {
                    stdout::json(&scene_report_json(&loaded, &report, wall_s))?;
                } else {
                    stdout::text(&text::report(&report, wall_s))?;
                }
                match report.outcome {
                    Outcome::Completed | Outcome::Stopped => Ok(()),
                    Outcome::Degraded => Err(Failure::Check(degraded(&report))),
                }
            }
            Err(failure) => {
                // A run that has diverged is worth looking at: what it had written is kept beside the name asked for.
                keep_partial(outputs)?;
                if let Err(other) = show(pictures, &pictures::failed(failure.message()), &Value::Null) {
                    failure::note(other.message());
                }
                if let Err(other) = plots.finish_stopped(simulation.plan(), failure.message()) {
                    failure::note(other.message());
                }
                Err(failure)
            }
        }
    }
}

/// Goes on to the end, to Ctrl-C or to a fault of writing, and keeps checkpoints on the way.
fn go_on(
    loaded: &LoadedScene,
    simulation: &mut Simulation,
    checkpoints: &Checkpoints,
    watch: &mut Watch<'_>,
) -> Result<RunReport, Failure> {
    loop {
        watch.stop_s = checkpoints.next_s(simulation.time());
        let report = simulation.run(watch).map_err(|error| scene::failed(loaded, error))?;
        // A run that has broken a promise says so whether it has ended or not.
        let has_ended = report.outcome == Outcome::Completed || simulation.time() >= loaded.scene.duration_s();
        let is_due = !has_ended && simulation.time() >= watch.stop_s;
        if !is_due || watch.interrupt.has_come() {
            return Ok(report);
        }
        if let Some(said) = checkpoints.write(simulation)? {
            watch.bar.note(&said);
        }
    }
}

/// Completes what shows the run, whether it has ended well or not: a page says itself where the run stopped.
fn show(mut pictures: Pictures, outcome: &str, report: &Value) -> Result<(), Failure> {
    pictures.end_run(outcome)?;
    pictures.finish(report)
}

/// Keeps what has been written, and says where.
fn keep_partial(outputs: Outputs) -> Result<(), Failure> {
    for path in outputs.keep_partial()? {
        failure::note(&format!("note: what was computed is in {}", path.display()));
    }
    Ok(())
}
