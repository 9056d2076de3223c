//! The border of a face of a polyhedron: how far a place is from it, and what of it is there.

use crate::shape::polyhedron::{ConvexPolyhedron, Face};
use crate::{ContactFeature, Shape};
use glam::DVec3;

/// Signed distance of a place over a face from the face's border, m; positive inside.
#[inline]
pub(crate) fn face_margin(polyhedron: &ConvexPolyhedron, face: &Face<'_>, y: DVec3) -> f64 {
    let mut least = f64::INFINITY;
    for (vertex, side) in face.vertices.iter().zip(face.sides) {
        let inward = side.dot(polyhedron.vertices[*vertex as usize] - y);
        // The minimum, which has to be asked only of what compares as neither less nor greater.
        if inward < least {
            least = inward;
        } else if inward == least || inward.is_nan() {
            least = least.min(inward);
        }
    }
    least
}

/// Where on a face of the other body a vertex lies.
pub(crate) enum Border {
    Inside,
    /// On an edge with this direction, its frame.
    Edge(DVec3),
    Vertex(u32),
    /// The other body's feature is no face of a polyhedron.
    Unknown,
}

/// Where on the face that a vertex-face contact names the place `y` (frame of the face's body) lies.
pub(crate) fn at_border(other: &Shape, feature: ContactFeature, y: DVec3, tolerance: f64) -> Border {
    if matches!((other, feature), (Shape::HalfSpace(_), ContactFeature::VertexFace { .. })) {
        return Border::Inside;
    }
    let (Shape::Convex(polyhedron), ContactFeature::VertexFace { face, .. }) = (other, feature) else {
        return Border::Unknown;
    };
    let Some(face) = polyhedron.face(face as usize) else { return Border::Unknown };
    let mut edge = Border::Inside;
    for ((&vertex, side), &number) in face.vertices.iter().zip(face.sides).zip(face.edges) {
        let from = y - polyhedron.vertices[vertex as usize];
        if (from - face.normal * face.normal.dot(from)).length() <= tolerance {
            return Border::Vertex(vertex);
        }
        if side.dot(from).abs() <= tolerance {
            edge = Border::Edge(polyhedron.edges[number as usize].direction);
        }
    }
    edge
}
