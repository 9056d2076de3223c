//! Which features of two polyhedra touch, by the numbers of [`super::polyhedron::Polyhedron`].

/// A contact. Body 0 is A, body 1 is B.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Feature {
    /// A vertex of one body on a face of the other one.
    VertexFace { vertex_of: usize, vertex: usize, face: usize },
    /// An edge of A across an edge of B.
    EdgeEdge { edge_a: usize, edge_b: usize },
}
