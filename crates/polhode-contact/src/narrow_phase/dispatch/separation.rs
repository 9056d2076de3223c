//! Signed separation of two shapes.

use crate::clearance::place_tolerance;
use crate::narrow_phase::axis::separating_axis::{Axes, Workspace};
use crate::narrow_phase::axis::{gap, ring};
use crate::narrow_phase::feature::closest_feature::nearest_feature;
use crate::narrow_phase::parts::composite::compound_separation;
use crate::narrow_phase::parts::mesh_pair::mesh_separation;
use crate::shape::polyhedron::ConvexPolyhedron;
use crate::shape::round::{is_round, support};
use crate::{HalfSpace, Shape};
use polhode_spatial::Pose;

/// Signed separation of two shapes, m: negative the depth of penetration; positive a lower bound of their distance that
/// is zero exactly when they touch, and the distance itself when a face or a smooth shape decides. Infinite when the
/// pair never touches, NaN when a pose is not finite.
///
/// Of a torus whose middle line enters the other body, and of compounds, a negative value is that of the deepest place or
/// pair of parts: a lower bound of the way out. Two clouds never touch, nor do two of half-space and mesh.
pub fn separation(shape_a: &Shape, pose_a: &Pose, shape_b: &Shape, pose_b: &Pose) -> f64 {
    separation_with(&mut Workspace::default(), shape_a, pose_a, shape_b, pose_b)
}

/// As [`separation`], with buffers that the caller keeps.
pub fn separation_with(
    workspace: &mut Workspace,
    shape_a: &Shape,
    pose_a: &Pose,
    shape_b: &Shape,
    pose_b: &Pose,
) -> f64 {
    if !(pose_a.is_finite() && pose_b.is_finite()) {
        return f64::NAN;
    }
    if let Some(separation) = compound_separation(workspace, [shape_a, shape_b], [pose_a, pose_b]) {
        return separation;
    }
    if let Some(separation) = mesh_separation(workspace, [shape_a, shape_b], [pose_a, pose_b]) {
        return separation;
    }
    match (shape_a, shape_b) {
        (Shape::Convex(a), Shape::Convex(b)) => {
            search_axes(workspace, a, pose_a, b, pose_b, f64::INFINITY).separation(a, pose_a, b, pose_b)
        }
        (Shape::HalfSpace(h), other) => above_half_space(h, pose_a, other, pose_b),
        (other, Shape::HalfSpace(h)) => above_half_space(h, pose_b, other, pose_a),
        (Shape::Torus(_), _) | (_, Shape::Torus(_)) => {
            ring::least(shape_a, pose_a, shape_b, pose_b).map_or(f64::INFINITY, |gap| gap.separation)
        }
        (a, b) if is_round(a) || is_round(b) => {
            gap::between(a, pose_a, b, pose_b, f64::INFINITY).map_or(f64::INFINITY, |gap| gap.separation)
        }
        (Shape::Convex(p), other) => from_polyhedron(p, pose_a, other, pose_b),
        (other, Shape::Convex(p)) => from_polyhedron(p, pose_b, other, pose_a),
        (Shape::Points(_), Shape::Points(_)) => f64::INFINITY,
        (a, b) => between_centers(a, pose_a, b, pose_b),
    }
}

/// Best separating axes of two polyhedra, in A's frame; see [`Workspace::search`].
pub(crate) fn search_axes(
    workspace: &mut Workspace,
    a: &ConvexPolyhedron,
    pose_a: &Pose,
    b: &ConvexPolyhedron,
    pose_b: &Pose,
    stop: f64,
) -> Axes {
    let x_ab = pose_a.relative(pose_b);
    workspace.place(b, &x_ab);
    workspace.search(a, b, &x_ab, stop)
}

/// Least height of a shape above a half-space; infinite for another half-space.
fn above_half_space(half_space: &HalfSpace, pose: &Pose, shape: &Shape, pose_of_shape: &Pose) -> f64 {
    let normal = pose.rotation.rotate(half_space.normal);
    let base = normal.dot(pose_of_shape.translation - pose.translation) - half_space.offset;
    // Directions are turned into the shape's frame once, instead of every point into the world.
    let normal = pose_of_shape.rotation.inverse_rotate(normal);
    base - support(shape, -normal)
}

/// Distance of a sphere or of the nearest point of a cloud from a polyhedron.
fn from_polyhedron(polyhedron: &ConvexPolyhedron, pose: &Pose, shape: &Shape, pose_of_shape: &Pose) -> f64 {
    let (centers, radius) = shape.centers();
    let x = pose.relative(pose_of_shape);
    let tolerance = place_tolerance(polyhedron.size, polyhedron.size, x.translation);
    let distance = |&c| nearest_feature(polyhedron, x.transform_point(c), tolerance).distance;
    centers.iter().map(distance).fold(f64::INFINITY, f64::min) - radius
}

/// Distance of two spheres, or of a sphere from the nearest point of a cloud.
fn between_centers(shape_a: &Shape, pose_a: &Pose, shape_b: &Shape, pose_b: &Pose) -> f64 {
    let ((centers_a, radius_a), (centers_b, radius_b)) = (shape_a.centers(), shape_b.centers());
    let between = pose_a.translation - pose_b.translation;
    let mut least = f64::INFINITY;
    for &a in centers_a {
        let a = between + pose_a.rotation.rotate(a);
        least = centers_b.iter().map(|&b| (a - pose_b.rotation.rotate(b)).length()).fold(least, f64::min);
    }
    least - radius_a - radius_b
}
