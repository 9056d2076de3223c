//! A shape as the pieces it consists of, and a branch-and-bound search over them.

use super::piece::{Core, Piece};
use crate::Shape;
use crate::bounding::aabb::Aabb;
use crate::shape::TriangleMesh;
use glam::DVec3;
use polhode_spatial::Pose;
use polhode_spatial::rounding;

/// Calls `visit` with the pieces of a shape at a pose. Triangles and points are numbered as in the shape; pieces of a
/// compound have the number of their part.
fn for_each_piece<'a>(shape: &'a Shape, pose: &Pose, visit: &mut dyn FnMut(&Piece<'a>)) {
    let mut one = |core, radius| visit(&Piece::new(core, radius, 0, *pose));
    match shape {
        Shape::Convex(p) => one(Core::Polyhedron(p), 0.0),
        Shape::Sphere(s) => one(Core::Point(s.center), s.radius),
        Shape::HalfSpace(h) => one(Core::HalfSpace(h), 0.0),
        Shape::Capsule(c) => one(Core::Segment(c.ends), c.radius),
        Shape::Cylinder(c) => one(Core::Cylinder(c), 0.0),
        Shape::Cone(c) => one(Core::Cone(c), 0.0),
        Shape::Torus(t) => one(Core::Circle(t), t.minor),
        Shape::Points(cloud) => {
            for (index, &point) in cloud.points.iter().enumerate() {
                visit(&Piece::new(Core::Point(point), 0.0, index as u32, *pose));
            }
        }
        Shape::TriangleMesh(mesh) => (0..mesh.triangles.len() as u32).for_each(|t| visit(&triangle(mesh, t, pose))),
        Shape::Compound(compound) => {
            (0..compound.parts.len() as u32).for_each(|part| for_each_of_part(&compound.parts, part, pose, visit));
        }
    }
}

fn triangle(mesh: &TriangleMesh, index: u32, pose: &Pose) -> Piece<'static> {
    // The indices are valid: a mesh is checked when it is made.
    let corners = mesh.triangles[index as usize].map(|v| mesh.vertices[v as usize]);
    Piece::new(Core::Triangle(corners), 0.0, index, *pose)
}

fn for_each_of_part<'a>(parts: &'a [Shape], part: u32, pose: &Pose, visit: &mut dyn FnMut(&Piece<'a>)) {
    for_each_piece(&parts[part as usize], pose, &mut |piece| visit(&Piece { part, ..*piece }));
}

/// Calls `measure` with the pieces of a shape that may have the least value, nearest boxes first. `measure` returns the
/// least value so far, `start` is its initial value, and `bound` is a lower bound of the values within a box of the
/// shape's frame. Boxes with a bound above both the least value and 0 are skipped.
pub(crate) fn offer_nearest<'a>(
    shape: &'a Shape,
    pose: &Pose,
    start: f64,
    bound: &impl Fn(&Aabb) -> f64,
    measure: &mut impl FnMut(&Piece<'a>) -> f64,
) {
    match shape {
        Shape::TriangleMesh(mesh) => {
            mesh.tree.least(start, 0.0, bound, &mut |t, _| measure(&triangle(mesh, t, pose)));
        }
        Shape::Compound(compound) => {
            compound.tree.least(start, 0.0, bound, &mut |part, mut least| {
                for_each_of_part(&compound.parts, part, pose, &mut |piece| least = least.min(measure(piece)));
                least
            });
        }
        _ => for_each_piece(shape, pose, &mut |piece| {
            measure(piece);
        }),
    }
}

/// Lower bound of the distance of a box from another, m.
pub(crate) fn box_distance(bounds: &Aabb, other: &Aabb) -> f64 {
    let largest = bounds.min.abs().max(bounds.max.abs()).max_element();
    bounds.distance(other) * (1.0 - rounding::DOZEN_TERMS) - rounding::DOZEN_TERMS * largest
}

/// A lower bound of the distance at which a ray enters a box, m; none for a miss.
pub(crate) fn entry_distance(bounds: &Aabb, origin: DVec3, direction: DVec3) -> Option<f64> {
    // The box is widened by the rounding of distances from the ray's origin.
    let farthest = (bounds.min - origin).abs().max((bounds.max - origin).abs()).max_element();
    let bounds = bounds.widened(rounding::DOZEN_TERMS * farthest);
    let (mut enter, mut leave): (f64, f64) = (0.0, f64::INFINITY);
    for axis in 0..3 {
        let (from, rate) = (origin[axis], direction[axis]);
        if rate == 0.0 {
            if from < bounds.min[axis] || from > bounds.max[axis] {
                return None;
            }
            continue;
        }
        let (s, t) = ((bounds.min[axis] - from) / rate, (bounds.max[axis] - from) / rate);
        enter = enter.max(s.min(t));
        leave = leave.min(s.max(t));
    }
    (enter <= leave).then_some(enter)
}
