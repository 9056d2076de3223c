//! `polhode run` and `polhode resume`: simulate a scene, from its start or from a checkpoint.

use crate::args::{ResumeArgs, RunArgs, RunOutputArgs};
use crate::checkpoints::Checkpoints;
use crate::failure::{self, Failure};
use crate::interrupt::Interrupt;
use crate::mechanism_figure::MOST_CONTACTS;
use crate::progress::Progress;
use crate::run_files::{RunFiles, is_stdout};
use crate::scene::SceneText;
use crate::second_opinion::{Asked, Opinion};
use crate::text::{Ended, Extent};
use crate::verbosity::{self, Verbosity};
use crate::watch::Watch;
use crate::{cost, scene, stdout, text};
use polhode::{ErrorEstimation, Outcome, RunReport, Simulation};
use polhode_scene::{Checkpoint, LoadedScene, scene_report_json};
use polhode_study::Threads;
use polhode_study::difference::energy_error;
use serde_json::json;
use std::io::IsTerminal;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::time::Instant;

/// Simulates, writes the files asked for and prints the report.
pub(crate) fn run(args: &RunArgs, interrupt: &Interrupt) -> Result<(), Failure> {
    let prepared = prepared(args, interrupt);
    prepared.map_err(|failure| told(Report::of(&args.output), failure, None))?.finish(interrupt)
}

/// Continues from a checkpoint: the report is that of the whole run.
pub(crate) fn resume(args: &ResumeArgs, interrupt: &Interrupt) -> Result<(), Failure> {
    let restored = restored(args, interrupt);
    restored.map_err(|failure| told(Report::of(&args.output), failure, None))?.finish(interrupt)
}

/// Progress of a run that is prepared. A trajectory that goes to a terminal leaves no line there to draw on.
fn preparing(asked: &RunOutputArgs, what: &'static str) -> Progress {
    let is_covered = Report::of(asked) == Report::OnStderr && std::io::stdout().is_terminal();
    if is_covered { Progress::in_lines(what) } else { Progress::new(what) }
}

/// A run of a scene from its start.
fn prepared(args: &RunArgs, interrupt: &Interrupt) -> Result<Run, Failure> {
    let mut changes = scene::overrides(&args.scene.changes)?;
    let text = SceneText::of(&args.scene.scene)?;
    if let Some(accuracy) = args.accuracy {
        changes.extend(cost::settings_for(&text, &args.scene.changes, accuracy)?);
    }
    let progress = preparing(&args.output, "preparing the run");
    let loaded = text.load(&changes)?;
    scene::tell_of_robots(&loaded);
    let file = args.scene.scene.as_path();
    if text.file().is_none() && (args.checkpoints.checkpoint.is_some() || args.checkpoints.checkpoint_every.is_some()) {
        let what = format!("error: {}: a checkpoint names the file of its scene, and this is none", file.display());
        return Err(Failure::Usage(what));
    }
    let checkpoints = Checkpoints::new(&args.checkpoints, &checkpoint_name(file), file, changes)?;
    let mut inputs = loaded.mesh_files();
    inputs.extend(text.file().map(Path::to_owned));
    let estimation = args.output.error.map(ErrorEstimation::from);
    let estimation = estimation.or(loaded.scene.method().error).unwrap_or_default();
    let files = RunFiles::create(&args.output, &inputs, (&loaded, estimation), &checkpoints, interrupt)?;
    let started = Instant::now();
    let progress = if scene::has_parts_to_find(&loaded) {
        drop(progress);
        preparing(&args.output, "decomposing meshes into convex parts")
    } else {
        progress
    };
    let mut simulation = scene::prepare(&loaded, &args.scene.changes)?;
    simulation.set_executor(threads(&args.output));
    simulation.set_error_estimation(estimation);
    let second = args.second_opinion.then(|| Asked::new(scene::effects(&args.scene.changes)));
    let (report, extent) = (Report::of(&args.output), extent(&args.output));
    Ok(Run { loaded, simulation, files, checkpoints, progress, started, second, report, extent })
}

