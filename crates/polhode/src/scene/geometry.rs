//! The shape of a body: a collision shape, or a solid mesh.

use polhode_contact::Shape;
use polhode_mesh::SolidMesh;

/// The boundary of a body, in its own frame.
#[derive(Debug, Clone)]
pub enum Geometry {
    /// A collision shape.
    Shape(Shape),
    /// A solid mesh that need not be convex. If the body may collide, its collision shape is the mesh itself when it is
    /// convex, the surface of the mesh when no force moves the body, and else the convex parts of its exact
    /// decomposition.
    Mesh(SolidMesh),
}

/// How well convex parts fill a mesh that they stand for in collisions. Mass is that of the mesh itself.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ApproximateParts {
    /// How many parts there are.
    pub parts: usize,
    /// Difference of their volume from that of the solid, relative to it.
    pub volume_error: f64,
}

impl From<Shape> for Geometry {
    fn from(shape: Shape) -> Self {
        Self::Shape(shape)
    }
}
