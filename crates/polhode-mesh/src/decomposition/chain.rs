//! Faces as closed chains of directed edges in a plane.
//!
//! A chain is a sum of directed edges; an edge and its reverse cancel. A closed chain (as many edges arrive at every
//! vertex as leave it) bounds a region of the plane, with holes or in several pieces, with the region on its left.

use glam::DVec3;

/// A directed edge between two vertices.
pub(super) type Edge = (u32, u32);

/// A plane region of a piece's surface.
#[derive(Debug, Clone)]
pub(super) struct Face {
    /// Index of the plane.
    pub(super) plane: u32,
    /// Whether the outward normal is minus the plane's.
    pub(super) is_flipped: bool,
    /// A closed chain.
    pub(super) edges: Vec<Edge>,
}

/// The chain in ascending order without edges that cancel; an edge that occurs twice stays twice.
pub(super) fn reduced(edges: impl IntoIterator<Item = Edge>) -> Vec<Edge> {
    let upward = |(from, to): Edge| if from < to { ((from, to), 1) } else { ((to, from), -1) };
    let mut counts: Vec<(Edge, i32)> = edges.into_iter().filter(|(from, to)| from != to).map(upward).collect();
    counts.sort_unstable();
    let mut result: Vec<Edge> = Vec::with_capacity(counts.len());
    for group in counts.chunk_by(|p, q| p.0 == q.0) {
        let count: i32 = group.iter().map(|&(_, count)| count).sum();
        let (low, high) = group[0].0;
        let edge = if count > 0 { (low, high) } else { (high, low) };
        result.extend(std::iter::repeat_n(edge, count.unsigned_abs() as usize));
    }
    result.sort_unstable();
    result
}

/// The vertices of some faces, ascending.
pub(super) fn vertices(faces: &[Face]) -> Vec<u32> {
    let mut result: Vec<u32> = faces.iter().flat_map(|face| &face.edges).map(|&(from, _)| from).collect();
    result.sort_unstable();
    result.dedup();
    result
}

/// A closed chain as loops that do not cross themselves. Where several meet at a vertex, each turns as far to the left
/// as it can, so that what touches in a point comes apart there. `normal` is outward.
pub(super) fn loops(edges: &[Edge], positions: &[DVec3], normal: DVec3) -> Vec<Vec<Edge>> {
    let mut edges = edges.to_vec();
    edges.sort_unstable();
    let edges = &edges;
    let mut is_used = vec![false; edges.len()];
    let mut result = Vec::new();
    for start in 0..edges.len() {
        let mut found: Vec<Edge> = Vec::new();
        let mut index = start;
        while !is_used[index] {
            is_used[index] = true;
            found.push(edges[index]);
            // The edge that the loop began with may be the one that continues it.
            let is_free = |i: usize| i == start || !is_used[i];
            let Some(next) = successor(edges, is_free, index, positions, normal) else { break };
            index = next;
        }
        if !found.is_empty() {
            result.push(found);
        }
    }
    result
}

/// The free edge that continues an edge, the leftmost when there are several.
fn successor(
    edges: &[Edge],
    is_free: impl Fn(usize) -> bool,
    index: usize,
    positions: &[DVec3],
    normal: DVec3,
) -> Option<usize> {
    let (from, vertex) = edges[index];
    let first = edges.partition_point(|&(other, _)| other < vertex);
    let leaving = (first..edges.len()).take_while(|&i| edges[i].0 == vertex).filter(|&i| is_free(i));
    let position = |v: u32| positions[v as usize];
    let back = position(from) - position(vertex);
    // Clockwise turn from the way back to the way on: the smallest encloses the least.
    let turn = |i: usize| {
        let on = position(edges[i].1) - position(vertex);
        let angle = libm::atan2(on.cross(back).dot(normal), on.dot(back));
        if angle > 0.0 { angle } else { angle + std::f64::consts::TAU }
    };
    leaving.min_by(|&i, &j| turn(i).total_cmp(&turn(j)).then(i.cmp(&j)))
}

/// Twice the area of the region that a closed chain bounds, along `normal` (m^2), and the length of the chain (m).
pub(super) fn twice_area(edges: &[Edge], positions: &[DVec3], normal: DVec3) -> (f64, f64) {
    let Some(&(first, _)) = edges.first() else { return (0.0, 0.0) };
    let origin = positions[first as usize];
    edges.iter().fold((0.0, 0.0), |(area, length), &(from, to)| {
        let (from, to) = (positions[from as usize] - origin, positions[to as usize] - origin);
        (area + from.cross(to).dot(normal), length + from.distance(to))
    })
}
