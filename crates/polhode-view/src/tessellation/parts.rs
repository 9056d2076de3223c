//! The parts of any shape.

use super::detail::Detail;
use super::part::Part;
use super::{points, polyhedron, round, triangles};
use crate::mesh_library::{MeshKey, MeshLibrary};
use crate::surface_mesh::SurfaceMesh;
use polhode::Geometry;
use polhode::contact::{ConvexPolyhedron, HalfSpace, Shape};
use polhode::spatial::{DQuat, DVec3, MassProperties, Rotation};

/// Height above which an axis counts as pointing down exactly: below it a rotation from z is well conditioned.
const DOWNWARD: f64 = -1.0 + 1e-9;

/// What a body is drawn as.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Parts {
    /// Meshes in their places.
    pub parts: Vec<Part>,
    /// Half-spaces, which have no mesh: their plane is drawn as a grid.
    pub half_spaces: Vec<HalfSpace>,
    /// Points of point sets. Their balls are a part too; in pictures that part may be too small to be seen.
    pub points: Vec<ShownPoint>,
}

/// A point of a point set.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ShownPoint {
    /// Where, in the body's frame, m.
    pub place: DVec3,
    /// Radius of the ball that is drawn about it, m.
    pub radius_m: f64,
}

/// The parts of a shape.
pub fn parts_of(geometry: &Geometry, detail: Detail, library: &mut MeshLibrary) -> Parts {
    let mut builder = Builder { parts: Parts::default(), detail, library };
    match geometry {
        Geometry::Shape(shape) => builder.add_shape(shape),
        Geometry::Mesh(mesh) => builder.add_surface(mesh.mesh().vertices(), mesh.mesh().triangles()),
    }
    builder.parts
}

/// For a body without a shape: the uniform solid ellipsoid that has its mass and inertia. Its semi-axes are
/// `a_i^2 = 5 (I_j + I_k - I_i) / (2 m)`.
pub fn equivalent_ellipsoid(mass: &MassProperties, detail: Detail, library: &mut MeshLibrary) -> Parts {
    let (axes, m) = (mass.principal_axes(), mass.mass());
    let moments = axes.moments();
    let square = 2.5 * (DVec3::splat(moments.element_sum()) - 2.0 * moments) / m;
    let semi_axes = square.max(DVec3::ZERO).map(f64::sqrt);
    // A rod or a point mass has no thickness: what is drawn has a little.
    let longest = semi_axes.max_element();
    let longest = if longest > 0.0 { longest } else { LEAST_SIZE_M };
    let scale = semi_axes.max(DVec3::splat(LEAST_THICKNESS * longest));
    let mut builder = Builder { parts: Parts::default(), detail, library };
    builder.add_sphere(mass.center_of_mass(), axes.rotation(), scale);
    builder.parts
}

/// Thickness of what is drawn of a body without any, as a fraction of its length.
const LEAST_THICKNESS: f64 = 0.02;
/// Radius of what is drawn of a point mass, m.
const LEAST_SIZE_M: f64 = 0.05;

/// A rod between two places, m.
pub fn rod([a, b]: [DVec3; 2], radius_m: f64, detail: Detail, library: &mut MeshLibrary) -> Part {
    let mesh = library.number_of(MeshKey::new("cylinder", []), || round::unit_cylinder(detail));
    let scale = DVec3::new(radius_m, radius_m, a.distance(b));
    Part { mesh, position: 0.5 * (a + b), orientation: from_z(b - a), scale }
}

/// A ball at a place, m.
pub fn ball(place: DVec3, radius_m: f64, detail: Detail, library: &mut MeshLibrary) -> Part {
    let mesh = library.number_of(MeshKey::new("sphere", []), || round::unit_sphere(detail));
    Part { position: place, scale: DVec3::splat(radius_m), ..Part::of(mesh) }
}

struct Builder<'a> {
    parts: Parts,
    detail: Detail,
    library: &'a mut MeshLibrary,
}

