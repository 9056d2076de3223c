//! Shapes, and the meshes they are read from.

use super::approximate;
use super::fault::{Fault, positive, vector};
use super::matter::Matter;
use super::placement;
use crate::document::KeyPath;
use crate::error::Refusal;
use crate::files::SceneFolder;
use crate::format::{CompoundEntry, FileEntry, MeshEntry, PartEntry, RadiusHeightEntry, ShapeEntry, WedgeEntry};
use crate::mesh_file::read_mesh_of;
use glam::DVec2;
use polhode::contact::{ConvexPolyhedron, Shape};
use polhode::mesh::{
    Capsule, Cone, Cuboid, Cylinder, MeshError, Primitive, PrismError, SolidMesh, Sphere, Torus, TriangleMesh,
    convexity, prism,
};
use polhode::spatial::UnitVector;
use polhode::{ApproximateParts, Geometry};

/// A shape, with what its mass properties need.
pub(super) struct Form {
    /// What collides.
    pub(super) geometry: Geometry,
    /// What has mass.
    pub(super) matter: Matter,
    /// How well convex parts fill a mesh, where they only do so approximately.
    pub(super) approximation: Option<ApproximateParts>,
}

/// Whether the body of a shape moves.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Mobility {
    /// It does: its shape must enclose something or be a set of points.
    Moves,
    /// It is ground: an open surface will do.
    Fixed,
}

/// The shape given at `path`.
pub(super) fn build(
    entry: &ShapeEntry,
    mobility: Mobility,
    folder: &SceneFolder,
    path: &KeyPath,
) -> Result<Form, Fault> {
    match entry {
        ShapeEntry::Box(entry) => {
            let path = path.key("box").key("size");
            let size = vector(&entry.size, &path)?;
            for (index, &edge) in entry.size.0.iter().enumerate() {
                positive(edge, &path.index(index))?;
            }
            form(Shape::cuboid(size), Cuboid::new(size).map(Primitive::Box), &path)
        }
        ShapeEntry::Sphere(entry) => {
            let path = path.key("sphere").key("radius");
            let radius = positive(entry.radius, &path)?;
            form(Shape::sphere(radius), Sphere::new(radius).map(Primitive::Sphere), &path)
        }
        ShapeEntry::Cylinder(entry) => {
            let path = path.key("cylinder");
            let (radius, height) = radius_and_height(entry, &path)?;
            form(Shape::cylinder(radius, height), Cylinder::new(radius, height).map(Primitive::Cylinder), &path)
        }
        ShapeEntry::Cone(entry) => {
            let path = path.key("cone");
            let (radius, height) = radius_and_height(entry, &path)?;
            form(Shape::cone(radius, height), Cone::new(radius, height).map(Primitive::Cone), &path)
        }
        ShapeEntry::Capsule(entry) => {
            let path = path.key("capsule");
            let (radius, height) = radius_and_height(entry, &path)?;
            form(Shape::capsule(radius, height), Capsule::new(radius, height).map(Primitive::Capsule), &path)
        }
        ShapeEntry::Torus(entry) => {
            let path = path.key("torus");
            let (major, minor) =
                (positive(entry.major, &path.key("major"))?, positive(entry.minor, &path.key("minor"))?);
            form(Shape::torus(major, minor), Torus::new(major, minor).map(Primitive::Torus), &path.key("minor"))
        }
        ShapeEntry::HalfSpace(entry) => {
            let path = path.key("half_space").key("normal");
            let normal = UnitVector::new(vector(&entry.normal, &path)?).map_err(|error| (path, error.into()))?;
            Ok(Form { geometry: Shape::half_space(normal).into(), matter: Matter::HalfSpace, approximation: None })
        }
        ShapeEntry::Points(entry) => {
            let path = path.key("points").key("positions");
            let mut points = Vec::with_capacity(entry.positions.len());
            for (index, position) in entry.positions.iter().enumerate() {
                points.push(vector(position, &path.index(index))?);
            }
            let shape = Shape::points(points).map_err(|error| (path, error.into()))?;
            Ok(Form { geometry: shape.into(), matter: Matter::WithoutVolume, approximation: None })
        }
        ShapeEntry::Compound(entry) => compound(entry, folder, &path.key("compound").key("parts")),
        ShapeEntry::Prism(entry) => {
            let path = path.key("prism");
            let corners: Vec<DVec2> = entry.polygon.iter().map(|corner| DVec2::from_array(corner.0)).collect();
            solid_form(prism(&corners, positive(entry.height, &path.key("height"))?), &path.key("polygon"))
        }
        ShapeEntry::Wedge(entry) => wedge(entry, &path.key("wedge")),
        ShapeEntry::Convex(entry) => convex(entry, folder, &path.key("convex")),
        ShapeEntry::Mesh(entry) => mesh(entry, mobility, folder, &path.key("mesh")),
    }
}

/// The convex solid of a mesh file.
fn convex(entry: &FileEntry, folder: &SceneFolder, path: &KeyPath) -> Result<Form, Fault> {
    let mesh = SolidMesh::new(read((&entry.file, entry.scale), folder, path)?);
    let mesh = mesh.map_err(|error| no_solid(&entry.file, error, path))?;
    let polyhedron = ConvexPolyhedron::from_mesh(&mesh).map_err(|error| (path.key("file"), error.into()))?;
    Ok(Form { geometry: Shape::convex(polyhedron).into(), matter: Matter::Mesh(mesh), approximation: None })
}

