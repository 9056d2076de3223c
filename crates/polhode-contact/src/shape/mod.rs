//! Shapes that can touch.
//!
//! A shape stands in a frame of its body; the engine uses the central frame, origin at the centre of mass, into which
//! [`Shape::translated`] brings it. Values are checked when a shape is made ("parse, don't validate"), so that the
//! algorithms meet only finite shapes that are what their kind says: convex polyhedra are closed and convex, triangles have
//! an area, tubes leave a hole.

pub mod approximate_decomposition;
mod capsule;
pub(crate) mod circle;
mod compound;
mod cone;
mod cylinder;
mod error;
pub(crate) mod extent;
mod half_space;
pub(crate) mod hull;
pub mod mirror;
pub(crate) mod nearer_place;
mod point_cloud;
pub mod polyhedron;
pub mod round;
mod solid;
mod sphere;
pub(crate) mod support;
pub(crate) mod topology;
mod torus;
pub(crate) mod triangle;
pub(crate) mod triangle_mesh;

pub use capsule::Capsule;
pub use compound::Compound;
pub use cone::Cone;
pub use cylinder::Cylinder;
pub use error::{LARGEST_LENGTH, SMALLEST_LENGTH, ShapeError};
pub use half_space::HalfSpace;
pub use point_cloud::PointCloud;
pub use sphere::Sphere;
pub use torus::Torus;
pub use triangle_mesh::TriangleMesh;

pub(crate) use compound::FirstElements;
pub(crate) use error::{check_length, check_point};
pub(crate) use point_cloud::largest_distance;

use crate::ConvexPolyhedron;
use error::check_finite;
use glam::DVec3;
use polhode_spatial::{Pose, UnitVector};

/// Height of a cone's centre of mass above its base, in units of its height.
const CONE_CENTER: f64 = 0.25;

/// A shape in its body's frame. Kinds will be added; match with a wildcard.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
#[allow(clippy::large_enum_variant, reason = "polyhedra are the common case, and a box would cost every query a jump")]
pub enum Shape {
    /// A convex polyhedron; a box is one.
    Convex(ConvexPolyhedron),
    /// A ball.
    Sphere(Sphere),
    /// A plane with everything below it.
    HalfSpace(HalfSpace),
    /// Points.
    Points(PointCloud),
    /// A cylinder with half-balls on its ends.
    Capsule(Capsule),
    /// A cylinder.
    Cylinder(Cylinder),
    /// A cone.
    Cone(Cone),
    /// A ring.
    Torus(Torus),
    /// A surface that does not move.
    TriangleMesh(TriangleMesh),
    /// Several parts.
    Compound(Compound),
}

impl Shape {
    /// A box about the origin with full edge lengths, m.
    ///
    /// # Errors
    /// When a length is not positive and finite.
    pub fn cuboid(size: DVec3) -> Result<Self, ShapeError> {
        ConvexPolyhedron::cuboid(size).map(Self::Convex)
    }

    /// A convex polyhedron.
    pub const fn convex(polyhedron: ConvexPolyhedron) -> Self {
        Self::Convex(polyhedron)
    }

    /// A ball about the origin, m.
    ///
    /// # Errors
    /// When the radius is not positive and finite.
    pub fn sphere(radius: f64) -> Result<Self, ShapeError> {
        Sphere::new(DVec3::ZERO, radius).map(Self::Sphere)
    }

    /// Everything below the plane through the origin with this outward normal.
    pub const fn half_space(normal: UnitVector) -> Self {
        Self::HalfSpace(HalfSpace { normal: normal.get(), offset: 0.0 })
    }

    /// Points at these places, m.
    ///
    /// # Errors
    /// When there are none or a coordinate is not finite.
    pub fn points(points: Vec<DVec3>) -> Result<Self, ShapeError> {
        PointCloud::new(points).map(Self::Points)
    }

    /// A capsule about the z axis, its centre at the origin; `height` is without the caps, m.
    ///
    /// # Errors
    /// When a length is not positive and finite.
    pub fn capsule(radius: f64, height: f64) -> Result<Self, ShapeError> {
        Capsule::new([DVec3::Z * (-0.5 * height), DVec3::Z * (0.5 * height)], radius).map(Self::Capsule)
    }

    /// A cylinder about the z axis, its centre at the origin, m.
    ///
    /// # Errors
    /// When a length is not positive and finite.
    pub fn cylinder(radius: f64, height: f64) -> Result<Self, ShapeError> {
        Cylinder::new(DVec3::ZERO, UnitVector::Z, radius, height).map(Self::Cylinder)
    }

    /// A cone about the z axis, its apex towards +z, its centre of mass (a quarter of its height above the base) at the
    /// origin, m.
    ///
    /// # Errors
    /// When a length is not positive and finite.
    pub fn cone(radius: f64, height: f64) -> Result<Self, ShapeError> {
        check_length("height", height)?;
        Cone::new(DVec3::Z * (-CONE_CENTER * height), UnitVector::Z, radius, height).map(Self::Cone)
    }

