//! `polhode view`: a scene or a trajectory as a page, a picture or a model.

use crate::args::ViewArgs;
use crate::failure::{self, Failure};
use crate::heading::Heading;
use crate::interrupt::Interrupt;
use crate::pictures::{ENDINGS, Kind, Options, Pictures};
use crate::progress::Progress;
use crate::viewpoint::{overlays, viewpoint};
use crate::watch::Watch;
use crate::{browser, examples, inputs, scene, stdout};
use polhode::{BodySample, Flow, Observer, Outcome, RunReport, Simulation, SimulationError};
use polhode_scene::{
    LoadedScene, TrajectoryError, TrajectoryReader, is_boxes, is_trajectory, page_report_json, shown_failure,
    shown_outcome,
};
use polhode_study::difference::energy_error;
use polhode_view::animation::FPS;
use polhode_view::overlay::Overlay;
use polhode_view::page::{AtFirst, MOST_FRAMES};
use polhode_view::{FrameSource, Recording};
use serde_json::Value;
use std::path::{Path, PathBuf};

/// Frames for each simulated second when none are asked for.
const DEFAULT_FPS: f64 = 60.0;

/// Where the motion of a run comes from.
enum Motion {
    /// It is simulated.
    Simulated,
    /// It has been computed before.
    Read(PathBuf),
}

/// A run to be shown.
struct ShownRun {
    loaded: LoadedScene,
    motion: Motion,
    name: String,
}

/// Shows what the command line names, and prints where.
pub(crate) fn view(args: &ViewArgs, interrupt: &Interrupt) -> Result<(), Failure> {
    let paths = outputs(args)?;
    let interval_s = interval(args.fps, &paths)?;
    let reading = Progress::new("reading the scene");
    let runs = runs(args, interval_s)?;
    drop(reading);
    check_pictures_of_two(&paths, &runs)?;
    for path in &paths {
        let meshes: Vec<PathBuf> = runs.iter().flat_map(|run| run.loaded.mesh_files()).collect();
        inputs::check_output(path, meshes.iter().map(PathBuf::as_path))?;
    }
    let heading = Heading::of(runs.iter().map(|run| &run.loaded));
    let options = Options {
        least_interval_s: args.fps.map(|_| interval_s),
        size: size(args.size.as_deref())?,
        viewpoint: viewpoint(args, &paths)?,
        overlays: overlays(args, &paths)?,
        at_first: if args.open { AtFirst::Plays } else { AtFirst::Waits },
    };
    let create = || Pictures::create(&paths, &heading, options.clone());
    let mut pictures = interrupt.remove(create, |pictures| pictures.temporary().to_vec())?;
    if let (Some(text), [run]) = (&args.still, &runs[..]) {
        let progress = Progress::new("simulating to the picture");
        pictures.take(at_instant(run, args, still_time(text, run)?)?);
        drop(progress);
        pictures.finish(&Value::Null, interrupt)?;
        print_paths(&paths)?;
        if args.open {
            paths.first().into_iter().for_each(|path| browser::open(path));
        }
        return Ok(());
    }
    let mut reports = Vec::new();
    let mut ended = Ok(());
    for run in &runs {
        let (outcome, report) = show(run, args, &mut pictures, interrupt)?;
        let shown = pictures.end_run(&outcome);
        match report {
            // What went wrong first is what is told.
            Err(failure) if shown.is_err() => return Err(failure),
            Ok(report) => {
                shown?;
                reports.push(report);
            }
            Err(failure) => {
                reports.push(Value::Null);
                ended = Err(failure);
                break;
            }
        }
    }
    let report = if reports.len() == 1 { reports.swap_remove(0) } else { Value::Array(reports) };
    interrupt.wait_for_steps();
    pictures.finish(&report, interrupt)?;
    print_paths(&paths)?;
    if args.open {
        paths.first().into_iter().for_each(|path| browser::open(path));
    }
    ended
}

/// Says where the files are.
fn print_paths(paths: &[PathBuf]) -> Result<(), Failure> {
    paths.iter().try_for_each(|path| stdout::text(&format!("{}\n", path.display())))
}

