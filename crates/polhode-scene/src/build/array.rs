//! Arrays: one body is built, and copied to every place of the layout; of a wall also half a brick, of an arch also a
//! stone that is fixed.

use super::body;
use super::fault::{Fault, Faults};
use super::layout::{self, MOST_BODIES, Model, Piece};
use super::materials::Materials;
use crate::document::KeyPath;
use crate::error::Refusal;
use crate::files::SceneFolder;
use crate::format::{ArrayEntry, BodyEntry, LayoutEntry, SceneFile, ShapeEntry, SpringersName};
use polhode::spatial::Pose;
use polhode::{Body, Geometry, SceneError};

/// The bodies of all arrays, in the order of the file.
pub(super) fn build(file: &SceneFile, materials: &Materials, folder: &SceneFolder, faults: &mut Faults) -> Vec<Body> {
    let mut bodies = Vec::new();
    let mut total = file.bodies.len() as u64;
    for (index, entry) in file.arrays.iter().enumerate() {
        let path = KeyPath::element("arrays", index);
        if entry.name.is_empty() {
            faults.add((path.key("name"), SceneError::EmptyName(index).into()));
        }
        let Some(model) = faults.note(model(entry, &path)) else { continue };
        let whole = faults.note(body::build(&model, materials, folder, &path));
        let whole = whole.unwrap_or_else(|| body::stand_in(&model));
        total = total.saturating_add(layout::count(&entry.layout));
        if total > MOST_BODIES {
            faults.add((path.key("layout"), Refusal::TooManyBodies { found: total, limit: MOST_BODIES }));
            break;
        }
        // What is refused of it is refused of the whole one.
        let other = other(entry, &model).and_then(|other| body::build(&other, materials, folder, &path).ok());
        let models = Models { other: other.as_ref().unwrap_or(&whole), whole: &whole };
        bodies.extend(faults.note(copies(entry, models, &path)).unwrap_or_default());
    }
    bodies
}

/// The bodies that those of an array are copies of.
#[derive(Debug, Clone, Copy)]
struct Models<'a> {
    whole: &'a Body,
    /// Half a brick, or a stone that is fixed.
    other: &'a Body,
}

/// The body that most of an array are copies of.
fn model(entry: &ArrayEntry, path: &KeyPath) -> Result<BodyEntry, Fault> {
    if let Some((key, what)) = meaningless(entry) {
        return Err((path.key(key), Refusal::Meaningless { key, what }));
    }
    let mut model = entry.body();
    if let LayoutEntry::Arch(arch) = &entry.layout {
        let stone = layout::stone_of(arch, &path.key("layout").key("arch"))?;
        model.shape = Some(ShapeEntry::Wedge(stone));
    }
    Ok(model)
}

/// The body that some are copies of, if the layout has others.
fn other(entry: &ArrayEntry, model: &BodyEntry) -> Option<BodyEntry> {
    match &entry.layout {
        LayoutEntry::Wall(_) => half_brick(model),
        LayoutEntry::Arch(_) => Some(fixed(model)),
        _ => None,
    }
}

/// The same body, immovable.
fn fixed(model: &BodyEntry) -> BodyEntry {
    let own = model.clone();
    let (mass, density, inertia, center_of_mass) = (None, None, None, None);
    let (velocity, angular_velocity) = (None, None);
    BodyEntry { fixed: true, hollow: false, mass, density, inertia, center_of_mass, velocity, angular_velocity, ..own }
}

/// Half a brick of an array of boxes: its length along x and its mass are halved.
fn half_brick(model: &BodyEntry) -> Option<BodyEntry> {
    let mut half = model.clone();
    half.mass = half.mass.map(|mass| 0.5 * mass);
    let Some(ShapeEntry::Box(shape)) = &mut half.shape else { return None };
    shape.size.0[0] *= 0.5;
    Some(half)
}

/// What has no meaning for the layout of an array.
fn meaningless(entry: &ArrayEntry) -> Option<(&'static str, &'static str)> {
    let turned = [(entry.orientation.is_some(), "orientation"), (entry.rotation_vector.is_some(), "rotation_vector")];
    let of_matter = [(entry.inertia.is_some(), "inertia"), (entry.center_of_mass.is_some(), "center_of_mass")];
    let given = |keys: [(bool, &'static str); 2]| keys.into_iter().find(|(given, _)| *given).map(|(_, key)| key);
    match entry.layout {
        LayoutEntry::Drop(_) => given(turned).map(|key| (key, "a drop, which turns its bodies at random")),
        LayoutEntry::Wall(_) => given(turned)
            .map(|key| (key, "a wall, whose bricks lie along it: `turn` turns it"))
            .or_else(|| given(of_matter).map(|key| (key, "a wall, which has half bricks"))),
        LayoutEntry::Arch(_) => {
            let shaped = [(entry.shape.is_some(), "shape"), (entry.center_of_mass.is_some(), "center_of_mass")];
            given(shaped)
                .map(|key| (key, "an arch, whose stones are wedges of its own"))
                .or_else(|| given(turned).map(|key| (key, "an arch, which turns its stones: `turn` turns it")))
        }
        LayoutEntry::Grid(_) | LayoutEntry::Pyramid(_) | LayoutEntry::Ring(_) => None,
    }
}

/// The bodies of an array, copies of its models.
fn copies(entry: &ArrayEntry, models: Models<'_>, path: &KeyPath) -> Result<Vec<Body>, Fault> {
    let radius = models.whole.shape().map(|geometry| match geometry {
        Geometry::Shape(shape) => shape.radius(),
        Geometry::Mesh(mesh) => mesh.mesh().vertices().iter().map(|vertex| vertex.length()).fold(0.0, f64::max),
    });
    let length = match &entry.shape {
        Some(ShapeEntry::Box(shape)) => Some(shape.size.0[0]),
        _ => None,
    };
    let stands = layout::stands(&entry.layout, Model { radius, length }, &path.key("layout"))?;
    let copy = |stand: layout::Stand| {
        let model = match stand.piece {
            Piece::Whole => models.whole,
            Piece::Half | Piece::Springer => models.other,
        };
        let pose = model.initial_pose();
        let pose = Pose::new(stand.rotation * pose.rotation, pose.translation + stand.offset);
        model.clone().renamed(format!("{}-{}", entry.name, stand.suffix)).pose(pose)
    };
    Ok(stands.into_iter().map(copy).collect())
}

/// How many bodies of arrays forces move, as far as there can be as many.
pub(super) fn movable(file: &SceneFile) -> usize {
    let count = |entry: &ArrayEntry| {
        let springers = match &entry.layout {
            LayoutEntry::Arch(arch) if arch.springers == Some(SpringersName::Fixed) => 2,
            _ => 0,
        };
        usize::try_from(layout::count(&entry.layout).saturating_sub(springers)).unwrap_or(usize::MAX)
    };
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
