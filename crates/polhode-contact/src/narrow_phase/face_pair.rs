//! The contacts of two faces that lie on each other.
//!
//! The overlap of two plane polygons has three kinds of vertices (thesis 3.4, figure 17): a vertex of A inside B's face,
//! a vertex of B inside A's face, and a crossing of two edges. They are found directly, not by clipping one polygon
//! with the other, so that the answer does not depend on which face is taken first. Signed distances of the vertices
//! from the lines of the other face's edges decide everything; distances up to the tolerance count as zero.
//!
//! Where features coincide one contact is kept for each place:
//!  - a vertex on an edge is vertex-face, and no crossing of that edge is made there;
//!  - of a vertex on a vertex, the one whose face has the higher index is kept, then the higher vertex index, then that
//!    of the upper body (the world's z, then y, then x component of the normal is positive towards it). The rule names
//!    the bodies' own features and so follows the bodies as they turn, and does not ask which one is called A;
//!  - edges along each other make no crossing; their ends are vertices on edges.

use crate::narrow_phase::separating_axis::Workspace;
use crate::shape::polyhedron::{ConvexPolyhedron, Face};
use crate::{ContactFeature, Side};
use glam::DVec3;

/// Two vertices are in one place within this many tolerances: each may stand off the other's edges by one.
const VERTEX_PLACES: f64 = 4.0;

/// A face of each body in A's frame, and distances between their features.
#[derive(Debug, Clone, Default)]
pub(crate) struct Buffers {
    a: PlacedFace,
    b: PlacedFace,
    /// Distance of vertex `i` of A's face outside side `j` of B's, at `i * count_b + j`, m.
    a_outside_b: Vec<f64>,
    /// Distance of vertex `j` of B's face outside side `i` of A's, at `j * count_a + i`, m.
    b_outside_a: Vec<f64>,
    kept_a: Vec<bool>,
    kept_b: Vec<bool>,
}

/// Corners and outward sides of a face.
#[derive(Debug, Clone, Default)]
struct PlacedFace {
    corners: Vec<DVec3>,
    sides: Vec<DVec3>,
}

/// Adds the contacts of face `face_a` of A with face `face_b` of B to the workspace's features. B must have been placed.
/// `upper` is the body that the last rule for vertices on vertices prefers.
pub(crate) fn collect(
    workspace: &mut Workspace,
    a: &ConvexPolyhedron,
    b: &ConvexPolyhedron,
    (index_a, index_b): (u32, u32),
    tolerance: f64,
    upper: Side,
) {
    let (Some(face_a), Some(face_b)) = (a.face(index_a as usize), b.face(index_b as usize)) else { return };
    let mut buffers = std::mem::take(&mut workspace.face_pair);
    buffers.a.corners.clear();
    buffers.a.corners.extend(face_a.vertices.iter().map(|&v| a.vertices[v as usize]));
    buffers.a.sides.clear();
    buffers.a.sides.extend_from_slice(face_a.sides);
    buffers.b.corners.clear();
    buffers.b.corners.extend(face_b.vertices.iter().map(|&v| workspace.vertices[v as usize]));
    buffers.b.sides.clear();
    buffers.b.sides.extend(sides_of_placed(b, &face_b, index_b, workspace));
    measure(&mut buffers.a_outside_b, &buffers.a, &buffers.b);
    measure(&mut buffers.b_outside_a, &buffers.b, &buffers.a);
    keep_inside(&mut buffers.kept_a, &buffers.a_outside_b, face_b.vertices.len(), tolerance);
    keep_inside(&mut buffers.kept_b, &buffers.b_outside_a, face_a.vertices.len(), tolerance);
    drop_coincident(&mut buffers, &face_a, &face_b, (index_a, index_b), tolerance, upper);
    let inside = |side, vertices: &[u32], kept: &[bool], face, out: &mut Vec<ContactFeature>| {
        let kept = vertices.iter().zip(kept).filter(|(_, kept)| **kept);
        out.extend(kept.map(|(&vertex, _)| ContactFeature::VertexFace { vertex_of: side, vertex, face }));
    };
    inside(Side::A, face_a.vertices, &buffers.kept_a, index_b, &mut workspace.features);
    inside(Side::B, face_b.vertices, &buffers.kept_b, index_a, &mut workspace.features);
    cross_edges(&buffers, &face_a, &face_b, tolerance, &mut workspace.features);
    workspace.face_pair = buffers;
}

