//! What a body is bounded by.

use polhode_contact::Shape;
use polhode_mesh::SolidMesh;

/// The boundary of a body, in its own frame.
#[derive(Debug, Clone)]
pub enum Geometry {
    /// A shape that collides.
    Shape(Shape),
    /// A solid mesh that need not be convex. Where it may meet another body it collides: as ground by its surface when it
    /// is fixed, else by the convex parts of its exact decomposition.
    Mesh(SolidMesh),
}

impl From<Shape> for Geometry {
    fn from(shape: Shape) -> Self {
        Self::Shape(shape)
    }
}
