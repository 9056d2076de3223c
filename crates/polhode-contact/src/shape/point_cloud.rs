//! Sets of points.

use super::error::{ShapeError, check_point};
use crate::bounding::aabb::Aabb;
use glam::DVec3;

/// Points that are fixed to each other: they touch faces, edges, vertices and spheres, never each other.
#[derive(Debug, Clone, PartialEq)]
pub struct PointCloud {
    pub(crate) points: Vec<DVec3>,
    size: f64,
}

impl PointCloud {
    /// From positions in the body's frame, m.
    ///
    /// # Errors
    /// When there is no point, more than 2^32 - 1, or a coordinate is not finite.
    pub fn new(points: Vec<DVec3>) -> Result<Self, ShapeError> {
        if points.is_empty() {
            return Err(ShapeError::TooFewPoints { count: 0, limit: 1 });
        }
        if u32::try_from(points.len()).is_err() {
            return Err(ShapeError::TooManyPoints { count: points.len(), limit: u32::MAX as usize });
        }
        for &point in &points {
            check_point("point", point)?;
        }
        let size = largest_distance(&points);
        Ok(Self { points, size })
    }

    /// Positions in the body's frame, m.
    pub fn points(&self) -> &[DVec3] {
        &self.points
    }

    pub(super) const fn size(&self) -> f64 {
        self.size
    }
}

/// Up to this many points (of a compound: balls around its parts) the largest distance is found over all pairs; above
/// it the diagonal of the bounding box is used, which is at most sqrt(3) times too large. The value only scales
/// tolerances.
pub(super) const EXACT_SIZE_LIMIT: usize = 1024;

/// Largest distance between two of some points, m.
pub(crate) fn largest_distance(points: &[DVec3]) -> f64 {
    if points.len() > EXACT_SIZE_LIMIT {
        let around = Aabb::of_points(points.iter().copied());
        return (around.max - around.min).length();
    }
    let mut largest: f64 = 0.0;
    for (i, a) in points.iter().enumerate() {
        for b in &points[i + 1..] {
            largest = largest.max(a.distance_squared(*b));
        }
    }
    largest.sqrt()
}