/// Outward sides of a face of B in A's frame.
fn sides_of_placed<'a>(
    b: &'a ConvexPolyhedron,
    face: &Face<'a>,
    index: u32,
    workspace: &'a Workspace,
) -> impl Iterator<Item = DVec3> + 'a {
    let normal = workspace.normals[index as usize];
    face.vertices.iter().zip(face.edges).map(move |(&vertex, &edge)| {
        let along = workspace.directions[edge as usize];
        let along = if b.edges[edge as usize].vertices[0] == vertex { along } else { -along };
        along.cross(normal)
    })
}

/// Distances of every corner of one face outside every side of the other.
fn measure(distances: &mut Vec<f64>, corners: &PlacedFace, sides: &PlacedFace) {
    distances.clear();
    for &corner in &corners.corners {
        distances.extend(sides.corners.iter().zip(&sides.sides).map(|(&start, side)| side.dot(corner - start)));
    }
}

/// A corner is kept when it is outside no side.
fn keep_inside(kept: &mut Vec<bool>, outside: &[f64], sides: usize, tolerance: f64) {
    kept.clear();
    kept.extend(outside.chunks(sides).map(|row| row.iter().all(|&d| d <= tolerance)));
}

/// Of two vertices in one place one is dropped.
fn drop_coincident(
    buffers: &mut Buffers,
    face_a: &Face<'_>,
    face_b: &Face<'_>,
    (index_a, index_b): (u32, u32),
    tolerance: f64,
    upper: Side,
) {
    let normal = face_a.normal;
    for (i, &vertex_a) in face_a.vertices.iter().enumerate() {
        for (j, &vertex_b) in face_b.vertices.iter().enumerate() {
            if !(buffers.kept_a[i] && buffers.kept_b[j]) {
                continue;
            }
            let between = buffers.a.corners[i] - buffers.b.corners[j];
            let lateral = between - normal * normal.dot(between);
            if lateral.length() <= VERTEX_PLACES * tolerance {
                let order = (index_a, vertex_a).cmp(&(index_b, vertex_b));
                match order.then(if upper == Side::A { std::cmp::Ordering::Greater } else { std::cmp::Ordering::Less })
                {
                    std::cmp::Ordering::Greater => buffers.kept_b[j] = false,
                    _ => buffers.kept_a[i] = false,
                }
            }
        }
    }
}

/// Edges whose ends lie clearly on both sides of each other's lines.
fn cross_edges(
    buffers: &Buffers,
    face_a: &Face<'_>,
    face_b: &Face<'_>,
    tolerance: f64,
    features: &mut Vec<ContactFeature>,
) {
    let (count_a, count_b) = (face_a.vertices.len(), face_b.vertices.len());
    let opposite = |p: f64, q: f64| (p > tolerance && q < -tolerance) || (p < -tolerance && q > tolerance);
    for i in 0..count_a {
        let next_i = (i + 1) % count_a;
        for j in 0..count_b {
            let (start, end) = (buffers.a_outside_b[i * count_b + j], buffers.a_outside_b[next_i * count_b + j]);
            if !opposite(start, end) {
                continue;
            }
            let next_j = (j + 1) % count_b;
            if opposite(buffers.b_outside_a[j * count_a + i], buffers.b_outside_a[next_j * count_a + i]) {
                features.push(ContactFeature::EdgeEdge { edge_a: face_a.edges[i], edge_b: face_b.edges[j] });
            }
        }
    }
}