/// A picture or model shows one run.
fn check_pictures_of_two(paths: &[PathBuf], runs: &[ShownRun]) -> Result<(), Failure> {
    let other = paths.iter().find(|path| Kind::of(path) != Some(Kind::Page));
    match other {
        Some(path) if runs.len() > 1 => {
            let what = format!("error: {}: two runs are shown by a page (.html) alone", path.display());
            Err(Failure::Usage(what))
        }
        _ => Ok(()),
    }
}

/// The time that `--still` names, s.
fn still_time(text: &str, run: &ShownRun) -> Result<f64, Failure> {
    let number = text.strip_prefix("t=").unwrap_or(text).trim();
    let t: f64 = number
        .parse()
        .map_err(|_| Failure::Usage(format!("error: --still {text}: not of the form t=S, such as --still t=1.5")))?;
    let duration = run.loaded.scene.duration_s();
    // How long a trajectory is, is known when it has been read.
    let is_within = t >= 0.0 && (t <= duration || matches!(run.motion, Motion::Read(_)));
    if is_within { Ok(t) } else { Err(outside(t, 0.0, duration)) }
}

/// That a time is not one of the run, which is from one time to another, s.
fn outside(t: f64, from: f64, to: f64) -> Failure {
    Failure::Usage(format!("error: --still t={t}: the motion is from t = {from} s to {to} s"))
}

/// One instant, with the motion that leads there: simulated to there exactly, or the nearest sample of a trajectory.
fn at_instant(run: &ShownRun, args: &ViewArgs, t_s: f64) -> Result<Recording, Failure> {
    let scene = &run.loaded.scene;
    let refused = |error| Failure::Usage(format!("error: {}: {error}", scene.name()));
    let recording = Recording::for_still(scene).map_err(refused)?;
    let mut recording = recording.shown_as(run.loaded.appearance());
    let wants_forces = args.show.iter().any(|name| Overlay::named(name.trim()) == Some(Overlay::Forces));
    let (t, bodies) = match &run.motion {
        Motion::Simulated => {
            let mut simulation = scene::prepare(&run.loaded, &args.changes)?;
            let reached = simulation.advance_to_observed(t_s, &mut recording);
            reached.map_err(|error| scene::failed(&run.loaded, error))?;
            if wants_forces {
                recording.frame(&simulation.frame());
            }
            (t_s, simulation.bodies())
        }
        Motion::Read(path) => nearest_sample(path, run, t_s, &mut recording)?,
    };
    recording.end_at(t, &bodies).map_err(refused)?;
    Ok(recording)
}

/// The sample of a trajectory that is nearest to a time (s) within it; what leads there is recorded.
fn nearest_sample(
    path: &Path,
    run: &ShownRun,
    t_s: f64,
    recording: &mut Recording,
) -> Result<(f64, Vec<BodySample>), Failure> {
    let mut reader = TrajectoryReader::open(path, &run.loaded.scene)?;
    let mut first_s = f64::NAN;
    let mut before: Option<(f64, Vec<BodySample>)> = None;
    while let Some((t, bodies)) = reader.next_sample()? {
        if before.is_none() {
            first_s = t;
        }
        if t >= t_s {
            let nearest = before.filter(|(other, _)| t_s - other < t - t_s).unwrap_or((t, bodies));
            return if t_s >= first_s { Ok(nearest) } else { Err(outside(t_s, first_s, t)) };
        }
        recording.sample(t, &bodies);
        before = Some((t, bodies));
    }
    note_cut_off(&reader);
    Err(outside(t_s, first_s, before.map_or(f64::NAN, |(last, _)| last)))
}

/// Width and height of pictures.
fn size(text: Option<&str>) -> Result<Option<[u32; 2]>, Failure> {
    let Some(text) = text else { return Ok(None) };
    let sides = text.split_once('x').and_then(|(width, height)| Some([width.parse().ok()?, height.parse().ok()?]));
    let what = || Failure::Usage(format!("error: --size {text}: not of the form WxH, such as --size 1280x720"));
    sides.map(Some).ok_or_else(what)
}

