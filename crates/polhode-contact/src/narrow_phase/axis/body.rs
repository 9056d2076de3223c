//! A convex body in the frame of a search for its separation from another one.

use crate::narrow_phase::feature::element::{Border, Element, Locus};
use crate::narrow_phase::feature::placed::Placed;
use crate::shape::round::{support, support_point};
use crate::{Shape, SurfaceFeature};
use glam::DVec3;
use polhode_spatial::Pose;

/// A convex body in the frame of the search: a shape at a pose, or one point of a cloud.
#[derive(Clone, Copy)]
pub(crate) struct Body<'a> {
    pub(crate) shape: &'a Shape,
    pub(crate) pose: Pose,
    /// The point, when the body is one point (of a cloud: its index there).
    pub(crate) point: Option<(u32, DVec3)>,
}

impl<'a> Body<'a> {
    pub(crate) const fn whole(shape: &'a Shape, pose: Pose) -> Self {
        Self { shape, pose, point: None }
    }

    /// A point of the frame; `shape` is not used.
    pub(crate) const fn at_point(shape: &'a Shape, point: DVec3) -> Self {
        Self { shape, pose: Pose::IDENTITY, point: Some((0, point)) }
    }

    /// Largest coordinate along a unit vector, m.
    pub(crate) fn support(&self, n: DVec3) -> f64 {
        let local = self.pose.rotation.inverse_rotate(n);
        let own = match self.point {
            Some((_, point)) => local.dot(point),
            None => support(self.shape, local),
        };
        own + n.dot(self.pose.translation)
    }

    /// The support point along a direction; the frame's origin for a zero direction and for a body without points.
    pub(crate) fn support_point(&self, n: DVec3) -> DVec3 {
        let local = self.pose.rotation.inverse_rotate(n);
        let own = match self.point {
            Some((_, point)) => point,
            None => support_point(self.shape, local),
        };
        self.pose.transform_point(own)
    }

    pub(crate) fn element(&self, feature: SurfaceFeature) -> Option<Element<'a>> {
        if let Some((_, point)) = self.point {
            return Some(Element::new(Locus::Point(self.pose.transform_point(point)), 0.0, Border::Open));
        }
        Element::of(self.shape, feature, &self.pose)
    }

    pub(crate) fn size(&self) -> f64 {
        if self.point.is_some() { 0.0 } else { self.shape.size() }
    }

    /// Calls `visit` with the faces and discs.
    pub(crate) fn each_plane(&self, mut visit: impl FnMut(SurfaceFeature)) {
        let count = match self.shape {
            _ if self.point.is_some() => 0,
            Shape::Convex(polyhedron) => polyhedron.face_count() as u32,
            Shape::Cylinder(_) => 2,
            Shape::Cone(_) => 1,
            _ => 0,
        };
        (0..count).map(SurfaceFeature::Face).for_each(&mut visit);
    }

    /// Calls `visit` with all other elements.
    pub(crate) fn each_other(&self, mut visit: impl FnMut(SurfaceFeature)) {
        use SurfaceFeature::{Cap, Edge, Rim, Side, Sphere, Vertex};
        let mut list = |features: &[SurfaceFeature]| features.iter().copied().for_each(&mut visit);
        if let Some((index, _)) = self.point {
            return list(&[Vertex(index)]);
        }
        match self.shape {
            Shape::Capsule(_) => list(&[Side(0), Cap(0), Cap(1)]),
            Shape::Cylinder(_) => list(&[Side(0), Rim(0), Rim(1)]),
            Shape::Cone(_) => list(&[Side(0), Rim(0), Vertex(0)]),
            Shape::Sphere(_) => list(&[Sphere]),
            // Only its lowest point above a half-space is needed.
            Shape::Torus(_) => list(&[Rim(0)]),
            Shape::Convex(polyhedron) => {
                (0..polyhedron.edges.len() as u32).map(Edge).for_each(&mut visit);
                (0..polyhedron.vertices.len() as u32).map(Vertex).for_each(&mut visit);
            }
            _ => {}
        }
    }

    /// The element that contains the support point along a unit vector; in a tie the first.
    pub(crate) fn farthest(&self, n: DVec3) -> SurfaceFeature {
        let mut best = (f64::NEG_INFINITY, SurfaceFeature::Vertex(0));
        self.each_other(|feature| {
            let Some(element) = self.element(feature) else { return };
            let height = match element.locus {
                Locus::Point(point) => n.dot(point),
                Locus::Circle(circle) => circle.support(n),
                _ => return,
            } + element.ball;
            if height > best.0 {
                best = (height, feature);
            }
        });
        best.1
    }
}

/// The bodies of a pair in the frame of the polyhedron, or of A when there is none, and that frame's pose in the world.
pub(crate) fn framed<'a>(a: Placed<'a>, b: Placed<'a>) -> (Body<'a>, Body<'a>, Pose) {
    if matches!(b.shape, Shape::Convex(_)) {
        (Body::whole(a.shape, b.pose.relative(a.pose)), Body::whole(b.shape, Pose::IDENTITY), *b.pose)
    } else {
        (Body::whole(a.shape, Pose::IDENTITY), Body::whole(b.shape, a.pose.relative(b.pose)), *a.pose)
    }
}
