//! How far a shape reaches along a direction: what every bounding volume is made from.

use crate::Shape;
use glam::{DMat3, DVec3};

/// Largest `d . x` over the points of the shape, m, for a unit vector d in the shape's frame; infinite for a half-space
/// but along its normal. For polyhedra and points this is a maximum over vertices; a circle of radius r about the axis
/// a reaches `r |d x a|`.
pub(crate) fn extent(shape: &Shape, direction: DVec3) -> f64 {
    let across = |axis: DVec3| direction.cross(axis).length();
    match shape {
        Shape::Cylinder(c) => {
            direction.dot(c.center) + c.radius * across(c.axis) + c.half_height * direction.dot(c.axis).abs()
        }
        Shape::Cone(c) => (direction.dot(c.base) + c.radius * across(c.axis)).max(direction.dot(c.apex())),
        Shape::Torus(t) => direction.dot(t.center) + t.major * across(t.axis) + t.minor,
        Shape::HalfSpace(h) if direction == h.normal => h.offset,
        Shape::HalfSpace(_) => f64::INFINITY,
        Shape::Compound(c) => c.parts.iter().map(|part| extent(part, direction)).fold(f64::NEG_INFINITY, f64::max),
        Shape::TriangleMesh(mesh) => mesh.places().map(|place| direction.dot(place)).fold(f64::NEG_INFINITY, f64::max),
        Shape::Convex(_) | Shape::Sphere(_) | Shape::Points(_) | Shape::Capsule(_) => {
            let (centers, rounding) = shape.centers();
            centers.iter().map(|&center| direction.dot(center)).fold(f64::NEG_INFINITY, f64::max) + rounding
        }
    }
}

/// Least and largest `d . x` over the points of the shape for three directions d, the columns of `axes`: of each direction
/// what [`extent`] gives for `-d`, turned round, and for `d`. Vertices are gone through once for all three.
pub(crate) fn extents(shape: &Shape, axes: &DMat3) -> (DVec3, DVec3) {
    if let Shape::TriangleMesh(mesh) = shape {
        return spread(mesh.places(), axes);
    }
    let (centers, rounding) = shape.centers();
    if centers.is_empty() {
        let reach =
            |sign: f64| DVec3::from_array(axes.to_cols_array_2d().map(|d| extent(shape, sign * DVec3::from(d))));
        return (-reach(-1.0), reach(1.0));
    }
    let (low, high) = spread(centers.iter().copied(), axes);
    (low - rounding, high + rounding)
}

/// The same of points.
fn spread(points: impl Iterator<Item = DVec3>, axes: &DMat3) -> (DVec3, DVec3) {
    let across = axes.transpose();
    points
        .map(|point| across * point)
        .fold((DVec3::INFINITY, DVec3::NEG_INFINITY), |(low, high), heights| (low.min(heights), high.max(heights)))
}
