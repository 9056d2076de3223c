//! Polygons to triangles.
//!
//! The fan from the first corner is kept where it is right: where all its triangles run the polygon's way round, seen
//! along its normal (Newell's: the sum of the cross products of neighbouring corners). That holds for every convex
//! polygon. Any other is cut by clipping ears (docs/REFERENCES.md, Meisters 1975): a corner that turns the right way
//! and whose triangle holds no other corner is cut off until three are left. All triangles of the result run the
//! polygon's way round, which for a polygon that does not cross itself means that they cover it once.
//!
//! A polygon that crosses itself, or is flat to rounding, has no such cut; it keeps its fan, whose signed areas still
//! sum to the polygon's, so that the integrals of a solid are right. Corners need not lie in a plane: only their
//! projection along the normal counts. Cost: n for a fan, n^2 for ears as a rule, n^3 for
//! spirals whose ears are few.

use crate::triangle_mesh::COORDINATE_ROUNDING;
use glam::{DVec2, DVec3};

/// Most corners of a polygon that ears are clipped from: a double spiral of so many takes half a second.
pub(crate) const MOST_CLIPPED_CORNERS: usize = 2000;

/// How the triangles of a polygon are found.
#[derive(Debug, Clone, PartialEq)]
pub(crate) enum Triangulation {
    /// The fan from the first corner.
    Fan,
    /// These triangles of corners, counted from 0.
    Ears(Vec<[usize; 3]>),
    /// Not convex, and more than [`MOST_CLIPPED_CORNERS`] corners.
    TooLarge,
}

/// Whether a fan (m) is plainly right: all its triangles run the polygon's way round, no rounding in question. This is
/// what nearly every polygon of nearly every file passes, and needs no memory.
pub(crate) fn is_plain_fan(fan: impl Iterator<Item = [DVec3; 3]> + Clone) -> bool {
    let areas = fan.map(|[a, b, c]| (b - a).cross(c - a));
    let normal = areas.clone().fold(DVec3::ZERO, |sum, area| sum + area);
    let axis = largest_axis(normal);
    areas.into_iter().all(|area| area[axis] * normal[axis].signum() > 0.0)
}

/// Of a polygon with these corners (m).
pub(crate) fn triangulate(corners: &[DVec3]) -> Triangulation {
    let Some((points, rounding)) = projected(corners) else { return Triangulation::Fan };
    let is_fan = match points[..] {
        [first, ..] => points.windows(2).all(|pair| turn(first, pair[0], pair[1]) >= -rounding),
        [] => true,
    };
    if is_fan {
        return Triangulation::Fan;
    }
    if corners.len() > MOST_CLIPPED_CORNERS {
        return Triangulation::TooLarge;
    }
    ears(&points).map_or(Triangulation::Fan, Triangulation::Ears)
}

/// The corners seen against the normal, in units of their extent and about the first, so that the polygon runs
/// anticlockwise; and the rounding of [`turn`]. None when the polygon has no normal.
fn projected(corners: &[DVec3]) -> Option<(Vec<DVec2>, f64)> {
    let first = *corners.first()?;
    let extent = corners.iter().fold(0.0f64, |extent, p| extent.max((*p - first).abs().max_element()));
    let largest = corners.iter().fold(0.0f64, |largest, p| largest.max(p.abs().max_element()));
    if !(extent > 0.0 && extent.is_finite()) {
        return None;
    }
    let relative: Vec<DVec3> = corners.iter().map(|&p| (p - first) / extent).collect();
    let normal = relative.windows(2).fold(DVec3::ZERO, |sum, pair| sum + pair[0].cross(pair[1]));
    // Coordinates are right to rounding of the largest, and lengths here are at most 2 sqrt(3).
    let rounding = COORDINATE_ROUNDING * (largest / extent) * 4.0;
    if normal.abs().max_element() <= rounding {
        return None;
    }
    let axis = largest_axis(normal);
    let (u, v) = if normal[axis] > 0.0 { ((axis + 1) % 3, (axis + 2) % 3) } else { ((axis + 2) % 3, (axis + 1) % 3) };
    Some((relative.iter().map(|p| DVec2::new(p[u], p[v])).collect(), rounding))
}

/// The axis along which a normal is largest.
fn largest_axis(normal: DVec3) -> usize {
    (0..3).fold(0, |best, i| if normal[i].abs() > normal[best].abs() { i } else { best })
}

/// Twice the signed area of a triangle: positive when it runs anticlockwise.
fn turn(a: DVec2, b: DVec2, c: DVec2) -> f64 {
    (b - a).perp_dot(c - a)
}

/// The triangles that clipping ears gives; none when no ear is found before three corners are left.
fn ears(points: &[DVec2]) -> Option<Vec<[usize; 3]>> {
    let count = points.len();
    let mut next: Vec<usize> = (0..count).map(|i| (i + 1) % count).collect();
    let mut previous: Vec<usize> = (0..count).map(|i| (i + count - 1) % count).collect();
    let mut triangles = Vec::with_capacity(count.saturating_sub(2));
    let mut left = count;
    let mut corner = 0;
    // Corners in a row that were no ears.
    let mut misses = 0;
    while left > 3 {
        let (before, after) = (previous[corner], next[corner]);
        // In the second round corners on a line are cut off too: they have no area, and no proper ear is left.
        let is_straight = || misses >= left && turn(points[before], points[corner], points[after]) == 0.0;
        if is_ear(points, &next, [before, corner, after]) || is_straight() {
            triangles.push([before, corner, after]);
            next[before] = after;
            previous[after] = before;
            left -= 1;
            misses = 0;
            // Going on after the neighbour spreads the cuts over the polygon instead of making a fan of slivers.
            corner = next[after];
        } else {
            misses += 1;
            if misses > 2 * left {
                return None;
            }
            corner = after;
        }
    }
    let last = [previous[corner], corner, next[corner]];
    let [a, b, c] = last.map(|i| points[i]);
    triangles.push(last);
    (turn(a, b, c) >= 0.0).then_some(triangles)
}

/// Whether the corner in the middle turns the right way and its triangle holds no other corner that is left. Corners at
/// the same place as one of the three do not count: a hole that is joined to the outline by a slit repeats two.
fn is_ear(points: &[DVec2], next: &[usize], [before, corner, after]: [usize; 3]) -> bool {
    let [a, b, c] = [before, corner, after].map(|i| points[i]);
    if turn(a, b, c) <= 0.0 {
        return false;
    }
    let mut other = next[after];
    while other != before {
        let p = points[other];
        let is_inside = turn(a, b, p) >= 0.0 && turn(b, c, p) >= 0.0 && turn(c, a, p) >= 0.0;
        if is_inside && p != a && p != b && p != c {
            return false;
        }
        other = next[other];
    }
    true
}
