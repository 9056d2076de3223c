//! The feature of a body that a query found.

use crate::SurfaceFeature;

/// A feature of a body, as a query names it.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct QueryFeature {
    /// Part of a compound, triangle of a mesh, point of a cloud; 0 for other shapes.
    pub part: u32,
    /// The feature of that part, numbered as in the part. Of a triangle: face 0, vertex `i` at its corner `i`, and edge
    /// `i` from there to the next corner.
    pub surface: SurfaceFeature,
}
