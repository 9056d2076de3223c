//! Signed separation of two shapes without parts.

use crate::Shape;
use crate::clearance::place_tolerance;
use crate::narrow_phase::axis::axis_search::AxisSearch;
use crate::narrow_phase::axis::half_space::height_above;
use crate::narrow_phase::axis::separating_axis::search_axes;
use crate::narrow_phase::axis::{gap, ring};
use crate::narrow_phase::feature::closest_feature::nearest_feature;
use crate::narrow_phase::feature::placed::Placed;
use crate::shape::polyhedron::ConvexPolyhedron;
use crate::shape::round::is_round;
use polhode_spatial::Pose;

/// The separation of two shapes of which neither is a compound or a mesh, m; see [`crate::separation()`].
pub(crate) fn pair_separation(search: &mut AxisSearch, a: Placed<'_>, b: Placed<'_>) -> f64 {
    let (pose_a, pose_b) = (a.pose, b.pose);
    if !(pose_a.is_finite() && pose_b.is_finite()) {
        return f64::NAN;
    }
    match (a.shape, b.shape) {
        (Shape::Convex(a), Shape::Convex(b)) => {
            let (polyhedra, poses) = ([a, b], [pose_a, pose_b]);
            search_axes(search, polyhedra, poses, f64::INFINITY).separation(polyhedra, poses)
        }
        (Shape::HalfSpace(h), other) => height_above(h, pose_a, other, pose_b),
        (other, Shape::HalfSpace(h)) => height_above(h, pose_b, other, pose_a),
        (Shape::Torus(_), _) | (_, Shape::Torus(_)) => ring::least(a, b).map_or(f64::INFINITY, |gap| gap.separation),
        (shape_a, shape_b) if is_round(shape_a) || is_round(shape_b) => {
            gap::between(a, b, f64::INFINITY).map_or(f64::INFINITY, |gap| gap.separation)
        }
        (Shape::Convex(p), other) => from_polyhedron(p, pose_a, other, pose_b),
        (other, Shape::Convex(p)) => from_polyhedron(p, pose_b, other, pose_a),
        (Shape::Points(_), Shape::Points(_)) => f64::INFINITY,
        _ => between_centers(a, b),
    }
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
fn between_centers(a: Placed<'_>, b: Placed<'_>) -> f64 {
    let (pose_a, pose_b) = (a.pose, b.pose);
    let ((centers_a, radius_a), (centers_b, radius_b)) = (a.shape.centers(), b.shape.centers());
    let between = pose_a.translation - pose_b.translation;
    let mut least = f64::INFINITY;
    for &a in centers_a {
        let a = between + pose_a.rotation.rotate(a);
        least = centers_b.iter().map(|&b| (a - pose_b.rotation.rotate(b)).length()).fold(least, f64::min);
    }
    least - radius_a - radius_b
}
