//! Pieces, between which distances are computed: Minkowski sums of a core (a convex set or a circle) and a ball.
//!
//! A sphere is a point with a radius, a capsule a segment with one, a torus a circle with one. Pieces are solid; the
//! elements of the narrow phase (`narrow_phase/feature/element.rs`) are features of their surfaces, and queries name
//! the same features.

use super::feature::QueryFeature;
use crate::bounding::aabb::Aabb;
use crate::shape::polyhedron::ConvexPolyhedron;
use crate::shape::support::farthest;
use crate::shape::topology::flat_triangle;
use crate::shape::triangle::area_vector;
use crate::{Cone, Cylinder, HalfSpace, SurfaceFeature, Torus};
use glam::DVec3;
use polhode_spatial::Pose;
use std::borrow::Cow;

/// A core in its shape's frame.
#[derive(Debug, Clone, Copy)]
pub(crate) enum Core<'a> {
    Point(DVec3),
    Segment([DVec3; 2]),
    Triangle([DVec3; 3]),
    Polyhedron(&'a ConvexPolyhedron),
    Cylinder(&'a Cylinder),
    Cone(&'a Cone),
    Circle(&'a Torus),
    HalfSpace(&'a HalfSpace),
}

/// A core, its radius (m), its number within the shape, and a bounding ball of the core (centre in the common frame and
/// radius, m).
#[derive(Debug, Clone, Copy)]
pub(crate) struct Piece<'a> {
    pub(crate) core: Core<'a>,
    pub(crate) radius: f64,
    pub(crate) part: u32,
    /// From the core's frame to the common frame of a query.
    pub(crate) pose: Pose,
    pub(crate) ball: (DVec3, f64),
}

impl<'a> Piece<'a> {
    pub(crate) fn new(core: Core<'a>, radius: f64, part: u32, pose: Pose) -> Self {
        let (center, around) = core.ball();
        let ball = (pose.transform_point(center), around);
        Self { core, radius, part, pose, ball }
    }

    /// The support point of the core along a direction of the common frame.
    pub(crate) fn support(&self, direction: DVec3) -> DVec3 {
        let local = self.pose.rotation.inverse_rotate(direction);
        self.pose.transform_point(self.core.support(local))
    }

    /// A box around the piece in a frame, m.
    pub(crate) fn bounds_in(&self, frame: &Pose) -> Aabb {
        let center = frame.inverse_transform_point(self.ball.0);
        Aabb::of_point(center).widened(self.ball.1 + self.radius)
    }

    /// Lower bound of the distance from another piece, m.
    pub(crate) fn bound(&self, other: &Self) -> f64 {
        let radii = self.ball.1 + self.radius + other.ball.1 + other.radius;
        (self.ball.0 - other.ball.0).length() - radii
    }

    /// Whether it is a point of a cloud.
    pub(crate) fn is_vertex(&self) -> bool {
        self.radius == 0.0 && matches!(self.core, Core::Point(_))
    }

    /// The feature of the shape for a feature of the core.
    pub(crate) fn feature(&self, feature: SurfaceFeature) -> QueryFeature {
        let surface = if self.is_vertex() { SurfaceFeature::Vertex(self.part) } else { feature };
        QueryFeature { part: self.part, surface }
    }
}

impl Core<'_> {
    /// The support point along a direction; for a half-space, which has none, the plane's point nearest to the origin.
    pub(crate) fn support(&self, direction: DVec3) -> DVec3 {
        match self {
            Self::Point(p) => *p,
            Self::Segment(ends) => farthest(ends, direction),
            Self::Triangle(corners) => farthest(corners, direction),
            Self::Polyhedron(p) => farthest(&p.vertices, direction),
            Self::Cylinder(c) => farthest(&c.rims().map(|rim| rim.farthest(direction)), direction),
            Self::Cone(c) => farthest(&[c.apex(), c.rim().farthest(direction)], direction),
            Self::Circle(t) => {
                let ring = t.ring();
                let place = ring.farthest(direction);
                if place == ring.center { ring.nearest(place) } else { place }
            }
            Self::HalfSpace(h) => h.normal * h.offset,
        }
    }

    /// The vertices of a polytope; none of other cores.
    pub(crate) fn vertices(&self) -> &[DVec3] {
        match self {
            Self::Point(p) => std::slice::from_ref(p),
            Self::Segment(ends) => ends,
            Self::Triangle(corners) => corners,
            Self::Polyhedron(p) => &p.vertices,
            Self::Cylinder(_) | Self::Cone(_) | Self::Circle(_) | Self::HalfSpace(_) => &[],
        }
    }

    /// The polyhedron, or a triangle as a polyhedron without thickness.
    pub(crate) fn polyhedron(&self) -> Option<Cow<'_, ConvexPolyhedron>> {
        match self {
            Self::Polyhedron(polyhedron) => Some(Cow::Borrowed(polyhedron)),
            Self::Triangle(corners) => {
                let normal = area_vector(*corners).try_normalize()?;
                Some(Cow::Owned(flat_triangle(*corners, normal)))
            }
            _ => None,
        }
    }

    pub(crate) fn is_polytope(&self) -> bool {
        !self.vertices().is_empty()
    }

    /// A ball that contains the core.
    fn ball(&self) -> (DVec3, f64) {
        match self {
            Self::Cylinder(c) => (c.center, libm::hypot(c.radius, c.half_height)),
            Self::Cone(c) => (c.base, c.radius.max(c.height)),
            Self::Circle(t) => (t.center, t.major),
            Self::HalfSpace(_) => (DVec3::ZERO, f64::INFINITY),
            _ => {
                let around = Aabb::of_points(self.vertices().iter().copied());
                let center = around.middle();
                (center, self.vertices().iter().map(|p| p.distance(center)).fold(0.0, f64::max))
            }
        }
    }
}
