//! Extents of shapes: size, radius, the balls whose convex hull contains a shape, bounding box.

use super::Shape;
use crate::bounding::aabb::Aabb;
use glam::DVec3;
use polhode_spatial::Pose;

impl Shape {
    /// Largest distance between two points of the shape, m; 0 for a half-space, which has no finite size.
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
            Self::Compound(c) => c.radius,
            Self::TriangleMesh(m) => m.radius(),
            _ => {
                let (centers, ball) = self.centers();
                centers.iter().map(|c| c.length()).fold(0.0, f64::max) + ball
            }
        }
    }

    /// The shape as the convex hull of points plus a ball of a radius, m; no points for a half-space and for shapes
    /// with circles.
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

    /// Calls `visit` with balls (centre and radius, m) whose convex hull contains the shape; none for a half-space.
    pub(crate) fn for_each_ball(&self, visit: &mut dyn FnMut(DVec3, f64)) {
        match self {
            Self::HalfSpace(_) => {}
            Self::Cylinder(c) => {
                let half = c.axis * c.half_height;
                visit(c.center - half, c.radius);
                visit(c.center + half, c.radius);
            }
            Self::Cone(c) => {
                visit(c.base, c.radius);
                visit(c.apex(), 0.0);
            }
            Self::Torus(t) => visit(t.center, t.major + t.minor),
            Self::Compound(c) => c.parts.iter().for_each(|part| part.for_each_ball(visit)),
            _ => {
                let (centers, radius) = self.centers();
                for &center in centers {
                    visit(center, radius);
                }
            }
        }
    }

    /// A box around the shape at a pose, m; empty for a half-space.
    pub(crate) fn bounds_at(&self, pose: &Pose) -> Aabb {
        match self {
            Self::TriangleMesh(m) => turned(m.bounds(), pose),
            Self::Compound(c) => turned(c.tree.bounds(), pose),
            _ => {
                let mut bounds = Aabb::EMPTY;
                self.for_each_ball(&mut |center, radius| {
                    let place = pose.transform_point(center);
                    bounds = bounds.merged(&Aabb { min: place - radius, max: place + radius });
                });
                bounds
            }
        }
    }
}

/// The axis-aligned box around a box at a pose.
pub(crate) fn turned(bounds: Aabb, pose: &Pose) -> Aabb {
    let rotation = pose.rotation.to_matrix();
    let half = 0.5 * (bounds.max - bounds.min);
    let center = pose.transform_point(bounds.min + half);
    let half_turned = rotation.x_axis.abs() * half.x + rotation.y_axis.abs() * half.y + rotation.z_axis.abs() * half.z;
    Aabb { min: center - half_turned, max: center + half_turned }
}
