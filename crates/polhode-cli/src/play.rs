//! `polhode play`: a page that runs a scene itself, with the engine in it.

use crate::args::PlayArgs;
use crate::failure::Failure;
use crate::interrupt::Interrupt;
use crate::plots::cannot_write;
use crate::progress::Progress;
use crate::scene::{self, SceneText};
use crate::{browser, examples, inputs, stdout};
use polhode_scene::{AtomicFile, LoadedScene, load_with_files};
use polhode_study::play::native::Hashes;
use polhode_study::play::{PlayError, Playground};
use polhode_view::play_page::{self, Example, Given, NativeHashes};
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

/// The native run that a page is held against ends after so long: its hashes up to there are in the page.
const LONGEST_RUN: Duration = Duration::from_secs(10);

/// The title of a page without a scene.
const TITLE: &str = "polhode playground";

/// Writes the page, or prints the hash of the scene's run.
pub(crate) fn play(args: &PlayArgs, interrupt: &Interrupt) -> Result<(), Failure> {
    let given = args.scene.as_deref().map(Scene::read).transpose()?;
    if let (true, Some(scene)) = (args.hash, &given) {
        let found = scene.hashes(|| !interrupt.has_come())?;
        let Some(hash) = found.whole() else {
            return Err(Failure::Interrupted("the run was stopped".to_owned(), interrupt.code()));
        };
        stdout::text(&format!("{hash:016x}\n"))?;
    }
    let Some(path) = args.output.as_deref() else { return Ok(()) };
    if path.extension().is_none_or(|ending| ending != "html") {
        return Err(Failure::Usage(format!("error: {}: unknown ending; accepted: .html", path.display())));
    }
    let begun = Instant::now();
    let native = given.as_ref().map(|scene| {
        let progress = Progress::new("running the scene, to compare the page with");
        let found = scene.hashes(|| begun.elapsed() < LONGEST_RUN && !interrupt.has_come());
        drop(progress);
        found
    });
    write(path, given.as_ref(), native.transpose()?.map(words))?;
    stdout::text(&format!("{}\n", path.display()))?;
    if args.open {
        browser::open(path);
    }
    Ok(())
}

/// A scene with the files that it names.
struct Scene {
    loaded: LoadedScene,
    files: Vec<(String, Vec<u8>)>,
}

impl Scene {
    /// Reads what the command line names.
    fn read(path: &Path) -> Result<Self, Failure> {
        let source = SceneText::of(path)?;
        let loaded = source.load(&[])?;
        let files = match &source {
            SceneText::Stdin(_) => Vec::new(),
            SceneText::Example(_, text) => shipped_meshes(text),
            SceneText::File(path) => files_beside(path, &loaded)?,
        };
        Ok(Self { loaded, files })
    }

    fn hashes(&self, goes_on: impl FnMut() -> bool) -> Result<Hashes, Failure> {
        let failed = |error: PlayError| match error {
            PlayError::Scene(error) => Failure::from(*error),
            PlayError::Simulation(error) => scene::failed(&self.loaded, *error),
            error => Failure::Check(format!("error: {error}")),
        };
        let mut own = Playground::of(self.loaded.clone()).map_err(failed)?;
        own.hashes(goes_on).map_err(failed)
    }
}

/// The meshes of the program that a text names.
fn shipped_meshes(text: &str) -> Vec<(String, Vec<u8>)> {
    let named = examples::MESHES.iter().filter(|(name, _)| text.contains(&format!("\"{name}\"")));
    named.map(|(name, bytes)| ((*name).to_owned(), bytes.to_vec())).collect()
}

/// The files that a scene file names, by names that end as those that it gives them.
fn files_beside(path: &Path, loaded: &LoadedScene) -> Result<Vec<(String, Vec<u8>)>, Failure> {
    let folder = path.parent().unwrap_or(Path::new(""));
    let absolute = std::path::absolute(folder).unwrap_or_else(|_| folder.to_owned());
    // A file elsewhere, as in a package of ROS, has the folder in common with the scene that is nearest to both: the
    // page tells nobody where on this machine that is.
    let name = |file: &Path| {
        let mut folders = std::iter::once(folder).chain(absolute.ancestors());
        folders.find_map(|above| file.strip_prefix(above).ok()).unwrap_or(file).to_string_lossy().into_owned()
    };
    let read = |file: &PathBuf| {
        let bytes = std::fs::read(file)
            .map_err(|error| Failure::InputOutput(format!("error: cannot read {}: {error}", file.display())))?;
        Ok((name(file), bytes))
    };
    loaded.mesh_files().iter().map(read).collect()
}

/// The hashes as the page has them.
fn words(found: Hashes) -> NativeHashes {
    let hex = |hash: u64| format!("{hash:016x}");
    NativeHashes {
        marks: found.marks.into_iter().map(|(step, hash)| (step, hex(hash))).collect(),
        hash: hex(found.hash),
        ended: found.ended,
    }
}

/// Writes the page; a scene file is never replaced.
fn write(path: &Path, scene: Option<&Scene>, native: Option<NativeHashes>) -> Result<(), Failure> {
    if let Some(scene) = scene {
        let meshes = scene.loaded.mesh_files();
        inputs::check_output(path, meshes.iter().map(AsRef::as_ref))?;
    }
    let titles = titles()?;
    let scenes = examples::SCENES.iter().zip(&titles);
    let examples = scenes.filter(|((_, text), _)| !text.contains(MESH_KEY));
    let title = scene.map_or_else(|| TITLE.to_owned(), |scene| scene.loaded.title());
    let given = Given {
        title: &title,
        scene: scene.map(|scene| scene.loaded.text()),
        files: scene.map(|scene| scene.files.clone()).unwrap_or_default(),
        examples: examples.map(|((name, text), title)| Example { name, title, text }).collect(),
        native,
    };
    let mut file = AtomicFile::create(path).map_err(|error| cannot_write(path, &error))?;
    play_page::write(&mut file, &given)
        .map_err(|error| Failure::InputOutput(format!("error: cannot write {}: {error}", path.display())))?;
    file.commit().map_err(|error| cannot_write(path, &error))
}

/// What stands in a scene that names mesh files: a page without them cannot run it.
const MESH_KEY: &str = "file = \"";

/// The titles of the shipped scenes.
fn titles() -> Result<Vec<String>, Failure> {
    let title = |(name, text): &(&str, &str)| Ok(load_with_files(name, text, examples::MESHES, &[])?.title());
    examples::SCENES.iter().map(title).collect()
}
