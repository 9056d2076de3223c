//! `cargo xtask import-rigid-ipc`: scenes of the Rigid IPC suite in our scene format.
//!
//! The suite (docs/REFERENCES.md, Ferguson) writes a scene as JSON: bodies with a mesh file, a place, velocities, what
//! is held; degrees; y upwards. Here its axes and its gravity stay as they are. Where its format leaves a choice open,
//! its own reader (`read_rb_scene.cpp`, `rigid_body.cpp`, `SimState.cpp`) decides. A restitution of -1 there means that
//! no velocity is restored after the step: 0 here. One coefficient of friction is that of all contacts, in both
//! formats. Settings of its solver are reported as not used, keys that are not known are reported too, and what cannot
//! be simulated yet is refused with file and key.
//!
//! | module | holds |
//! |---|---|
//! | `table` | objects of the document; keys read and unread |
//! | `body` | bodies |
//! | `meshes` | mesh files and their sizes |
//! | `points` | corners without faces |
//! | `rotation` | three angles |
//! | `scene` | what is written |
//! | `error` | [`ImportError`] |

mod body;
mod error;
mod meshes;
mod points;
mod rotation;
mod scene;
mod table;

pub use body::HeldRotations;
pub use error::ImportError;

use clap::Args;
use glam::DVec3;
use meshes::Meshes;
use scene::{MATERIAL, MaterialText, NoContactText, OutputText, SceneText};
use std::collections::{BTreeMap, BTreeSet};
use std::error::Error;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::ExitCode;
use table::Table;

/// Simulated time of a scene that gives none (the suite runs it until its window is closed), s.
const DEFAULT_DURATION_S: f64 = 10.0;
/// The suite's time step when none is given, s.
const DEFAULT_TIMESTEP_S: f64 = 0.01;
/// Keys of the document that steer the suite's solver, its files and its picture.
const SOLVER_KEYS: [&str; 14] = [
    "solver",
    "max_iterations",
    "distance_barrier_constraint",
    "distance_barrier_constraints",
    "ipc_solver",
    "newton_solver",
    "homotopy_solver",
    "ncp_solver",
    "friction_constraints",
    "viewer",
    "num_threads",
    "rigid_body_problem.collision_eps",
    "rigid_body_problem.time_stepper",
    "rigid_body_problem.do_intersection_check",
];

/// What the command takes.
#[derive(Debug, Args)]
pub struct Options {
    /// Scene of the suite, JSON.
    scene: PathBuf,
    /// Folder that the scene and its mesh files are written to.
    #[arg(short, long)]
    output: PathBuf,
    /// Folder of the mesh files; else the nearest folder `meshes` above the scene.
    #[arg(long)]
    meshes: Option<PathBuf>,
    /// Free rotations that are held while translations are not, instead of refusing the scene.
    #[arg(long)]
    free_rotations: bool,
}

/// A scene taken over.
#[derive(Debug)]
pub struct Imported {
    /// Name of the scene.
    pub name: String,
    /// The scene file.
    pub text: String,
    /// Mesh files beside it: names and contents.
    pub meshes: BTreeMap<String, String>,
    /// What was not taken over as it stands, a line each.
    pub notes: Vec<String>,
}

/// Runs the command.
///
/// # Errors
/// When the scene cannot be read, holds what is not available, or the result cannot be written.
pub fn run(options: &Options) -> Result<ExitCode, Box<dyn Error>> {
    let held = if options.free_rotations { HeldRotations::Freed } else { HeldRotations::Refused };
    let imported = import(&options.scene, options.meshes.as_deref(), held)?;
    for note in &imported.notes {
        eprintln!("{note}");
    }
    println!("{}", imported.write(&options.output)?.display());
    Ok(ExitCode::SUCCESS)
}

/// Reads a scene of the suite; mesh files are looked for in `meshes`, else beside the scene and above it.
///
/// # Errors
/// When a file cannot be read, a key holds what is not understood, or the scene needs what is not available.
pub fn import(scene: &Path, meshes: Option<&Path>, held: HeldRotations) -> Result<Imported, ImportError> {
    let read = |source| ImportError::Read { path: scene.to_owned(), source };
    let text = fs::read_to_string(scene).map_err(read)?;
    let document = serde_json::from_str(&text);
    let document = document.map_err(|source| ImportError::Json { path: scene.to_owned(), source })?;
    let name = scene.file_stem().map_or_else(|| "scene".to_owned(), |stem| stem.to_string_lossy().into_owned());
    let mut meshes = Meshes::new(scene, meshes);
    let mut notes = Vec::new();
    let mut root = Table::new(scene, String::new(), &document)?;
    let text = toml::to_string(&scene_text(&mut root, name.clone(), &mut meshes, held, &mut notes)?)?;
    notes.append(&mut meshes.notes);
    Ok(Imported { name, text, meshes: meshes.written, notes })
}

