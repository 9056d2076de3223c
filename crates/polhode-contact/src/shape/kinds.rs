//! The kinds of shapes.
//!
//! A compound is a shape whose parts are shapes, so both types are defined here; their functions are in files of their
//! own.

use super::capsule::Capsule;
use super::cone::Cone;
use super::cylinder::Cylinder;
use super::half_space::HalfSpace;
use super::point_cloud::PointCloud;
use super::polyhedron::ConvexPolyhedron;
use super::sphere::Sphere;
use super::torus::Torus;
use super::triangle_mesh::TriangleMesh;
use crate::bounding::BoxTree;

/// A shape in its body's frame. Kinds will be added; match with a wildcard.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
#[allow(
    clippy::large_enum_variant,
    reason = "polyhedra are the common case, and a `Box` would cost every query an indirection"
)]
pub enum Shape {
    /// A convex polyhedron; a box is one.
    Convex(ConvexPolyhedron),
    /// A ball.
    Sphere(Sphere),
    /// All points below a plane.
    HalfSpace(HalfSpace),
    /// Points that are fixed to each other.
    Points(PointCloud),
    /// A cylinder with a hemisphere at each end.
    Capsule(Capsule),
    /// A cylinder.
    Cylinder(Cylinder),
    /// A cone.
    Cone(Cone),
    /// A torus.
    Torus(Torus),
    /// A surface of triangles, of a body that does not move.
    TriangleMesh(TriangleMesh),
    /// Several shapes that are fixed to each other.
    Compound(Compound),
}

impl Shape {
    #[inline]
    pub(crate) const fn is_half_space(&self) -> bool {
        matches!(self, Self::HalfSpace(_))
    }

    /// Whether it is a torus.
    #[inline]
    pub(crate) const fn is_ring(&self) -> bool {
        matches!(self, Self::Torus(_))
    }

    /// The parts of a compound; any other shape is its own only part.
    pub(crate) fn parts(&self) -> &[Self] {
        match self {
            Self::Compound(compound) => compound.parts(),
            other => std::slice::from_ref(other),
        }
    }
}

/// Parts that are fixed to each other and may touch or overlap. Their vertices (centres, points), edges and faces are
/// numbered one part after the other, so that the number of a feature also identifies its part.
#[derive(Debug, Clone, PartialEq)]
pub struct Compound {
    pub(crate) parts: Vec<Shape>,
    /// First numbers of every part, and one past the last.
    pub(crate) first: Vec<FirstElements>,
    pub(crate) tree: BoxTree,
    pub(super) size: f64,
    /// Largest distance of a point of a part from the frame's origin, m.
    pub(super) radius: f64,
    /// Size of the smallest part that has one, m; infinite when none has.
    pub(crate) least_part_size: f64,
}

/// Numbers of the first vertex (or centre), edge and face of a part among all of the compound.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub(crate) struct FirstElements {
    pub(crate) vertex: u32,
    pub(crate) edge: u32,
    pub(crate) face: u32,
}
