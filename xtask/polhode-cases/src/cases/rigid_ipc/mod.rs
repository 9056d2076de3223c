//! Unit scenes of Rigid IPC (docs/REFERENCES.md, Ferguson), whose claim is: no intersection at any step.
//!
//! Each scene is taken over by the importer, run with default settings (no scene but the incline has friction), and
//! every sample is checked for bodies in each other by [`polhode_oracles::interpenetration`]. A scene passes when it
//! runs to its end, no two bodies are deeper in each other than the tolerance at any sample, none is inside a solid or
//! beyond a surface, and energy is not created. Rotations that the suite holds (in its tunnels) are free here, which is
//! harder.
//!
//! Scenes written after the suite's descriptions need nothing; those of the suite itself are read from the folder
//! `rigid-ipc` of the folder that `POLHODE_DATA` names. The plain command runs the first [`PART_S`] of each,
//! `--full` all of it.
//!
//! | module | holds |
//! |---|---|
//! | `incline` | the incline of the suite |
//! | `own_scenes` | scenes written after the descriptions of the suite's scenes |

mod incline;
mod own_scenes;

pub(super) use incline::incline;

use super::{Amount, CaseResult, Context, Run};
use crate::rigid_ipc::{HeldRotations, import};
use crate::row::Row;
use glam::DVec3;
use polhode::Effects;
use polhode::mesh::obj;
use polhode_oracles::interpenetration::{self, Form};
use polhode_scene::format::{SceneFile, ShapeEntry};
use polhode_scene::{Override, load_with, read_mesh};
use std::error::Error;
use std::fs;
use std::path::{Path, PathBuf};

/// Simulated time of a scene in the plain command, s.
const PART_S: f64 = 1.0;

/// Energy that a scene may gain beyond the work of its forces, relative to its largest energy: the local errors of
/// 1e-11 a step over hundreds of steps in contact.
const ENERGY_GAIN: f64 = 1e-9;

/// Scenes of our own.
pub(super) fn own(context: &Context) -> CaseResult {
    let case = "Rigid IPC scenes";
    let folder = tempfile::tempdir()?;
    for (file, mesh) in own_scenes::mesh_files()? {
        fs::write(folder.path().join(file), obj::write(&mesh))?;
    }
    for (file, text) in own_scenes::point_files() {
        fs::write(folder.path().join(file), text)?;
    }
    let mut rows = Vec::new();
    for (number, scene) in own_scenes::all().iter().enumerate() {
        let path = folder.path().join(format!("{number}.json"));
        fs::write(&path, scene.document.to_string())?;
        rows.extend(scene_rows(context, case, scene.name, &path));
    }
    Ok(rows)
}

/// The scenes of the suite.
pub(super) fn suite(context: &Context) -> CaseResult {
    let case = "Rigid IPC suite";
    let Some(data) = std::env::var_os("POLHODE_DATA") else {
        return Ok(vec![Row::skipped(case, "scenes of the suite", "POLHODE_DATA is not set: they are not checked")]);
    };
    let folder = Path::new(&data).join("rigid-ipc/scenes");
    let mut rows = Vec::new();
    for path in json_files(&folder)? {
        let name = path.strip_prefix(&folder)?.with_extension("").to_string_lossy().into_owned();
        rows.extend(scene_rows(context, case, &name, &path));
    }
    Ok(rows)
}

/// All scenes below a folder, in order.
fn json_files(folder: &Path) -> Result<Vec<PathBuf>, Box<dyn Error>> {
    let mut files = Vec::new();
    for entry in fs::read_dir(folder).map_err(|error| format!("{}: {error}", folder.display()))? {
        let path = entry?.path();
        if path.is_dir() {
            files.extend(json_files(&path)?);
        } else if path.extension().is_some_and(|ending| ending == "json") {
            files.push(path);
        }
    }
    files.sort();
    Ok(files)
}

/// The rows of a scene, or one that fails with the error that kept it from giving any.
fn scene_rows(context: &Context, case: &str, name: &str, path: &Path) -> Vec<Row> {
    measure(context, case, name, path).unwrap_or_else(|error| vec![Row::broken(case, name, error.to_string())])
}

fn measure(context: &Context, case: &str, name: &str, path: &Path) -> CaseResult {
    let imported = import(path, None, HeldRotations::Freed)?;
    let folder = tempfile::tempdir()?;
    let file = imported.write(folder.path())?;
    let description: SceneFile = toml::from_str(&imported.text)?;
    let whole = description.duration.unwrap_or(PART_S);
    let duration = if context.amount == Amount::Full { whole } else { whole.min(PART_S) };
    let shortened = [Override::new("verify", "duration", duration.to_string())];
    let scene = load_with(&file, &shortened).map_err(|error| error.to_string())?.scene;
    let run = Run::of(&scene, Effects::Planned)?;
    let findings = interpenetration::check(&run.scene, &run.record, &body_forms(&description, folder.path())?)?;
    if let Some(t) = findings.since_s {
        eprintln!("\n{name}: {} m beyond the tolerance, first at {t} s", findings.beyond_m);
    }
    let ledger = &run.report.ledger;
    let gained = ledger.current_j - ledger.initial_j - ledger.external.value();
    let relative = if gained > 0.0 { gained / ledger.scale_j } else { 0.0 };
    let found = [run.report.simulated_s, findings.beyond_m, findings.within as f64, findings.through as f64];
    let quantity = format!("{name}: time run (s), deepest beyond the tolerance (m), bodies inside, bodies through");
    Ok(vec![
        Row::exact(case, &quantity, [duration, 0.0, 0.0, 0.0], found),
        Row::at_most(case, &format!("{name}: energy created, relative"), ENERGY_GAIN, relative),
    ])
}

/// The forms of the bodies of a scene that was taken over, meshes read again from their files.
fn body_forms(scene: &SceneFile, folder: &Path) -> Result<Vec<Form>, Box<dyn Error>> {
    let mut forms = Vec::new();
    for body in &scene.bodies {
        forms.push(match &body.shape {
            Some(ShapeEntry::Mesh(entry)) => {
                let mesh = read_mesh(&folder.join(&entry.file))?;
                Form::Mesh(entry.scale.map_or(Ok(mesh.clone()), |scale| mesh.scaled(scale))?)
            }
            Some(ShapeEntry::Points(entry)) => {
                Form::Points(entry.positions.iter().map(|position| DVec3::from_array(position.0)).collect())
            }
            _ => return Err(format!("{}: neither a mesh nor points", body.name).into()),
        });
    }
    Ok(forms)
}
