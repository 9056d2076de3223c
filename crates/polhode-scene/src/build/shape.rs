//! Shapes, and the meshes they are read from.

use super::{Fault, positive, vector};
use crate::document::KeyPath;
use crate::error::Refusal;
use crate::format::ShapeEntry;
use crate::mesh_file::MeshFolder;
use glam::DVec3;
use polhode::Geometry;
use polhode::contact::{ConvexPolyhedron, Shape};
use polhode::mesh::{SolidMesh, convexity};
use polhode::spatial::UnitVector;

/// A shape, with what its mass properties need.
pub(super) struct Form {
    /// What collides.
    pub(super) geometry: Geometry,
    /// What has mass.
    pub(super) matter: Matter,
}

/// What the mass of a body is spread over.
pub(super) enum Matter {
    /// A box of this size, m.
    Box(DVec3),
    /// A ball of this radius, m.
    Sphere(f64),
    /// The solid that a mesh bounds.
    Mesh(SolidMesh),
    /// Nothing that has a volume.
    Points,
    /// A half-space, which no mass can fill.
    HalfSpace,
}

/// The shape given at `path`.
pub(super) fn build(entry: &ShapeEntry, folder: &MeshFolder, path: &KeyPath) -> Result<Form, Fault> {
    match entry {
        ShapeEntry::Box(entry) => {
            let path = path.key("box").key("size");
            let size = vector(&entry.size, &path)?;
            for (index, &edge) in entry.size.0.iter().enumerate() {
                positive(edge, &path.index(index))?;
            }
            let shape = Shape::cuboid(size).map_err(|error| (path, error.into()))?;
            Ok(Form { geometry: shape.into(), matter: Matter::Box(size) })
        }
        ShapeEntry::Sphere(entry) => {
            let path = path.key("sphere").key("radius");
            let radius = positive(entry.radius, &path)?;
            let shape = Shape::sphere(radius).map_err(|error| (path, error.into()))?;
            Ok(Form { geometry: shape.into(), matter: Matter::Sphere(radius) })
        }
        ShapeEntry::HalfSpace(entry) => {
            let path = path.key("half_space").key("normal");
            let normal = UnitVector::new(vector(&entry.normal, &path)?).map_err(|error| (path, error.into()))?;
            Ok(Form { geometry: Shape::half_space(normal).into(), matter: Matter::HalfSpace })
        }
        ShapeEntry::Points(entry) => {
            let path = path.key("points").key("positions");
            let mut points = Vec::with_capacity(entry.positions.len());
            for (index, position) in entry.positions.iter().enumerate() {
                points.push(vector(position, &path.index(index))?);
            }
            let shape = Shape::points(points).map_err(|error| (path, error.into()))?;
            Ok(Form { geometry: shape.into(), matter: Matter::Points })
        }
        ShapeEntry::Convex(entry) => {
            let path = path.key("convex").key("file");
            let mesh = solid(&entry.file, folder, &path)?;
            let polyhedron = ConvexPolyhedron::from_mesh(&mesh).map_err(|error| (path, error.into()))?;
            Ok(Form { geometry: Shape::convex(polyhedron).into(), matter: Matter::Mesh(mesh) })
        }
        ShapeEntry::Mesh(entry) => {
            let mesh = solid(&entry.file, folder, &path.key("mesh").key("file"))?;
            Ok(Form { geometry: colliding_if_convex(&mesh), matter: Matter::Mesh(mesh) })
        }
    }
}

/// The solid in a file of this name.
fn solid(file: &str, folder: &MeshFolder, path: &KeyPath) -> Result<SolidMesh, Fault> {
    let mesh = folder.read(file).map_err(|error| (path.clone(), Refusal::MeshFile(error)))?;
    SolidMesh::new(mesh).map_err(|error| (path.clone(), Refusal::Mesh(error)))
}

/// A convex mesh collides; any other has mass properties only.
fn colliding_if_convex(mesh: &SolidMesh) -> Geometry {
    let polyhedron = if convexity(mesh).is_convex() { ConvexPolyhedron::from_mesh(mesh).ok() } else { None };
    polyhedron.map_or_else(|| Geometry::Mesh(mesh.clone()), |polyhedron| Shape::convex(polyhedron).into())
}
