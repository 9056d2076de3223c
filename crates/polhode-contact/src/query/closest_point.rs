//! One point against a shape: the nearest point of its surface, and whether the shape contains it.

use super::error::QueryError;
use super::feature::QueryFeature;
use super::pieces::{box_distance, offer_nearest};
use super::signed_distance::signed_distance;
use crate::Shape;
use crate::bounding::aabb::Aabb;
use glam::DVec3;
use polhode_spatial::Pose;

/// The point of a surface that is nearest to a given point.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SurfacePoint {
    /// Signed distance of the given point, m; negative inside the shape.
    pub distance: f64,
    /// The nearest point of the surface, world, m.
    pub point: DVec3,
    /// Outward unit normal of the surface there, world; towards the given point if that is outside.
    pub normal: DVec3,
    /// The feature that contains the nearest point.
    pub feature: QueryFeature,
}

/// The nearest point of a shape's surface, to rounding of the coordinates.
///
/// Inside a compound the result is that of the part in which the point is deepest, so that the depth is exact where
/// parts do not overlap or meet, and a lower bound elsewhere. Meshes, which are surfaces, and points have no inside. Of
/// equally near points the one with the lowest part is taken.
///
/// ```
/// use polhode_contact::{DVec3, Pose, Shape, closest_point};
/// let brick = Shape::cuboid(DVec3::ONE)?;
/// let near = closest_point(&brick, &Pose::IDENTITY, DVec3::new(0.0, 0.0, 2.0))?;
/// assert_eq!((near.distance, near.point), (1.5, DVec3::Z * 0.5));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// When the pose or the point is not finite.
pub fn closest_point(shape: &Shape, pose: &Pose, point: DVec3) -> Result<SurfacePoint, QueryError> {
    if !pose.is_finite() {
        return Err(QueryError::NotFinite { what: "the pose" });
    }
    if !point.is_finite() {
        return Err(QueryError::NotFinite { what: "the point" });
    }
    let local = pose.inverse_transform_point(point);
    let mut best: Option<SurfacePoint> = None;
    let here = Aabb::of_point(local);
    offer_nearest(shape, &Pose::IDENTITY, f64::INFINITY, &|bounds| box_distance(bounds, &here), &mut |piece| {
        let found = signed_distance(&piece.core, local);
        let distance = found.distance - piece.radius;
        if best.is_none_or(|best| (distance, piece.part) < (best.distance, best.feature.part)) {
            best = Some(SurfacePoint {
                distance,
                point: local - found.normal * distance,
                normal: found.normal,
                feature: piece.feature(found.feature),
            });
        }
        best.map_or(f64::INFINITY, |best| best.distance)
    });
    let best = best.ok_or(QueryError::NotFinite { what: "the shape" })?;
    Ok(SurfacePoint { point: pose.transform_point(best.point), normal: pose.rotation.rotate(best.normal), ..best })
}

/// Whether a shape contains a point; its surface counts, to rounding. Meshes and clouds contain their own points only;
/// no shape contains a point that is not finite.
///
/// ```
/// use polhode_contact::{DVec3, Pose, Shape, contains};
/// let ring = Shape::torus(2.0, 0.5)?;
/// assert!(contains(&ring, &Pose::IDENTITY, DVec3::X * 2.5) && !contains(&ring, &Pose::IDENTITY, DVec3::ZERO));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn contains(shape: &Shape, pose: &Pose, point: DVec3) -> bool {
    closest_point(shape, pose, point).is_ok_and(|near| near.distance <= 0.0)
}
