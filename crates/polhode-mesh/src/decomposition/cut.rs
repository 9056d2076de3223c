//! Cutting a piece by a plane into the piece in front and the piece behind.

use super::chain::{Edge, Face, reduced};
use super::plane::Plane;
use glam::DVec3;
use std::cmp::Ordering;
use std::collections::BTreeMap;

/// The vertices and planes that all pieces share.
#[derive(Debug)]
pub(super) struct Space {
    /// Vertices, m: those of the mesh, then those that cuts have made.
    pub(super) positions: Vec<DVec3>,
    /// Planes of faces and cuts.
    pub(super) planes: Vec<Plane>,
    /// How close to a plane a vertex counts as on it, m.
    pub(super) tolerance: f64,
    /// The places of the vertices of one piece among them ([`Space::number`]); those of other vertices mean nothing.
    numbers: Vec<u32>,
}

impl Space {
    /// Vertices, before anything is cut (m).
    pub(super) const fn new(positions: Vec<DVec3>, planes: Vec<Plane>, tolerance: f64) -> Self {
        Self { positions, planes, tolerance, numbers: Vec::new() }
    }

    /// Numbers the vertices of a piece from zero, until another piece is numbered.
    pub(super) fn number(&mut self, vertices: &[u32]) {
        self.numbers.resize(self.positions.len(), 0);
        for (&vertex, number) in vertices.iter().zip(0..) {
            self.numbers[vertex as usize] = number;
        }
    }

    /// The number of a vertex of the piece that was numbered last.
    pub(super) fn number_of(&self, vertex: u32) -> usize {
        self.numbers[vertex as usize] as usize
    }

    /// Outward normal of a face.
    pub(super) fn normal(&self, face: &Face) -> DVec3 {
        let normal = self.planes[face.plane as usize].normal;
        if face.is_flipped { -normal } else { normal }
    }
}

/// The side of a plane that each vertex of the piece that was numbered last lies on, with its distance (m, zero on the
/// plane).
#[derive(Debug)]
pub(super) struct Sides {
    distances: Vec<f64>,
}

impl Sides {
    /// From the distances of the vertices in the order of their numbers.
    pub(super) const fn new(distances: Vec<f64>) -> Self {
        Self { distances }
    }

    /// Distance of a vertex, m; zero on the plane.
    fn distance(&self, space: &Space, vertex: u32) -> f64 {
        self.distances[space.number_of(vertex)]
    }

    /// In front (greater), behind (less) or on the plane.
    fn side(&self, space: &Space, vertex: u32) -> Ordering {
        side(self.distance(space, vertex))
    }
}

/// In front (greater), behind (less) or on the plane.
pub(super) fn side(distance: f64) -> Ordering {
    distance.partial_cmp(&0.0).unwrap_or(Ordering::Equal)
}

/// The faces in front of a plane and those behind, each a closed surface with a cap in the plane.
pub(super) fn cut(space: &mut Space, faces: &[Face], plane: u32, sides: &Sides) -> (Vec<Face>, Vec<Face>) {
    let mut crossings: BTreeMap<Edge, u32> = BTreeMap::new();
    let (mut front, mut back) = (Vec::new(), Vec::new());
    let (mut front_cap, mut back_cap) = (Vec::new(), Vec::new());
    for face in faces {
        let halves = Halves::of(space, face, sides, &mut crossings);
        // The cap closes what the line along the cut has closed, so it is minus those edges. Faces in the plane itself
        // have no halves: they are part of the caps.
        for (half, pieces, cap) in [(halves.front, &mut front, &mut front_cap), (halves.back, &mut back, &mut back_cap)]
        {
            if half.is_empty() {
                continue;
            }
            let closing = closing_edges(space, &half, &halves.on_plane);
            cap.extend(closing.iter().map(|&(from, to)| (to, from)));
            let edges = reduced(half.into_iter().chain(closing));
            if !edges.is_empty() {
                pieces.push(Face { edges, ..*face });
            }
        }
    }
    for (pieces, cap, is_flipped) in [(&mut front, front_cap, true), (&mut back, back_cap, false)] {
        let edges = reduced(cap);
        if !edges.is_empty() {
            pieces.push(Face { plane, is_flipped, edges });
        }
    }
    (front, back)
}

