//! Integrals over the solid that a closed surface bounds: volume, centroid, second moment.
//!
//! The solid is the signed sum of the tetrahedra between a reference point and each triangle b, c, d (thesis 3.2,
//! Figures 9 and 10); with the reference point as origin and `D = b . (c x d)`
//!
//! ```text
//! int dV       = D / 6                                                        m^3
//! int r dV     = D / 24 s,                          s = b + c + d             m^4
//! int r r^T dV = D / 120 (s s^T + b b^T + c c^T + d d^T)                      m^5
//! ```
//!
//! (thesis 3.2, with errata E1 and E2: its `int p^2` over the unit tetrahedron is 1/60, the last formula is right.)
//!
//! The thesis takes the origin of the file as the reference, which is ruinous far from it (erratum E5: at 1e6 m a
//! moment of 3.4 comes out as -3045). Here the sums are formed about the middle of the bounding box, compensated, and
//! once more about the centroid where the shift to it would cancel digits; so no difference of large numbers is ever
//! formed, and the result moves with the mesh. What remains is the rounding of the coordinates themselves.
//! Fails by NaN or infinity when coordinates beyond about 1e60 m overflow; [`SolidMesh`](crate::SolidMesh) refuses it.

use crate::moment_sums::{CentralMoments, Simplex};
use crate::triangle_mesh::{COORDINATE_ROUNDING, TriangleMesh};
use glam::{DMat3, DVec3};
use polhode_spatial::CompensatedSum;

/// Integrals over a solid.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct VolumeIntegrals {
    /// `int dV`, m^3; negative when the surface is inside out.
    pub volume: f64,
    /// `int r dV / int dV` in the axes and from the origin of the mesh, m.
    pub centroid: DVec3,
    /// `int (r - centroid) (r - centroid)^T dV`, m^5.
    pub second_moment: DMat3,
}

impl VolumeIntegrals {
    /// Of the region that `mesh` bounds. Meaningful for a closed surface only, which
    /// [`SolidMesh::volume_integrals`](crate::SolidMesh::volume_integrals) guarantees.
    pub fn of(mesh: &TriangleMesh) -> Self {
        let CentralMoments { measure, centroid, second_moment } = CentralMoments::of(mesh, Simplex::TETRAHEDRON);
        Self { volume: measure, centroid, second_moment }
    }
}

/// Signed volume (m^3) that some triangles enclose, about a reference point near them.
pub(crate) fn signed_volume(corners: impl IntoIterator<Item = [DVec3; 3]>, reference: DVec3) -> f64 {
    let sum: CompensatedSum =
        corners.into_iter().map(|triangle| determinant(triangle.map(|p| p - reference))).collect();
    sum.value() / 6.0
}

/// Largest volume (m^3) that rounding of the coordinates can give a flat surface: its area moved by one rounding.
pub(crate) fn volume_rounding(area: f64, largest_coordinate: f64) -> f64 {
    COORDINATE_ROUNDING * largest_coordinate * area
}

/// `b . (c x d)`, formed from the edges: for a small triangle far from the reference point the edges are exact and
/// the products do not cancel.
fn determinant([b, c, d]: [DVec3; 3]) -> f64 {
    b.dot((c - b).cross(d - b))
}
