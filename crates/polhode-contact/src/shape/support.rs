//! The point that is farthest along a direction, and the parts of vectors that finding it takes.

use glam::DVec3;

/// The first of the points that are farthest along a direction; the origin when there is none.
pub(crate) fn farthest(points: &[DVec3], direction: DVec3) -> DVec3 {
    let mut best = points.first().copied().unwrap_or_default();
    let mut most = best.dot(direction);
    for &point in points.iter().skip(1) {
        let along = point.dot(direction);
        if along > most {
            most = along;
            best = point;
        }
    }
    best
}

/// The part of a vector perpendicular to a unit vector. What rounding leaves along the axis is taken away a second time:
/// where the part is small it would tilt it. Zero when that takes most of it, for then all of it was rounding.
pub(crate) fn across(vector: DVec3, axis: DVec3) -> DVec3 {
    let once = vector - axis * vector.dot(axis);
    let again = axis * once.dot(axis);
    let most = 0.5 * once.abs().max_element();
    if again.abs().max_element() > most { DVec3::ZERO } else { once - again }
}

/// The direction of a vector of any length, zero when it has none.
pub(crate) fn unit(vector: DVec3) -> DVec3 {
    let largest = vector.abs().max_element();
    if !(largest > 0.0 && largest.is_finite()) {
        return DVec3::ZERO;
    }
    let scaled = vector / largest;
    scaled / scaled.length()
}
