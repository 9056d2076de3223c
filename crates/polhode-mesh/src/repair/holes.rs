//! Holes: closed rims of open edges, filled by the triangulation of least area.
//!
//! From an open edge the rim goes on with the next open edge in the fan of triangles around its end; where it comes
//! back to a vertex it has passed, what lies between is a hole of its own, so that holes that share a vertex are told
//! apart. Over a rim of n corners `W(i, j) = min over i < k < j of W(i, k) + W(k, j) +
//! area(i, k, j)` is the least area of a triangulation of the corners i to j (docs/REFERENCES.md, Barequet and Sharir
//! 1995); no new vertex is made. Edges that the mesh already has are not used again, for they would be those of three
//! triangles; a rim that has no triangulation without them stays open. So does the rim of a sheet, for its filling
//! would be a second sheet upon the first and no solid: a filling may have at most [`LARGEST_FILLING`] of the area of
//! the component it closes. Cost: n^3 / 6 areas.

use crate::repair::orientation::{HalfEdges, Side, open_sides};
use crate::surface_integrals::triangle_area;
use crate::topology::Topology;
use crate::triangle_mesh::{Bounds, MeshError, TriangleMesh};
use std::collections::BTreeSet;

/// Most areas that are computed, over all rims: those of one rim of 1000 corners, some seconds. Rims beyond stay open.
const MOST_AREAS: f64 = 1.7e8;

/// Largest area of a filling relative to that of the component (dimensionless): a flat sheet has 1, a half-ball 1/2.
const LARGEST_FILLING: f64 = 0.8;

/// The mesh with holes filled whose box has a diagonal of at most `largest` times that of the mesh, and how many.
pub(super) fn filled(mesh: &TriangleMesh, largest: f64) -> Result<(TriangleMesh, usize), MeshError> {
    let edges = HalfEdges::of(mesh);
    let limit = largest * mesh.bounds().diagonal();
    let mut triangles = mesh.triangles().to_vec();
    let mut new_edges = BTreeSet::new();
    let (mut count, mut areas_left) = (0, MOST_AREAS);
    let component_areas = component_areas(mesh);
    for (triangle, rim) in rims(mesh, &edges) {
        let positions = || rim.iter().filter_map(|&index| mesh.vertices().get(index as usize).copied());
        let corners = rim.len() as f64;
        let areas = corners * corners * corners / 6.0;
        if areas > areas_left || Bounds::of(positions()).diagonal() > limit {
            continue;
        }
        areas_left -= areas;
        let is_free = |a: u32, b: u32| a != b && !edges.has_edge(a, b) && !new_edges.contains(&(a.min(b), a.max(b)));
        let Some(patch) = least_area(mesh, &rim, is_free) else { continue };
        let area: f64 = patch.iter().map(|&corners| triangle_area(mesh.corners(corners))).sum();
        if area > LARGEST_FILLING * component_areas[triangle] {
            continue;
        }
        for &[a, b, c] in &patch {
            new_edges.extend([(a, b), (b, c), (c, a)].map(|(from, to)| (from.min(to), from.max(to))));
        }
        triangles.extend(patch);
        count += 1;
    }
    Ok((TriangleMesh::new(mesh.vertices().to_vec(), triangles)?, count))
}

/// For each triangle the area of its component, m^2.
fn component_areas(mesh: &TriangleMesh) -> Vec<f64> {
    let mut areas = vec![0.0; mesh.triangles().len()];
    for component in &Topology::of(mesh).components {
        let corners = component.triangles.iter().map(|&triangle| mesh.corners(mesh.triangles()[triangle as usize]));
        let area = corners.map(triangle_area).sum();
        for &triangle in &component.triangles {
            areas[triangle as usize] = area;
        }
    }
    areas
}

