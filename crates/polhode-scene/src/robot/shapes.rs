//! From geometries of links to shapes of bodies. Of a mesh its convex hull collides.

use super::finding::{Findings, RobotDefect};
use super::model::{Geom, GeomForm};
use crate::files::Files;
use crate::mesh_file::read_mesh_of;
use glam::DVec3;
use polhode::contact::{ConvexPolyhedron, Shape};
use polhode::mesh::TriangleMesh;
use polhode::spatial::Pose;
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// Endings of mesh files that are known and not read.
const NOT_READ: [&str; 6] = ["dae", "gltf", "glb", "usd", "msh", "skn"];

/// Meshes that have been read.
#[derive(Debug)]
pub(super) struct Meshes {
    /// Where files are.
    files: Files,
    /// By their paths.
    read: BTreeMap<PathBuf, Arc<TriangleMesh>>,
}

impl Meshes {
    /// None yet.
    pub(super) fn new(files: Files) -> Self {
        Self { files, read: BTreeMap::new() }
    }

    /// The mesh of a geometry, in metres.
    ///
    /// # Errors
    /// When it is not found or cannot be read.
    pub(super) fn read(&mut self, name: &str, path: Option<&Path>, scale: DVec3) -> Result<TriangleMesh, RobotDefect> {
        if is_not_read(name) {
            return Err(RobotDefect::MeshFormat(name.to_owned()));
        }
        let path = path.ok_or_else(|| RobotDefect::MeshNotFound(name.to_owned()))?;
        let mesh = if let Some(mesh) = self.read.get(path) {
            mesh.clone()
        } else {
            let mesh = Arc::new(read_mesh_of(self.files, path)?);
            self.read.insert(path.to_owned(), mesh.clone());
            mesh
        };
        scaled(&mesh, scale).map_err(|source| RobotDefect::Mesh { file: name.to_owned(), source })
    }
}

/// Whether a mesh file is in a format that is known and not read.
pub(super) fn is_not_read(name: &str) -> bool {
    let ending = name.rsplit_once('.').map(|(_, ending)| ending.to_ascii_lowercase());
    ending.is_some_and(|ending| NOT_READ.contains(&ending.as_str()))
}

/// A mesh with its coordinates multiplied; where that mirrors it, its triangles are turned.
fn scaled(mesh: &TriangleMesh, scale: DVec3) -> Result<TriangleMesh, polhode::mesh::MeshError> {
    if scale == DVec3::ONE {
        return Ok(mesh.clone());
    }
    let vertices = mesh.vertices().iter().map(|&vertex| vertex * scale).collect();
    let made = TriangleMesh::new(vertices, mesh.triangles().to_vec())?;
    Ok(if is_mirrored(scale) { made.flipped() } else { made })
}

/// Whether a scale mirrors.
pub(super) fn is_mirrored(scale: DVec3) -> bool {
    scale.x * scale.y * scale.z < 0.0
}

/// A half-space, where it stands and in which link.
#[derive(Debug, Clone)]
pub(super) struct Ground {
    /// `X_LG`.
    pub(super) pose: Pose,
}

/// What collides of a link or of several.
#[derive(Debug, Default)]
pub(super) struct Colliding {
    /// Parts, in the frame of the body.
    pub(super) parts: Vec<Shape>,
    /// Half-spaces.
    pub(super) grounds: Vec<Ground>,
}

impl Colliding {
    /// The parts as one shape.
    ///
    /// # Errors
    /// When they make none.
    pub(super) fn shape(mut self) -> Result<Option<Shape>, RobotDefect> {
        match self.parts.len() {
            0 => Ok(None),
            1 => Ok(self.parts.pop()),
            _ => Ok(Some(Shape::compound(self.parts)?)),
        }
    }
}

/// Adds what collides of a geometry, whose frame stands at `pose` in that of the body.
pub(super) fn add(
    colliding: &mut Colliding,
    geom: &Geom,
    pose: &Pose,
    subject: &str,
    (meshes, findings): (&mut Meshes, &mut Findings),
) {
    if matches!(geom.form, GeomForm::Plane) {
        colliding.grounds.push(Ground { pose: *pose });
        return;
    }
    match own_shape(&geom.form, meshes).and_then(|shape| Ok(shape.placed(pose)?)) {
        Ok(shape) => colliding.parts.push(shape),
        Err(defect) => findings.add(&geom.place, subject, defect),
    }
}

/// The shape of a geometry in its own frame.
pub(super) fn own_shape(form: &GeomForm, meshes: &mut Meshes) -> Result<Shape, RobotDefect> {
    Ok(match form {
        GeomForm::Box { size } => Shape::cuboid(*size)?,
        GeomForm::Sphere { radius } => Shape::sphere(*radius)?,
        GeomForm::Cylinder { radius, height } => Shape::cylinder(*radius, *height)?,
        GeomForm::Capsule { radius, height } => Shape::capsule(*radius, *height)?,
        GeomForm::Ellipsoid { .. } => return Err(RobotDefect::NoSuchShape("ellipsoid")),
        GeomForm::Plane => return Err(RobotDefect::NoSuchShape("plane of a part that moves")),
        GeomForm::Mesh { name, path, scale } => hull(&meshes.read(name, path.as_deref(), *scale)?, name)?,
    })
}

fn hull(mesh: &TriangleMesh, name: &str) -> Result<Shape, RobotDefect> {
    let hull = ConvexPolyhedron::from_points(mesh.vertices());
    hull.map(Shape::convex).map_err(|source| RobotDefect::FlatMesh { file: name.to_owned(), source })
}
