//! Euclidean distance of two shapes, with the closest points.

use super::curved::{apart, overlapping};
use super::error::QueryError;
use super::feature::QueryFeature;
use super::found::Found;
use super::lines::nearest_points;
use super::piece::{Core, Piece};
use super::pieces::{box_distance, offer_nearest};
use super::polytopes;
use super::signed_distance::{signed, signed_distance};
use super::sweep::{along_circle, along_segment};
use crate::bounding::aabb::Aabb;
use crate::{Shape, SurfaceFeature};
use glam::DVec3;
use polhode_spatial::Pose;

/// The distance of two shapes, with its normal and witness points.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ClosestPoints {
    /// Distance, m; overlapping shapes have minus the depth of penetration.
    pub distance: f64,
    /// Unit vector from B to A, world; for overlapping shapes the direction of the shortest translation of A that
    /// separates them.
    pub normal: DVec3,
    /// The closest point of A, world, m: `point_a = point_b + distance normal`.
    pub point_a: DVec3,
    /// The closest point of B, world, m.
    pub point_b: DVec3,
    /// The feature of A that contains the point.
    pub feature_a: QueryFeature,
    /// The feature of B that contains the point.
    pub feature_b: QueryFeature,
}

/// Distance of two shapes and their closest points.
///
/// - Polyhedra, triangles, capsules, spheres, points, half-spaces: exact to rounding of the coordinates, apart and
///   overlapping.
/// - Cylinders and cones: exact to rounding against half-spaces, spheres, points, and capsules whose axis does not
///   enter them; otherwise to about 1e-12 of the size when apart (by an iteration), and to rounding when overlapping.
/// - A torus is a circle with a radius: the minimum along the circle is searched in 96 intervals. Where the circle
///   enters the other body, the result is minus the depth of the deepest ball of the tube.
/// - Meshes, compounds and clouds: the least over their triangles, parts and points. Where several parts overlap, it is
///   the depth of the deepest one, and may be less than the translation that separates all.
///
/// Of several equally close pairs of points one is chosen: by the order of parts, faces before edges before vertices,
/// and lower indices first. On an axis of symmetry the direction is a fixed one.
///
/// ```
/// use polhode_contact::{DVec3, Pose, Shape, distance};
/// let (brick, ball) = (Shape::cuboid(DVec3::ONE)?, Shape::sphere(0.5)?);
/// let apart = distance(&ball, &Pose::from_translation(DVec3::X * 3.0), &brick, &Pose::IDENTITY)?;
/// assert_eq!((apart.distance, apart.normal), (2.0, DVec3::X));
/// let inside = distance(&brick, &Pose::from_translation(DVec3::Z * 0.75), &brick, &Pose::IDENTITY)?;
/// assert_eq!((inside.distance, inside.normal), (-0.25, DVec3::Z));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// When a pose is not finite, and for two half-spaces.
pub fn distance(shape_a: &Shape, pose_a: &Pose, shape_b: &Shape, pose_b: &Pose) -> Result<ClosestPoints, QueryError> {
    if !(pose_a.is_finite() && pose_b.is_finite()) {
        return Err(QueryError::NotFinite { what: "a pose" });
    }
    if shape_a.is_half_space() && shape_b.is_half_space() {
        return Err(QueryError::Unbounded);
    }
    // In world axes with A's origin as the origin, so that pairs far from the world's origin lose no digits.
    let here = Pose::new(pose_a.rotation, DVec3::ZERO);
    let there = Pose::new(pose_b.rotation, pose_b.translation - pose_a.translation);
    if !there.is_finite() {
        return Err(QueryError::NotFinite { what: "the distance of the poses" });
    }
    let mut best: Option<ClosestPoints> = None;
    let least = |best: &Option<ClosestPoints>| best.map_or(f64::INFINITY, |best| best.distance);
    let from_b = distance_from(shape_b, &here, &there);
    offer_nearest(shape_a, &here, f64::INFINITY, &from_b, &mut |a| {
        let around_a = a.bounds_in(&there);
        offer_nearest(shape_b, &there, least(&best), &|bounds| box_distance(bounds, &around_a), &mut |b| {
            if best.is_none_or(|best| a.bound(b) <= best.distance) {
                let found = with_radii(a, b, &of_cores(a, b));
                if best.is_none_or(|best| found.order() < best.order()) {
                    best = Some(found);
                }
            }
            least(&best)
        });
        least(&best)
    });
    let best = best.ok_or(QueryError::NotFinite { what: "the shape" })?;
    let origin = pose_a.translation;
    Ok(ClosestPoints { point_a: origin + best.point_a, point_b: origin + best.point_b, ..best })
}

/// Lower bound of the distance of a shape from anything in a box of a frame, m.
fn distance_from(shape: &Shape, frame: &Pose, pose: &Pose) -> impl Fn(&Aabb) -> f64 {
    // A half-space has no finite box; its bound is always zero, so that nothing is skipped.
    let around = match shape {
        Shape::HalfSpace(_) => Aabb::UNBOUNDED,
        _ => shape.bounds_at(&frame.relative(pose)),
    };
    move |bounds| box_distance(bounds, &around)
}

