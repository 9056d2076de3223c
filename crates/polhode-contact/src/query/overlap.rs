//! Whether two shapes share a point.

use super::distance::distance;
use crate::Shape;
use crate::clearance::resolution;
use polhode_spatial::Pose;

/// Whether two shapes overlap; touch counts, that is a distance up to the resolution of the pair
/// ([`crate::clearance::resolution`]). Two half-spaces overlap; a pair with a pose that is not finite does
/// not.
///
/// ```
/// use polhode_contact::{Shape, overlap};
/// use polhode_spatial::{DVec3, Pose};
/// let brick = Shape::cuboid(DVec3::ONE)?;
/// assert!(overlap(&brick, &Pose::IDENTITY, &brick, &Pose::from_translation(DVec3::X)));
/// assert!(!overlap(&brick, &Pose::IDENTITY, &brick, &Pose::from_translation(DVec3::X * 1.0001)));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn overlap(shape_a: &Shape, pose_a: &Pose, shape_b: &Shape, pose_b: &Pose) -> bool {
    match distance(shape_a, pose_a, shape_b, pose_b) {
        Ok(found) => found.distance <= resolution(shape_a, pose_a, shape_b, pose_b),
        Err(super::QueryError::Unbounded) => true,
        Err(_) => false,
    }
}