/// A run from a checkpoint on.
fn restored(args: &ResumeArgs, interrupt: &Interrupt) -> Result<Run, Failure> {
    let progress = preparing(&args.output, "preparing the run");
    let mut checkpoint = Checkpoint::read(&args.from)?;
    checkpoint.overrides.extend(args.duration.as_deref().map(scene::duration));
    let (loaded, mut simulation) = checkpoint.load(&args.from)?;
    simulation.set_executor(threads(&args.output));
    if let Some(estimation) = args.output.error {
        simulation.set_error_estimation(estimation.into());
    }
    let checkpoints = Checkpoints::new(&args.checkpoints, &args.from, &checkpoint.scene, checkpoint.overrides.clone())?;
    let mut inputs = loaded.mesh_files();
    inputs.extend([args.from.clone(), checkpoint.scene.clone()]);
    let (reached_s, duration_s) = (simulation.time(), loaded.scene.duration_s());
    if args.duration.is_some() && duration_s <= reached_s {
        let what = format!(
            "error: --duration {duration_s}: the checkpoint is of t = {reached_s} s already; the duration counts from \
             the start of the run"
        );
        return Err(Failure::Usage(what));
    }
    if simulation.has_ended() {
        failure::remark(&format!(
            "note: the run has ended at t = {reached_s} s; resume --duration S, with S above that, goes on from there"
        ));
    }
    let run = (&loaded, simulation.error_estimation());
    let files = RunFiles::create(&args.output, &inputs, run, &checkpoints, interrupt)?;
    let started = Instant::now();
    let (second, report, extent) = (None, Report::of(&args.output), extent(&args.output));
    Ok(Run { loaded, simulation, files, checkpoints, progress, started, second, report, extent })
}

/// The threads that compute islands.
fn threads(args: &RunOutputArgs) -> Arc<Threads> {
    Arc::new(Threads(args.threads))
}

/// How the report is told.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Report {
    /// As text on stdout.
    Text,
    /// As text on stderr: stdout holds the trajectory.
    OnStderr,
    /// Not at all: quiet is asked for.
    Untold,
    /// As JSON on stdout.
    Json,
}

impl Report {
    fn of(asked: &RunOutputArgs) -> Self {
        if asked.json {
            Self::Json
        } else if verbosity::asked() == Verbosity::Quiet {
            Self::Untold
        } else if asked.output.iter().any(|path| is_stdout(path)) {
            Self::OnStderr
        } else {
            Self::Text
        }
    }
}

/// How much of the report is told as text.
fn extent(asked: &RunOutputArgs) -> Extent {
    if asked.full { Extent::Full } else { Extent::Short }
}

/// How far a run has come that did not end: its scene, the time reached and the duration, s.
type Reached<'a> = (&'a str, f64, f64);

/// The failure, after the object that `--json` prints for a run that has no report.
fn told(report: Report, failure: Failure, reached: Option<Reached<'_>>) -> Failure {
    if report == Report::Json && !matches!(failure, Failure::Degraded(_) | Failure::StdoutClosed) {
        let outcome = if matches!(failure, Failure::Interrupted(..)) { "interrupted" } else { "failed" };
        let mut value = json!({
            "outcome": outcome,
            "error": failure.message().trim_start_matches("error: "),
            "exit_code": failure.code(),
        });
        if let Some((scene, simulated_s, duration_s)) = reached {
            value["scene"] = scene.into();
            value["simulated_s"] = simulated_s.into();
            value["duration_s"] = duration_s.into();
        }
        // Where stdout cannot be written to, the failure on stderr says enough.
        let _ = stdout::json(&value);
    }
    failure
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
    files: RunFiles,
    checkpoints: Checkpoints,
    progress: Progress,
    started: Instant,
    /// What a second opinion is to be compared with, if one is asked for.
    second: Option<Asked>,
    report: Report,
    extent: Extent,
}

impl Run {
    /// Goes on to the end, and prints the report.
    fn finish(mut self, interrupt: &Interrupt) -> Result<(), Failure> {
        failure::detail(&text::plan(&self.loaded, &scene::with_origins(&self.loaded, self.simulation.plan())));
        let (duration_s, at_start_s) = (self.loaded.scene.duration_s(), self.simulation.time());
        self.files.begin(&self.loaded, &self.simulation);
        interrupt.wait_for_steps();
        self.progress.run(at_start_s, duration_s);
        let (mut observers, bar) = (self.files.observers(), &self.progress);
        observers.extend(self.second.as_mut().map(Asked::observer));
        let mut watch = Watch { observers, bar, interrupt, stop_s: f64::INFINITY, is_stopped: false };
        let ended = go_on(&self.loaded, &mut self.simulation, &self.checkpoints, &mut watch);
        self.progress.clear();
        let reached_s = self.simulation.time();
        let name = self.loaded.scene.name().to_owned();
        let ended = match ended {
            Ok(_) if reached_s < duration_s && interrupt.has_come() => self.interrupted(interrupt),
            Ok(mut report) => {
                report.plan = scene::with_origins(&self.loaded, &report.plan);
                self.completed(&report, interrupt)
            }
            Err(failure) => {
                // A run that has diverged is worth looking at: what it had written is kept beside the name asked for.
                self.files.keep(self.simulation.plan(), failure.message(), interrupt);
                return Err(told(self.report, failure, Some((&name, reached_s, duration_s))));
            }
        };
        ended.map_err(|(report, failure)| told(report, failure, Some((&name, reached_s, duration_s))))
    }