/// The closed rims, each by a triangle beside it and its corners in the order in which new triangles run along it.
fn rims(mesh: &TriangleMesh, edges: &HalfEdges) -> Vec<(usize, Vec<u32>)> {
    let open = open_sides(mesh);
    let index_of = |side: Side| open.binary_search_by_key(&(side.triangle, side.side), |s| (s.triangle, s.side)).ok();
    let mut is_taken = vec![false; open.len()];
    let mut rims = Vec::new();
    for start in 0..open.len() {
        let mut rim = Vec::new();
        let mut current = Some(start);
        while let Some(index) = current.filter(|&index| !is_taken[index]) {
            is_taken[index] = true;
            let side = open[index];
            rim.push(mesh.triangles()[side.triangle][side.side]);
            current = next_open(mesh, edges, side).and_then(index_of);
        }
        if current == Some(start) {
            // New triangles run along the rim against the old ones.
            rim.reverse();
            rims.extend(without_repeats(&rim).into_iter().map(|rim| (open[start].triangle, rim)));
        }
    }
    rims
}

/// A closed rim as rims that pass no vertex twice.
fn without_repeats(rim: &[u32]) -> Vec<Vec<u32>> {
    let mut rims = Vec::new();
    let mut open: Vec<u32> = Vec::new();
    let mut is_open = BTreeSet::new();
    for &vertex in rim {
        if !is_open.insert(vertex) {
            let start = open.iter().rposition(|&earlier| earlier == vertex).unwrap_or(0);
            let between = open.split_off(start);
            for inner in &between[1..] {
                is_open.remove(inner);
            }
            rims.push(between);
        }
        open.push(vertex);
    }
    rims.push(open);
    rims.retain(|rim| rim.len() >= 3);
    rims
}

/// The open side that begins where `side` ends, in the same fan of triangles; none where the fan is not consistently
/// wound or ends at an edge of more than two triangles.
fn next_open(mesh: &TriangleMesh, edges: &HalfEdges, side: Side) -> Option<Side> {
    let end = mesh.triangles()[side.triangle][(side.side + 1) % 3];
    let mut candidate = Side { triangle: side.triangle, side: (side.side + 1) % 3 };
    // A fan has no more triangles than the mesh.
    for _ in 0..mesh.triangles().len() {
        let Some(twin) = edges.twin(candidate.triangle, candidate.side) else { return Some(candidate) };
        candidate = Side { triangle: twin.triangle, side: (twin.side + 1) % 3 };
        if mesh.triangles()[candidate.triangle][candidate.side] != end {
            return None;
        }
    }
    None
}

/// The triangulation of a rim of least area whose inner edges are all free.
fn least_area(mesh: &TriangleMesh, rim: &[u32], is_free: impl Fn(u32, u32) -> bool) -> Option<Vec<[u32; 3]>> {
    let n = rim.len();
    let at = |i: usize, j: usize| i * n + j;
    // Least area over the corners i to j, and the corner that makes a triangle with them.
    let mut area = vec![0.0f64; n * n];
    let mut apex = vec![0usize; n * n];
    for span in 2..n {
        for i in 0..n - span {
            let j = i + span;
            let is_rim = span == n - 1;
            let mut best = (f64::INFINITY, i + 1);
            if is_rim || is_free(rim[i], rim[j]) {
                for k in i + 1..j {
                    let below = area[at(i, k)] + area[at(k, j)];
                    if below < best.0 {
                        let total = below + triangle_area(mesh.corners([rim[i], rim[k], rim[j]]));
                        if total < best.0 {
                            best = (total, k);
                        }
                    }
                }
            }
            (area[at(i, j)], apex[at(i, j)]) = best;
        }
    }
    if !area[at(0, n - 1)].is_finite() {
        return None;
    }
    let mut triangles = Vec::with_capacity(n - 2);
    let mut open = vec![(0, n - 1)];
    while let Some((i, j)) = open.pop() {
        if j - i >= 2 {
            let k = apex[at(i, j)];
            triangles.push([rim[i], rim[k], rim[j]]);
            open.extend([(i, k), (k, j)]);
        }
    }
    Some(triangles)
}
