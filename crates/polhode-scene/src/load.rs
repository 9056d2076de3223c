//! From a scene file to a scene.

use crate::boxes;
use crate::build::{self, Built, PlacedRobot};
use crate::document::{Document, KeyPath, Override};
use crate::error::{Refusal, SceneFileError};
use crate::files::{Fault, Files, GivenFiles, SceneFolder};
use crate::format::{ArrayEntry, SceneFile};
use crate::robot::{self, Finding};
use crate::uncertain::Uncertain;
use polhode::scene::Appearance;
use polhode::{Scene, SceneError};
use std::path::{Path, PathBuf};

/// Largest scene file read, bytes: a hundred thousand bodies need about 20 MB.
pub const LARGEST_SCENE_FILE: u64 = 64 << 20;

/// A scene and the file it came from.
#[derive(Debug, Clone)]
pub struct LoadedScene {
    /// The scene.
    pub scene: Scene,
    document: Document,
    file: SceneFile,
    folder: SceneFolder,
    robots: Vec<PlacedRobot>,
    uncertain: Vec<Uncertain>,
    appearance: Appearance,
}

impl LoadedScene {
    /// How its file wants it shown.
    pub fn appearance(&self) -> &Appearance {
        &self.appearance
    }

    /// The text of its file, without what is set from outside; where a robot or a table stands for it, the text that
    /// was made of that.
    pub fn text(&self) -> &str {
        self.document.text()
    }

    /// The files on disk of meshes and robots that the scene was made from.
    pub fn mesh_files(&self) -> Vec<PathBuf> {
        if self.folder.files != Files::Disk {
            return Vec::new();
        }
        let mut files = Vec::new();
        let of_bodies = self.file.bodies.iter().filter_map(|body| body.shape.as_ref());
        let of_arrays = self.file.arrays.iter().filter_map(|array| array.shape.as_ref());
        of_bodies.chain(of_arrays).for_each(|shape| shape.add_files(&mut files));
        let of_shapes = files.into_iter().map(|file| self.folder.path(file));
        of_shapes.chain(self.robots.iter().flat_map(|robot| robot.robot.all_files())).collect()
    }

    /// What is uncertain, in the order of the file: the scene has what it says, and a sweep draws these.
    pub fn uncertain(&self) -> &[Uncertain] {
        &self.uncertain
    }

    /// The arrays of the file.
    pub(crate) fn arrays(&self) -> &[ArrayEntry] {
        &self.file.arrays
    }

    /// The names of the joints by their handles: those of the file, and of robots; a joint without a name has its
    /// number, counted from 1.
    pub fn joint_names(&self) -> Vec<String> {
        let count = self.scene.joints().len();
        let mut names: Vec<String> = (1..=count).map(|number| format!("joint {number}")).collect();
        for (name, entry) in names.iter_mut().zip(&self.file.joints) {
            if let Some(own) = &entry.name {
                name.clone_from(own);
            }
        }
        let mut first = self.file.joints.len();
        for robot in &self.robots {
            for named in &robot.joint_names {
                if let Some(own) = names.get_mut(first + named.joint) {
                    named.name.clone_into(own);
                }
            }
            first += robot.joints.len();
        }
        names
    }

    /// What the scene is, in a few words: its `title`, or else its name.
    pub fn title(&self) -> String {
        self.file.title.as_deref().and_then(on_one_line).unwrap_or_else(|| self.scene.name().to_owned())
    }

    /// What the scene shows and what to look at, on one line; none when its file does not say.
    pub fn description(&self) -> Option<String> {
        self.file.description.as_deref().and_then(on_one_line)
    }

    /// What has set a key from outside the file (the origin of the last [`Override`] of it); none when the file itself
    /// does, or nothing.
    pub fn set_by(&self, key: &str) -> Option<&str> {
        self.document.set_by(key)
    }

    /// What was found in the files of robots: what differs from them, and what of them is ignored.
    pub fn findings(&self) -> impl Iterator<Item = &Finding> {
        self.robots.iter().flat_map(|robot| robot.findings.iter())
    }

    /// Examines the robots of the scene: whether masses and inertias fit the shapes, whether meshes are sound, and
    /// which links overlap at the start. It reads their meshes, which may take seconds.
    pub fn examine_robots(&self) -> Vec<Finding> {
        self.robots.iter().flat_map(|robot| robot::examine(&robot.robot, &robot.placement)).collect()
    }

    /// An error that the engine found in the scene later (two bodies that overlap), shown at its place in the file.
    pub fn explain(&self, error: SceneError) -> SceneFileError {
        self.document.refuse(&build::path_of(&error, &self.file, &self.robots), Refusal::Scene(error))
    }
}

/// The words of a text with one space between each; none when there are none.
fn on_one_line(text: &str) -> Option<String> {
    let words: Vec<&str> = text.split_whitespace().collect();
    (!words.is_empty()).then(|| words.join(" "))
}

/// Loads a scene from a file. Paths of meshes are relative to the file. A robot file (`.urdf`, `.xml`, `.mjcf`) stands
/// for a scene of the robot, for two seconds, with a floor below it unless the world holds it. A table of boxes
/// (`.csv`) stands for a scene of these on a floor.
///
/// # Errors
/// [`SceneFileError`]: the file, its text, a key or a value is refused, with the place and the line.
pub fn load(path: &Path) -> Result<Scene, SceneFileError> {
    load_with(path, &[]).map(|loaded| loaded.scene)
}