impl Builder<'_> {
    fn add(&mut self, mesh: usize, position: DVec3, orientation: Rotation, scale: DVec3) {
        self.parts.parts.push(Part { mesh, position, orientation, scale });
    }

    fn add_sphere(&mut self, center: DVec3, orientation: Rotation, scale: DVec3) {
        let detail = self.detail;
        let mesh = self.library.number_of(MeshKey::new("sphere", []), || round::unit_sphere(detail));
        self.add(mesh, center, orientation, scale);
    }

    fn add_shape(&mut self, shape: &Shape) {
        let detail = self.detail;
        match shape {
            Shape::Sphere(sphere) => {
                self.add_sphere(sphere.center(), Rotation::IDENTITY, DVec3::splat(sphere.radius()));
            }
            Shape::HalfSpace(half_space) => self.parts.half_spaces.push(half_space.clone()),
            Shape::Points(cloud) => {
                let radius_m = points::radius(cloud.points());
                self.parts.points.extend(cloud.points().iter().map(|&place| ShownPoint { place, radius_m }));
                let key = MeshKey::new("points", coordinates(cloud.points()));
                let mesh = self.library.number_of(key, || points::surface(cloud.points()));
                self.add(mesh, DVec3::ZERO, Rotation::IDENTITY, DVec3::ONE);
            }
            Shape::Capsule(capsule) => {
                let ([a, b], radius) = (capsule.ends(), capsule.radius());
                let half = 0.5 * a.distance(b) / radius;
                let key = MeshKey::new("capsule", [half]);
                let mesh = self.library.number_of(key, || round::capsule(half, detail));
                self.add(mesh, 0.5 * (a + b), from_z(b - a), DVec3::splat(radius));
            }
            Shape::Cylinder(cylinder) => {
                let mesh = self.library.number_of(MeshKey::new("cylinder", []), || round::unit_cylinder(detail));
                let scale = DVec3::new(cylinder.radius(), cylinder.radius(), cylinder.height());
                self.add(mesh, cylinder.center(), from_z(cylinder.axis()), scale);
            }
            Shape::Cone(cone) => {
                let mesh = self.library.number_of(MeshKey::new("cone", []), || round::unit_cone(detail));
                let scale = DVec3::new(cone.radius(), cone.radius(), cone.height());
                self.add(mesh, cone.base(), from_z(cone.axis()), scale);
            }
            Shape::Torus(torus) => {
                let minor = torus.minor() / torus.major();
                let mesh = self.library.number_of(MeshKey::new("torus", [minor]), || round::torus(minor, detail));
                self.add(mesh, torus.center(), from_z(torus.axis()), DVec3::splat(torus.major()));
            }
            Shape::Convex(polyhedron) => self.add_polyhedron(polyhedron),
            Shape::TriangleMesh(mesh) => self.add_surface(mesh.vertices(), mesh.triangles()),
            Shape::Compound(compound) => compound.parts().iter().for_each(|part| self.add_shape(part)),
            // Kinds to come are bodies all the same; nothing is drawn of them.
            _ => {}
        }
    }

    fn add_polyhedron(&mut self, polyhedron: &ConvexPolyhedron) {
        if let Some([low, high]) = box_of(polyhedron) {
            let unit = || ConvexPolyhedron::cuboid(DVec3::ONE).map_or_else(|_| SurfaceMesh::default(), surface_of);
            let mesh = self.library.number_of(MeshKey::new("box", []), unit);
            self.add(mesh, 0.5 * (low + high), Rotation::IDENTITY, high - low);
            return;
        }
        let key = MeshKey::new("polyhedron", coordinates(polyhedron.vertices()));
        let mesh = self.library.number_of(key, || polyhedron::surface(polyhedron));
        self.add(mesh, DVec3::ZERO, Rotation::IDENTITY, DVec3::ONE);
    }

    fn add_surface(&mut self, vertices: &[DVec3], corners: &[[u32; 3]]) {
        let numbers = coordinates(vertices).chain(corners.iter().flatten().map(|&corner| f64::from(corner)));
        let mesh = self.library.number_of(MeshKey::new("surface", numbers), || triangles::surface(vertices, corners));
        self.add(mesh, DVec3::ZERO, Rotation::IDENTITY, DVec3::ONE);
    }
}

#[allow(clippy::needless_pass_by_value, reason = "what is made on the way is used up")]
fn surface_of(polyhedron: ConvexPolyhedron) -> SurfaceMesh {
    polyhedron::surface(&polyhedron)
}

fn coordinates(points: &[DVec3]) -> impl Iterator<Item = f64> + '_ {
    points.iter().flat_map(DVec3::to_array)
}

/// Smallest and largest coordinates of a polyhedron that is a box along the axes; none of any other.
fn box_of(polyhedron: &ConvexPolyhedron) -> Option<[DVec3; 2]> {
    let vertices = polyhedron.vertices();
    if vertices.len() != 8 || polyhedron.face_count() != 6 {
        return None;
    }
    let [low, high] = vertices.iter().fold([vertices[0]; 2], |[low, high], &p| [low.min(p), high.max(p)]);
    let at_corner = |p: &DVec3| (p.cmpeq(low) | p.cmpeq(high)).all();
    vertices.iter().all(at_corner).then_some([low, high])
}

/// The shortest rotation of z into a direction.
fn from_z(direction: DVec3) -> Rotation {
    let Some(axis) = direction.try_normalize() else { return Rotation::IDENTITY };
    if axis.z < DOWNWARD {
        return Rotation::renormalized(DQuat::from_xyzw(1.0, 0.0, 0.0, 0.0));
    }
    let cross = DVec3::Z.cross(axis);
    Rotation::renormalized(DQuat::from_xyzw(cross.x, cross.y, cross.z, 1.0 + axis.z))
}
