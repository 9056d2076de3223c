//! Triangles and their sides as sets of points: areas, and what of them is nearest to a point.
//!
//! A triangle may be a needle, whose plane the rounding of its long sides would tilt. Its area is the product of the two
//! shortest ones. A point is split along the longest side and across it towards the tip, two directions that stay
//! perpendicular for any height; how far it stands off the plane does not enter. Rounding then moves the nearest place
//! within the triangle only, and its distance is good to rounding of the point's distance from a corner.

use super::nearer_place::is_nearer;
use super::support::farthest;
use glam::DVec3;

/// Part of a triangle.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Part {
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

/// Twice the area along the normal from which the corners are seen anticlockwise, m^2.
pub(crate) fn area_vector(corners: [DVec3; 3]) -> DVec3 {
    let from = sides(corners).1;
    let tip = corners[(from + 2) % 3];
    (corners[from] - tip).cross(corners[(from + 1) % 3] - tip)
}

/// The vector from the nearest place of a triangle, which may be flat, to a point (m), and the part that place lies in. Of
/// equally near sides the first is taken.
pub(crate) fn from_triangle(corners: &[DVec3; 3], point: DVec3) -> (DVec3, Part) {
    let [a, b, c] = *corners;
    // Any product of two sides tells well enough which to look at: its rounding, epsilon times length over height, moves the
    // border between two answers no farther than where they differ by rounding.
    let normal = (b - a).cross(c - a);
    let within = |p: DVec3, q: DVec3| (q - p).cross(point - p).dot(normal);
    let beyond = [within(a, b), within(b, c), within(c, a)].map(|inward| inward < 0.0);
    if beyond != [false; 3] {
        return from_sides(corners, point, beyond);
    }
    match over_face(corners, point) {
        Some(height) => (height, Part::Face),
        None => from_sides(corners, point, [true; 3]),
    }
}

/// The vector from the face to a point over it.
fn over_face(corners: &[DVec3; 3], point: DVec3) -> Option<DVec3> {
    let (squares, from) = sides(*corners);
    let (to, tip) = ((from + 1) % 3, (from + 2) % 3);
    // From the end that is nearer to the tip.
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

/// The same of some of the sides: the nearest place lies on one beyond which the point is.
fn from_sides(corners: &[DVec3; 3], point: DVec3, wanted: [bool; 3]) -> (DVec3, Part) {
    let lengths = corners.iter().map(|&corner| (corner - point).abs().max_element()).fold(0.0, f64::max);
    let reach = |direction| (farthest(corners, direction) - point).dot(direction);
    let way = |away: DVec3| (away.length(), away / away.length());
    let mut best: Option<(DVec3, Part)> = None;
    for i in (0..3).filter(|&i| wanted[i]) {
        let (place, part) = on_segment(corners[i], corners[(i + 1) % 3], point);
        let away = point - place;
        if best.is_none_or(|(other, _)| is_nearer(way(away), way(other), lengths, reach)) {
            let part = match part {
                Part::Corner(end) => Part::Corner((i + end) % 3),
                _ => Part::Edge(i),
            };
            best = Some((away, part));
        }
    }
    best.unwrap_or((point - corners[0], Part::Corner(0)))
}

/// Nearest place of a segment, its edge or one of its corners.
pub(crate) fn on_segment(p: DVec3, q: DVec3, point: DVec3) -> (DVec3, Part) {
    let along = q - p;
    let (from, to) = ((point - p).dot(along), (q - point).dot(along));
    if from <= 0.0 {
        (p, Part::Corner(0))
    } else if to <= 0.0 {
        (q, Part::Corner(1))
    } else if from < to {
        (p + along * (from / along.length_squared()), Part::Edge(0))
    } else {
        (q - along * (to / along.length_squared()), Part::Edge(0))
    }
}
