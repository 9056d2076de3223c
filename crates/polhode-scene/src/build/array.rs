//! Arrays: one body is built, and copied to every place of the layout.

use super::body;
use super::fault::{Fault, Faults};
use super::layout::{self, MOST_BODIES};
use super::materials::Materials;
use crate::document::KeyPath;
use crate::error::Refusal;
use crate::format::{ArrayEntry, LayoutEntry, SceneFile};
use crate::mesh_file::MeshFolder;
use polhode::spatial::Pose;
use polhode::{Body, Geometry, SceneError};

/// The bodies of all arrays, in the order of the file.
pub(super) fn build(file: &SceneFile, materials: &Materials, folder: &MeshFolder, faults: &mut Faults) -> Vec<Body> {
    let mut bodies = Vec::new();
    let mut total = file.bodies.len() as u64;
    for (index, entry) in file.arrays.iter().enumerate() {
        let path = KeyPath::element("arrays", index);
        if entry.name.is_empty() {
            faults.add((path.key("name"), SceneError::EmptyName(index).into()));
        }
        let made = body::build(&entry.body(), materials, folder, &path);
        let model = faults.note(made).unwrap_or_else(|| body::stand_in(&entry.body()));
        total = total.saturating_add(layout::count(&entry.layout));
        if total > MOST_BODIES {
            faults.add((path.key("layout"), Refusal::TooManyBodies { found: total, limit: MOST_BODIES }));
            break;
        }
        bodies.extend(faults.note(copies(entry, &model, &path)).unwrap_or_default());
    }
    bodies
}

/// The bodies of an array, copies of `model`.
fn copies(entry: &ArrayEntry, model: &Body, path: &KeyPath) -> Result<Vec<Body>, Fault> {
    if matches!(entry.layout, LayoutEntry::Drop(_)) {
        let given =
            [(entry.orientation.is_some(), "orientation"), (entry.rotation_vector.is_some(), "rotation_vector")];
        if let Some((_, key)) = given.into_iter().find(|(given, _)| *given) {
            return Err((
                path.key(key),
                Refusal::Meaningless { key, what: "a drop, which turns its bodies at random" },
            ));
        }
    }
    let radius = model.shape().map(|geometry| match geometry {
        Geometry::Shape(shape) => shape.radius(),
        Geometry::Mesh(mesh) => mesh.mesh().vertices().iter().map(|vertex| vertex.length()).fold(0.0, f64::max),
    });
    let stands = layout::stands(&entry.layout, radius, &path.key("layout"))?;
    let pose = model.initial_pose();
    let copy = |stand: layout::Stand| {
        let pose = Pose::new(stand.rotation * pose.rotation, pose.translation + stand.offset);
        model.clone().renamed(format!("{}-{}", entry.name, stand.suffix)).pose(pose)
    };
    Ok(stands.into_iter().map(copy).collect())
}

/// How many bodies of arrays forces move, as far as there can be as many.
pub(super) fn movable(file: &SceneFile) -> usize {
    let count = |entry: &ArrayEntry| usize::try_from(layout::count(&entry.layout)).unwrap_or(usize::MAX);
    file.arrays.iter().filter(|entry| !entry.fixed).map(count).fold(0, usize::saturating_add)
}

/// The array that a body of this name is of.
pub(super) fn of_body(name: &str, file: &SceneFile) -> Option<usize> {
    let is_number = |c: char| c.is_ascii_digit() || c == '-';
    file.arrays.iter().position(|array| {
        let suffix = name.strip_prefix(array.name.as_str()).and_then(|suffix| suffix.strip_prefix('-'));
        suffix.is_some_and(|suffix| !suffix.is_empty() && suffix.chars().all(is_number))
    })
}
