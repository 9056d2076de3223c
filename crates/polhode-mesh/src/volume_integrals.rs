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
//! moment of 3.4 comes out as -3045). Here the first pass goes about the middle of the bounding box, the second about
//! the centroid that the first has found, and every sum is compensated; so no difference of large numbers is ever
//! formed, and the result moves with the mesh. What remains is the rounding of the coordinates themselves.
//! Fails by NaN or infinity when coordinates beyond about 1e60 m overflow; [`SolidMesh`](crate::SolidMesh) refuses it.

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
        let reference = mesh.bounds().center();
        let (mut six_volume, mut first) = (CompensatedSum::ZERO, VectorSum::default());
        for corners in mesh.corner_positions() {
            let [b, c, d] = corners.map(|p| p - reference);
            let det = determinant([b, c, d]);
            six_volume.add(det);
            first.add(det * (b + c + d));
        }
        let six_volume = six_volume.value();
        // int r dV / int dV = (sum D s / 24) / (sum D / 6).
        let local_centroid = first.value() / (4.0 * six_volume);
        let mut second = SymmetricSum::default();
        for corners in mesh.corner_positions() {
            let corners = corners.map(|p| (p - reference) - local_centroid);
            second.add_simplex(determinant(corners), corners);
        }
        Self {
            volume: six_volume / 6.0,
            centroid: reference + local_centroid,
            second_moment: second.value() * (1.0 / 120.0),
        }
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

/// Compensated sum of vectors.
#[derive(Default)]
pub(crate) struct VectorSum([CompensatedSum; 3]);

impl VectorSum {
    pub(crate) fn add(&mut self, term: DVec3) {
        for (sum, x) in self.0.iter_mut().zip(term.to_array()) {
            sum.add(x);
        }
    }

    pub(crate) fn value(&self) -> DVec3 {
        DVec3::from_array(self.0.map(|sum| sum.value()))
    }
}

/// Compensated sum of symmetric matrices; only the six different elements are summed.
#[derive(Default)]
pub(crate) struct SymmetricSum {
    diagonal: VectorSum,
    /// Elements yz, xz, xy.
    off_diagonal: VectorSum,
}

impl SymmetricSum {
    /// Adds `weight (s s^T + b b^T + c c^T + d d^T)` with `s = b + c + d`: the second moment of a triangle, and of the
    /// tetrahedron between it and the origin, up to a factor.
    pub(crate) fn add_simplex(&mut self, weight: f64, [b, c, d]: [DVec3; 3]) {
        let s = b + c + d;
        self.diagonal.add(weight * (s * s + b * b + c * c + d * d));
        let cross = |v: DVec3| DVec3::new(v.y * v.z, v.x * v.z, v.x * v.y);
        self.off_diagonal.add(weight * (cross(s) + cross(b) + cross(c) + cross(d)));
    }

    pub(crate) fn value(&self) -> DMat3 {
        let (d, o) = (self.diagonal.value(), self.off_diagonal.value());
        DMat3::from_cols(DVec3::new(d.x, o.z, o.y), DVec3::new(o.z, d.y, o.x), DVec3::new(o.y, o.x, d.z))
    }
}
