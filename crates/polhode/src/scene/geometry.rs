//! What a body is bounded by.

use polhode_contact::Shape;
use polhode_mesh::SolidMesh;

/// The boundary of a body, in its own frame.
#[derive(Debug, Clone)]
pub enum Geometry {
    /// A shape that collides.
    Shape(Shape),
    /// A solid mesh that need not be convex. It gives mass properties; it cannot collide yet, so a scene in which it
    /// could meet another body is refused.
    Mesh(SolidMesh),
}

impl From<Shape> for Geometry {
    fn from(shape: Shape) -> Self {
        Self::Shape(shape)
    }
}
