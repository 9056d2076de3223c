//! Diagnosis: what keeps a mesh from being a solid, how often, and where first.
//!
//! A surface bounds a solid when every edge belongs to exactly two triangles that run along it in opposite directions,
//! and every closed component faces away from the material (thesis 3.2: the boundary parts space into inside and
//! outside). Orientation is judged component by component: a component of negative volume inside another is a void.

pub use crate::defect::{Defect, DefectKind, Location};

use crate::nesting::inverted_components;
use crate::topology::{EdgeKind, EdgeUse, Topology, names_vertex_twice, smallest_first};
use crate::triangle_mesh::{COORDINATE_ROUNDING, TriangleMesh};
use crate::weld::equal_positions;
use glam::DVec3;

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
