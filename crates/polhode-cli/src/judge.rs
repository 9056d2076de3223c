//! `polhode judge`: a trajectory of any engine, judged by the laws of a scene.

use crate::abandoned;
use crate::args::JudgeArgs;
use crate::failure::Failure;
use crate::inputs;
use crate::plots::{cannot_write, is_plot};
use crate::progress::Progress;
use crate::scene::{self, SceneText};
use crate::stdout;
use crate::text::judge::{page, picture};
use polhode_scene::{AtomicFile, LoadedScene, TrajectoryError, is_trajectory};
use polhode_study::judge::{Given, JudgeError, Judgement, Question, judge as judged, truth_of};
use std::io::Write as _;
use std::path::Path;

/// Judges, and prints what was broken first; exit code 1 where a law is broken.
pub(crate) fn judge(args: &JudgeArgs) -> Result<(), Failure> {
    let path = &args.trajectory;
    if !is_trajectory(path) {
        return Err(TrajectoryError::Ending { path: path.clone() }.into());
    }
    let progress = Progress::new("judging the trajectory");
    let text = SceneText::of(&args.scene.scene)?;
    let changes = scene::overrides(&args.scene.changes)?;
    let loaded = text.load(&changes)?;
    let mut file = match &args.output {
        None => None,
        Some(output) => Some(opened(output, &loaded, path)?),
    };
    let given = Given::read(path, &loaded.scene)?;
    let truth = if args.no_truth { None } else { Some(text.load(&[changes, vec![truth_of(&loaded.scene)]].concat())?) };
    let question = Question { tolerance: args.tolerance, truth: truth.as_ref().map(|own| &own.scene) };
    let judgement = judged(&given, &loaded.scene, question)?;
    if let Some(file) = &mut file {
        write(file, &judgement)?;
    }
    drop(progress);
    if args.json {
        stdout::json(&judgement.json())?;
    } else {
        stdout::text(&page(&judgement))?;
    }
    // What is broken has been printed.
    if judgement.is_kept() { Ok(()) } else { Err(Failure::Check(String::new())) }
}

/// The file of the picture.
fn opened(output: &Path, loaded: &LoadedScene, trajectory: &Path) -> Result<AtomicFile, Failure> {
    if !is_plot(output) {
        return Err(Failure::Usage(format!("error: {}: unknown ending; accepted: .svg", output.display())));
    }
    let meshes = loaded.mesh_files();
    inputs::check_output(output, std::iter::once(trajectory).chain(meshes.iter().map(std::path::PathBuf::as_path)))?;
    let file = AtomicFile::create(output).map_err(|error| cannot_write(output, &error))?;
    abandoned::note(file.left_behind());
    Ok(file)
}

fn write(file: &mut AtomicFile, judgement: &Judgement) -> Result<(), Failure> {
    let svg = picture(judgement);
    let written = file.write_all(svg.as_bytes()).and_then(|()| file.commit());
    written.map_err(|error| cannot_write(file.target(), &error))
}

impl From<JudgeError> for Failure {
    fn from(error: JudgeError) -> Self {
        match error {
            JudgeError::Trajectory(error) => error.into(),
            error => Self::Usage(format!("error: {error}")),
        }
    }
}
