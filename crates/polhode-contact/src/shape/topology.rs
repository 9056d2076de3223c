//! Builds a convex polyhedron from loops of vertices, and checks it: edges, adjacency, normals.
//!
//! A list of faces is accepted when every directed edge occurs once and its opposite once, Euler's formula
//! `V - E + F = 2` holds, every vertex has at least three faces, every face is plane and no vertex is outside a face.

use crate::bounding::BoxTree;
use crate::bounding::aabb::Aabb;
use crate::shape::error::{ShapeError, check_length, check_point};
use crate::shape::lists::Lists;
use crate::shape::needle::needle_normal;
use crate::shape::point_cloud::largest_distance;
use crate::shape::polyhedron::{ConvexPolyhedron, Edge, FaceRecord};
use crate::shape::support::middle_coordinate;
use glam::DVec3;
use polhode_spatial::rounding;
use std::collections::{BTreeMap, BTreeSet};

/// Builds a polyhedron from vertices and anticlockwise loops.
pub(crate) fn build(vertices: Vec<DVec3>, loops: Vec<Vec<u32>>) -> Result<ConvexPolyhedron, ShapeError> {
    build_within(vertices, loops, 0.0)
}

/// As [`build`], for vertices that are known within a tolerance, m: a vertex may be that far from the planes of faces.
pub(crate) fn build_within(
    vertices: Vec<DVec3>,
    loops: Vec<Vec<u32>>,
    tolerance: f64,
) -> Result<ConvexPolyhedron, ShapeError> {
    if vertices.len() < 4 {
        return Err(ShapeError::TooFewPoints { count: vertices.len(), limit: 4 });
    }
    let count = vertices.len().max(loops.len());
    if u32::try_from(count).is_err() {
        return Err(ShapeError::TooManyPoints { count, limit: u32::MAX as usize });
    }
    vertices.iter().try_for_each(|&v| check_point("vertex", v))?;
    let corner_edges = join_edges(vertices.len(), &loops)?;
    let size = largest_distance(&vertices);
    let mut polyhedron = ConvexPolyhedron {
        edges: edges_of(&vertices, &corner_edges.endpoints, &corner_edges.faces),
        corner_edges: corner_edges.edges,
        corner_sides: Vec::new(),
        faces: faces_of(&vertices, &loops),
        faces_at: Lists::new(vertices.len(), at_vertices(loops.iter().map(Vec::as_slice))),
        edges_at: Lists::new(vertices.len(), at_vertices(corner_edges.endpoints.iter().map(<[u32; 2]>::as_slice))),
        corner_vertices: loops.into_iter().flatten().collect(),
        vertices,
        size,
    };
    polyhedron.edges.iter().try_for_each(|edge| check_length("edge length", edge.length))?;
    check_geometry(&polyhedron, tolerance)?;
    set_sides(&mut polyhedron);
    complete_edges(&mut polyhedron);
    Ok(polyhedron)
}

/// A triangle as a polyhedron without thickness: face 0 with the given unit normal, face 1 with the opposite one.
pub(crate) fn flat_triangle(corners: [DVec3; 3], normal: DVec3) -> ConvexPolyhedron {
    let loops = [[0, 1, 2], [0, 2, 1]];
    let ends = [[0, 1], [1, 2], [2, 0]];
    let edge = |from: u32, to: u32| bare_edge([from, to], [0, 1], DVec3::ZERO, 0.0);
    let face = |first: usize| FaceRecord { first, count: 3, normal, offset: 0.0 };
    let mut polyhedron = ConvexPolyhedron {
        vertices: corners.to_vec(),
        edges: ends.iter().map(|&[from, to]| edge(from, to)).collect(),
        faces: vec![face(0), face(3)],
        corner_vertices: loops.concat(),
        corner_edges: vec![0, 1, 2, 2, 1, 0],
        corner_sides: Vec::new(),
        faces_at: Lists::new(3, at_vertices(loops.iter().map(<[u32; 3]>::as_slice))),
        edges_at: Lists::new(3, at_vertices(ends.iter().map(<[u32; 2]>::as_slice))),
        size: 0.0,
    };
    set_flat_triangle(&mut polyhedron, corners, normal);
    polyhedron
}

/// Replaces the corners of a polyhedron made by [`flat_triangle`].
pub(crate) fn set_flat_triangle(polyhedron: &mut ConvexPolyhedron, corners: [DVec3; 3], normal: DVec3) {
    let [a, b, c] = corners;
    polyhedron.vertices.clear();
    polyhedron.vertices.extend(corners);
    for edge in &mut polyhedron.edges {
        let [from, to] = edge.vertices.map(|v| v as usize);
        let along = corners[to] - corners[from];
        edge.length = along.length();
        edge.direction = along / edge.length;
    }
    let offset = (normal.dot(a) + normal.dot(b) + normal.dot(c)) / 3.0;
    for (face, sign) in polyhedron.faces.iter_mut().zip([1.0, -1.0]) {
        (face.normal, face.offset) = (normal * sign, offset * sign);
    }
    polyhedron.size = (b - a).length().max((c - b).length()).max((a - c).length());
    set_sides(polyhedron);
    complete_edges(polyhedron);
}

