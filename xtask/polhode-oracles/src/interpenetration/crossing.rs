//! What meets what, without rounding: by signs of determinants of four points (`robust`; docs/REFERENCES.md, Shewchuk).

use glam::DVec3;
use robust::{Coord3D, orient3d};

/// A triangle by its corners, m.
pub(super) type Triangle = [DVec3; 3];

/// Sign of the volume of a tetrahedron: -1, 0 or 1.
fn sign(a: DVec3, b: DVec3, c: DVec3, d: DVec3) -> i32 {
    let [a, b, c, d] = [a, b, c, d].map(|p| Coord3D { x: p.x, y: p.y, z: p.z });
    let volume = orient3d(a, b, c, d);
    i32::from(volume > 0.0) - i32::from(volume < 0.0)
}

/// On which side of a triangle's plane points lie.
fn sides<const N: usize>([a, b, c]: Triangle, points: [DVec3; N]) -> [i32; N] {
    points.map(|point| sign(a, b, c, point))
}

/// On which sides of a line the three sides of a triangle pass it.
fn turns([from, to]: [DVec3; 2], [a, b, c]: Triangle) -> [i32; 3] {
    [sign(from, to, a, b), sign(from, to, b, c), sign(from, to, c, a)]
}

fn is_through(turns: [i32; 3]) -> bool {
    turns.iter().all(|&turn| turn >= 0) || turns.iter().all(|&turn| turn <= 0)
}

/// Whether a way goes from one side of a triangle to the other through it or its rim. The plane counts to one of the
/// sides, so that a way in two parts that ends between them on the plane goes through once.
pub(super) fn goes_through(way: [DVec3; 2], triangle: Triangle) -> bool {
    let [start, end] = sides(triangle, way);
    (start >= 0) != (end >= 0) && is_through(turns(way, triangle))
}

/// Whether two triangles have a point in common, rims included. Two that lie in one plane, and a side that lies in the
/// plane of the other triangle, count only by what reaches out of the plane: their neighbours in a surface, or nothing.
pub(super) fn meet(first: Triangle, second: Triangle) -> bool {
    let is_apart = |sides: [i32; 3]| sides.iter().all(|&side| side > 0) || sides.iter().all(|&side| side < 0);
    let of_second = sides(first, second);
    if is_apart(of_second) {
        return false;
    }
    let of_first = sides(second, first);
    !is_apart(of_first) && (reaches(second, of_second, first) || reaches(first, of_first, second))
}

/// Whether a side of a triangle with its corners on these sides of the other one's plane meets the other one.
fn reaches(corners: Triangle, sides: [i32; 3], other: Triangle) -> bool {
    (0..3).any(|k| {
        let next = (k + 1) % 3;
        let crosses_plane = sides[k] * sides[next] <= 0 && (sides[k] != 0 || sides[next] != 0);
        crosses_plane && is_through(turns([corners[k], corners[next]], other))
    })
}

/// How often a way crosses these triangles; nothing when it meets a side or a corner, or begins or ends on one.
pub(super) fn crossings(way: [DVec3; 2], triangles: impl Iterator<Item = Triangle>) -> Option<usize> {
    let mut count = 0;
    for triangle in triangles {
        let [start, end] = sides(triangle, way);
        if start * end > 0 {
            continue;
        }
        let turns = turns(way, triangle);
        if is_through(turns) {
            if start == 0 || end == 0 || turns.contains(&0) {
                return None;
            }
            count += 1;
        }
    }
    Some(count)
}

#[cfg(test)]
mod tests {
    //! Ways through a triangle, its rim and past it; triangles that meet, touch and do not.
    use super::*;

    const TRIANGLE: Triangle = [DVec3::ZERO, DVec3::X, DVec3::Y];

    #[test]
    fn a_way_through_a_triangle_or_its_rim_is_found_and_one_beside_it_is_not() {
        let down = |x: f64, y: f64| [DVec3::new(x, y, 1.0), DVec3::new(x, y, -1.0)];
        assert!(goes_through(down(0.25, 0.25), TRIANGLE));
        assert!(goes_through(down(0.5, 0.5), TRIANGLE));
        assert!(!goes_through(down(0.75, 0.75), TRIANGLE));
        assert!(!goes_through([DVec3::new(0.25, 0.25, 2.0), DVec3::new(0.25, 0.25, 1.0)], TRIANGLE));
        let [from, to] = down(0.25, 0.25);
        let between = from.midpoint(to);
        assert!(goes_through([from, between], TRIANGLE) != goes_through([between, to], TRIANGLE));
    }

    #[test]
    fn triangles_meet_by_a_corner_and_not_above_it() {
        let standing = |height: f64| {
            let foot = DVec3::new(0.2, 0.2, height);
            [foot, foot + DVec3::new(1.0, 0.0, 1.0), foot + DVec3::new(0.0, 1.0, 1.0)]
        };
        assert!(meet(TRIANGLE, standing(0.0)) && meet(standing(0.0), TRIANGLE));
        assert!(meet(TRIANGLE, standing(-1e-300)));
        assert!(!meet(TRIANGLE, standing(1e-300)));
        assert!(!meet(TRIANGLE, standing(-0.9)), "the plane is met beside the triangle");
    }

    #[test]
    fn a_way_that_meets_a_side_has_no_count() {
        let down = |x: f64, y: f64| [DVec3::new(x, y, 1.0), DVec3::new(x, y, -1.0)];
        let count = |x, y| crossings(down(x, y), [TRIANGLE].into_iter());
        assert_eq!([count(0.25, 0.25), count(0.75, 0.75), count(0.5, 0.5)], [Some(1), Some(0), None]);
    }
}
