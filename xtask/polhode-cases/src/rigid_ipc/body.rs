//! Bodies of the suite.
//!
//! `position` is that of the mesh's origin and `rotation` is about it; `linear_velocity` is that of the centre of mass,
//! `angular_velocity` and `torque` are in the world's axes, both in degrees (the suite's reader turns a torque of
//! `x` into `x pi / 180` N m), `force` acts at the centre of mass.

use super::error::ImportError;
use super::meshes::{Form, Meshes};
use super::rotation;
use super::scene::{BodyText, ForceKindText, ForceText, MATERIAL, MeshText, PointsText, ShapeText};
use super::table::Table;
use glam::DVec3;
use polhode::mesh::{SolidMesh, TriangleMesh};
use polhode_spatial::Pose;
use std::f64::consts::PI;

/// Density when none is given, kg/m^3.
const DEFAULT_DENSITY: f64 = 1000.0;

/// rad per degree.
const RADIANS: f64 = PI / 180.0;

/// What happens to a body whose rotations alone are held.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum HeldRotations {
    /// The scene is refused.
    Refused,
    /// It turns freely, from rest.
    Freed,
}

/// What of a body is held.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Freedom {
    /// Nothing.
    Free,
    /// All of it.
    Fixed,
    /// Its centre of mass.
    Turns,
    /// Its orientation.
    Slides,
}

/// A body of the result.
#[derive(Debug)]
pub(super) struct ImportedBody {
    pub(super) text: BodyText,
    pub(super) forces: Vec<ForceText>,
    /// Bodies of one group do not collide with each other.
    pub(super) group: Option<i64>,
    /// What was not taken over as it stands.
    pub(super) notes: Vec<String>,
}

/// Takes a body over; nothing when it is not enabled. `name_of` makes a name that no other body has from the name of
/// the mesh.
pub(super) fn import(
    body: &mut Table<'_>,
    meshes: &mut Meshes<'_>,
    held: HeldRotations,
    name_of: impl FnOnce(&str) -> String,
) -> Result<Option<ImportedBody>, ImportError> {
    if body.flag("enabled")? == Some(false) {
        return Ok(None);
    }
    let placed = meshes.of_body(body)?;
    let mut notes = Vec::new();
    let name = name_of(&placed.stem);
    let linear = body.vector("linear_velocity")?.unwrap_or(DVec3::ZERO);
    let angular = body.vector("angular_velocity")?.unwrap_or(DVec3::ZERO) * RADIANS;
    let freedom = freedom(body, linear == DVec3::ZERO && angular == DVec3::ZERO)?;
    let orientation = rotation::of_degrees(body.vector("rotation")?.unwrap_or(DVec3::ZERO));
    let pose = Pose::new(orientation, body.vector("position")?.unwrap_or(DVec3::ZERO));
    let density = body.number("density")?.unwrap_or(DEFAULT_DENSITY);
    let group = body.integer("group_id")?.filter(|&group| group >= 0);
    if freedom == Freedom::Slides {
        match held {
            HeldRotations::Refused => {
                let message = "rotations that are held and translations that are free: not available; --free-rotations \
                    frees them";
                return Err(body.refuse("is_dof_fixed", message));
            }
            HeldRotations::Freed => {
                notes.push(format!("{}: rotations, held there, are free here", body.key("is_dof_fixed")));
            }
        }
    }
    let pivot = match (freedom, &placed.form) {
        (Freedom::Turns, Form::Mesh { mesh, .. }) => Some(pose.transform_point(center_of_mass(body, mesh)?).to_array()),
        _ => None,
    };
    let velocity = matches!(freedom, Freedom::Free | Freedom::Slides).then_some(linear);
    let angular = matches!(freedom, Freedom::Free | Freedom::Turns).then_some(angular);
    let forces = forces(body, &name, freedom)?;
    refuse_what_is_not_built(body)?;
    let is_given = |vector: &DVec3| *vector != DVec3::ZERO;
    let text = BodyText {
        name,
        fixed: freedom == Freedom::Fixed,
        shape: shape(body, placed.form, freedom)?,
        density: (freedom != Freedom::Fixed).then_some(density),
        position: pose.translation.to_array(),
        orientation: orientation.to_wxyz(),
        pivot,
        velocity: velocity.filter(is_given).map(|vector| vector.to_array()),
        angular_velocity: angular.filter(is_given).map(|vector| vector.to_array()),
        material: MATERIAL,
    };
    Ok(Some(ImportedBody { text, forces, group, notes }))
}

