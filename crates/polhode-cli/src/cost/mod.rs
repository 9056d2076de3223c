//! `polhode cost`: error against time over methods and steps.
//!
//! A scene is run by many candidates, each a change of its settings. The error of a candidate is its distance from the
//! exact solution, or from the finest one where there is none; its cost is time as a ratio, measured in interleaved
//! rounds, or instructions. Both are told with what is known about them: no error below that of the reference itself
//! is claimed, and a candidate that is refused or fails is listed with its reason.
//!
//! | module | holds |
//! |---|---|
//! | `program` | the program as the host of a study |
//! | `instructions` | cost as instructions executed |
//! | `elastic_drop`, `elastic_text` | an elastic body on the drop of a scene, beside the impact laws |
//! | `scale` | how the time of a method grows with the bodies |
//! | `broad_phases` | what finding pairs costs |
//! | `text`, `csv`, `figure`, `html` | how it is told; as JSON by the crate of studies |

mod broad_phases;
mod csv;
mod elastic_drop;
mod elastic_text;
mod figure;
pub(crate) mod html;
mod instructions;
mod program;
mod scale;
mod text;

pub(crate) use instructions::probe;

use crate::abandoned;
use crate::args::{ChangeArgs, CostArgs};
use crate::failure::{self, Failure};
use crate::interrupt::Interrupt;
use crate::scene::SceneText;
use crate::{inputs, stdout};
use broad_phases::BroadPhaseStudy;
use elastic_drop::{ElasticBeside, ElasticDrop};
use polhode::ErrorEstimation;
use polhode_scene::{AtomicFile, Override};
use polhode_study::ladder::Range;
use polhode_study::timing::Effort;
use polhode_study::{Alone, Axis, Counting, Options, Source, Study, StudyError, json};
use scale::ScaleStudy;
use std::io::{self, Write as _};
use std::path::{Path, PathBuf};

/// Runs the study and tells it in every way asked for; exit code 1 when no candidate runs or a target is not reached.
pub(crate) fn cost(args: &CostArgs, interrupt: &Interrupt) -> Result<(), Failure> {
    positive("--target", args.target)?;
    positive("--budget", Some(args.budget))?;
    if args.broad_phase {
        return broad_phases(args, interrupt);
    }
    let axes: Vec<Axis> =
        args.vary.iter().map(|text| Axis::parse(text)).collect::<Result<_, _>>().map_err(StudyError::Axis)?;
    if !args.scale.is_empty() {
        return scale(args, &axes, interrupt);
    }
    let counting = if args.instructions { Counting::Instructions } else { Counting::Time };
    if counting == Counting::Instructions {
        instructions::available()?;
    }
    let text = SceneText::of(&args.scene.scene)?;
    if counting == Counting::Instructions && matches!(text, SceneText::Stdin(_)) {
        return Err(usage("--instructions runs the program again, which cannot read stdin twice: name a file"));
    }
    let load = |changes: &[Override]| text.load(changes);
    let source = program::source(&load, &args.scene.changes, &Alone)?;
    check_outputs(args, &text, &source)?;
    let elastic = elastic_drop(args, &source)?;
    // A folder that does not exist is found before the work, not after it.
    let paths = [&args.csv, &args.svg, &args.html];
    let [csv, svg, html] = interrupt.remove(|| open_all(paths), temporary)?;
    let (target, range, estimation) = (args.target, Range::MethodsAndLaws, ErrorEstimation::Quick);
    let (samples, budget_s) = (args.samples, args.budget);
    let options = Options { samples, effort: effort(args), budget_s, target, range, counting, estimation };
    let study = program::study(&text, &args.scene.changes, |source| Study::run(source, &axes, &options))?;
    let beside: Option<ElasticBeside> = elastic.map(ElasticDrop::run).transpose()?;
    let told = beside.as_ref().map_or_else(String::new, ElasticBeside::text);
    let drawn = if svg.is_some() || html.is_some() { figure::svg(&study, args.target) } else { String::new() };
    for (file, text) in [(csv, csv::text(&study)), (html, html::page(&study, &drawn, &told)), (svg, drawn)] {
        if let Some(file) = file {
            write(file, &text)?;
        }
    }
    if args.json {
        let mut value = json::value(&study, args.target);
        if let Some(beside) = beside {
            value["elastic"] = beside.json();
        }
        stdout::json(&value)?;
    } else {
        stdout::text(&format!("{}{told}", text::page(&study, args.target)))?;
    }
    match args.target {
        _ if study.base.is_none() => Err(Failure::Check(text::none_ran(&study))),
        Some(target) => Ok(study.answer(target).map(|_| ())?),
        None => Ok(()),
    }
}

/// The drop of the scene, where an elastic body can be shown beside the laws: wherever it can, unless settings are
/// varied.
///
/// # Errors
/// Why it cannot, where it is asked for.
fn elastic_drop(args: &CostArgs, source: &Source<'_>) -> Result<Option<ElasticDrop>, Failure> {
    if !args.elastic && !args.vary.is_empty() {
        return Ok(None);
    }
    match ElasticDrop::of(&source.loaded()?.scene) {
        Err(reason) if args.elastic => {
            Err(usage(&format!("--elastic: no elastic body stands for this scene: {reason}")))
        }
        drop => Ok(drop.ok()),
    }
}

