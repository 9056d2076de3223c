//! The contacts of two faces that lie on each other.
//!
//! The overlap of two plane polygons has three kinds of vertices (thesis 3.4, figure 17): a vertex of A inside B's
//! face, a vertex of B inside A's face, and a crossing of two edges. They are found directly, not by clipping one
//! polygon with the other, so that the result does not depend on which face is taken first. Every decision is made from
//! the signed distances of the vertices of one face from the edge lines of the other; distances up to the tolerance
//! count as zero.
//!
//! Where features coincide, one contact is kept at each point:
//!  - a vertex on an edge is a vertex-face contact, and that edge has no crossing there;
//!  - of two coinciding vertices the one whose face has the higher index is kept; if these are equal, the one with the
//!    higher vertex index; then that of the upper body (the normal towards it has a positive z component in the world,
//!    or else y, or else x). The rule depends on the bodies' own features, so it holds as the bodies turn and does not
//!    depend on which one is called A;
//!  - collinear edges have no crossing; their ends are vertices on edges.
//!
//! `placed_face.rs` classifies the corners of each face against the sides of the other.

use crate::narrow_phase::axis::axes::axis_slack;
use crate::narrow_phase::axis::axis_search::{AxisSearch, plane_of_b};
use crate::narrow_phase::region::pair_buffers::PairBuffers;
use crate::narrow_phase::region::placed_face::{DEEP_PLACES, FacePairBuffers, following};
use crate::narrow_phase::region::same_place::SAME_PLACE;
use crate::shape::polyhedron::{ConvexPolyhedron, Face};
use crate::{ContactFeature, Side};
use glam::DVec3;

/// For faces with fewer pairs of vertices than this all distances are computed, which is as fast.
const FEW_PAIRS: usize = 32;

/// Adds the contacts of face `index_a` of A with face `index_b` of B to the features of the buffers; vertices that are
/// clearly higher than `reach` (m) above the other face may be omitted. B must have been placed in the buffers. `upper`
/// is the body that the last rule for coinciding vertices prefers.
pub(crate) fn collect(
    buffers: &mut PairBuffers,
    a: &ConvexPolyhedron,
    b: &ConvexPolyhedron,
    (index_a, index_b): (u32, u32),
    (tolerance, reach): (f64, f64),
    upper: Side,
) {
    let (Some(face_a), Some(face_b)) = (a.face(index_a as usize), b.face(index_b as usize)) else { return };
    let PairBuffers {
        search: AxisSearch { x_ab, vertices, normals, directions, .. },
        features,
        face_pair: buffers,
        ..
    } = buffers;
    let normal_b = normals[index_b as usize];
    buffers.a.corners.clear();
    buffers.a.corners.extend(face_a.vertices.iter().map(|&v| a.vertices[v as usize]));
    buffers.a.sides.clear();
    buffers.a.sides.extend_from_slice(face_a.sides);
    buffers.b.corners.clear();
    buffers.b.corners.extend(face_b.vertices.iter().map(|&v| vertices[v as usize]));
    buffers.b.sides.clear();
    buffers.b.sides.extend(sides_of_placed(b, &face_b, normal_b, directions));
    let few = face_a.vertices.len() * face_b.vertices.len() < FEW_PAIRS;
    if few {
        let least =
            [buffers.b.classify_by_signs(&buffers.a, tolerance), buffers.a.classify_by_signs(&buffers.b, tolerance)];
        // Two corners farther than this from every side do not coincide.
        buffers.clearances = least.map(|distance| distance - DEEP_PLACES * tolerance);
    } else {
        buffers.clearances = [0.0; 2];
        buffers.a.classify_by_circles(&buffers.b, normal_b, tolerance);
        buffers.b.classify_by_circles(&buffers.a, face_a.normal, tolerance);
        buffers.a.keep_inside(&buffers.b, tolerance);
        buffers.b.keep_inside(&buffers.a, tolerance);
    }
    drop_coincident(buffers, &face_a, &face_b, (index_a, index_b), tolerance, upper);
    let highest = reach + axis_slack(a, b, x_ab);
    let plane_b = plane_of_b(b, index_b as usize, normal_b, x_ab);
    for (vertex, corner) in buffers.a.contacts(&face_a) {
        let height = normal_b.dot(corner) - plane_b;
        if height <= highest {
            features.push(ContactFeature::VertexFace { vertex_of: Side::A, vertex, face: index_b });
        } else {
            buffers.clearances[1] = buffers.clearances[1].min(height - highest);
        }
    }
    for (vertex, corner) in buffers.b.contacts(&face_b) {
        let height = face_a.normal.dot(corner) - face_a.offset;
        if height <= highest {
            features.push(ContactFeature::VertexFace { vertex_of: Side::B, vertex, face: index_a });
        } else {
            buffers.clearances[0] = buffers.clearances[0].min(height - highest);
        }
    }
    if few {
        cross_by_signs(buffers, &face_a, &face_b, features);
    } else {
        cross_edges(buffers, &face_a, &face_b, tolerance, features);
    }
}

