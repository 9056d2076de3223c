//! Shapes as the elements they consist of.

use super::element::{Core, Element};
use crate::Shape;
use glam::DVec3;
use polhode_spatial::Pose;

/// The elements of a shape whose frame stands at a pose; triangles and points are numbered as in the shape, the elements
/// of a compound by their part.
pub(crate) fn elements<'a>(shape: &'a Shape, pose: &Pose) -> Vec<Element<'a>> {
    let one = |core, radius| vec![Element::new(core, radius, 0, *pose)];
    match shape {
        Shape::Convex(p) => one(Core::Polyhedron(p), 0.0),
        Shape::Sphere(s) => one(Core::Point(s.center), s.radius),
        Shape::HalfSpace(h) => one(Core::HalfSpace(h), 0.0),
        Shape::Capsule(c) => one(Core::Segment(c.ends), c.radius),
        Shape::Cylinder(c) => one(Core::Cylinder(c), 0.0),
        Shape::Cone(c) => one(Core::Cone(c), 0.0),
        Shape::Torus(t) => one(Core::Circle(t), t.minor),
        Shape::Points(cloud) => cloud.points.iter().enumerate().map(|(i, &p)| cloud_point(p, i, pose)).collect(),
        Shape::TriangleMesh(mesh) => (0..mesh.triangles.len())
            .map(|i| Element::new(Core::Triangle(corners(mesh.vertices(), mesh.triangles[i])), 0.0, i as u32, *pose))
            .collect(),
        Shape::Compound(compound) => {
            let parts = compound.parts().iter().enumerate();
            let inner = parts.flat_map(|(i, part)| {
                elements(part, pose).into_iter().map(move |element| Element { part: i as u32, ..element })
            });
            inner.collect()
        }
    }
}

fn cloud_point(point: DVec3, index: usize, pose: &Pose) -> Element<'static> {
    Element { point_is_vertex: true, ..Element::new(Core::Point(point), 0.0, index as u32, *pose) }
}

/// Corners of a triangle; a mesh names only vertices that exist.
pub(crate) fn corners(vertices: &[DVec3], triangle: [u32; 3]) -> [DVec3; 3] {
    triangle.map(|v| vertices.get(v as usize).copied().unwrap_or_default())
}

/// Bounds of a shape along the world's axes, m, with the rounding of the pose; unbounded for a half-space.
pub(crate) fn bounds(shape: &Shape, pose: &Pose) -> (DVec3, DVec3) {
    if let Shape::HalfSpace(_) = shape {
        return (DVec3::NEG_INFINITY, DVec3::INFINITY);
    }
    let (mut low, mut high) = (DVec3::INFINITY, DVec3::NEG_INFINITY);
    let axes = [DVec3::X, DVec3::Y, DVec3::Z];
    let whole = |direction: DVec3| {
        let farthest = shape.support(pose.rotation.inverse_rotate(direction))?;
        Some(pose.transform_point(farthest))
    };
    if axes.iter().all(|&direction| whole(direction).is_some()) {
        for (axis, direction) in axes.into_iter().enumerate() {
            high[axis] = whole(direction).map_or(f64::INFINITY, |place| place[axis]);
            low[axis] = whole(-direction).map_or(f64::NEG_INFINITY, |place| place[axis]);
        }
        return widened(low, high);
    }
    for element in elements(shape, pose) {
        for (axis, direction) in axes.into_iter().enumerate() {
            high[axis] = high[axis].max(element.support(direction)[axis] + element.radius);
            low[axis] = low[axis].min(element.support(-direction)[axis] - element.radius);
        }
    }
    widened(low, high)
}

fn widened(low: DVec3, high: DVec3) -> (DVec3, DVec3) {
    let rounding = ROUNDING_ULPS * f64::EPSILON * (low.abs().max(high.abs()) + (high - low));
    (low - rounding, high + rounding)
}

/// Bounds are wider by this many epsilon of their largest coordinate.
const ROUNDING_ULPS: f64 = 16.0;
