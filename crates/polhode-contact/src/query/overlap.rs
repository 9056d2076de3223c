//! Whether two shapes share a point.

use super::distance::distance;
use super::error::QueryError;
use crate::Shape;
use crate::clearance::{joint_size, resolution};
use polhode_spatial::Pose;

/// Bound of the error of a distance found by an iteration, relative to the joint size: four times the 1e-12 stated by
/// [`distance()`] (the tests find errors up to 5e-15 against closed forms).
const ITERATION: f64 = 4e-12;

/// Whether two shapes overlap. Touch counts: a distance up to the resolution of the pair
/// ([`crate::clearance::resolution`]), or up to 4e-12 of the joint size for a cylinder, cone or torus, the error bound
/// of their distance. Two half-spaces overlap; a pair with a pose that is not finite does not.
///
/// ```
/// use polhode_contact::{DVec3, Pose, Shape, overlap};
/// let brick = Shape::cuboid(DVec3::ONE)?;
/// assert!(overlap(&brick, &Pose::IDENTITY, &brick, &Pose::from_translation(DVec3::X)));
/// assert!(!overlap(&brick, &Pose::IDENTITY, &brick, &Pose::from_translation(DVec3::X * 1.0001)));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn overlap(shape_a: &Shape, pose_a: &Pose, shape_b: &Shape, pose_b: &Pose) -> bool {
    match distance(shape_a, pose_a, shape_b, pose_b) {
        Ok(found) => {
            let rounding = resolution(shape_a, pose_a, shape_b, pose_b);
            let curved = is_curved(shape_a) || is_curved(shape_b);
            let touch = if curved { rounding.max(ITERATION * joint_size(shape_a, shape_b)) } else { rounding };
            found.distance <= touch
        }
        Err(QueryError::Unbounded) => true,
        Err(_) => false,
    }
}

/// Whether distances from the shape may come from an iteration.
fn is_curved(shape: &Shape) -> bool {
    match shape {
        Shape::Cylinder(_) | Shape::Cone(_) | Shape::Torus(_) => true,
        Shape::Compound(compound) => compound.parts().iter().any(is_curved),
        _ => false,
    }
}
