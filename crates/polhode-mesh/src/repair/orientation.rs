//! Which way round triangles run.
//!
//! Neighbours agree when they run along their common edge in opposite directions. From the first triangle of every
//! patch the others follow by going from neighbour to neighbour over edges of exactly two triangles; the patch then
//! runs the way most of its triangles did. A patch where this contradicts itself has only one side (a Moebius strip)
//! and stays as it is. A closed component that lies inside an even number of others faces outward, one inside an odd
//! number is the wall of a void and faces inward.

use crate::nesting::misdirected_components;
use crate::topology::{EdgeKind, EdgeUse, Topology};
use crate::triangle_mesh::{MeshError, TriangleMesh};

/// A side of a triangle: side k runs from corner k to the next.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Side {
    pub(super) triangle: usize,
    pub(super) side: usize,
}

/// The other triangle at every side that exactly two triangles have.
pub(super) struct HalfEdges {
    twins: Vec<[Option<Side>; 3]>,
    /// All edges as (low, high), ordered.
    edges: Vec<(u32, u32)>,
}

impl HalfEdges {
    pub(super) fn of(mesh: &TriangleMesh) -> Self {
        let topology = Topology::of(mesh);
        let mut twins = vec![[None; 3]; mesh.triangles().len()];
        let mut edges = Vec::new();
        for uses in topology.edges() {
            edges.extend(uses.first().map(|edge| (edge.low, edge.high)));
            let [first, second] = uses else { continue };
            let (first, second) = (side_of(mesh, *first), side_of(mesh, *second));
            twins[first.triangle][first.side] = Some(second);
            twins[second.triangle][second.side] = Some(first);
        }
        Self { twins, edges }
    }

    pub(super) fn twin(&self, triangle: usize, side: usize) -> Option<Side> {
        self.twins[triangle][side]
    }

    pub(super) fn has_edge(&self, a: u32, b: u32) -> bool {
        self.edges.binary_search(&(a.min(b), a.max(b))).is_ok()
    }
}

/// Where an edge stands in its triangle.
pub(super) fn side_of(mesh: &TriangleMesh, edge: EdgeUse) -> Side {
    let triangle = edge.triangle as usize;
    let from = if edge.ascending { edge.low } else { edge.high };
    let side = mesh.triangles()[triangle].iter().position(|&corner| corner == from).unwrap_or_default();
    Side { triangle, side }
}

/// The mesh with the triangles of every patch running the same way round, and how many were turned.
pub(super) fn consistent(mesh: &TriangleMesh) -> Result<(TriangleMesh, usize), MeshError> {
    let edges = HalfEdges::of(mesh);
    // For each triangle whether it is turned; none while not yet reached.
    let mut turned: Vec<Option<bool>> = vec![None; mesh.triangles().len()];
    let mut triangles = mesh.triangles().to_vec();
    let mut count = 0;
    for first in 0..triangles.len() {
        if turned[first].is_some() {
            continue;
        }
        let (patch, is_two_sided) = follow(mesh, &edges, &mut turned, first);
        if !is_two_sided {
            continue;
        }
        let number = patch.iter().filter(|&&triangle| turned[triangle] == Some(true)).count();
        // The majority stays as it is; of equal halves that of the first triangle.
        let turn = 2 * number <= patch.len();
        for &triangle in patch.iter().filter(|&&triangle| turned[triangle] == Some(turn)) {
            triangles[triangle].swap(1, 2);
            count += 1;
        }
    }
    Ok((TriangleMesh::new(mesh.vertices().to_vec(), triangles)?, count))
}

/// Decides for every triangle of the patch of `first` whether it is turned against it; the patch, and whether no edge
/// contradicts.
fn follow(mesh: &TriangleMesh, edges: &HalfEdges, turned: &mut [Option<bool>], first: usize) -> (Vec<usize>, bool) {
    turned[first] = Some(false);
    let mut patch = vec![first];
    let mut is_two_sided = true;
    let mut next = 0;
    while let Some(&triangle) = patch.get(next) {
        next += 1;
        let is_turned = turned[triangle] == Some(true);
        for side in 0..3 {
            let Some(twin) = edges.twin(triangle, side) else { continue };
            let (corners, others) = (mesh.triangles()[triangle], mesh.triangles()[twin.triangle]);
            let is_same_direction = corners[side] == others[twin.side];
            let expected = is_turned != is_same_direction;
            match turned[twin.triangle] {
                None => {
                    turned[twin.triangle] = Some(expected);
                    patch.push(twin.triangle);
                }
                Some(found) => is_two_sided &= found == expected,
            }
        }
    }
    (patch, is_two_sided)
}

/// The mesh with its closed components facing away from the material, and how many triangles were turned.
pub(super) fn outward(mesh: &TriangleMesh) -> Result<(TriangleMesh, usize), MeshError> {
    let topology = Topology::of(mesh);
    let mut triangles = mesh.triangles().to_vec();
    let mut count = 0;
    for component in misdirected_components(mesh, &topology) {
        for &triangle in &component.triangles {
            triangles[triangle as usize].swap(1, 2);
        }
        count += component.triangles.len();
    }
    Ok((TriangleMesh::new(mesh.vertices().to_vec(), triangles)?, count))
}

/// Open sides: those of one triangle only.
pub(super) fn open_sides(mesh: &TriangleMesh) -> Vec<Side> {
    let topology = Topology::of(mesh);
    let open = topology.edges().filter(|uses| EdgeKind::of(uses) == EdgeKind::Open);
    let mut sides: Vec<Side> = open.filter_map(|uses| uses.first()).map(|&edge| side_of(mesh, edge)).collect();
    sides.sort_by_key(|side| (side.triangle, side.side));
    sides
}
