//! Defects: what can be wrong with a mesh, how often and where first, and which mend is offered.

use crate::mend::Repair;
use std::fmt;

/// What can be wrong with a mesh.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[non_exhaustive]
pub enum DefectKind {
    /// An edge of one triangle only: the surface has a hole or ends there.
    OpenEdge,
    /// An edge of three or more triangles.
    NonManifoldEdge,
    /// An edge that its two triangles run along in the same direction: one of them is the wrong way round.
    InconsistentWinding,
    /// A closed component that faces into the material: negative volume, or positive inside another component.
    Inverted,
    /// A triangle without area: it names a vertex twice, or its corners lie on a line to rounding. Harmless.
    DegenerateTriangle,
    /// A triangle with the corners of an earlier one in the same direction: it makes edges of more than two triangles.
    DuplicateTriangle,
    /// A vertex that no triangle uses. Harmless.
    UnusedVertex,
    /// A vertex at exactly the position of an earlier one. Harmless in itself, and often the reason for open edges.
    DuplicateVertex,
}

/// The first place of a defect: indices into the arrays of the mesh, counted from 0.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub enum Location {
    /// An edge, in the direction in which the triangle runs along it.
    Edge {
        /// Where the triangle's edge begins.
        from: u32,
        /// Where it ends.
        to: u32,
        /// The triangle.
        triangle: u32,
    },
    /// A triangle.
    Triangle(u32),
    /// A connected component.
    Component {
        /// Its first triangle.
        first_triangle: u32,
        /// Number of its triangles.
        triangles: usize,
        /// Its signed volume, m^3.
        volume: f64,
    },
    /// A vertex.
    Vertex(u32),
    /// A triangle and the earlier one that it repeats.
    TrianglePair {
        /// The triangle.
        triangle: u32,
        /// The earlier one.
        earlier: u32,
    },
    /// A vertex and the earlier one that it repeats.
    VertexPair {
        /// The vertex.
        vertex: u32,
        /// The earlier one.
        earlier: u32,
    },
}

/// One kind of defect with its number and its first place.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Defect {
    /// What.
    pub kind: DefectKind,
    /// How often.
    pub count: usize,
    /// Where first, by triangle or vertex.
    pub location: Location,
}

impl Defect {
    /// The repair that is offered for it.
    pub const fn repair(&self) -> Option<Repair> {
        self.kind.repair()
    }
}

impl DefectKind {
    /// Whether a mesh with this defect bounds no solid; the others are harmless to mass properties.
    pub const fn prevents_solid(self) -> bool {
        matches!(self, Self::OpenEdge | Self::NonManifoldEdge | Self::InconsistentWinding | Self::Inverted)
    }

    /// The repair that is offered: what may mend it, though [`repair`](crate::repair::repair) may find that it cannot.
    /// Open edges of a mesh with duplicate vertices are first of all a matter of welding.
    pub const fn repair(self) -> Option<Repair> {
        match self {
            Self::OpenEdge => Some(Repair::FillHoles),
            Self::NonManifoldEdge => None,
            Self::InconsistentWinding | Self::Inverted => Some(Repair::Flip),
            Self::DegenerateTriangle => Some(Repair::DropDegenerate),
            Self::DuplicateTriangle => Some(Repair::DropDuplicates),
            Self::UnusedVertex => Some(Repair::DropUnused),
            Self::DuplicateVertex => Some(Repair::Weld),
        }
    }

    /// A name for files and programs.
    pub const fn name(self) -> &'static str {
        match self {
            Self::OpenEdge => "open_edge",
            Self::NonManifoldEdge => "non_manifold_edge",
            Self::InconsistentWinding => "inconsistent_winding",
            Self::Inverted => "inverted",
            Self::DegenerateTriangle => "degenerate_triangle",
            Self::DuplicateTriangle => "duplicate_triangle",
            Self::UnusedVertex => "unused_vertex",
            Self::DuplicateVertex => "duplicate_vertex",
        }
    }

    /// The name in a sentence, for one and for several.
    const fn words(self) -> (&'static str, &'static str) {
        match self {
            Self::OpenEdge => ("open edge", "open edges"),
            Self::NonManifoldEdge => ("edge of more than two triangles", "edges of more than two triangles"),
            Self::InconsistentWinding => ("edge with inconsistent winding", "edges with inconsistent winding"),
            Self::Inverted => ("inverted component", "inverted components"),
            Self::DegenerateTriangle => ("degenerate triangle", "degenerate triangles"),
            Self::DuplicateTriangle => ("duplicate triangle", "duplicate triangles"),
            Self::UnusedVertex => ("unused vertex", "unused vertices"),
            Self::DuplicateVertex => ("duplicate vertex", "duplicate vertices"),
        }
    }
}

impl fmt::Display for DefectKind {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.words().0)
    }
}

impl fmt::Display for Location {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Edge { from, to, triangle } => write!(f, "edge {from}-{to} of triangle {triangle}"),
            Self::Triangle(triangle) => write!(f, "triangle {triangle}"),
            Self::Component { first_triangle, triangles, volume } => {
                write!(f, "the component of triangle {first_triangle} ({triangles} triangles, volume {volume} m^3)")
            }
            Self::TrianglePair { triangle, earlier } => {
                write!(f, "triangle {triangle}, which repeats triangle {earlier}")
            }
            Self::Vertex(vertex) => write!(f, "vertex {vertex}"),
            Self::VertexPair { vertex, earlier } => write!(f, "vertex {vertex}, which repeats vertex {earlier}"),
        }
    }
}

impl fmt::Display for Defect {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (one, several) = self.kind.words();
        write!(f, "{} {}, first: {}", self.count, if self.count == 1 { one } else { several }, self.location)
    }
}
