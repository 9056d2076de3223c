//! Support points, and components of vectors.

use glam::DVec3;

/// The support point along a direction; in a tie the first, and the origin when there are no points.
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

/// The middle of the smallest and the largest coordinate of some points along a direction.
pub(crate) fn middle_coordinate(points: impl Iterator<Item = DVec3>, direction: DVec3) -> f64 {
    let (low, high) = points
        .map(|point| direction.dot(point))
        .fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), along| (low.min(along), high.max(along)));
    0.5 * (low + high)
}

/// The component of a vector perpendicular to a unit vector. The projection is made twice: a remainder along the axis,
/// from rounding, would tilt a small component. Zero when the second projection removes most of it, because then all of
/// it was rounding.
pub(crate) fn across(vector: DVec3, axis: DVec3) -> DVec3 {
    let once = vector - axis * vector.dot(axis);
    let again = axis * once.dot(axis);
    let most = 0.5 * once.abs().max_element();
    if again.abs().max_element() > most { DVec3::ZERO } else { once - again }
}

/// The unit vector along a vector of any length; zero for the zero vector.
pub(crate) fn unit(vector: DVec3) -> DVec3 {
    let largest = vector.abs().max_element();
    if !(largest > 0.0 && largest.is_finite()) {
        return DVec3::ZERO;
    }
    let scaled = vector / largest;
    scaled / scaled.length()
}
