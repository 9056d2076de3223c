//! Diagnosis: what keeps a mesh from being a solid, how often, and where first.
//!
//! A surface bounds a solid when every edge belongs to exactly two triangles that run along it in opposite directions,
//! and every closed component faces away from the material (thesis 3.2: the boundary parts space into inside and
//! outside). Orientation is judged component by component: a component of negative volume inside another is a void.

use crate::nesting::inverted_components;
use crate::repair::Repair;
use crate::topology::{EdgeKind, EdgeUse, Topology, names_vertex_twice, smallest_first};
use crate::triangle_mesh::{COORDINATE_ROUNDING, TriangleMesh};
use crate::weld::equal_positions;
use glam::DVec3;
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

/// The defects of a mesh, at most one entry a kind, in the order of [`DefectKind`].
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Diagnosis {
    /// The defects.
    pub defects: Vec<Defect>,
}

/// Looks for every kind of defect. Time grows as n log n in the number of triangles, but for meshes of many nested
/// components, where every component costs one pass over those that its bounding box lies in.
///
/// ```
/// use polhode_mesh::{DVec3, DefectKind, TriangleMesh, diagnose};
/// let sheet = TriangleMesh::new(vec![DVec3::ZERO, DVec3::X, DVec3::Y], vec![[0, 1, 2]])?;
/// let diagnosis = diagnose(&sheet);
/// assert!(!diagnosis.is_solid());
/// assert_eq!(diagnosis.get(DefectKind::OpenEdge).map(|defect| defect.count), Some(3));
/// assert_eq!(diagnosis.defects[0].to_string(), "3 open edges, first: edge 0-1 of triangle 0");
/// # Ok::<(), polhode_mesh::MeshError>(())
/// ```
pub fn diagnose(mesh: &TriangleMesh) -> Diagnosis {
    let topology = Topology::of(mesh);
    let mut tally = Tally::default();
    for edge in topology.edges() {
        match EdgeKind::of(edge) {
            EdgeKind::Sound => {}
            EdgeKind::Open => tally.add(DefectKind::OpenEdge, edge[0].triangle, edge_location(edge[0])),
            EdgeKind::NonManifold => tally.add(DefectKind::NonManifoldEdge, edge[0].triangle, edge_location(edge[0])),
            EdgeKind::Inconsistent => {
                tally.add(DefectKind::InconsistentWinding, edge[0].triangle, edge_location(edge[0]));
            }
        }
    }
    for component in inverted_components(mesh, &topology) {
        let (first_triangle, triangles, volume) = (component.first_triangle, component.triangles, component.volume);
        tally.add(DefectKind::Inverted, first_triangle, Location::Component { first_triangle, triangles, volume });
    }
    for (triangle, &corners) in (0u32..).zip(mesh.triangles()) {
        if names_vertex_twice(corners) || has_no_area(mesh.corners(corners)) {
            tally.add(DefectKind::DegenerateTriangle, triangle, Location::Triangle(triangle));
        }
    }
    duplicate_triangles(mesh, &mut tally);
    vertex_defects(mesh, &mut tally);
    tally.into_diagnosis()
}

impl Defect {
    /// The repair that is offered for it.
    pub const fn repair(&self) -> Option<Repair> {
        self.kind.repair()
    }
}

impl Diagnosis {
    /// Whether the mesh bounds a solid: no defect that [prevents](DefectKind::prevents_solid) it.
    pub fn is_solid(&self) -> bool {
        self.defects.iter().all(|defect| !defect.kind.prevents_solid())
    }

    /// The defect of one kind, if there is any.
    pub fn get(&self, kind: DefectKind) -> Option<&Defect> {
        self.defects.iter().find(|defect| defect.kind == kind)
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

/// Defects being counted; the place with the smallest key is kept.
#[derive(Default)]
struct Tally(Vec<(Defect, u32)>);

impl Tally {
    fn add(&mut self, kind: DefectKind, key: u32, location: Location) {
        match self.0.iter_mut().find(|(defect, _)| defect.kind == kind) {
            Some((defect, first)) => {
                defect.count += 1;
                if key < *first {
                    *first = key;
                    defect.location = location;
                }
            }
            None => self.0.push((Defect { kind, count: 1, location }, key)),
        }
    }

    fn into_diagnosis(self) -> Diagnosis {
        let mut defects: Vec<Defect> = self.0.into_iter().map(|(defect, _)| defect).collect();
        defects.sort_by_key(|defect| defect.kind);
        Diagnosis { defects }
    }
}

fn edge_location(edge: EdgeUse) -> Location {
    let (from, to) = if edge.ascending { (edge.low, edge.high) } else { (edge.high, edge.low) };
    Location::Edge { from, to, triangle: edge.triangle }
}

/// Whether the height of a triangle over its longest edge is no more than rounding of its coordinates can make.
pub(crate) fn has_no_area(corners: [DVec3; 3]) -> bool {
    let [a, b, c] = corners;
    let largest_coordinate = a.abs().max(b.abs()).max(c.abs()).max_element();
    if largest_coordinate == 0.0 {
        return true;
    }
    // In units of the largest coordinate nothing over- or underflows.
    let [a, b, c] = corners.map(|p| p / largest_coordinate);
    let longest = (b - a).length().max((c - b).length()).max((a - c).length());
    (b - a).cross(c - a).length() <= COORDINATE_ROUNDING * longest
}

/// Triangles that repeat an earlier one.
fn duplicate_triangles(mesh: &TriangleMesh, tally: &mut Tally) {
    let mut order: Vec<([u32; 3], u32)> =
        mesh.triangles().iter().zip(0u32..).map(|(&corners, triangle)| (smallest_first(corners), triangle)).collect();
    order.sort_unstable();
    for group in order.chunk_by(|a, b| a.0 == b.0).filter(|group| !names_vertex_twice(group[0].0)) {
        let earlier = group[0].1;
        for &(_, triangle) in &group[1..] {
            tally.add(DefectKind::DuplicateTriangle, triangle, Location::TrianglePair { triangle, earlier });
        }
    }
}

/// Unused and duplicate vertices.
fn vertex_defects(mesh: &TriangleMesh, tally: &mut Tally) {
    let vertices = mesh.vertices();
    let mut is_used = vec![false; vertices.len()];
    for &index in mesh.triangles().iter().flatten() {
        is_used[index as usize] = true;
    }
    for (vertex, _) in (0u32..).zip(&is_used).filter(|&(_, &used)| !used) {
        tally.add(DefectKind::UnusedVertex, vertex, Location::Vertex(vertex));
    }
    for (vertex, &earlier) in (0u32..).zip(&equal_positions(vertices)).filter(|&(vertex, &first)| vertex != first) {
        tally.add(DefectKind::DuplicateVertex, vertex, Location::VertexPair { vertex, earlier });
    }
}
