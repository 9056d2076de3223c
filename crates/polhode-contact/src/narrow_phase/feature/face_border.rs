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
pub(crate) enum PlaceOnFace {
    /// Farther inside than the tolerance.
    Inside,
    /// On an edge with this direction, in the frame of the face's body.
    OnEdge(DVec3),
    AtVertex(u32),
    /// The other body's feature is no face of a polyhedron.
    Unknown,
}

/// Where the point `y` (frame of the face's body) lies on the face that a vertex-face contact names: at a vertex or on
/// an edge if it is no farther from it than `tolerance` (m).
pub(crate) fn place_on_face(other: &Shape, feature: ContactFeature, y: DVec3, tolerance: f64) -> PlaceOnFace {
    if matches!((other, feature), (Shape::HalfSpace(_), ContactFeature::VertexFace { .. })) {
        return PlaceOnFace::Inside;
    }
    let (Shape::Convex(polyhedron), ContactFeature::VertexFace { face, .. }) = (other, feature) else {
        return PlaceOnFace::Unknown;
    };
    let Some(face) = polyhedron.face(face as usize) else { return PlaceOnFace::Unknown };
    let mut edge = PlaceOnFace::Inside;
    for ((&vertex, side), &number) in face.vertices.iter().zip(face.sides).zip(face.edges) {
        let from = y - polyhedron.vertices[vertex as usize];
        if (from - face.normal * face.normal.dot(from)).length() <= tolerance {
            return PlaceOnFace::AtVertex(vertex);
        }
        if side.dot(from).abs() <= tolerance {
            edge = PlaceOnFace::OnEdge(polyhedron.edges[number as usize].direction);
        }
    }
    edge
}