    /// A ring about the z axis, its centre at the origin, m.
    ///
    /// # Errors
    /// When a length is not positive and finite, or the tube closes the hole.
    pub fn torus(major: f64, minor: f64) -> Result<Self, ShapeError> {
        Torus::new(DVec3::ZERO, UnitVector::Z, major, minor).map(Self::Torus)
    }

    /// A surface of triangles, anticlockwise seen from outside, m.
    ///
    /// # Errors
    /// When there is no triangle, one names a vertex that does not exist, or a coordinate is not finite.
    pub fn triangle_mesh(vertices: Vec<DVec3>, triangles: Vec<[u32; 3]>) -> Result<Self, ShapeError> {
        TriangleMesh::new(vertices, triangles).map(Self::TriangleMesh)
    }

    /// Several parts, each in the body's frame.
    ///
    /// # Errors
    /// When there is no part, or one cannot be a part.
    pub fn compound(parts: Vec<Self>) -> Result<Self, ShapeError> {
        Compound::new(parts).map(Self::Compound)
    }

    /// The same shape turned about its frame's origin and then moved: a shape in its place within a body.
    ///
    /// # Errors
    /// When a coordinate becomes too large or is not finite.
    pub fn placed(&self, pose: &Pose) -> Result<Self, ShapeError> {
        match self {
            Self::Convex(polyhedron) => {
                polyhedron.rotated(pose.rotation).translated(pose.translation).map(Self::Convex)
            }
            Self::Sphere(s) => Sphere::new(pose.transform_point(s.center), s.radius).map(Self::Sphere),
            Self::HalfSpace(h) => {
                let normal = pose.rotation.rotate(h.normal);
                let offset = h.offset + normal.dot(pose.translation);
                check_finite("offset", offset)?;
                Ok(Self::HalfSpace(HalfSpace { normal, offset }))
            }
            Self::Points(c) => Self::points(c.points.iter().map(|&p| pose.transform_point(p)).collect()),
            Self::Capsule(c) => c.placed(pose).map(Self::Capsule),
            Self::Cylinder(c) => c.placed(pose).map(Self::Cylinder),
            Self::Cone(c) => c.placed(pose).map(Self::Cone),
            Self::Torus(t) => t.placed(pose).map(Self::Torus),
            Self::TriangleMesh(m) => m.placed(pose).map(Self::TriangleMesh),
            Self::Compound(c) => c.placed(pose).map(Self::Compound),
        }
    }

    /// The same shape moved by a vector, m: brings a shape given about a body's origin into the central frame.
    ///
    /// # Errors
    /// When a coordinate becomes too large or is not finite.
    pub fn translated(&self, by: DVec3) -> Result<Self, ShapeError> {
        self.placed(&Pose::from_translation(by))
    }

    /// Largest distance between two points of the shape, m; 0 for a half-space, whose extent says nothing.
    pub fn size(&self) -> f64 {
        match self {
            Self::Convex(polyhedron) => polyhedron.size(),
            Self::Sphere(s) => 2.0 * s.radius,
            Self::HalfSpace(_) => 0.0,
            Self::Points(c) => c.size(),
            Self::Capsule(c) => c.size(),
            Self::Cylinder(c) => c.size(),
            Self::Cone(c) => c.size(),
            Self::Torus(t) => t.size(),
            Self::TriangleMesh(m) => m.size(),
            Self::Compound(c) => c.size(),
        }
    }

    /// Largest distance of a point of the shape from the frame's origin, m; infinite for a half-space.
    pub fn radius(&self) -> f64 {
        match self {
            Self::HalfSpace(_) => f64::INFINITY,
            Self::Cylinder(c) => c.center.length() + 0.5 * c.size(),
            Self::Cone(c) => (c.base.length() + c.radius).max(c.apex().length()),
            Self::Torus(t) => t.center.length() + 0.5 * t.size(),
            Self::Compound(c) => c.parts.iter().map(Self::radius).fold(0.0, f64::max),
            Self::TriangleMesh(m) => m.reach(),
            _ => {
                let (centers, rounding) = self.centers();
                centers.iter().map(|c| c.length()).fold(0.0, f64::max) + rounding
            }
        }
    }

    /// The shape as the convex hull of points, blown up by a radius, m; no points for a half-space and where circles are
    /// needed too.
    pub(crate) fn centers(&self) -> (&[DVec3], f64) {
        match self {
            Self::Convex(polyhedron) => (polyhedron.vertices(), 0.0),
            Self::Sphere(s) => (std::slice::from_ref(&s.center), s.radius),
            Self::Points(c) => (&c.points, 0.0),
            Self::Capsule(c) => (&c.ends, c.radius),
            Self::TriangleMesh(m) => (&m.vertices, 0.0),
            Self::HalfSpace(_) | Self::Cylinder(_) | Self::Cone(_) | Self::Torus(_) | Self::Compound(_) => (&[], 0.0),
        }
    }
}
