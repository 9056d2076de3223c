//! Triangles: their areas, and the point of a triangle or of a side that is nearest to a given point.
//!
//! A triangle may be a needle, whose plane the rounding of its long sides would tilt. So its area is the cross product
//! of the two shortest sides. A point is resolved along the longest side and perpendicular to it towards the opposite
//! corner, two directions that stay perpendicular for any height; its distance from the plane is not used. Rounding
//! then moves the nearest point within the triangle only, and the error of the distance is the rounding of the point's
//! distance from a corner.

use super::nearer_point::is_nearer;
use super::support::farthest;
use glam::DVec3;

/// A feature of a triangle.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum TriangleFeature {
    Face,
    /// From corner k to the next.
    Edge(usize),
    Corner(usize),
}

/// Squares of the lengths of the sides, m^2, and the longest: side k runs from corner k to the next.
fn sides([a, b, c]: [DVec3; 3]) -> ([f64; 3], usize) {
    let squares = [b - a, c - b, a - c].map(DVec3::length_squared);
    let first = squares[0] >= squares[1] && squares[0] >= squares[2];
    (squares, if first { 0 } else { 1 + usize::from(squares[2] > squares[1]) })
}

/// The area vector: twice the area times the unit normal (corners anticlockwise seen from its tip), m^2.
pub(crate) fn area_vector(corners: [DVec3; 3]) -> DVec3 {
    let from = sides(corners).1;
    let tip = corners[(from + 2) % 3];
    (corners[from] - tip).cross(corners[(from + 1) % 3] - tip)
}

/// The vector from the nearest point of a triangle, which may have no area, to a given point (m), and the feature that
/// contains the nearest point. Of equally near sides the first is taken.
pub(crate) fn from_triangle(corners: &[DVec3; 3], point: DVec3) -> (DVec3, TriangleFeature) {
    let [a, b, c] = *corners;
    // Any product of two sides is accurate enough for the choice of the case: its rounding, epsilon times length over
    // height, moves the border between two cases no farther than where their results differ by rounding.
    let normal = (b - a).cross(c - a);
    let within = |p: DVec3, q: DVec3| (q - p).cross(point - p).dot(normal);
    let beyond = [within(a, b), within(b, c), within(c, a)].map(|inward| inward < 0.0);
    if beyond != [false; 3] {
        return from_sides(corners, point, beyond);
    }
    match over_face(corners, point) {
        Some(height) => (height, TriangleFeature::Face),
        None => from_sides(corners, point, [true; 3]),
    }
}

/// The vector from the face to a point that projects onto it; none for other points.
fn over_face(corners: &[DVec3; 3], point: DVec3) -> Option<DVec3> {
    let (squares, from) = sides(*corners);
    let (to, tip) = ((from + 1) % 3, (from + 2) % 3);
    // Relative to the end nearer to the opposite corner.
    let (start, end) = if squares[tip] <= squares[to] { (from, to) } else { (to, from) };
    let (along, square) = (corners[end] - corners[start], squares[from]);
    let (to_tip, to_point) = (corners[tip] - corners[start], point - corners[start]);
    let tip_along = to_tip.dot(along) / square;
    let across = to_tip - along * tip_along;
    let u = to_point.dot(along) / square;
    let beside = to_point - along * u;
    let v = beside.dot(across) / across.length_squared();
    let within = v >= 0.0 && u - v * tip_along >= 0.0 && 1.0 - u - v * (1.0 - tip_along) >= 0.0;
    within.then(|| beside - across * v)
}

/// The same for the sides in `wanted`: the nearest point lies on a side whose line separates the point from the
/// triangle.
fn from_sides(corners: &[DVec3; 3], point: DVec3, wanted: [bool; 3]) -> (DVec3, TriangleFeature) {
    let lengths = corners.iter().map(|&corner| (corner - point).abs().max_element()).fold(0.0, f64::max);
    let support = |direction| (farthest(corners, direction) - point).dot(direction);
    let measured = |away: DVec3| (away.length(), away / away.length());
    let mut best: Option<(DVec3, TriangleFeature)> = None;
    for i in (0..3).filter(|&i| wanted[i]) {
        let (place, part) = on_segment(corners[i], corners[(i + 1) % 3], point);
        let away = point - place;
        if best.is_none_or(|(other, _)| is_nearer(measured(away), measured(other), lengths, support)) {
            let part = match part {
                TriangleFeature::Corner(end) => TriangleFeature::Corner((i + end) % 3),
                _ => TriangleFeature::Edge(i),
            };
            best = Some((away, part));
        }
    }
    best.unwrap_or((point - corners[0], TriangleFeature::Corner(0)))
}

/// Nearest point of a segment, and whether it is one of its ends.
pub(crate) fn on_segment(p: DVec3, q: DVec3, point: DVec3) -> (DVec3, TriangleFeature) {
    let along = q - p;
    let (from, to) = ((point - p).dot(along), (q - point).dot(along));
    if from <= 0.0 {
        (p, TriangleFeature::Corner(0))
    } else if to <= 0.0 {
        (q, TriangleFeature::Corner(1))
    } else if from < to {
        (p + along * (from / along.length_squared()), TriangleFeature::Edge(0))
    } else {
        (q - along * (to / along.length_squared()), TriangleFeature::Edge(0))
    }
}
