//! Boxes: edges a, b, c; moments about x, the others by turns.
//!
//! | body | moment |
//! |---|---|
//! | solid | `m (b^2 + c^2) / 12` |
//! | hollow | `m ((b^2 + c^2) bc + (c^2 + 3 b^2) ca + (b^2 + 3 c^2) ab) / (12 (ab + bc + ca))` |
//!
//! A hollow box is its six faces: two across x at no distance along y and z, two across y at b/2, two across z at c/2.

use super::uniform::Uniform;
use super::{PrimitiveError, Refinement};
use crate::triangle_mesh::TriangleMesh;
use crate::{Amount, SolidMesh};
use glam::DVec3;
use polhode_spatial::MassProperties;

/// A box about the origin, edges along the axes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Cuboid {
    size: DVec3,
}

impl Cuboid {
    /// With full edges `size`, m.
    ///
    /// # Errors
    /// [`PrimitiveError::Size`] when an edge is not positive and finite.
    pub fn new(size: DVec3) -> Result<Self, PrimitiveError> {
        if size.cmpgt(DVec3::ZERO).all() && size.is_finite() {
            Ok(Self { size })
        } else {
            Err(PrimitiveError::Size(size))
        }
    }

    /// Filled with matter, from its density (kg/m^3) or mass.
    ///
    /// # Errors
    /// [`PrimitiveError::MassProperties`] when mass or inertia over- or underflow.
    pub fn solid(&self, amount: impl Into<Amount>) -> Result<MassProperties, PrimitiveError> {
        let s2 = self.size * self.size;
        let moments = DVec3::new(s2.y + s2.z, s2.z + s2.x, s2.x + s2.y) / 12.0;
        Uniform::centered(self.size.element_product(), moments).body(amount)
    }

    /// All its mass in its faces, from its density (kg/m^2) or mass.
    ///
    /// # Errors
    /// As [`Cuboid::solid`].
    pub fn hollow(&self, amount: impl Into<Amount>) -> Result<MassProperties, PrimitiveError> {
        let size = self.size;
        let s2 = size * size;
        // Area of one face across each axis.
        let faces = DVec3::new(size.y * size.z, size.z * size.x, size.x * size.y);
        let half_area = faces.x + faces.y + faces.z;
        let moment = |i: usize| {
            let (j, k) = ((i + 1) % 3, (i + 2) % 3);
            let across_i = (s2[j] + s2[k]) * faces[i];
            let across_j = (s2[k] + 3.0 * s2[j]) * faces[j];
            let across_k = (s2[j] + 3.0 * s2[k]) * faces[k];
            (across_i + across_j + across_k) / (12.0 * half_area)
        };
        Uniform::centered(2.0 * half_area, DVec3::new(moment(0), moment(1), moment(2))).body(amount)
    }

    /// Its mesh: 8 vertices, 12 triangles, whatever the refinement, because it is exact.
    ///
    /// # Errors
    /// [`PrimitiveError::Mesh`] when it is so thin that it is flat to rounding.
    pub fn mesh(&self, _refinement: Refinement) -> Result<SolidMesh, PrimitiveError> {
        // Vertex i lies on the positive side of axis k when bit k of i is set.
        let side = |i: u32, axis: u32| if i >> axis & 1 == 1 { 0.5 } else { -0.5 };
        let vertices = (0..8).map(|i| self.size * DVec3::new(side(i, 0), side(i, 1), side(i, 2))).collect();
        let faces = [[0, 4, 6, 2], [1, 3, 7, 5], [0, 1, 5, 4], [2, 6, 7, 3], [0, 2, 3, 1], [4, 5, 7, 6]];
        let triangles = faces.iter().flat_map(|&[a, b, c, d]| [[a, b, c], [a, c, d]]).collect();
        Ok(SolidMesh::new(TriangleMesh::new(vertices, triangles)?)?)
    }
}

/// A solid box with full edges `size` (m), from its density (kg/m^3) or mass: [`Cuboid::solid`].
///
/// # Errors
/// [`PrimitiveError`] when `size` is not positive and finite, or mass or inertia over- or underflow.
pub fn solid_box(size: DVec3, amount: impl Into<Amount>) -> Result<MassProperties, PrimitiveError> {
    Cuboid::new(size)?.solid(amount)
}

/// A hollow box with full edges `size` (m), from its density (kg/m^2) or mass: [`Cuboid::hollow`].
///
/// # Errors
/// As [`solid_box`].
pub fn hollow_box(size: DVec3, amount: impl Into<Amount>) -> Result<MassProperties, PrimitiveError> {
    Cuboid::new(size)?.hollow(amount)
}

/// The mesh of a box with full edges `size` (m): [`Cuboid::mesh`].
///
/// # Errors
/// [`PrimitiveError::Size`] when an edge is not positive and finite, [`PrimitiveError::Mesh`] when it is so thin beside
/// the others that the box is flat to rounding.
pub fn box_mesh(size: DVec3) -> Result<SolidMesh, PrimitiveError> {
    Cuboid::new(size)?.mesh(Refinement::COARSEST)
}
