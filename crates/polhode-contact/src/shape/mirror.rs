//! Whether a shape is its own mirror image.
//!
//! A scene whose bodies are all their own mirror image in one plane, and move in it, stays in it: that is what planar
//! motion needs to know of shapes. A point x has the image `x - 2 (n.x - d) n` in the plane `n.x = d`.

use crate::Shape;
use glam::DVec3;
use polhode_spatial::UnitVector;

/// Cosine up to which two directions are perpendicular: the rounding of two unit vectors that were turned.
const PERPENDICULAR: f64 = 4.0 * f64::EPSILON;

/// How far the shape is from being its own mirror image in the plane `normal . x = offset` (m) of its frame: the largest
/// distance of the image of a vertex, point or centre from the nearest one of the shape, m; for a half-space, how far
/// its plane misses being perpendicular, as infinity. Zero for a symmetric shape, to the rounding of its coordinates.
pub fn mirror_defect(shape: &Shape, normal: UnitVector, offset: f64) -> f64 {
    let n = normal.get();
    let image = |x: DVec3| x - n * (2.0 * (n.dot(x) - offset));
    if let Shape::HalfSpace(half_space) = shape {
        let along = half_space.normal().dot(n).abs();
        return if along <= PERPENDICULAR { 0.0 } else { f64::INFINITY };
    }
    let points = shape.centers().0;
    let distance = |x: DVec3| points.iter().map(|p| (*p - x).length()).fold(f64::INFINITY, f64::min);
    points.iter().map(|&p| distance(image(p))).fold(0.0, f64::max)
}
