//! The scene that a command names: a file, `-` for stdin, or `example:NAME` for one inside the program.

use crate::args::{ChangeArgs, EffectsArg, SceneArgs};
use crate::examples;
use crate::failure::{self, Failure};
use polhode::{Effects, Geometry, Plan, Simulation, SimulationError};
use polhode_scene::robot::Severity;
use polhode_scene::{LoadedScene, Override, SceneFileError, load_text, load_with, load_with_files};
use std::ffi::OsStr;
use std::io::Read as _;
use std::path::Path;

/// What stands for stdin, and with -o for stdout.
pub(crate) const STANDARD: &str = "-";

/// What errors call a scene from stdin.
const STDIN: &str = "<stdin>";

/// Whether preparing the scene decomposes a mesh into convex parts, which may take seconds.
pub(crate) fn has_parts_to_find(loaded: &LoadedScene) -> bool {
    let bodies = loaded.scene.bodies();
    bodies.iter().any(|body| !body.is_fixed() && matches!(body.shape(), Some(Geometry::Mesh(_))))
}

/// Where the text of a scene is. It can be loaded many times, each time with other changes.
#[derive(Debug, Clone)]
pub(crate) enum SceneText<'a> {
    /// In a file.
    File(&'a Path),
    /// It has been read from stdin.
    Stdin(String),
    /// Inside the program: what it is called, and the text.
    Example(&'a str, &'static str),
}

impl<'a> SceneText<'a> {
    /// What a command names; stdin is read.
    ///
    /// # Errors
    /// When there is no such example, or stdin cannot be read.
    pub(crate) fn of(path: &'a Path) -> Result<Self, Failure> {
        let name = path.to_str().unwrap_or_default();
        if name == STANDARD {
            let mut bytes = Vec::new();
            let limit = polhode_scene::load::LARGEST_SCENE_FILE;
            let read = std::io::stdin().lock().take(limit + 1).read_to_end(&mut bytes);
            read.map_err(|error| Failure::InputOutput(format!("error: cannot read stdin: {error}")))?;
            if bytes.len() as u64 > limit {
                return Err(Failure::Usage(format!("error: stdin is larger than {limit} bytes, which no scene is")));
            }
            let text = String::from_utf8(bytes);
            return text.map(Self::Stdin).map_err(|error| {
                let at = error.utf8_error().valid_up_to();
                Failure::Usage(format!("error: {STDIN}: not a scene file: byte {at} is not UTF-8 text"))
            });
        }
        match name.strip_prefix(examples::PREFIX) {
            Some(example) => Ok(Self::Example(name, examples::find(example)?)),
            None => Ok(Self::File(path)),
        }
    }

    /// The scene with changes.
    ///
    /// # Errors
    /// As [`load_with`].
    pub(crate) fn load(&self, changes: &[Override]) -> Result<LoadedScene, SceneFileError> {
        match self {
            Self::File(path) => load_with(path, changes),
            Self::Stdin(text) => load_text(STDIN, text, changes),
            Self::Example(name, text) => load_with_files(name, text, examples::MESHES, changes),
        }
    }

    /// What it is called on the command line.
    pub(crate) fn name(&self) -> &OsStr {
        match self {
            Self::File(path) => path.as_os_str(),
            Self::Stdin(_) => OsStr::new(STANDARD),
            Self::Example(name, _) => OsStr::new(*name),
        }
    }

    /// The file, when it is one.
    pub(crate) fn file(&self) -> Option<&'a Path> {
        match self {
            Self::File(path) => Some(path),
            Self::Stdin(_) | Self::Example(..) => None,
        }
    }
}

/// The scene with the changes of the command line.
pub(crate) fn load(args: &SceneArgs) -> Result<LoadedScene, Failure> {
    Ok(SceneText::of(&args.scene)?.load(&overrides(&args.changes)?)?)
}

/// A scene by its name, with changes.
pub(crate) fn load_changed(path: &Path, changes: &[Override]) -> Result<LoadedScene, Failure> {
    Ok(SceneText::of(path)?.load(changes)?)
}

/// The changes of the command line.
pub(crate) fn overrides(args: &ChangeArgs) -> Result<Vec<Override>, Failure> {
    let mut overrides = Vec::new();
    for text in &args.set {
        overrides.push(change("--set", text)?);
    }
    let flags = [("--tier", "method.tier", &args.tier), ("--step", "method.step", &args.step)];
    for (flag, key, value) in flags {
        if let Some(value) = value {
            overrides.push(Override::new(format!("command line ({flag})"), key, value));
        }
    }
    overrides.extend(args.duration.as_deref().map(duration));
    Ok(overrides)
}

/// The change that `--duration` is.
pub(crate) fn duration(value: &str) -> Override {
    Override::new("command line (--duration)".to_owned(), "duration", value)
}

/// One change that an option of this name gives.
pub(crate) fn change(option: &str, text: &str) -> Result<Override, Failure> {
    Override::parse(format!("command line ({option})"), text).ok_or_else(|| {
        Failure::Usage(format!("error: {option} {text}: not of the form KEY=VALUE, such as {option} duration=5"))
    })
}

/// Says that robot files have something that drives their joints, is simulated otherwise, or not at all.
pub(crate) fn tell_of_robots(loaded: &LoadedScene) {
    let name = loaded.scene.name();
    let count = |severity: Severity| loaded.findings().filter(|finding| finding.severity() == severity).count();
    let (all, ignored, read) = (loaded.findings().count(), count(Severity::Ignored), count(Severity::Read));
    if all > 0 {
        let differ = all - ignored - read;
        let drives = if read == 0 { String::new() } else { format!(", and {read} are read that drive it") };
        failure::remark(&format!(
            "note: {name}: of what its robot files say {differ} things are simulated otherwise and {ignored} are \
             ignored{drives}: `polhode check` lists them"
        ));
    }
}

/// The scene, ready to run.
pub(crate) fn prepare(loaded: &LoadedScene, args: &ChangeArgs) -> Result<Simulation, Failure> {
    Simulation::with_effects(&loaded.scene, effects(args)).map_err(|error| failed(loaded, error))
}

/// The effects that are simulated.
pub(crate) fn effects(args: &ChangeArgs) -> Effects {
    match args.effects {
        EffectsArg::Planned => Effects::Planned,
        EffectsArg::All => Effects::All,
    }
}

/// A plan whose reasons name the option that has set a method, where it was not the scene.
pub(crate) fn with_origins(loaded: &LoadedScene, plan: &Plan) -> Plan {
    let mut plan = plan.clone();
    for (reason, key) in [(&mut plan.tier_reason, "method.tier"), (&mut plan.integrator_reason, "method.integrator")] {
        if let (Some(origin), Some(rest)) = (loaded.set_by(key), reason.strip_prefix(NAMED_BY_SCENE)) {
            let option = origin.strip_prefix("command line (").and_then(|option| option.strip_suffix(')'));
            *reason = format!("set by {}{rest}", option.unwrap_or(origin));
        }
    }
    plan
}

/// How the plan says that a method is given by what it was made from.
const NAMED_BY_SCENE: &str = "the scene names it";

/// A failure of the engine: a scene that is refused is shown at its place, anything else is a failed check.
pub(crate) fn failed(loaded: &LoadedScene, error: SimulationError) -> Failure {
    match error {
        SimulationError::Scene(error) => loaded.explain(error).into(),
        error => Failure::Check(format!("error: {}: {error}", loaded.scene.name())),
    }
}