/// Edges in the order in which they first occur in the loops.
struct JoinedEdges {
    endpoints: Vec<[u32; 2]>,
    faces: Vec<[u32; 2]>,
    /// Edge of every corner, face after face.
    edges: Vec<u32>,
}

/// Pairs every directed edge with its opposite.
fn join_edges(vertex_count: usize, loops: &[Vec<u32>]) -> Result<JoinedEdges, ShapeError> {
    let corners = loops.iter().map(Vec::len).sum::<usize>();
    let edges = corners / 2;
    let mut joined = JoinedEdges {
        endpoints: Vec::with_capacity(edges),
        faces: Vec::with_capacity(edges),
        edges: Vec::with_capacity(corners),
    };
    let fail =
        |edges: usize, reason| Err(ShapeError::NotClosed { vertices: vertex_count, edges, faces: loops.len(), reason });
    // The number of the edge for every directed edge whose opposite has not occurred yet.
    let mut open: BTreeMap<(u32, u32), usize> = BTreeMap::new();
    let mut seen: BTreeSet<(u32, u32)> = BTreeSet::new();
    let mut uses = vec![0_usize; vertex_count];
    for (face, corners) in loops.iter().enumerate() {
        if corners.len() < 3 {
            return fail(joined.endpoints.len(), "a face has fewer than three vertices");
        }
        for (i, &from) in corners.iter().enumerate() {
            let to = corners[(i + 1) % corners.len()];
            match uses.get_mut(from as usize) {
                Some(count) => *count += 1,
                None => return fail(joined.endpoints.len(), "a face names a vertex that does not exist"),
            }
            if from == to {
                return fail(joined.endpoints.len(), "a face has the same vertex twice in a row");
            }
            if !seen.insert((from, to)) {
                return fail(joined.endpoints.len(), "two faces run along an edge in the same direction");
            }
            if let Some(edge) = open.remove(&(to, from)) {
                joined.faces[edge][1] = face as u32;
                joined.edges.push(edge as u32);
            } else {
                open.insert((from, to), joined.endpoints.len());
                joined.edges.push(joined.endpoints.len() as u32);
                joined.endpoints.push([from, to]);
                joined.faces.push([face as u32; 2]);
            }
        }
    }
    let edges = joined.endpoints.len();
    if !open.is_empty() {
        return fail(edges, "an edge has a face on one side only");
    }
    if uses.iter().any(|&count| count < 3) {
        return fail(edges, "a vertex has fewer than three faces");
    }
    if vertex_count + loops.len() != edges + 2 {
        return fail(edges, "it has holes or several parts, so that vertices - edges + faces is not 2");
    }
    Ok(joined)
}

/// An edge without the fields that [`complete_edges`] fills in.
const fn bare_edge(vertices: [u32; 2], faces: [u32; 2], direction: DVec3, length: f64) -> Edge {
    Edge { vertices, faces, direction, length, middle: DVec3::ZERO, outward: DVec3::ZERO }
}

/// Fills in the midpoints of edges and the directions out of the body.
pub(crate) fn complete_edges(polyhedron: &mut ConvexPolyhedron) {
    let ConvexPolyhedron { vertices, faces, edges, .. } = polyhedron;
    for edge in edges {
        let [from, to] = edge.vertices.map(|v| vertices[v as usize]);
        let [left, right] = edge.faces.map(|f| faces[f as usize].normal);
        edge.middle = 0.5 * (from + to);
        edge.outward = outward(edge.direction, left, right);
    }
}

/// A direction out of a body at an edge: the sum of the normals of its faces and of the directions out of the faces
/// perpendicular to the edge. The second sum does not vanish where the faces are the two sides of a plate.
fn outward(direction: DVec3, left: DVec3, right: DVec3) -> DVec3 {
    (left + right) + direction.cross(left - right)
}

/// Directions and lengths.
fn edges_of(vertices: &[DVec3], endpoints: &[[u32; 2]], faces: &[[u32; 2]]) -> Vec<Edge> {
    let edge = |(&[from, to], &faces): (&[u32; 2], &[u32; 2])| {
        let along = vertices[to as usize] - vertices[from as usize];
        let length = along.length();
        bare_edge([from, to], faces, along / length, length)
    };
    endpoints.iter().zip(faces).map(edge).collect()
}