/// Loads a scene from a file after setting some of its values from outside.
///
/// # Errors
/// As [`load`]; a value set from outside names its origin as the place.
pub fn load_with(path: &Path, overrides: &[Override]) -> Result<LoadedScene, SceneFileError> {
    if robot::is_robot_file(path) {
        return load_robot(path, overrides);
    }
    let bytes = read_scene_file(Files::Disk, path)?;
    if boxes::is_table(path) {
        let origin = format!("the scene of {}", path.display());
        let text = boxes::scene_of(path, &bytes)?;
        return from_document(Document::new(&origin, text, overrides), &SceneFolder::beside(path), &name_of(path));
    }
    let text = String::from_utf8(bytes).map_err(|error| {
        let offset = error.utf8_error().valid_up_to();
        let line = error.as_bytes()[..offset].split(|&byte| byte == b'\n').count();
        SceneFileError::NotText { path: path.to_owned(), line, offset }
    })?;
    from_document(
        Document::new(&path.display().to_string(), text, overrides),
        &SceneFolder::beside(path),
        &name_of(path),
    )
}

/// The bytes of a scene file.
fn read_scene_file(files: Files, path: &Path) -> Result<Vec<u8>, SceneFileError> {
    files.bounded(path, LARGEST_SCENE_FILE).map_err(|fault| match fault {
        Fault::Io(source) => SceneFileError::Read { path: path.to_owned(), source },
        Fault::TooLarge => SceneFileError::TooLarge { path: path.to_owned(), limit: LARGEST_SCENE_FILE },
    })
}

/// The name of a scene that has none: that of its file.
fn name_of(path: &Path) -> String {
    path.file_stem().map_or_else(String::new, |stem| stem.to_string_lossy().into_owned())
}

/// A scene of one robot: its file stands for it.
fn load_robot(path: &Path, overrides: &[Override]) -> Result<LoadedScene, SceneFileError> {
    let text = robot::scene_of(Files::Disk, path)?;
    let origin = format!("the scene of {}", path.display());
    let folder = SceneFolder::beside(path);
    from_document(Document::new(&origin, text, overrides), &folder, &name_of(path)).map_err(SceneFileError::of_robot)
}

/// Loads a scene from text; `origin` is what errors call it, and names the folder that mesh files are relative to.
///
/// # Errors
/// As [`load`].
pub fn load_text(origin: &str, text: &str, overrides: &[Override]) -> Result<LoadedScene, SceneFileError> {
    let folder = SceneFolder::beside(Path::new(origin));
    from_document(Document::new(origin, text.to_owned(), overrides), &folder, origin)
}

/// Loads a scene from text that has the files of its meshes and robots with it, each by the name that the scene gives
/// it.
///
/// # Errors
/// As [`load`].
pub fn load_with_files(
    origin: &str,
    text: &str,
    files: GivenFiles,
    overrides: &[Override],
) -> Result<LoadedScene, SceneFileError> {
    from_document(Document::new(origin, text.to_owned(), overrides), &SceneFolder::given(files), origin)
}

/// The text of the scene that a robot file or a table of boxes stands for, as [`load`] has it: one of the given files.
///
/// # Errors
/// When the robot file or the table is refused.
pub fn scene_text_of(name: &str, files: GivenFiles) -> Result<String, SceneFileError> {
    let (path, files) = (Path::new(name), Files::Given(files));
    if robot::is_robot_file(path) {
        return Ok(robot::scene_of(files, path)?);
    }
    let bytes = read_scene_file(files, path)?;
    boxes::scene_of(path, &bytes)
}

fn from_document(document: Document, folder: &SceneFolder, name: &str) -> Result<LoadedScene, SceneFileError> {
    let (file, Built { scene, robots, appearance }) = document.read(|file| build::scene(file, folder, name))?;
    let uncertain = uncertain_of(&document, &file)?;
    Ok(LoadedScene { scene, document, file, folder: folder.clone(), robots, uncertain, appearance })
}

/// What is uncertain; the scene takes each of its keys.
fn uncertain_of(document: &Document, file: &SceneFile) -> Result<Vec<Uncertain>, SceneFileError> {
    if file.uncertain.is_empty() {
        return Ok(Vec::new());
    }
    let all = build::uncertain(file, &|key| document.number(key)).map_err(|faults| document.refuse_all(faults))?;
    let middle = |own: &Uncertain| match own {
        Uncertain::Key { key, drawn } => Some(Override::new("uncertain", key, drawn.middle())),
        Uncertain::Poses { .. } => None,
    };
    let changes: Vec<(usize, Override)> =
        all.iter().enumerate().filter_map(|(number, own)| Some((number, middle(own)?))).collect();
    let together: Vec<Override> = changes.iter().map(|(_, change)| change.clone()).collect();
    if document.taken(&together).is_ok() {
        return Ok(all);
    }
    let refused = changes.into_iter().filter_map(|(number, change)| {
        let cause = document.taken(&[change]).err()?;
        Some((KeyPath::element("uncertain", number).key("key"), cause))
    });
    let refused: Vec<_> = refused.collect();
    if refused.is_empty() { Ok(all) } else { Err(document.refuse_all(refused)) }
}
