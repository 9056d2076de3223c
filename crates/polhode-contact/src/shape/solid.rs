//! Solids of any form as shapes: a convex polyhedron, or the compound of an exact decomposition into convex parts.
//!
//! A decomposition cuts off slivers, whose faces differ by less than the tolerance up to which faces are merged. They
//! are kept exactly, with their faces as they are. A part that is thinner than the rounding of the solid's coordinates,
//! or flat within the tolerance of polyhedra, is omitted: its neighbours on both sides touch within that.

use super::{Compound, Shape, ShapeError, hull};
use crate::ConvexPolyhedron;
use polhode_mesh::{ConvexSolid, DecompositionSettings, SolidMesh, convex_decomposition};

/// Rounding of a vertex that a cut has made, in epsilons of the largest coordinate: up to this distance a decomposition
/// takes vertices to lie in a plane.
const CUT_ROUNDINGS: f64 = 16.0;

/// Comparisons after which a mesh counts as too fine for exact parts: some six seconds' work, at 7e7 to 9e7 a second
/// (optimised build, bumpy spheres of 5,000 to 330,000 triangles). Such a sphere of 5,000 triangles needs nearly all of
/// it, a real part of 5,000 triangles, most of them on its hull, a small share.
const MOST_COMPARISONS: u64 = 400_000_000;

impl Shape {
    /// The solid that a mesh bounds: a polyhedron when it is convex, else a compound of convex parts that fill it
    /// exactly (docs/REFERENCES.md, Chazelle 1984). Parts that are flat within the tolerance of polyhedra are omitted.
    ///
    /// # Errors
    /// When it needs too many parts or too much work, none of them is thick enough, or one of them has no polyhedron.
    pub fn solid(mesh: &SolidMesh) -> Result<Self, ShapeError> {
        if let Ok(polyhedron) = ConvexPolyhedron::from_mesh(mesh) {
            return Ok(Self::Convex(polyhedron));
        }
        let settings = DecompositionSettings { max_comparisons: MOST_COMPARISONS, ..DecompositionSettings::default() };
        Self::of_convex_parts(&convex_decomposition(mesh, settings)?.parts)
    }

    /// The compound of the convex parts of a solid. Parts that are flat within the tolerance of polyhedra are omitted.
    ///
    /// # Errors
    /// When none of them is thick enough, or one of them has no polyhedron.
    pub fn of_convex_parts(parts: &[ConvexSolid]) -> Result<Self, ShapeError> {
        let largest = parts.iter().map(|part| part.mesh().bounds().largest_coordinate()).fold(0.0, f64::max);
        let rounding = CUT_ROUNDINGS * f64::EPSILON * largest;
        let mut shapes = Vec::with_capacity(parts.len());
        for (index, part) in parts.iter().enumerate() {
            match polyhedron_of_part(part, rounding) {
                Ok(polyhedron) => shapes.push(Self::Convex(polyhedron)),
                Err(ShapeError::Flat { .. } | ShapeError::TooSmall { .. }) => {}
                Err(error) => {
                    let bounds = part.mesh().bounds();
                    return Err(ShapeError::Part {
                        part: index + 1,
                        parts: parts.len(),
                        at: bounds.center(),
                        size: bounds.diagonal(),
                        reason: Box::new(error),
                    });
                }
            }
        }
        Compound::new(shapes).map(Self::Compound)
    }
}

/// A part with faces of one plane merged; where that leaves no polyhedron, with its faces as they are.
fn polyhedron_of_part(part: &ConvexSolid, rounding: f64) -> Result<ConvexPolyhedron, ShapeError> {
    let merged = ConvexPolyhedron::from_mesh(part.solid());
    match merged {
        Ok(_) | Err(ShapeError::Flat { .. } | ShapeError::TooSmall { .. }) => merged,
        Err(_) => hull::exact(part.mesh().vertices(), rounding),
    }
}
