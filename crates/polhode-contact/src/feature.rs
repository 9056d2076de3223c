//! Which features of two bodies touch: the persistent identity of a contact.
//!
//! The identity depends on the features alone, not on the pose: the same vertex on the same face is the same contact
//! one step later. The kinds are those of thesis 3.3 (end): vertex-face and edge-edge, and what smooth shapes add.
//! Vertices, edges and faces are numbered as in the shape ([`crate::ConvexPolyhedron`]); a half-space is face 0; the
//! points of a cloud are vertices; the centre of a sphere is centre 0. A compound numbers the features of its parts one
//! part after the other; centres are counted as vertices, and a part that is a sphere is named by the vertex number of
//! its centre. The flat patch `p` of a triangle mesh is face `2 p` seen from outside and face `2 p + 1` seen from
//! inside. [`crate::shape::round`] lists the features of capsules, cylinders, cones and tori.

/// One of the two bodies of a pair.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Side {
    /// The first body, towards which normals point.
    A,
    /// The second body.
    B,
}

impl Side {
    /// The other body.
    pub const fn other(self) -> Self {
        match self {
            Self::A => Self::B,
            Self::B => Self::A,
        }
    }

    /// The position of the body in arrays of a pair: 0 for A, 1 for B.
    pub(crate) const fn index(self) -> usize {
        match self {
            Self::A => 0,
            Self::B => 1,
        }
    }
}

/// A feature of a surface: one of the two that make a contact, or the one that a query found.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum SurfaceFeature {
    /// A face of a polyhedron, a disc, a side of a patch of a mesh, or face 0 of a half-space.
    Face(u32),
    /// An edge of a polyhedron or a mesh.
    Edge(u32),
    /// A vertex of a polyhedron or a mesh, a point of a cloud, a cone's apex, a sample point of a rim or a torus.
    Vertex(u32),
    /// The surface of a sphere.
    Sphere,
    /// The hemisphere at an end of a capsule.
    Cap(u32),
    /// The side of a capsule, cylinder or cone.
    Side(u32),
    /// The rim of a disc, at its nearest point; or the centre circle of a torus.
    Rim(u32),
    /// The rim of a disc that lies almost flat on the other body, at the point where an edge, followed in its own
    /// direction, leaves the disc. Against another rim: where that rim, followed anticlockwise about the outward normal
    /// of its disc, leaves this disc. Of a torus: the point of its centre circle nearest to an edge, a side or another
    /// circle, on the half towards which the edge or axis points.
    RimExit(u32),
    /// The same where the edge or the other rim enters the disc, and on the other half of a torus.
    RimEntry(u32),
}

impl SurfaceFeature {
    /// Its number among those of its kind.
    pub(crate) const fn number(self) -> u32 {
        match self {
            Self::Face(n)
            | Self::Edge(n)
            | Self::Vertex(n)
            | Self::Cap(n)
            | Self::Side(n)
            | Self::Rim(n)
            | Self::RimExit(n)
            | Self::RimEntry(n) => n,
            Self::Sphere => 0,
        }
    }
}

/// Which features touch.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum ContactFeature {
    /// A vertex of one body on a face of the other.
    VertexFace {
        /// The body that owns the vertex; the other one owns the face.
        vertex_of: Side,
        /// The vertex.
        vertex: u32,
        /// The face.
        face: u32,
    },
    /// An edge of A across an edge of B.
    EdgeEdge {
        /// Edge of A.
        edge_a: u32,
        /// Edge of B.
        edge_b: u32,
    },
    /// A sphere, a cap of a capsule, or a point of a cloud beyond a face's border, against the nearest feature of the
    /// other body.
    Smooth {
        /// The body that owns the centre; the other one owns the surface.
        center_of: Side,
        /// Index of the centre: 0 for a sphere, the cap's index for a capsule, the point's index for a cloud.
        center: u32,
        /// The nearest feature of the other body.
        against: SurfaceFeature,
    },
    /// Two spheres.
    SphereSphere,
    /// Two spheres, at least one of them a part of a compound, by the numbers of their centres.
    Spheres {
        /// Centre of A's sphere.
        center_a: u32,
        /// Centre of B's sphere.
        center_b: u32,
    },
    /// Any other two features.
    Elements {
        /// Feature of A.
        a: SurfaceFeature,
        /// Feature of B.
        b: SurfaceFeature,
    },
}

impl ContactFeature {
    /// The same contact with A and B swapped.
    pub const fn swapped(self) -> Self {
        match self {
            Self::VertexFace { vertex_of, vertex, face } => {
                Self::VertexFace { vertex_of: vertex_of.other(), vertex, face }
            }
            Self::EdgeEdge { edge_a, edge_b } => Self::EdgeEdge { edge_a: edge_b, edge_b: edge_a },
            Self::Smooth { center_of, center, against } => {
                Self::Smooth { center_of: center_of.other(), center, against }
            }
            Self::SphereSphere => Self::SphereSphere,
            Self::Spheres { center_a, center_b } => Self::Spheres { center_a: center_b, center_b: center_a },
            Self::Elements { a, b } => Self::Elements { a: b, b: a },
        }
    }
}
