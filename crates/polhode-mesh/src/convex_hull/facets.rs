//! Faces of a hull: triangles of exactly one plane become one convex polygon, and vertices that are no corners go.

use crate::predicates::side_of_plane;
use glam::DVec3;
use polhode_spatial::DisjointSets;
use std::collections::BTreeMap;

/// The faces of a hull as polygons over the points that are corners.
pub(super) struct Facets {
    /// Indices into `sources`, anticlockwise seen from outside.
    pub(super) faces: Vec<Vec<u32>>,
    /// The corners as indices of the given points, ascending.
    pub(super) sources: Vec<u32>,
}

/// An edge of a triangle, ordered by its ends.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
struct EdgeUse {
    low: u32,
    high: u32,
    triangle: u32,
}

/// Merges triangles that close a convex surface; none when they do not.
pub(super) fn merged(points: &[DVec3], triangles: &[[u32; 3]]) -> Option<Facets> {
    let facet_of = facets_of_triangles(points, triangles);
    // The border of each facet, as successors of its vertices.
    let mut borders: BTreeMap<u32, BTreeMap<u32, u32>> = BTreeMap::new();
    let mut owner: Vec<(u32, u32, u32)> = Vec::with_capacity(3 * triangles.len());
    for (&[a, b, c], &facet) in triangles.iter().zip(&facet_of) {
        owner.extend([(a, b, facet), (b, c, facet), (c, a, facet)]);
    }
    owner.sort_unstable();
    for &(from, to, facet) in &owner {
        let reverse = owner.binary_search(&(to, from, facet));
        if reverse.is_err() {
            borders.entry(facet).or_default().insert(from, to);
        }
    }
    let mut uses: BTreeMap<u32, u32> = BTreeMap::new();
    for border in borders.values() {
        for &vertex in border.keys() {
            *uses.entry(vertex).or_default() += 1;
        }
    }
    // A corner belongs to three faces at least; a vertex inside an edge to two.
    let sources: Vec<u32> = uses.iter().filter(|&(_, &count)| count >= 3).map(|(&vertex, _)| vertex).collect();
    let mut faces = Vec::with_capacity(borders.len());
    for border in borders.values() {
        faces.push(polygon(border, &sources)?);
    }
    faces.sort_unstable();
    Some(Facets { faces, sources })
}

/// For each triangle the smallest triangle that is coplanar with it and connected through others that are.
fn facets_of_triangles(points: &[DVec3], triangles: &[[u32; 3]]) -> Vec<u32> {
    let mut uses = Vec::with_capacity(3 * triangles.len());
    for (triangle, &[a, b, c]) in (0u32..).zip(triangles) {
        for (from, to) in [(a, b), (b, c), (c, a)] {
            uses.push(EdgeUse { low: from.min(to), high: from.max(to), triangle });
        }
    }
    uses.sort_unstable();
    let mut facets = DisjointSets::new(triangles.len());
    for pair in uses.chunk_by(|p, q| (p.low, p.high) == (q.low, q.high)) {
        let [first, second] = pair else { continue };
        let plane = triangles[first.triangle as usize].map(|corner| points[corner as usize]);
        let corners = triangles[second.triangle as usize];
        let is_coplanar = corners
            .iter()
            .filter(|&&corner| corner != first.low && corner != first.high)
            .all(|&corner| side_of_plane(plane, points[corner as usize]) == 0.0);
        if is_coplanar {
            facets.join(first.triangle as usize, second.triangle as usize);
        }
    }
    (0..triangles.len()).map(|triangle| facets.smallest(triangle) as u32).collect()
}

/// The corners along a border from the smallest on, as indices into `sources`; none when it is not one loop.
fn polygon(border: &BTreeMap<u32, u32>, sources: &[u32]) -> Option<Vec<u32>> {
    let (&start, _) = border.first_key_value()?;
    let mut corners = Vec::with_capacity(border.len());
    let mut vertex = start;
    for _ in 0..border.len() {
        if let Ok(index) = sources.binary_search(&vertex) {
            corners.push(index as u32);
        }
        vertex = *border.get(&vertex)?;
    }
    let smallest = corners.iter().enumerate().min_by_key(|&(_, corner)| *corner)?.0;
    corners.rotate_left(smallest);
    (vertex == start && corners.len() >= 3).then_some(corners)
}