impl Imported {
    /// Writes scene and meshes into a folder and returns the path of the scene.
    ///
    /// # Errors
    /// When a file cannot be written.
    pub fn write(&self, folder: &Path) -> Result<PathBuf, ImportError> {
        let write = |path: PathBuf, text: &str| match fs::write(&path, text) {
            Ok(()) => Ok(path),
            Err(source) => Err(ImportError::Write { path, source }),
        };
        fs::create_dir_all(folder).map_err(|source| ImportError::Write { path: folder.to_owned(), source })?;
        for (file, text) in &self.meshes {
            write(folder.join(file), text)?;
        }
        write(folder.join(format!("{}.toml", self.name)), &self.text)
    }
}

fn scene_text(
    root: &mut Table<'_>,
    name: String,
    meshes: &mut Meshes<'_>,
    held: HeldRotations,
    notes: &mut Vec<String>,
) -> Result<SceneText, ImportError> {
    if let Some(other) = root.text("scene_type")?.filter(|&kind| kind != "distance_barrier_rb_problem") {
        return Err(root.refuse("scene_type", format!("\"{other}\" is not a scene of rigid bodies")));
    }
    let interval = root.number("timestep")?.unwrap_or(DEFAULT_TIMESTEP_S);
    let duration = root.number("max_time")?.filter(|&duration| duration > 0.0).unwrap_or_else(|| {
        notes.push(format!("max_time: none given, {DEFAULT_DURATION_S} s taken"));
        DEFAULT_DURATION_S
    });
    let Some(mut problem) = root.table("rigid_body_problem")? else {
        return Err(root.refuse("rigid_body_problem", "absent"));
    };
    let gravity = problem.vector("gravity")?.unwrap_or(DVec3::ZERO);
    let restitution = problem.number("coefficient_restitution")?.unwrap_or(0.0).max(0.0);
    let friction = problem.number("coefficient_friction")?.unwrap_or(0.0);
    if friction < 0.0 {
        return Err(problem.refuse("coefficient_friction", format!("{friction} is negative")));
    }
    let mut bodies = Vec::new();
    let mut names = BTreeSet::new();
    for mut body in problem.tables("rigid_bodies")? {
        let name_of = |stem: &str| unique(stem, &mut names);
        if let Some(imported) = body::import(&mut body, meshes, held, name_of)? {
            notes.extend(imported.notes.iter().cloned());
            note_unread(&body, notes);
            bodies.push(imported);
        }
    }
    note_unread(&problem, notes);
    note_unread(root, notes);
    let no_contact = groups(&bodies);
    let (bodies, forces): (Vec<_>, Vec<_>) = bodies.into_iter().map(|body| (body.text, body.forces)).unzip();
    Ok(SceneText {
        format: polhode_scene::format::VERSION,
        name,
        duration,
        gravity: gravity.to_array(),
        output: OutputText { interval },
        materials: BTreeMap::from([(MATERIAL, MaterialText { friction, restitution })]),
        bodies,
        forces: forces.into_iter().flatten().collect(),
        no_contact,
    })
}

/// A name from that of a mesh that no other body has.
fn unique(stem: &str, names: &mut BTreeSet<String>) -> String {
    let mut name = stem.to_owned();
    let mut number = 2;
    while !names.insert(name.clone()) {
        name = format!("{stem}-{number}");
        number += 1;
    }
    name
}

/// Reports the keys of an object that nobody has read.
fn note_unread(table: &Table<'_>, notes: &mut Vec<String>) {
    for key in table.unread() {
        let last = key.rsplit('.').next().unwrap_or_default();
        let reason = if last.starts_with('#') {
            "switched off in the scene"
        } else if SOLVER_KEYS.contains(&key.as_str()) {
            "a setting of the suite's solver, not used"
        } else {
            "unknown key, not used"
        };
        notes.push(format!("{key}: {reason}"));
    }
}

/// Groups of bodies that do not collide. All fixed bodies are one group in the suite, whatever number they bear; a
/// group with one of them in it holds them all.
fn groups(bodies: &[body::ImportedBody]) -> Vec<NoContactText> {
    let numbers: BTreeSet<i64> = bodies.iter().filter(|body| !body.text.fixed).filter_map(|body| body.group).collect();
    let mut groups = Vec::new();
    for number in numbers {
        let is_member = |body: &&body::ImportedBody| body.group == Some(number);
        let with_fixed = bodies.iter().any(|body| body.text.fixed && is_member(&body));
        let members: Vec<String> = bodies
            .iter()
            .filter(|body| is_member(body) || (with_fixed && body.text.fixed))
            .map(|body| body.text.name.clone())
            .collect();
        if members.len() > 1 {
            groups.push(NoContactText { bodies: members });
        }
    }
    groups
}
