//! What of a body a query met.

/// The part of a body that a query met. Vertices, edges and faces are numbered as in the shape.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct QueryFeature {
    /// Part of a compound, triangle of a mesh, point of a cloud; 0 for other shapes.
    pub part: u32,
    /// What of that part.
    pub kind: FeatureKind,
}

/// A vertex, an edge, a face or a curved surface.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[non_exhaustive]
pub enum FeatureKind {
    /// A face of a polyhedron; a half-space is face 0, a triangle too; the base of a cone is face 0, the caps of a
    /// cylinder 0 (against its axis) and 1.
    Face(u32),
    /// An edge of a polyhedron; edge `i` of a triangle runs from its corner `i` to the next; the rims of a cylinder are
    /// numbered as its caps, that of a cone is edge 0.
    Edge(u32),
    /// A vertex of a polyhedron, a corner of a triangle, the apex of a cone (vertex 0).
    Vertex(u32),
    /// A curved surface: of a sphere, capsule or torus, the side of a cylinder or cone.
    Surface,
}