    /// After Ctrl-C or SIGTERM: keeps what was computed, and a checkpoint where one was asked for.
    fn interrupted(self, interrupt: &Interrupt) -> Result<(), (Report, Failure)> {
        let said = format!("interrupted at t = {} s of {} s", self.simulation.time(), self.loaded.scene.duration_s());
        self.files.keep(self.simulation.plan(), &said, interrupt);
        let written = self.checkpoints.write(&self.simulation).map_err(|failure| (self.report, failure))?;
        if let Some(checkpoint) = written {
            failure::note(&checkpoint);
        }
        Err((self.report, Failure::Interrupted(said, interrupt.code())))
    }

    /// How far the bodies that rest at the end are from moving, in a line. A report comes without it where they are too
    /// many for it to be found at once, or it cannot be found.
    fn stands(&self) -> Option<String> {
        if self.simulation.contacts().len() > MOST_CONTACTS {
            return None;
        }
        text::stability_line(&self.loaded.scene, &self.simulation.stability().ok()?)
    }

    /// At the end: completes the files and prints the report.
    fn completed(self, report: &RunReport, interrupt: &Interrupt) -> Result<(), (Report, Failure)> {
        let told = self.report;
        if let Some(said) = self.checkpoints.write_at_end(&self.simulation).map_err(|failure| (told, failure))? {
            failure::remark(&said);
        }
        let wall_s = self.started.elapsed().as_secs_f64();
        let stands = if matches!(told, Report::Text | Report::OnStderr) { self.stands() } else { None };
        self.files.finish(report, interrupt).map_err(|failure| (told, failure))?;
        let scene = &self.loaded.scene;
        let opinion = self.second.map(|asked| asked.answer(scene, report, interrupt));
        let ended = Ended { report, stands: stands.as_deref(), wall_s };
        let text = || {
            let said = opinion.as_ref().map_or_else(String::new, Opinion::text);
            format!("{}{said}", text::run(&self.loaded, ended, self.extent))
        };
        let printed = match told {
            Report::Json => {
                let mut value = scene_report_json(&self.loaded, report, wall_s);
                if let Some(opinion) = &opinion {
                    value["second_opinion"] = opinion.json();
                }
                stdout::json(&value)
            }
            Report::Text => stdout::text(&text()),
            Report::Untold => Ok(()),
            Report::OnStderr => {
                failure::remark(text().trim_end());
                Ok(())
            }
        };
        printed.map_err(|failure| (told, failure))?;
        // An outcome of which nothing else is known is not a good one.
        let is_good = matches!(report.outcome, Outcome::Completed | Outcome::Stopped);
        let contradiction = opinion.and_then(|own| own.contradiction(scene.name()));
        let wrong: Vec<String> = (!is_good).then(|| degraded(report)).into_iter().chain(contradiction).collect();
        if wrong.is_empty() { Ok(()) } else { Err((told, Failure::Degraded(wrong.join("\n")))) }
    }
}

/// Goes on to the end, to Ctrl-C, SIGTERM or to a fault of writing; keeps checkpoints and looks at the energies on the
/// way.
fn go_on(
    loaded: &LoadedScene,
    simulation: &mut Simulation,
    checkpoints: &Checkpoints,
    watch: &mut Watch<'_>,
) -> Result<RunReport, Failure> {
    loop {
        watch.stop_s = checkpoints.next_s(simulation.time());
        let report = simulation.run_observed(watch).map_err(|error| scene::failed(loaded, error))?;
        // A run that has broken a promise says so whether it has ended or not.
        let has_ended = report.outcome == Outcome::Completed || simulation.time() >= loaded.scene.duration_s();
        let is_due = !has_ended && simulation.time() >= watch.stop_s;
        let is_look = !has_ended && watch.bar.wants_look() && !watch.is_stopped;
        if is_look {
            watch.bar.look(energy_error(&report));
        }
        if !(is_due || is_look) || watch.interrupt.has_come() {
            return Ok(report);
        }
        if is_due && let Some(said) = checkpoints.write(simulation)? {
            failure::remark(&said);
        }
    }
}