impl ClosestPoints {
    /// Sort key: nearer pairs first, of equally near ones those of lower parts.
    const fn order(&self) -> (f64, u32, u32) {
        (self.distance, self.feature_a.part, self.feature_b.part)
    }
}

/// The result for two pieces from that for their cores.
fn with_radii(a: &Piece<'_>, b: &Piece<'_>, found: &Found) -> ClosestPoints {
    ClosestPoints {
        distance: found.distance - (a.radius + b.radius),
        normal: found.normal,
        point_a: found.on_a - found.normal * a.radius,
        point_b: found.on_b + found.normal * b.radius,
        feature_a: a.feature(found.feature_a),
        feature_b: b.feature(found.feature_b),
    }
}

/// Distance of two cores in the common frame.
fn of_cores(a: &Piece<'_>, b: &Piece<'_>) -> Found {
    match (&a.core, &b.core) {
        (Core::HalfSpace(_), _) => above_plane(b, a).swapped(),
        (_, Core::HalfSpace(_)) => above_plane(a, b),
        (Core::Point(p), _) => at_place(a, a.pose.transform_point(*p), b),
        (_, Core::Point(p)) => at_place(b, b.pose.transform_point(*p), a).swapped(),
        (Core::Circle(_), _) => of_circle(a, b),
        (_, Core::Circle(_)) => of_circle(b, a).swapped(),
        (Core::Segment(p), Core::Segment(q)) => {
            let near = nearest_points(p.map(|e| a.pose.transform_point(e)), q.map(|e| b.pose.transform_point(e)));
            Found {
                distance: near.distance,
                normal: near.normal,
                on_a: near.on_a,
                on_b: near.on_b,
                feature_a: signed(near.on_a, a).feature,
                feature_b: signed(near.on_b, b).feature,
            }
        }
        (Core::Segment(_), Core::Cylinder(_) | Core::Cone(_)) => of_segment(a, b),
        (Core::Cylinder(_) | Core::Cone(_), Core::Segment(_)) => of_segment(b, a).swapped(),
        _ if a.core.is_polytope() && b.core.is_polytope() => polytopes::distance(a, b),
        _ => of_curved(a, b),
    }
}

/// Signed height of a core above a half-space.
fn above_plane(a: &Piece<'_>, plane: &Piece<'_>) -> Found {
    let Core::HalfSpace(half_space) = plane.core else { return of_curved(a, plane) };
    let normal = plane.pose.rotation.rotate(half_space.normal);
    let lowest = a.support(-normal);
    let height = normal.dot(lowest - plane.pose.translation) - half_space.offset;
    let feature_a = match &a.core {
        Core::Polyhedron(p) => {
            let local = a.core.support(a.pose.rotation.inverse_rotate(-normal));
            SurfaceFeature::Vertex(p.vertices.iter().position(|&v| v == local).unwrap_or(0) as u32)
        }
        _ => signed_distance(&a.core, a.pose.inverse_transform_point(lowest)).feature,
    };
    Found {
        distance: height,
        normal,
        on_a: lowest,
        on_b: lowest - normal * height,
        feature_a,
        feature_b: SurfaceFeature::Face(0),
    }
}

/// Distance of a point of core `a` from core `b`.
fn at_place(a: &Piece<'_>, place: DVec3, b: &Piece<'_>) -> Found {
    let near = signed(place, b);
    Found {
        distance: near.distance,
        normal: near.normal,
        on_a: place,
        on_b: place - near.normal * near.distance,
        feature_a: signed(place, a).feature,
        feature_b: near.feature,
    }
}

/// Distance of a circle: the minimum along it.
fn of_circle(circle: &Piece<'_>, b: &Piece<'_>) -> Found {
    let Core::Circle(torus) = circle.core else { return of_curved(circle, b) };
    let x = torus.axis.any_orthonormal_vector();
    let y = torus.axis.cross(x);
    let turn = |v: DVec3| circle.pose.rotation.rotate(v * torus.major);
    let center = circle.pose.transform_point(torus.center);
    let (place, _) = along_circle(center, turn(x), turn(y), &|p| signed(p, b));
    at_place(circle, place, b)
}

/// A segment against a curved core: the minimum along it, or, when that is inside, the depth of the whole segment.
fn of_segment(segment: &Piece<'_>, b: &Piece<'_>) -> Found {
    let Core::Segment(ends) = segment.core else { return of_curved(segment, b) };
    let ends = ends.map(|e| segment.pose.transform_point(e));
    let (place, near) = along_segment(ends, &|p| signed(p, b));
    if near.distance > 0.0 { at_place(segment, place, b) } else { overlapping(segment, b) }
}

/// Two convex cores, at least one of them curved.
fn of_curved(a: &Piece<'_>, b: &Piece<'_>) -> Found {
    apart(a, b).unwrap_or_else(|| overlapping(a, b))
}