/// Times the broad phases and tells it in every way asked for.
fn broad_phases(args: &CostArgs, interrupt: &Interrupt) -> Result<(), Failure> {
    let text = SceneText::of(&args.scene.scene)?;
    let load = |changes: &[Override]| text.load(changes);
    let source = program::source(&load, &args.scene.changes, &Alone)?;
    check_outputs(args, &text, &source)?;
    let [csv, html] = interrupt.remove(|| open_all([&args.csv, &args.html]), temporary)?;
    let study = BroadPhaseStudy::run(&source, args.samples, effort(args))?;
    for (file, text) in [(csv, study.csv()), (html, study.html())] {
        if let Some(file) = file {
            write(file, &text)?;
        }
    }
    if args.json { stdout::json(&study.json()) } else { stdout::text(&study.page()) }
}

/// Times the methods at several numbers of bodies and tells it in every way asked for.
fn scale(args: &CostArgs, axes: &[Axis], interrupt: &Interrupt) -> Result<(), Failure> {
    let text = SceneText::of(&args.scene.scene)?;
    let load = |changes: &[Override]| text.load(changes);
    let source = program::source(&load, &args.scene.changes, &Alone)?;
    check_outputs(args, &text, &source)?;
    let [csv] = interrupt.remove(|| open_all([&args.csv]), temporary)?;
    let study = ScaleStudy::run(&source, &args.scale, axes, args.budget)?;
    if let Some(file) = csv {
        write(file, &study.csv())?;
    }
    if args.json { stdout::json(&study.json()) } else { stdout::text(&study.page()) }
}

/// Opens those files that are asked for.
fn open_all<const N: usize>(paths: [&Option<PathBuf>; N]) -> Result<[Option<AtomicFile>; N], Failure> {
    let mut files = [const { None }; N];
    for (file, path) in files.iter_mut().zip(paths) {
        *file = open(path.as_ref())?;
    }
    Ok(files)
}

/// The temporary names of files.
fn temporary<const N: usize>(files: &[Option<AtomicFile>; N]) -> Vec<PathBuf> {
    files.iter().flatten().filter_map(|file| file.temporary().map(Path::to_owned)).collect()
}

/// That no output replaces what the study is made from.
fn check_outputs(args: &CostArgs, text: &SceneText<'_>, source: &Source<'_>) -> Result<(), Failure> {
    let mut read = source.loaded()?.mesh_files();
    read.extend(text.file().map(Path::to_owned));
    let outputs = [&args.csv, &args.svg, &args.html];
    outputs.into_iter().flatten().try_for_each(|path| inputs::check_output(path, read.iter().map(PathBuf::as_path)))
}

fn effort(args: &CostArgs) -> Effort {
    Effort { fewest_rounds: args.rounds.min(3) as usize, most_rounds: args.rounds as usize, enough_s: 0.2 }
}

fn write(mut file: AtomicFile, text: &str) -> Result<(), Failure> {
    let written = file.write_all(text.as_bytes()).and_then(|()| file.commit());
    written.map_err(|error| cannot_write(file.target(), &error))
}

/// The settings of the cheapest method that reaches an accuracy, which becomes what the run promises; stderr is told
/// which it is. Where none reaches it they are those of the most accurate one, and the run will say how far off it is.
///
/// # Errors
/// When no candidate ran.
pub(crate) fn settings_for(
    scene: &SceneText<'_>,
    changes: &ChangeArgs,
    accuracy: f64,
) -> Result<Vec<Override>, Failure> {
    positive("--accuracy", Some(accuracy))?;
    let options = Options::for_accuracy(accuracy);
    let study = program::study(scene, changes, |source| Study::run(source, &[], &options))?;
    let entry = match (study.answer(accuracy), study.most_accurate()) {
        (Ok(entry), _) => {
            failure::remark(&format!("note: {}", text::reached(&study, entry, accuracy)));
            entry
        }
        (Err(error), Some((_, most_accurate))) => {
            failure::remark(&format!("note: {error}: the run is by it"));
            most_accurate
        }
        (Err(error), None) => return Err(error.into()),
    };
    let chosen = |key: &str, value: &str| Override::new("command line (--accuracy)", key, value);
    let method = entry.candidate.changes.iter().map(|change| chosen(&change.key, &change.value));
    let promised = study.of_smallest_body(accuracy).to_string();
    Ok(method.chain([chosen("promise.error", &promised)]).collect())
}

fn open(path: Option<&PathBuf>) -> Result<Option<AtomicFile>, Failure> {
    let Some(path) = path else { return Ok(None) };
    let file = AtomicFile::create(path).map_err(|error| cannot_write(path, &error))?;
    abandoned::note(file.left_behind());
    Ok(Some(file))
}

fn cannot_write(path: &Path, error: &io::Error) -> Failure {
    Failure::InputOutput(format!("error: cannot write {}: {error}", path.display()))
}

fn positive(option: &str, value: Option<f64>) -> Result<(), Failure> {
    match value {
        Some(value) if !(value > 0.0 && value.is_finite()) => {
            Err(usage(&format!("{option} {value}: a positive number is needed")))
        }
        _ => Ok(()),
    }
}

fn usage(message: &str) -> Failure {
    Failure::Usage(format!("error: {message}"))
}
