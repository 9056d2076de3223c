//! Exact signs: on which side of a line or plane a point lies, for the coordinates as they are in memory.
//!
//! Shewchuk's adaptive predicates (docs/REFERENCES.md, Shewchuk 1997), in the `robust` crate: a determinant in plain
//! f64 with a bound on its error, computed to more digits only when its sign is in doubt. They are exact unless a
//! product of coordinates over- or underflows, so points are first brought near one by [`unit_scale`], a power of two.

use glam::{DVec2, DVec3};
use robust::{Coord, Coord3D};

/// Side of the plane of a, b, c that `point` lies on: positive in front (where a, b, c run anticlockwise), negative
/// behind, zero on it. The magnitude is about the determinant `(b - a) x (c - a) . (point - a)`, m^3.
pub(crate) fn side_of_plane([a, b, c]: [DVec3; 3], point: DVec3) -> f64 {
    // Shewchuk's determinant is positive when the fourth point lies behind.
    -robust::orient3d(coord3(a), coord3(b), coord3(c), coord3(point))
}

/// Side of the line from a to b that `point` lies on: positive on the left, negative on the right, zero on it.
pub(crate) fn side_of_line(a: DVec2, b: DVec2, point: DVec2) -> f64 {
    robust::orient2d(coord2(a), coord2(b), coord2(point))
}

/// Whether three points lie on one line: their projections along the three axes do.
pub(crate) fn are_collinear(a: DVec3, b: DVec3, c: DVec3) -> bool {
    (0..3).all(|axis| {
        let [a, b, c] = [a, b, c].map(|p| drop_axis(p, axis));
        side_of_line(a, b, c) == 0.0
    })
}

/// The two coordinates after `axis`, in cyclic order: the projection along that axis, seen from its positive end.
pub(crate) fn drop_axis(p: DVec3, axis: usize) -> DVec2 {
    match axis {
        0 => DVec2::new(p.y, p.z),
        1 => DVec2::new(p.z, p.x),
        _ => DVec2::new(p.x, p.y),
    }
}

/// The power of two that brings a largest coordinate into [1/2, 1): multiplying by it rounds nothing that matters.
pub(crate) fn unit_scale(largest_coordinate: f64) -> f64 {
    /// Exponents whose power of two is a normal number, with room to spare.
    const EXPONENTS: i32 = 1000;
    if largest_coordinate > 0.0 && largest_coordinate.is_finite() {
        libm::scalbn(1.0, (-libm::frexp(largest_coordinate).1).clamp(-EXPONENTS, EXPONENTS))
    } else {
        1.0
    }
}

fn coord3(p: DVec3) -> Coord3D<f64> {
    Coord3D { x: p.x, y: p.y, z: p.z }
}

fn coord2(p: DVec2) -> Coord<f64> {
    Coord { x: p.x, y: p.y }
}
