//! The pair of faces, one of each polyhedron, that lie on each other.

use crate::narrow_phase::axis::axes::{Axes, EdgeAxis};
use crate::narrow_phase::axis::axis_search::AxisSearch;
use crate::narrow_phase::feature::alike::ALIKE;
use crate::shape::polyhedron::ConvexPolyhedron;
use glam::DVec3;
use polhode_spatial::Pose;
use polhode_spatial::unit_vector::SAME_DIRECTION;

/// Unit normals of two faces in the world, from B to A.
pub(super) fn normals_of(
    search: &AxisSearch,
    a: &ConvexPolyhedron,
    (face_a, face_b): (u32, u32),
    pose_a: &Pose,
) -> [DVec3; 2] {
    let normals = [-a.faces[face_a as usize].normal, search.normals[face_b as usize]];
    normals.map(|normal| pose_a.rotation.rotate(normal))
}

/// Which of the two faces decide what belongs to the contact region: the one with the larger separation, or both when
/// they separate equally well (where edges of two tilted bodies meet, points of the edge may lie below either face).
/// Where two edges are the best axis, only a face whose normal is within 0.01 rad of theirs counts (`alike`).
pub(super) fn deciding_faces(
    search: &AxisSearch,
    axes: &Axes,
    (face_a, face_b): (u32, u32),
    alike: [bool; 2],
) -> [bool; 2] {
    let along = [search.along_faces_a[face_a as usize], search.along_faces_b[face_b as usize]];
    [(0, 1), (1, 0)].map(|(own, other)| alike[own] && (!alike[other] || along[own] >= along[other] - axes.tolerance))
}

/// The faces beside two crossing edges that are most nearly antiparallel, when at least one of them has almost the
/// normal of the crossing. Then the other body's edge lies almost in that face, and may touch it at more than the
/// crossing.
pub(super) fn faces_beside(
    search: &AxisSearch,
    a: &ConvexPolyhedron,
    b: &ConvexPolyhedron,
    pose_a: &Pose,
    edges: EdgeAxis,
    normal: DVec3,
) -> Option<(u32, u32)> {
    let normal = pose_a.rotation.inverse_rotate(normal);
    let best = |faces: [u32; 2], along: &dyn Fn(u32) -> f64| {
        let [first, second] = faces.map(|face| (face, along(face)));
        if second.1 > first.1 { second } else { first }
    };
    let face_a = best(a.edges[edges.edge_a as usize].faces, &|f| -normal.dot(a.faces[f as usize].normal));
    let face_b = best(b.edges[edges.edge_b as usize].faces, &|f| normal.dot(search.normals[f as usize]));
    (face_a.1.max(face_b.1) >= ALIKE).then_some((face_a.0, face_b.0))
}

/// The best separating face and the face of the other body that lies against it.
///
/// Of several faces that separate equally well (a body flush with a corner of another) the one that meets the most
/// nearly parallel face is taken, then the one whose normal is most nearly vertical (z, then y, then x), then the
/// first.
pub(super) fn facing(
    search: &AxisSearch,
    a: &ConvexPolyhedron,
    b: &ConvexPolyhedron,
    axes: &Axes,
    pose_a: &Pose,
) -> (u32, u32) {
    let least = axes.face_separation() - axes.tolerance;
    let limits = (axes.tolerance, SAME_DIRECTION);
    let mut best: Option<(f64, DVec3, (u32, u32))> = None;
    let mut offer = |pair: (u32, u32), normal: DVec3, parallel: f64| {
        let direction = pose_a.rotation.rotate(normal).abs();
        if best.is_none_or(|(p, d, _)| is_better((parallel, direction), (p, d))) {
            best = Some((parallel, direction, pair));
        }
    };
    for (face, _) in search.along_faces_a.iter().enumerate().filter(|(_, s)| **s >= least) {
        let normal = a.faces[face].normal;
        let (other, parallel) = opposing(b, &search.vertices, |f| search.normals[f], normal, limits);
        offer((face as u32, other), normal, parallel);
    }
    for (face, _) in search.along_faces_b.iter().enumerate().filter(|(_, s)| **s >= least) {
        let normal = search.normals[face];
        let (other, parallel) = opposing(a, &a.vertices, |f| a.faces[f].normal, normal, limits);
        offer((other, face as u32), normal, parallel);
    }
    best.map_or((0, 0), |(_, _, pair)| pair)
}

/// Whether the first pair (degree of parallelism or number of contacts, direction) is preferred to the second.
pub(super) fn is_better(first: (f64, DVec3), second: (f64, DVec3)) -> bool {
    let differences = [first.0 - second.0, first.1.z - second.1.z, first.1.y - second.1.y, first.1.x - second.1.x];
    differences.into_iter().find(|d| d.abs() > SAME_DIRECTION).is_some_and(|d| d > 0.0)
}

/// Of the faces at the lowest vertices along `normal`, the one whose normal is most nearly antiparallel to it, and
/// minus the cosine between them. Vertices within `tolerance` (m) of the lowest are as low; of faces with cosines equal
/// within `same` the one with the lowest number is taken.
#[inline]
pub(crate) fn opposing(
    polyhedron: &ConvexPolyhedron,
    vertices: &[DVec3],
    normal_of: impl Fn(usize) -> DVec3,
    normal: DVec3,
    (tolerance, same): (f64, f64),
) -> (u32, f64) {
    let lowest = vertices.iter().map(|v| v.dot(normal)).fold(f64::INFINITY, f64::min);
    let mut best = (0, f64::NEG_INFINITY);
    for (vertex, place) in vertices.iter().enumerate() {
        if place.dot(normal) > lowest + tolerance {
            continue;
        }
        for &face in polyhedron.faces_at.of(vertex) {
            let parallel = -normal_of(face as usize).dot(normal);
            if parallel > best.1 + same || (parallel > best.1 - same && face < best.0) {
                best = (face, parallel);
            }
        }
    }
    best
}