fn shape(body: &Table<'_>, form: Form, freedom: Freedom) -> Result<ShapeText, ImportError> {
    match form {
        Form::Mesh { file, scale, .. } => Ok(ShapeText::Mesh(MeshText { file, scale })),
        Form::Points(positions) if freedom == Freedom::Fixed => {
            Ok(ShapeText::Points(PointsText { positions: positions.iter().map(DVec3::to_array).collect() }))
        }
        Form::Points(_) => {
            let message = "points without faces have no volume to take a mass from: available are static ones";
            Err(body.refuse("type", message))
        }
    }
}

/// What is held, by `type` and `is_dof_fixed`; velocities of what is held are zero there too.
fn freedom(body: &mut Table<'_>, at_rest: bool) -> Result<Freedom, ImportError> {
    let held = body.six_flags("is_dof_fixed")?.unwrap_or([false; 6]);
    match body.text("type")? {
        None | Some("dynamic") => {}
        Some("static") => return Ok(Freedom::Fixed),
        Some("kinematic") if at_rest && body.value("kinematic_poses").is_none() => return Ok(Freedom::Fixed),
        Some("kinematic") => return Err(body.refuse("type", "bodies that move as prescribed are not available")),
        Some(other) => {
            return Err(body.refuse("type", format!("\"{other}\" is none of static, kinematic and dynamic")));
        }
    }
    match held {
        [false, false, false, false, false, false] => Ok(Freedom::Free),
        [true, true, true, true, true, true] => Ok(Freedom::Fixed),
        [true, true, true, false, false, false] => Ok(Freedom::Turns),
        [false, false, false, true, true, true] => Ok(Freedom::Slides),
        _ => {
            let message = "available are: nothing held, all held, all translations held, all rotations held";
            Err(body.refuse("is_dof_fixed", message))
        }
    }
}

fn center_of_mass(body: &Table<'_>, mesh: &TriangleMesh) -> Result<DVec3, ImportError> {
    let solid = SolidMesh::new(mesh.clone());
    let solid = solid.map_err(|error| body.refuse("mesh", format!("no centre of mass: {error}")))?;
    Ok(solid.volume_integrals().centroid)
}

/// Force and torque on a body, as far as what they move is free.
fn forces(body: &mut Table<'_>, name: &str, freedom: Freedom) -> Result<Vec<ForceText>, ImportError> {
    let force = body.vector("force")?.unwrap_or(DVec3::ZERO);
    let torque = body.vector("torque")?.unwrap_or(DVec3::ZERO) * RADIANS;
    let mut forces = Vec::new();
    if force != DVec3::ZERO && matches!(freedom, Freedom::Free | Freedom::Slides) {
        forces.push(ForceKindText::Force { body: name.to_owned(), force: force.to_array() });
    }
    if torque != DVec3::ZERO && matches!(freedom, Freedom::Free | Freedom::Turns) {
        forces.push(ForceKindText::Torque { body: name.to_owned(), torque: torque.to_array() });
    }
    Ok(forces.into_iter().map(|kind| ForceText { kind }).collect())
}

fn refuse_what_is_not_built(body: &mut Table<'_>) -> Result<(), ImportError> {
    if body.flag("split_components")? == Some(true) {
        return Err(body.refuse("split_components", "meshes are not split: give each component a file of its own"));
    }
    // Of plane bodies only.
    body.value("oriented");
    Ok(())
}