/// Shows one run: how it ended, and its report or why there is none.
fn show(
    run: &ShownRun,
    args: &ViewArgs,
    pictures: &mut Pictures,
    interrupt: &Interrupt,
) -> Result<(String, Result<Value, Failure>), Failure> {
    match &run.motion {
        Motion::Read(path) => {
            pictures.begin_run(&run.loaded, &run.name, FrameSource::Trajectory)?;
            let progress = Progress::new("reading the trajectory");
            read(path, run, pictures)?;
            drop(progress);
            Ok(("completed".to_owned(), Ok(Value::Null)))
        }
        Motion::Simulated => {
            pictures.begin_run(&run.loaded, &run.name, FrameSource::Simulation)?;
            let mut simulation = scene::prepare(&run.loaded, &args.changes)?;
            pictures.begin_simulation(&run.loaded, &simulation);
            let mut bar = Progress::new("simulating");
            bar.run(0.0, run.loaded.scene.duration_s());
            interrupt.wait_for_steps();
            let stop_s = f64::INFINITY;
            let mut watch = Watch { observers: vec![pictures], bar: &bar, interrupt, stop_s, is_stopped: false };
            let report = shown_to_its_end(&mut simulation, &mut watch);
            bar.clear();
            match report.map_err(|error| scene::failed(&run.loaded, error)) {
                Ok(report) if interrupt.has_come() => {
                    let (t, duration) = (report.simulated_s, report.duration_s);
                    let said = format!("interrupted at t = {t} s of {duration} s");
                    Ok((shown_failure(&said), Err(Failure::Interrupted(said, interrupt.code()))))
                }
                Ok(report) => {
                    note_degraded(&report);
                    Ok((shown_outcome(&report), Ok(page_report_json(&report))))
                }
                Err(failure) => Ok((shown_failure(failure.message()), Err(failure))),
            }
        }
    }
}

/// Runs to the end, to Ctrl-C or to a picture that is full, and looks at the energies on the way.
fn shown_to_its_end(simulation: &mut Simulation, watch: &mut Watch<'_>) -> Result<RunReport, SimulationError> {
    loop {
        let report = simulation.run_observed(watch)?;
        let is_look = report.simulated_s < report.duration_s && watch.bar.wants_look() && !watch.is_stopped;
        if !is_look || watch.interrupt.has_come() {
            return Ok(report);
        }
        watch.bar.look(energy_error(&report));
    }
}

/// Says on stderr that a run has not kept its promise: what it shows is still worth looking at.
fn note_degraded(report: &RunReport) {
    if report.outcome == Outcome::Degraded {
        let first = report.warnings.first().map_or("", String::as_str);
        failure::remark(&format!("note: {}: degraded: {first}", report.scene));
    }
}

/// Shows a trajectory.
fn read(path: &Path, run: &ShownRun, pictures: &mut Pictures) -> Result<(), Failure> {
    let mut reader = TrajectoryReader::open(path, &run.loaded.scene)?;
    while let Some((t, bodies)) = reader.next_sample()? {
        pictures.sample(t, &bodies);
        pictures.errors(t, reader.errors());
        if pictures.progress(t) == Flow::Stop {
            break;
        }
    }
    note_cut_off(&reader);
    Ok(())
}

/// Says that a file was cut off, and what is shown of it.
fn note_cut_off(reader: &TrajectoryReader) {
    if let Some(error) = reader.cut_off() {
        failure::remark(&format!("note: {error}; what stands before is shown"));
    }
}

