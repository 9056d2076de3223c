//! The generalised winding number: how much of the sky around a point a surface covers, with sign.
//!
//! ```text
//! w(p) = 1 / (4 pi) sum omega_i(p)
//! ```
//!
//! with the signed solid angles of the triangles seen from p (docs/REFERENCES.md, Van Oosterom and Strackee 1983;
//! Jacobson et al. 2013). For a closed surface it is an integer but for rounding (about 1e-15 times the root of the
//! number of triangles), 1 inside and 0 outside; for a surface with holes it falls off smoothly across them, which is
//! how a broken mesh still tells inside (near 1) from outside (near 0). On the surface it is half of what lies on its
//! two sides. Cost: one arc tangent a triangle. For closed surfaces [`PointLocator`](crate::PointLocator) is exact and
//! quicker.

use crate::TriangleMesh;
use crate::nesting::solid_angle;
use crate::triangle_mesh::COORDINATE_ROUNDING;
use glam::DVec3;
use polhode_spatial::CompensatedSum;
use std::f64::consts::PI;

/// How close to the plane of a triangle a point counts as on it, in roundings of the coordinates: a point that was
/// computed to lie there is off by a few. Between 4 and 1000 only points so close are affected.
const SURFACE_ROUNDINGS: f64 = 16.0;

/// The winding number of `mesh`, which may be open, around `point` (m). NaN for a point that is not finite.
pub fn winding_number(mesh: &TriangleMesh, point: DVec3) -> f64 {
    // A triangle that holds the point takes half the sky on each side: none, in the mean.
    let largest_coordinate = mesh.bounds().largest_coordinate();
    let touch = SURFACE_ROUNDINGS * COORDINATE_ROUNDING * largest_coordinate;
    let sum: CompensatedSum = mesh.corner_positions().map(|triangle| solid_angle(triangle, point, touch)).collect();
    sum.value() / (4.0 * PI)
}