/// Outward sides of a face of B in A's frame.
fn sides_of_placed<'a>(
    b: &'a ConvexPolyhedron,
    face: &Face<'a>,
    normal: DVec3,
    directions: &'a [DVec3],
) -> impl Iterator<Item = DVec3> + 'a {
    face.vertices.iter().zip(face.edges).map(move |(&vertex, &edge)| {
        let along = directions[edge as usize];
        let along = if b.edges[edge as usize].vertices[0] == vertex { along } else { -along };
        along.cross(normal)
    })
}

/// Drops one of every two coinciding vertices.
fn drop_coincident(
    buffers: &mut FacePairBuffers,
    face_a: &Face<'_>,
    face_b: &Face<'_>,
    (index_a, index_b): (u32, u32),
    tolerance: f64,
    upper: Side,
) {
    let normal = face_a.normal;
    // Points are compared in A's plane: a vertex far inside A's face coincides with no vertex of A.
    buffers.near.clear();
    buffers.near.extend((0..face_b.vertices.len()).filter(|&j| buffers.b.kept[j] && !buffers.b.deep[j]));
    for (i, &vertex_a) in face_a.vertices.iter().enumerate() {
        for &j in &buffers.near {
            if !(buffers.a.kept[i] && buffers.b.kept[j]) {
                continue;
            }
            let vertex_b = face_b.vertices[j];
            let between = buffers.a.corners[i] - buffers.b.corners[j];
            let lateral = between - normal * normal.dot(between);
            if lateral.length() <= SAME_PLACE * tolerance {
                let order = (index_a, vertex_a).cmp(&(index_b, vertex_b));
                match order.then(if upper == Side::A { std::cmp::Ordering::Greater } else { std::cmp::Ordering::Less })
                {
                    std::cmp::Ordering::Greater => buffers.b.kept[j] = false,
                    _ => buffers.a.kept[i] = false,
                }
            }
        }
    }
}

/// Adds the crossings: pairs of edges whose ends lie clearly on both sides of each other's line.
fn cross_edges(
    buffers: &FacePairBuffers,
    face_a: &Face<'_>,
    face_b: &Face<'_>,
    tolerance: f64,
    features: &mut Vec<ContactFeature>,
) {
    let (a, b) = (&buffers.a, &buffers.b);
    let (count_a, count_b) = (face_a.vertices.len(), face_b.vertices.len());
    let opposite = |p: f64, q: f64| (p > tolerance && q < -tolerance) || (p < -tolerance && q > tolerance);
    for j in (0..count_b).filter(|&j| b.crossable[j]) {
        let next_j = following(j, count_b);
        let mut before = None;
        for i in 0..count_a {
            if !a.crossable[i] {
                before = None;
                continue;
            }
            let next_i = following(i, count_a);
            let start = before.unwrap_or_else(|| b.outside(a.corners[i], j));
            let end = b.outside(a.corners[next_i], j);
            before = Some(end);
            if opposite(start, end) && opposite(a.outside(b.corners[j], i), a.outside(b.corners[next_j], i)) {
                features.push(ContactFeature::EdgeEdge { edge_a: face_a.edges[i], edge_b: face_b.edges[j] });
            }
        }
    }
}

/// As [`cross_edges`], for faces with few vertices, from their stored signs.
fn cross_by_signs(buffers: &FacePairBuffers, face_a: &Face<'_>, face_b: &Face<'_>, features: &mut Vec<ContactFeature>) {
    let (count_a, count_b) = (face_a.vertices.len(), face_b.vertices.len());
    for j in 0..count_b {
        let next_j = following(j, count_b);
        for i in 0..count_a {
            let next_i = following(i, count_a);
            let of_a = buffers.a.signs[i * count_b + j] * buffers.a.signs[next_i * count_b + j];
            let of_b = buffers.b.signs[j * count_a + i] * buffers.b.signs[next_j * count_a + i];
            if of_a < 0 && of_b < 0 {
                features.push(ContactFeature::EdgeEdge { edge_a: face_a.edges[i], edge_b: face_b.edges[j] });
            }
        }
    }
}
