//! Constructors of shapes, and shapes moved within a body.

use super::error::{ShapeError, check_finite, check_length};
use super::{Capsule, Compound, Cone, Cylinder, HalfSpace, PointCloud, Shape, Sphere, Torus, TriangleMesh};
use crate::ConvexPolyhedron;
use glam::DVec3;
use polhode_spatial::{Pose, UnitVector};

/// Height of a cone's centre of mass above its base, in units of its height.
const CONE_CENTER: f64 = 0.25;

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

    /// A ball of this radius (m) about the origin.
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

    /// Points with these positions, m.
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

    /// A torus about the z axis, its centre at the origin, m.
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

    /// The same shape rotated about its frame's origin and then translated, for example to its pose within a compound.
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

    /// The same shape translated by a vector, m: moves a shape from the frame of its file into the central frame.
    ///
    /// # Errors
    /// When a coordinate becomes too large or is not finite.
    pub fn translated(&self, by: DVec3) -> Result<Self, ShapeError> {
        self.placed(&Pose::from_translation(by))
    }
}
