//! Solids of any form as shapes: a convex polyhedron, or the compound of an exact decomposition into convex parts.

use super::{Compound, Shape, ShapeError};
use crate::ConvexPolyhedron;
use polhode_mesh::{DecompositionSettings, SolidMesh, convex_decomposition};

impl Shape {
    /// The solid that a mesh bounds: a polyhedron when it is convex, else a compound of convex parts that fill it
    /// exactly (docs/REFERENCES.md, Chazelle 1984). Parts that are flat within the tolerance of polyhedra are omitted.
    ///
    /// # Errors
    /// When it needs too many parts, or none of them is thick enough.
    pub fn solid(mesh: &SolidMesh) -> Result<Self, ShapeError> {
        if let Ok(polyhedron) = ConvexPolyhedron::from_mesh(mesh) {
            return Ok(Self::Convex(polyhedron));
        }
        let mut parts = Vec::new();
        for part in convex_decomposition(mesh, DecompositionSettings::default())?.parts {
            match ConvexPolyhedron::from_mesh(part.solid()) {
                Ok(polyhedron) => parts.push(Self::Convex(polyhedron)),
                Err(ShapeError::Flat { .. } | ShapeError::TooSmall { .. }) => {}
                Err(error) => return Err(error),
            }
        }
        Compound::new(parts).map(Self::Compound)
    }
}
