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
//! As for volumes, the first pass goes about the middle of the bounding box, the second about the centroid, and the
//! sums are compensated. The surface need not be closed, and the winding of its triangles does not matter.

use crate::triangle_mesh::TriangleMesh;
use crate::volume_integrals::{SymmetricSum, VectorSum};
use glam::{DMat3, DVec3};
use polhode_spatial::CompensatedSum;

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
        let reference = mesh.bounds().center();
        let (mut area, mut first) = (CompensatedSum::ZERO, VectorSum::default());
        for corners in mesh.corner_positions() {
            let [b, c, d] = corners.map(|p| p - reference);
            let weight = triangle_area([b, c, d]);
            area.add(weight);
            first.add(weight * (b + c + d));
        }
        let area = area.value();
        let local_centroid = first.value() / (3.0 * area);
        let mut second = SymmetricSum::default();
        for corners in mesh.corner_positions() {
            let corners = corners.map(|p| (p - reference) - local_centroid);
            second.add_simplex(triangle_area(corners), corners);
        }
        Self { area, centroid: reference + local_centroid, second_moment: second.value() * (1.0 / 12.0) }
    }
}

/// Area of a triangle, m^2.
pub(crate) fn triangle_area([b, c, d]: [DVec3; 3]) -> f64 {
    0.5 * (c - b).cross(d - b).length()
}
