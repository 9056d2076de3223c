//! The border of a face of a polyhedron: the distance of a point from it, and the edge or vertex at a point.

use crate::shape::polyhedron::{ConvexPolyhedron, Face};
use crate::{ContactFeature, Shape};
use glam::DVec3;

/// Signed distance of a point from a face's border, measured in the face's plane, m; positive inside.
#[inline]
pub(crate) fn face_margin(polyhedron: &ConvexPolyhedron, face: &Face<'_>, y: DVec3) -> f64 {
    let mut least = f64::INFINITY;
    for (vertex, side) in face.vertices.iter().zip(face.sides) {
        let inward = side.dot(polyhedron.vertices[*vertex as usize] - y);
        // `f64::min` is called only for ties and NaN: the comparison alone is faster and gives the same minimum.
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
    /// On an edge with this direction, in the frame of the face's body.
    Edge(DVec3),
    Vertex(u32),
    /// The other body's feature is no face of a polyhedron.
    Unknown,
}

/// Whether the point `y` (frame of the face's body) lies on an edge or a vertex of the face that a vertex-face contact
/// names, within `tolerance` (m).
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
