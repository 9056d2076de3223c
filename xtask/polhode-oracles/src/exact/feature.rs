//! Which features of two polyhedra touch, by the numbers of [`super::polyhedron::Polyhedron`].

/// A contact. Body 0 is A, body 1 is B.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Feature {
    /// A vertex of one body on a face of the other one.
    VertexFace {
        /// The body of the vertex, 0 or 1.
        vertex_of: usize,
        /// Number of the vertex.
        vertex: usize,
        /// Number of the face of the other body.
        face: usize,
    },
    /// An edge of A across an edge of B.
    EdgeEdge {
        /// Number of the edge of A.
        edge_a: usize,
        /// Number of the edge of B.
        edge_b: usize,
    },
}