/// The edges of a face in front of a plane and behind it, and its vertices on the plane.
#[derive(Default)]
struct Halves {
    front: Vec<Edge>,
    back: Vec<Edge>,
    on_plane: Vec<u32>,
}

impl Halves {
    /// Splits edges that pass through the plane; `crossings` holds the new vertices, so that the faces on both sides of
    /// an edge get the same one.
    fn of(space: &mut Space, face: &Face, sides: &Sides, crossings: &mut BTreeMap<Edge, u32>) -> Self {
        let mut result = Self::default();
        for &(from, to) in &face.edges {
            let (side, side_to) = (sides.side(space, from), sides.side(space, to));
            if side == Ordering::Equal {
                result.on_plane.push(from);
            }
            match (side, side_to) {
                // Along the line: what of it belongs to which half follows from the rest.
                (Ordering::Equal, Ordering::Equal) => {}
                (Ordering::Equal, other) | (other, Ordering::Equal) => result.half(other).push((from, to)),
                (one, other) if one == other => result.half(one).push((from, to)),
                (one, other) => {
                    let vertex = *crossings
                        .entry((from.min(to), from.max(to)))
                        .or_insert_with_key(|&(low, high)| crossing(space, sides, low, high));
                    result.on_plane.push(vertex);
                    result.half(one).push((from, vertex));
                    result.half(other).push((vertex, to));
                }
            }
        }
        result
    }

    fn half(&mut self, side: Ordering) -> &mut Vec<Edge> {
        if side == Ordering::Greater { &mut self.front } else { &mut self.back }
    }
}

/// A new vertex where the edge from `low` to `high` passes through the plane.
fn crossing(space: &mut Space, sides: &Sides, low: u32, high: u32) -> u32 {
    let (before, after) = (sides.distance(space, low), sides.distance(space, high));
    let (start, end) = (space.positions[low as usize], space.positions[high as usize]);
    space.positions.push(start + (end - start) * (before / (before - after)));
    space.positions.len() as u32 - 1
}

/// The edges along the cutting line that close half a face. Between neighbouring points of the line the chain runs as
/// often, and in the direction, as arrivals less departures up to there demand.
fn closing_edges(space: &Space, half: &[Edge], on_plane: &[u32]) -> Vec<Edge> {
    let mut points = on_plane.to_vec();
    points.sort_unstable();
    points.dedup();
    let mut net: Vec<(u32, i32)> = points.iter().map(|&point| (point, 0)).collect();
    let mut count = |vertex: u32, by: i32| {
        if let Ok(index) = points.binary_search(&vertex) {
            net[index].1 += by;
        }
    };
    for &(from, to) in half {
        count(to, 1);
        count(from, -1);
    }
    // Along the axis in which the points lie farthest apart, their order is that along the line.
    let position = |vertex: u32| space.positions[vertex as usize];
    let bounds = crate::triangle_mesh::Bounds::of(points.iter().map(|&p| position(p)));
    let axis = (bounds.max - bounds.min).max_position();
    net.sort_by(|&(p, _), &(q, _)| position(p)[axis].total_cmp(&position(q)[axis]).then(p.cmp(&q)));
    let mut running = 0;
    let mut closing = Vec::new();
    for pair in net.windows(2) {
        let ((from, arrivals), (to, _)) = (pair[0], pair[1]);
        running += arrivals;
        let edge = if running > 0 { (from, to) } else { (to, from) };
        closing.extend(std::iter::repeat_n(edge, running.unsigned_abs() as usize));
    }
    closing
}
