//! Which plane to cut a piece along.
//!
//! Candidates pass through a reflex edge: the planes of its two faces and the one halfway between. A plane is worth the
//! reflex edges that lie in it, less those that it would cut in two; then the fewest edges cut, then the most even
//! halves decide.

use super::adjacency::Joint;
use super::chain::{self, Face};
use super::cut::{self, Sides, Space};
use super::grouping::Group;
use super::plane::Plane;
use std::cmp::Ordering;
use std::collections::{BTreeMap, BTreeSet};

/// Reflex edges that candidates are taken from, evenly spread over all of a piece. More make a few parts less and take
/// longer.
const CANDIDATE_EDGES: usize = 32;

/// How good a plane is; the greater the better.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
struct Score {
    resolved_less_cut: i64,
    fewer_edges_cut: i64,
    evenness: i64,
}

/// A piece with its vertices numbered from zero, so that a candidate is judged by plain arrays.
struct Numbered {
    /// Ascending.
    vertices: Vec<u32>,
    /// Ends of all edges.
    edges: Vec<[usize; 2]>,
    /// Ends of the reflex edges.
    reflex: Vec<[usize; 2]>,
    /// For each plane that faces lie in, the vertices of those faces.
    on_planes: BTreeMap<u32, Vec<usize>>,
}

impl Numbered {
    fn of(space: &mut Space, group: &Group) -> Self {
        let vertices = chain::vertices(&group.faces);
        space.number(&vertices);
        let number = |vertex: u32| space.number_of(vertex);
        let mut edges = Vec::new();
        let mut on_planes: BTreeMap<u32, Vec<usize>> = BTreeMap::new();
        for face in &group.faces {
            let ends = face.edges.iter().map(|&(from, to)| [number(from), number(to)]);
            on_planes.entry(face.plane).or_default().extend(ends.clone().map(|[from, _]| from));
            edges.extend(ends.filter(|[from, to]| from < to));
        }
        let reflex = group.reflex.iter().map(|joint| [number(joint.edge.0), number(joint.edge.1)]).collect();
        Self { vertices, edges, reflex, on_planes }
    }

    /// Distance of every vertex from a plane (m), zero for those on it: those of faces in it, those of the reflex edge
    /// that it goes through, and those too close to be told from it.
    fn distances(&self, space: &Space, candidate: &Candidate, edge: &[usize]) -> Vec<f64> {
        let snapped = |distance: f64| if distance.abs() > space.tolerance { distance } else { 0.0 };
        let positions = self.vertices.iter().map(|&vertex| space.positions[vertex as usize]);
        let mut distances: Vec<f64> = positions.map(|p| snapped(candidate.plane.distance(p))).collect();
        let of_faces = candidate.index.and_then(|index| self.on_planes.get(&index)).into_iter().flatten();
        for &vertex in of_faces.chain(edge) {
            distances[vertex] = 0.0;
        }
        distances
    }

    /// The score of a plane, none when it leaves all vertices on one side.
    fn score(&self, distances: &[f64]) -> Option<Score> {
        let is_cut = |&&[p, q]: &&[usize; 2]| distances[p] * distances[q] < 0.0;
        let is_resolved = |&&[p, q]: &&[usize; 2]| distances[p] == 0.0 && distances[q] == 0.0;
        let resolved = self.reflex.iter().filter(is_resolved).count() as i64;
        let resolved_less_cut = resolved - self.reflex.iter().filter(is_cut).count() as i64;
        let count = |side: Ordering| distances.iter().filter(|&&d| cut::side(d) == side).count() as i64;
        let evenness = count(Ordering::Greater).min(count(Ordering::Less));
        let fewer_edges_cut = -(self.edges.iter().filter(is_cut).count() as i64);
        (evenness > 0).then_some(Score { resolved_less_cut, fewer_edges_cut, evenness })
    }
}

/// A plane through a reflex edge, with its index when it is that of a face.
struct Candidate {
    plane: Plane,
    index: Option<u32>,
}

/// The best plane with the sides of the vertices; none for a piece without reflex edges, or when no candidate parts it.
/// `comparisons` counts the vertices and edges that planes are compared with.
pub(super) fn plane_through_reflex_edge(
    space: &mut Space,
    group: &Group,
    comparisons: &mut u64,
) -> Option<(u32, Sides)> {
    if group.reflex.is_empty() {
        return None;
    }
    let piece = Numbered::of(space, group);
    let mut best = Best::default();
    let step = piece.reflex.len().div_ceil(CANDIDATE_EDGES);
    // When none of the samples parts the piece, every reflex edge is tried.
    for step in [step, 1] {
        let mut judged = BTreeSet::new();
        for reflex in (0..piece.reflex.len()).step_by(step) {
            for candidate in candidates(space, &group.faces, group.reflex[reflex]) {
                // The plane of a face is the same at each of its edges.
                if candidate.index.is_some_and(|index| !judged.insert(index)) {
                    continue;
                }
                *comparisons += (piece.vertices.len() + piece.edges.len()) as u64;
                let distances = piece.distances(space, &candidate, &piece.reflex[reflex]);
                best.consider(&piece, candidate, distances);
            }
        }
        if best.0.is_some() {
            break;
        }
    }
    let (_, Candidate { plane, index }, distances) = best.0?;
    let index = index.unwrap_or_else(|| {
        space.planes.push(plane);
        space.planes.len() as u32 - 1
    });
    Some((index, Sides::new(distances)))
}

/// The best plane among those of the faces that have vertices in front, for a piece that is not convex although it has
/// no reflex edge.
pub(super) fn plane_of_dented_face(space: &mut Space, group: &Group) -> Option<(u32, Sides)> {
    let piece = Numbered::of(space, group);
    let mut best = Best::default();
    for &index in piece.on_planes.keys() {
        let candidate = Candidate { plane: space.planes[index as usize], index: Some(index) };
        let distances = piece.distances(space, &candidate, &[]);
        best.consider(&piece, candidate, distances);
    }
    let (_, Candidate { index, .. }, distances) = best.0?;
    Some((index?, Sides::new(distances)))
}

/// The best plane so far, with its distances from the vertices.
#[derive(Default)]
struct Best(Option<(Score, Candidate, Vec<f64>)>);

impl Best {
    fn consider(&mut self, piece: &Numbered, candidate: Candidate, distances: Vec<f64>) {
        if let Some(score) = piece.score(&distances)
            && self.0.as_ref().is_none_or(|(other, ..)| score > *other)
        {
            self.0 = Some((score, candidate, distances));
        }
    }
}

/// Planes through a reflex edge.
fn candidates(space: &Space, faces: &[Face], joint: Joint) -> impl Iterator<Item = Candidate> {
    let [first, second] = joint.faces.map(|face| &faces[face as usize]);
    let of_face = |face: &Face| Candidate { plane: space.planes[face.plane as usize], index: Some(face.plane) };
    let (from, to) = joint.edge;
    let (start, end) = (space.positions[from as usize], space.positions[to as usize]);
    let halfway = Plane::halfway(start, end - start, space.normal(first), space.normal(second));
    [of_face(first), of_face(second)].into_iter().chain(halfway.map(|plane| Candidate { plane, index: None }))
}
