//! Support functions: the point of a convex shape that is farthest along a direction.

use super::{Cone, Cylinder, Shape};
use crate::narrow_phase::simplex::unit;
use glam::DVec3;

impl Shape {
    /// The point farthest along a direction, in the shape's frame, m; of equally far ones the first. Nothing for a
    /// half-space, which has none, and for shapes that are not convex.
    pub(crate) fn support(&self, direction: DVec3) -> Option<DVec3> {
        match self {
            Self::Convex(polyhedron) => Some(farthest(&polyhedron.vertices, direction)),
            Self::Sphere(s) => Some(s.center + unit(direction) * s.radius),
            Self::Capsule(c) => Some(farthest(&c.ends, direction) + unit(direction) * c.radius),
            Self::Cylinder(c) => Some(of_cylinder(c, direction)),
            Self::Cone(c) => Some(of_cone(c, direction)),
            Self::HalfSpace(_) | Self::Points(_) | Self::Torus(_) | Self::TriangleMesh(_) | Self::Compound(_) => None,
        }
    }
}

/// The first of the points that are farthest along a direction; the origin when there is none.
pub(crate) fn farthest(points: &[DVec3], direction: DVec3) -> DVec3 {
    let mut best = points.first().copied().unwrap_or_default();
    let mut most = best.dot(direction);
    for &point in points.iter().skip(1) {
        let along = point.dot(direction);
        if along > most {
            most = along;
            best = point;
        }
    }
    best
}

/// Of a cylinder; the middle of a cap that faces the direction exactly.
pub(crate) fn of_cylinder(cylinder: &Cylinder, direction: DVec3) -> DVec3 {
    let along = direction.dot(cylinder.axis);
    let cap = cylinder.axis * if along < 0.0 { -cylinder.half_height } else { cylinder.half_height };
    cylinder.center + cap + unit(across(direction, cylinder.axis)) * cylinder.radius
}

/// Of a cone: its apex or a point of its rim.
pub(crate) fn of_cone(cone: &Cone, direction: DVec3) -> DVec3 {
    let radial = unit(across(direction, cone.axis));
    if direction.dot(cone.axis) * cone.height >= direction.dot(radial) * cone.radius {
        cone.apex()
    } else {
        cone.base + radial * cone.radius
    }
}

/// Of a circle about an axis.
pub(crate) fn of_circle(center: DVec3, axis: DVec3, radius: f64, direction: DVec3) -> DVec3 {
    let radial = unit(across(direction, axis));
    center + if radial == DVec3::ZERO { axis.any_orthonormal_vector() } else { radial } * radius
}

/// The part of a vector perpendicular to a unit vector; twice, because the first difference may be all rounding.
pub(crate) fn across(vector: DVec3, axis: DVec3) -> DVec3 {
    let once = vector - axis * vector.dot(axis);
    once - axis * once.dot(axis)
}