/// A primitive as shape and matter.
fn form(
    shape: Result<Shape, polhode::contact::ShapeError>,
    primitive: Result<Primitive, polhode::mesh::PrimitiveError>,
    path: &KeyPath,
) -> Result<Form, Fault> {
    let shape = shape.map_err(|error| (path.clone(), error.into()))?;
    let primitive = primitive.map_err(|error| (path.clone(), error.into()))?;
    Ok(Form { geometry: shape.into(), matter: Matter::Primitive(primitive), approximation: None })
}

fn radius_and_height(entry: &RadiusHeightEntry, path: &KeyPath) -> Result<(f64, f64), Fault> {
    Ok((positive(entry.radius, &path.key("radius"))?, positive(entry.height, &path.key("height"))?))
}

/// A mesh file as ground, convex solid or solid of any form.
fn mesh(entry: &MeshEntry, mobility: Mobility, folder: &SceneFolder, path: &KeyPath) -> Result<Form, Fault> {
    let surface = read((&entry.file, entry.scale), folder, path)?;
    let mesh = match (SolidMesh::new(surface.clone()), mobility) {
        (Ok(mesh), _) => mesh,
        (Err(_), Mobility::Fixed) => {
            let shape = Shape::triangle_mesh(surface.vertices().to_vec(), surface.triangles().to_vec());
            let shape = shape.map_err(|error| (path.key("file"), error.into()))?;
            return Ok(Form { geometry: shape.into(), matter: Matter::WithoutVolume, approximation: None });
        }
        (Err(error), Mobility::Moves) => return Err(no_solid(&entry.file, error, path)),
    };
    if let Some(entry) = &entry.approximate {
        let (shape, approximation) = approximate::parts(&mesh, entry, &path.key("approximate"))?;
        return Ok(Form { geometry: shape.into(), matter: Matter::Mesh(mesh), approximation: Some(approximation) });
    }
    Ok(Form { geometry: geometry_of(&mesh), matter: Matter::Mesh(mesh), approximation: None })
}

/// A wedge about the z axis.
fn wedge(entry: &WedgeEntry, path: &KeyPath) -> Result<Form, Fault> {
    let inner = positive(entry.inner_radius, &path.key("inner_radius"))?;
    let outer = positive(entry.outer_radius, &path.key("outer_radius"))?;
    let width = positive(entry.width, &path.key("width"))?;
    let key = if outer > inner { "angle" } else { "outer_radius" };
    solid_form(polhode::mesh::wedge(inner, outer, entry.angle, width), &path.key(key))
}

/// A solid with plane faces, of any form.
fn solid_form(made: Result<SolidMesh, PrismError>, path: &KeyPath) -> Result<Form, Fault> {
    let mesh = made.map_err(|error| (path.clone(), error.into()))?;
    Ok(Form { geometry: geometry_of(&mesh), matter: Matter::Mesh(mesh), approximation: None })
}

/// What collides of a solid: a polyhedron where it is convex.
fn geometry_of(mesh: &SolidMesh) -> Geometry {
    let polyhedron = if convexity(mesh).is_convex() { ConvexPolyhedron::from_mesh(mesh).ok() } else { None };
    polyhedron.map_or_else(|| Geometry::Mesh(mesh.clone()), |polyhedron| Shape::convex(polyhedron).into())
}

/// The mesh in a file, in metres: its name, and what its coordinates are multiplied by.
fn read((file, scale): (&str, Option<f64>), folder: &SceneFolder, path: &KeyPath) -> Result<TriangleMesh, Fault> {
    let mesh =
        read_mesh_of(folder.files, &folder.path(file)).map_err(|error| (path.key("file"), Refusal::MeshFile(error)))?;
    let Some(scale) = scale else { return Ok(mesh) };
    let scale = positive(scale, &path.key("scale"))?;
    mesh.scaled(scale).map_err(|error| (path.key("scale"), Refusal::Mesh(error)))
}

/// That the mesh of a file, named at `path`, bounds no solid.
fn no_solid(file: &str, source: MeshError, path: &KeyPath) -> Fault {
    (path.key("file"), Refusal::Solid { file: file.to_owned(), source })
}

/// Parts that are fixed to each other.
fn compound(entry: &CompoundEntry, folder: &SceneFolder, path: &KeyPath) -> Result<Form, Fault> {
    let mut shapes = Vec::with_capacity(entry.parts.len());
    let mut matters = Vec::with_capacity(entry.parts.len());
    for (index, part) in entry.parts.iter().enumerate() {
        let path = path.index(index);
        let (shape, matter) = self::part(part, folder, &path)?;
        shapes.push(shape);
        matters.push(matter);
    }
    let shape = Shape::compound(shapes).map_err(|error| (path.clone(), error.into()))?;
    Ok(Form { geometry: shape.into(), matter: Matter::Parts(matters), approximation: None })
}

fn part(
    entry: &PartEntry,
    folder: &SceneFolder,
    path: &KeyPath,
) -> Result<(Shape, (Matter, polhode::spatial::Pose)), Fault> {
    let pose =
        placement::pose(entry.position.as_ref(), entry.orientation.as_ref(), entry.rotation_vector.as_ref(), path)?;
    let path = path.key("shape");
    let form = build(&entry.shape, Mobility::Moves, folder, &path)?;
    let shape = match form.geometry {
        Geometry::Shape(shape) => Ok(shape),
        Geometry::Mesh(mesh) => Shape::solid(&mesh),
    };
    let shape = shape.and_then(|shape| shape.placed(&pose)).map_err(|error| (path, error.into()))?;
    Ok((shape, (form.matter, pose)))
}
