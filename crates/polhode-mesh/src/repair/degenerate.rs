//! Triangles that repeat another, and triangles without area.
//!
//! A triangle that names a vertex twice is no part of the surface and goes. One whose three corners lie on a line is:
//! without it the surface would be open there. Its longest edge is swapped with the neighbour's: of `a b c` with c
//! between a and b, and the neighbour `b a d`, become `a d c` and `d b c`, which cover the neighbour as before.

use crate::diagnosis::has_no_area;
use crate::repair::orientation::HalfEdges;
use crate::topology::{names_vertex_twice, smallest_first};
use crate::triangle_mesh::{MeshError, TriangleMesh};
use std::collections::BTreeSet;

/// The mesh without triangles that have the corners of an earlier one in the same direction, and how many there were.
pub(super) fn without_duplicates(mesh: &TriangleMesh) -> Result<(TriangleMesh, usize), MeshError> {
    let mut seen = BTreeSet::new();
    let kept: Vec<[u32; 3]> =
        mesh.triangles().iter().copied().filter(|&triangle| seen.insert(smallest_first(triangle))).collect();
    let count = mesh.triangles().len() - kept.len();
    Ok((TriangleMesh::new(mesh.vertices().to_vec(), kept)?, count))
}

/// The mesh without triangles that name a vertex twice and with those on a line swapped where possible, and how many.
pub(super) fn without_degenerate(mesh: &TriangleMesh) -> Result<(TriangleMesh, usize), MeshError> {
    let kept: Vec<[u32; 3]> =
        mesh.triangles().iter().copied().filter(|&triangle| !names_vertex_twice(triangle)).collect();
    let dropped = mesh.triangles().len() - kept.len();
    let mesh = TriangleMesh::new(mesh.vertices().to_vec(), kept)?;
    let (triangles, swapped) = swapped(&mesh);
    Ok((TriangleMesh::new(mesh.vertices().to_vec(), triangles)?, dropped + swapped))
}

/// The triangles, those on a line swapped with a neighbour that has not been touched yet; and how many.
fn swapped(mesh: &TriangleMesh) -> (Vec<[u32; 3]>, usize) {
    let edges = HalfEdges::of(mesh);
    let mut triangles = mesh.triangles().to_vec();
    let mut is_touched = vec![false; triangles.len()];
    // Edges that swapping made.
    let mut new_edges = BTreeSet::new();
    let mut count = 0;
    for triangle in 0..triangles.len() {
        let corners = mesh.triangles()[triangle];
        if is_touched[triangle] || !has_no_area(mesh.corners(corners)) {
            continue;
        }
        let side = longest_side(mesh, corners);
        let [a, b, c] = [corners[side], corners[(side + 1) % 3], corners[(side + 2) % 3]];
        let Some(twin) = edges.twin(triangle, side) else { continue };
        let neighbour = twin.triangle;
        let [from, _, d] = [0, 1, 2].map(|i| mesh.triangles()[neighbour][(twin.side + i) % 3]);
        let is_opposite = from == b;
        let is_new = d != c && !edges.has_edge(c, d) && !new_edges.contains(&(c.min(d), c.max(d)));
        let swap = [[a, d, c], [d, b, c]];
        // A neighbour without area cannot lend any.
        if is_touched[neighbour] || !is_opposite || !is_new || swap.iter().any(|&t| has_no_area(mesh.corners(t))) {
            continue;
        }
        new_edges.insert((c.min(d), c.max(d)));
        (triangles[triangle], triangles[neighbour]) = (swap[0], swap[1]);
        (is_touched[triangle], is_touched[neighbour]) = (true, true);
        count += 1;
    }
    (triangles, count)
}

/// Which side (0 from the first to the second corner, ...) is the longest.
fn longest_side(mesh: &TriangleMesh, corners: [u32; 3]) -> usize {
    let positions = mesh.corners(corners);
    let length = |side: usize| positions[side].distance(positions[(side + 1) % 3]);
    (0..3).fold(0, |best, side| if length(side) > length(best) { side } else { best })
}
