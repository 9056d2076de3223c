//! The second contact of two vertices that coincide.
//!
//! Where a vertex of one body meets a vertex of the other, the direction of the force is not defined by the two points
//! (thesis 3.3 calls the case degenerate and leaves the choice open). Two faces define it: the vertex of A must stay
//! outside the face of B and the vertex of B outside the face of A. A manifold has one contact per point, the first of
//! these. This module finds the second, for a contact response that treats both bodies alike: with one contact only, a
//! mirror-symmetric pair of bodies would be pushed along one of the two normals and lose its symmetry.

use crate::{ContactFeature, ConvexPolyhedron, Shape, Side};
use glam::DVec3;
use polhode_spatial::Pose;

/// Faces are parallel when the cosine between their normals is -1 within this: angles above about 2e-8 rad are
/// distinguished.
const PARALLEL_COSINE: f64 = 2.0 * f64::EPSILON;

/// The counterpart of a vertex-face contact whose vertex lies at a vertex of the face, within `distance` (m). None when
/// it lies elsewhere, when the two faces are parallel, or for shapes other than convex polyhedra.
pub fn counterpart(
    feature: ContactFeature,
    shape_a: &Shape,
    pose_a: &Pose,
    shape_b: &Shape,
    pose_b: &Pose,
    distance: f64,
) -> Option<ContactFeature> {
    let ContactFeature::VertexFace { vertex_of, vertex, face } = feature else { return None };
    let (Shape::Convex(a), Shape::Convex(b)) = (shape_a, shape_b) else { return None };
    // The owner of the vertex and the owner of the face.
    let ((owner, owner_pose), (other, other_pose)) = match vertex_of {
        Side::A => ((a, pose_a), (b, pose_b)),
        Side::B => ((b, pose_b), (a, pose_a)),
    };
    let in_other = other_pose.relative(owner_pose);
    let point = in_other.transform_point(*owner.vertices().get(vertex as usize)?);
    let other_face = other.face(face as usize)?;
    let partner = other_face
        .vertices
        .iter()
        .copied()
        .find(|&u| other.vertices().get(u as usize).is_some_and(|p| (*p - point).length() <= distance))?;
    let (facing, cosine) = most_opposed_face(owner, vertex, &in_other, other_face.normal)?;
    // Parallel faces have one normal: the second contact would repeat the first.
    if 1.0 + cosine <= PARALLEL_COSINE {
        return None;
    }
    Some(ContactFeature::VertexFace { vertex_of: vertex_of.other(), vertex: partner, face: facing })
}

/// The face at a vertex whose normal is most nearly opposite to `normal`; in a tie the first.
fn most_opposed_face(owner: &ConvexPolyhedron, vertex: u32, pose: &Pose, normal: DVec3) -> Option<(u32, f64)> {
    let mut best: Option<(u32, f64)> = None;
    for (index, face) in owner.faces().enumerate().filter(|(_, face)| face.vertices.contains(&vertex)) {
        let cosine = pose.rotation.rotate(face.normal).dot(normal);
        if best.is_none_or(|(_, least)| cosine < least) {
            best = Some((index as u32, cosine));
        }
    }
    best
}
