//! A scene: its bodies, forces, materials and method, and where an error of the whole is shown.

use super::bodies::Bodies;
use super::fault::{Fault, positive, vector};
use super::materials::Materials;
use super::{body, force, method};
use crate::document::KeyPath;
use crate::error::Refusal;
use crate::format::{self, NoContactEntry, SceneFile};
use crate::mesh_file::MeshFolder;
use polhode::{Scene, SceneError};

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
    let mut list = Vec::with_capacity(file.bodies.len());
    for (index, entry) in file.bodies.iter().enumerate() {
        list.push(body::build(entry, &materials, folder, &KeyPath::element("bodies", index))?);
    }
    let bodies = Bodies::new(&list);
    for force in force::build(file, &bodies)? {
        builder = builder.force(force);
    }
    for (index, group) in file.no_contact.iter().enumerate() {
        builder = builder.no_contact(no_contact(group, &bodies, &KeyPath::element("no_contact", index))?);
    }
    for body in list {
        builder = builder.body(body);
    }
    builder.build().map_err(|error| (path_of(&error, file), Refusal::Scene(error)))
}

/// Where an error of the whole scene is best shown: at the body or the force it names, else at the top.
pub(crate) fn path_of(error: &SceneError, file: &SceneFile) -> KeyPath {
    let body = |name: &str| {
        let index = file.bodies.iter().position(|body| body.name == name);
        index.map_or_else(KeyPath::root, |index| KeyPath::element("bodies", index))
    };
    match error {
        SceneError::NotFinite { body: name, .. }
        | SceneError::InitialOverlap { body_b: name, .. }
        | SceneError::DuplicateName(name)
        | SceneError::FixedBodyMoves(name)
        | SceneError::MovingSurface(name)
        | SceneError::Shape { body: name, .. }
        | SceneError::MovingHalfSpace(name)
        | SceneError::Motion { body: name, .. } => body(name),
        SceneError::FixedBodyPivots(name) | SceneError::KinematicBodyPivots(name) => body(name).key("pivot"),
        SceneError::PivotMoves { body: name, .. } | SceneError::KinematicBodyHasVelocity(name) => {
            body(name).key("velocity")
        }
        SceneError::EmptyName(index) => KeyPath::element("bodies", *index),
        SceneError::Force { force: number, .. } | SceneError::ForceOnUnknownBody { force: number, .. } => {
            force::entry_of(*number, file).map_or_else(KeyPath::root, |index| KeyPath::element("forces", index))
        }
        SceneError::IntegratorTakesNoVelocities { .. } => KeyPath::of(&["method", "integrator"]),
        SceneError::ThesisFriction => KeyPath::of(&["method", "tier"]),
        _ => KeyPath::root(),
    }
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

/// Numbers of the bodies of a group that does not collide.
fn no_contact(group: &NoContactEntry, bodies: &Bodies<'_>, path: &KeyPath) -> Result<Vec<usize>, Fault> {
    let path = path.key("bodies");
    if group.bodies.len() < 2 {
        let accepted = "names of two or more bodies".to_owned();
        return Err((path, Refusal::Type { found: format!("length {}", group.bodies.len()), accepted }));
    }
    let number = |(index, name): (usize, &String)| Ok(bodies.get(name, &path.index(index))?.0);
    group.bodies.iter().enumerate().map(number).collect()
}
