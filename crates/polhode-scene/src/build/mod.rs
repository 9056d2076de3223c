//! From the format to the engine's scene.
//!
//! Every value goes through the constructor that checks it; what a constructor refuses is reported at the key it came
//! from. Nothing here looks at the text: places are paths of keys.
//!
//! | module | holds |
//! |---|---|
//! | `body` | a body: its pose, motion, shape and mass |
//! | `mass` | mass properties from mass or density, shape and inertia |
//! | `materials` | materials and rules for pairs of them |
//! | `method` | tier and knobs |
//! | `shape` | shapes, and the meshes they are read from |

mod body;
mod mass;
mod materials;
mod method;
mod shape;

use crate::document::KeyPath;
use crate::error::{Refusal, list};
use crate::format::{self, Exactly, NoContactEntry, SceneFile, ShapeEntry};
use crate::mesh_file::MeshFolder;
use glam::DVec3;
use materials::Materials;
use polhode::{Scene, SceneBuilder, SceneError};

/// A refusal and the path of the key it is about.
pub(crate) type Fault = (KeyPath, Refusal);

/// The scene that a file describes; `name` is used when the file gives none.
pub(crate) fn scene(file: &SceneFile, folder: &MeshFolder, name: &str) -> Result<Scene, Fault> {
    if file.format != format::VERSION {
        return Err((KeyPath::of(&["format"]), Refusal::Version(file.format)));
    }
    let mut builder = Scene::builder(file.name.as_deref().unwrap_or(name)).method(method::build(&file.method)?);
    if let Some(duration) = file.duration {
        builder = builder.duration_s(positive(duration, &KeyPath::of(&["duration"]))?);
    }
    if let Some(interval) = file.output.interval {
        builder = builder.output_interval_s(positive(interval, &KeyPath::of(&["output", "interval"]))?);
    }
    if let Some(gravity) = &file.gravity {
        builder = builder.gravity(vector(gravity, &KeyPath::of(&["gravity"]))?);
    }
    let materials = Materials::build(&file.materials)?;
    for (index, entry) in file.pairs.iter().enumerate() {
        builder = builder.pair_rule(materials.pair_rule(entry, &KeyPath::element("pairs", index))?);
    }
    check_names(file)?;
    for (index, entry) in file.bodies.iter().enumerate() {
        builder = builder.body(body::build(entry, &materials, folder, &KeyPath::element("bodies", index))?);
    }
    for (index, group) in file.no_contact.iter().enumerate() {
        builder = no_contact(builder, group, file, &KeyPath::element("no_contact", index))?;
    }
    builder.build().map_err(|error| (path_of(&error, file), Refusal::Scene(error)))
}

/// Where an error of the whole scene is best shown: at the body it names, else at the top.
pub(crate) fn path_of(error: &SceneError, file: &SceneFile) -> KeyPath {
    let body = |name: &str| file.bodies.iter().position(|body| body.name == name);
    let index = match error {
        SceneError::NotFinite { body: name, .. }
        | SceneError::InitialOverlap { body_b: name, .. }
        | SceneError::DuplicateName(name)
        | SceneError::FixedBodyMoves(name)
        | SceneError::MovingHalfSpace(name) => body(name),
        SceneError::EmptyName(index) => Some(*index),
        SceneError::NotYetAvailable { .. } => {
            file.bodies.iter().position(|body| matches!(body.shape, Some(ShapeEntry::Mesh(_))))
        }
        _ => None,
    };
    index.map_or_else(KeyPath::root, |index| KeyPath::element("bodies", index))
}

/// Every body has a name of its own.
fn check_names(file: &SceneFile) -> Result<(), Fault> {
    let mut seen = std::collections::BTreeSet::new();
    for (index, body) in file.bodies.iter().enumerate() {
        let path = KeyPath::element("bodies", index).key("name");
        if body.name.is_empty() {
            return Err((path, SceneError::EmptyName(index).into()));
        }
        if !seen.insert(body.name.as_str()) {
            return Err((path, Refusal::DuplicateName(body.name.clone())));
        }
    }
    Ok(())
}

fn no_contact(
    builder: SceneBuilder,
    group: &NoContactEntry,
    file: &SceneFile,
    path: &KeyPath,
) -> Result<SceneBuilder, Fault> {
    let path = path.key("bodies");
    if group.bodies.len() < 2 {
        let accepted = "names of two or more bodies".to_owned();
        return Err((path, Refusal::Type { found: format!("length {}", group.bodies.len()), accepted }));
    }
    let names: Vec<_> = file.bodies.iter().map(|body| body.name.as_str()).collect();
    let mut bodies = Vec::with_capacity(group.bodies.len());
    for (index, name) in group.bodies.iter().enumerate() {
        let Some(body) = names.iter().position(|known| known == name) else {
            let refusal = Refusal::UnknownName { kind: "body", name: name.clone(), known: list(&names) };
            return Err((path.index(index), refusal));
        };
        bodies.push(body);
    }
    Ok(builder.no_contact(bodies))
}

/// `value`, when it is positive and finite.
fn positive(value: f64, path: &KeyPath) -> Result<f64, Fault> {
    if value > 0.0 && value.is_finite() {
        Ok(value)
    } else {
        Err((path.clone(), Refusal::Number { value, accepted: "a positive, finite number" }))
    }
}

/// Three numbers, when all are finite.
fn vector(value: &Exactly<f64, 3>, path: &KeyPath) -> Result<DVec3, Fault> {
    match value.0.iter().position(|component| !component.is_finite()) {
        Some(index) => {
            let refusal = Refusal::Number { value: value.0[index], accepted: "a finite number" };
            Err((path.index(index), refusal))
        }
        None => Ok(DVec3::from_array(value.0)),
    }
}