/// A face is a needle when its area is less than this part of the square of its length: rounding of the
/// products, 1e-16 of that square, would then turn its normal by more than 1e-10.
const NEEDLE: f64 = 1e-6;

/// Normals by Newell's formula, `sum (v_i - c) x (v_i+1 - c)`, which weights every vertex of a face equally. The offset
/// of a plane is the middle of the smallest and the largest offset of its vertices.
fn faces_of(vertices: &[DVec3], loops: &[Vec<u32>]) -> Vec<FaceRecord> {
    let mut first = 0;
    let mut faces = Vec::with_capacity(loops.len());
    for corners in loops {
        let at = |i: usize| vertices[corners[i % corners.len()] as usize];
        let center = (0..corners.len()).map(at).sum::<DVec3>() / corners.len() as f64;
        let area: DVec3 = (0..corners.len()).map(|i| (at(i) - center).cross(at(i + 1) - center)).sum();
        let longest = (0..corners.len()).map(|i| at(i).distance_squared(center)).fold(0.0, f64::max);
        let normal = if area.length() < NEEDLE * longest {
            needle_normal(corners.iter().map(|&v| vertices[v as usize]))
        } else {
            area / area.length()
        };
        let offset = middle_coordinate((0..corners.len()).map(at), normal);
        faces.push(FaceRecord { first, count: corners.len(), normal, offset });
        first += corners.len();
    }
    faces
}

/// Fills in the outward directions in the plane of each face, perpendicular to each of its edges.
fn set_sides(polyhedron: &mut ConvexPolyhedron) {
    let ConvexPolyhedron { faces, edges, corner_vertices, corner_edges, corner_sides, .. } = polyhedron;
    corner_sides.clear();
    for face in faces {
        for corner in face.first..face.first + face.count {
            let edge = &edges[corner_edges[corner] as usize];
            let forward = edge.vertices[0] == corner_vertices[corner];
            corner_sides.push(if forward { edge.direction } else { -edge.direction }.cross(face.normal));
        }
    }
}

/// The pairs of a vertex and a loop (a face, or an edge as a loop of two) that contains it.
fn at_vertices<'a>(loops: impl Iterator<Item = &'a [u32]> + Clone) -> impl Iterator<Item = (u32, u32)> + Clone {
    (0..).zip(loops).flat_map(|(index, corners)| corners.iter().map(move |&vertex| (vertex, index)))
}

/// Checks that faces are plane, and the polyhedron convex and thick enough, for vertices that are known within a
/// tolerance (m). The vertex farthest in front of a plane is found in a tree of boxes, so that the time grows little
/// faster than their number.
fn check_geometry(polyhedron: &ConvexPolyhedron, tolerance: f64) -> Result<(), ShapeError> {
    let limit = (rounding::DIGITS_OF_A_FILE * polyhedron.size).max(tolerance);
    let thinnest = (rounding::DIGITS_OF_A_FILE * polyhedron.size).max(tolerance);
    let boxes: Vec<Aabb> = polyhedron.vertices.iter().map(|&vertex| Aabb::of_point(vertex)).collect();
    let tree = BoxTree::new(&boxes);
    for (index, record) in polyhedron.faces.iter().enumerate() {
        let height = |v: usize| record.normal.dot(polyhedron.vertices[v]) - record.offset;
        for &vertex in &polyhedron.corner_vertices[record.first..record.first + record.count] {
            let distance = height(vertex as usize).abs();
            // A face without area has a NaN normal.
            if distance.is_nan() || distance > limit {
                return Err(ShapeError::FaceNotPlane { face: index, vertex: vertex as usize, distance, limit });
            }
        }
        // The highest vertex; what rounding may add to the bound of a box is far below the limits.
        let bound = |of: &Aabb| {
            let down = -record.normal;
            (down * of.min).min(down * of.max).element_sum() + record.offset - limit
        };
        let highest = -tree.least(f64::INFINITY, f64::NEG_INFINITY, &bound, &mut |vertex, _| -height(vertex as usize));
        if highest > limit {
            let first = (0..polyhedron.vertices.len()).find(|&vertex| height(vertex) > limit);
            let vertex = first.unwrap_or_default();
            return Err(ShapeError::NotConvex { vertex, face: index, height: height(vertex), limit });
        }
        // Nearly every vertex is deep enough.
        let depths = || (0..polyhedron.vertices.len()).map(|vertex| -height(vertex));
        if !depths().any(|depth| depth >= thinnest) {
            let deepest = depths().fold(0.0, f64::max);
            return Err(ShapeError::Flat { thickness: deepest, limit: thinnest });
        }
    }
    Ok(())
}
