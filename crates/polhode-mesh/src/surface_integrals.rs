//! Integrals over a surface: area, centroid, second moment, for hollow bodies of uniform wall.
//!
//! For a triangle b, c, d of area `A = |(c - b) x (d - b)| / 2` (thesis 3.2; erratum E3 confirms the last line)
//!
//! ```text
//! int dA       = A                                                            m^2
//! int r dA     = A / 3 s,                           s = b + c + d             m^3
//! int r r^T dA = A / 12 (s s^T + b b^T + c c^T + d d^T)                       m^4
//! ```
//!
//! As for volumes, the sums are compensated and about a point near the centroid. The surface need not be closed, and
//! the winding of its triangles does not matter.

use crate::moment_sums::{CentralMoments, Simplex};
use crate::triangle_mesh::TriangleMesh;
use glam::{DMat3, DVec3};

/// Integrals over a surface.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SurfaceIntegrals {
    /// `int dA`, m^2.
    pub area: f64,
    /// `int r dA / int dA` in the axes and from the origin of the mesh, m; NaN when the area is zero.
    pub centroid: DVec3,
    /// `int (r - centroid) (r - centroid)^T dA`, m^4.
    pub second_moment: DMat3,
}

impl SurfaceIntegrals {
    /// Of the triangles of `mesh`.
    pub fn of(mesh: &TriangleMesh) -> Self {
        let CentralMoments { measure, centroid, second_moment } = CentralMoments::of(mesh, Simplex::TRIANGLE);
        Self { area: measure, centroid, second_moment }
    }
}

/// Area of a triangle, m^2.
#[inline]
pub(crate) fn triangle_area([b, c, d]: [DVec3; 3]) -> f64 {
    0.5 * (c - b).cross(d - b).length()
}