/// The runs that the command line names.
fn runs(args: &ViewArgs, interval_s: f64) -> Result<Vec<ShownRun>, Failure> {
    let (trajectories, scenes): (Vec<_>, Vec<_>) =
        args.files.iter().partition(|path| is_trajectory(path) && !is_boxes(path));
    let changes = scene::overrides(&args.changes)?;
    let simulated = |path: &Path, changes: &[polhode_scene::Override], name: Option<String>| {
        let mut loaded = scene::load_changed(path, changes)?;
        let interval = interval_s.max(loaded.scene.duration_s() / MOST_FRAMES).min(loaded.scene.duration_s());
        let scene = loaded.scene.clone().with_output_interval(interval);
        loaded.scene = scene.map_err(|error| Failure::from(loaded.explain(error)))?;
        let name = name.unwrap_or_else(|| loaded.scene.name().to_owned());
        Ok::<_, Failure>(ShownRun { loaded, motion: Motion::Simulated, name })
    };
    match (&scenes[..], &trajectories[..]) {
        ([], _) => Err(Failure::Usage(
            "error: a trajectory has no shapes: name its scene too, as in `polhode view scene.toml trajectory.csv`"
                .to_owned(),
        )),
        ([scene], []) if args.beside.is_empty() => Ok(vec![simulated(scene, &changes, None)?]),
        ([scene], []) => {
            let mut beside = changes.clone();
            for text in &args.beside {
                beside.push(scene::change("--beside", text)?);
            }
            let second = Some(args.beside.join(", "));
            Ok(vec![simulated(scene, &changes, None)?, simulated(scene, &beside, second)?])
        }
        (_, _) if !args.beside.is_empty() => {
            Err(Failure::Usage("error: --beside shows one scene twice: name one scene and no trajectory".to_owned()))
        }
        ([a, b], []) => {
            let named = |path: &Path| {
                let stem = path.file_stem().unwrap_or_default().to_string_lossy();
                Some(stem.strip_prefix(examples::PREFIX).unwrap_or(&stem).to_owned())
            };
            Ok(vec![simulated(a, &changes, named(a))?, simulated(b, &changes, named(b))?])
        }
        ([scene], [_] | [_, _]) => trajectories
            .iter()
            .map(|path| {
                let loaded = scene::load_changed(scene, &changes)?;
                let name = path.file_stem().unwrap_or_default().to_string_lossy().into_owned();
                Ok(ShownRun { loaded, motion: Motion::Read((*path).clone()), name })
            })
            .collect(),
        _ => Err(Failure::Usage("error: a page shows two runs at the most".to_owned())),
    }
}

/// Where the pictures go.
fn outputs(args: &ViewArgs) -> Result<Vec<PathBuf>, Failure> {
    let ending = if args.still.is_some() { "png" } else { "html" };
    let beside = || args.files.first().map(|file| place_beside(file, ending)).into_iter().collect();
    let paths: Vec<PathBuf> = if args.output.is_empty() { beside() } else { args.output.clone() };
    for path in &paths {
        let refused = match Kind::of(path) {
            None => format!("unknown ending; accepted: {ENDINGS}"),
            Some(kind) if args.still.is_some() && kind != Kind::Still => "--still draws a picture (.png)".to_owned(),
            Some(_) => {
                inputs::check_output(path, args.files.iter().map(PathBuf::as_path))?;
                continue;
            }
        };
        return Err(Failure::Usage(format!("error: {}: {refused}", path.display())));
    }
    Ok(paths)
}

/// Where pictures of a file go; those of an example or of stdin are put into the present folder.
fn place_beside(file: &Path, ending: &str) -> PathBuf {
    let name = file.to_str().unwrap_or_default();
    match name.strip_prefix(examples::PREFIX) {
        Some(example) => PathBuf::from(format!("{example}.{ending}")),
        None if name == scene::STANDARD => PathBuf::from(format!("stdin.{ending}")),
        None => file.with_extension(ending),
    }
}

/// Time between frames, s.
fn interval(fps: Option<f64>, paths: &[PathBuf]) -> Result<f64, Failure> {
    match fps {
        None if paths.iter().all(|path| Kind::of(path).is_some_and(Kind::moves)) => Ok(1.0 / FPS),
        None => Ok(1.0 / DEFAULT_FPS),
        Some(fps) if fps.is_finite() && fps > 0.0 => Ok(1.0 / fps),
        Some(fps) => Err(Failure::Usage(format!("error: --fps {fps}: a positive number of frames a second is needed"))),
    }
}

impl From<TrajectoryError> for Failure {
    fn from(failure: TrajectoryError) -> Self {
        let message = format!("error: {failure}");
        match failure {
            TrajectoryError::Read { .. } => Self::InputOutput(message),
            TrajectoryError::Content { .. } | TrajectoryError::Ending { .. } => Self::Usage(message),
        }
    }
}
