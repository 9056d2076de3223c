//! The feature of a convex polyhedron that is nearest to a point.

use crate::SurfaceFeature;
use crate::narrow_phase::feature::face_border::face_margin;
use crate::shape::nearer_point::is_nearer;
use crate::shape::polyhedron::ConvexPolyhedron;
use crate::shape::support::farthest;
use glam::DVec3;

/// A feature and its signed distance from the point, m; negative inside the body.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct NearestFeature {
    pub(crate) feature: SurfaceFeature,
    pub(crate) distance: f64,
    /// Unit vector from the feature to the point, outward also when the point is inside.
    pub(crate) normal: DVec3,
}

/// The nearest feature. A point inside the body, or outside it by at most `tolerance` (m), is nearest to the face with
/// the nearest plane; a point that is outside a face's plane and projects onto the face is nearest to that face. Of
/// equally near faces the one with the lowest index is taken.
pub(crate) fn nearest_feature(polyhedron: &ConvexPolyhedron, point: DVec3, tolerance: f64) -> NearestFeature {
    let mut plane =
        NearestFeature { feature: SurfaceFeature::Face(0), distance: f64::NEG_INFINITY, normal: DVec3::ZERO };
    let mut over: Option<NearestFeature> = None;
    for (index, face) in polyhedron.faces().enumerate() {
        let distance = face.normal.dot(point) - face.offset;
        let nearest = NearestFeature { feature: SurfaceFeature::Face(index as u32), distance, normal: face.normal };
        if distance > plane.distance {
            plane = nearest;
        }
        if distance > tolerance && over.is_none() && face_margin(polyhedron, &face, point) >= 0.0 {
            over = Some(nearest);
        }
    }
    // A triangle is a flat polyhedron with two faces, whose planes do not bound it.
    let flat = polyhedron.faces.len() == 2;
    let inside = |nearest: &NearestFeature| match nearest.feature {
        SurfaceFeature::Face(face) if flat => {
            polyhedron.face(face as usize).is_some_and(|face| face_margin(polyhedron, &face, point) >= 0.0)
        }
        _ => true,
    };
    if plane.distance <= tolerance && inside(&plane) {
        return plane;
    }
    // When the point is outside a face's plane and projects onto the face, no other feature of a convex body is nearer.
    over.or_else(|| nearest_edge_or_vertex(polyhedron, point)).unwrap_or(plane)
}

fn nearest_edge_or_vertex(polyhedron: &ConvexPolyhedron, point: DVec3) -> Option<NearestFeature> {
    let mut best: Option<NearestFeature> = None;
    let lengths = polyhedron.size() + point.abs().max_element();
    let support = |direction| farthest(&polyhedron.vertices, direction).dot(direction) - point.dot(direction);
    let mut offer = |feature, w: DVec3| {
        let distance = w.length();
        let new = NearestFeature { feature, distance, normal: w / distance };
        let measured = |nearest: &NearestFeature| (nearest.distance, nearest.normal);
        if best
            .is_none_or(|best| feature != best.feature && is_nearer(measured(&new), measured(&best), lengths, support))
        {
            best = Some(new);
        }
    };
    for (index, edge) in polyhedron.edges.iter().enumerate() {
        let w = point - polyhedron.vertices[edge.vertices[0] as usize];
        let along = edge.direction.dot(w);
        if along <= 0.0 {
            offer(SurfaceFeature::Vertex(edge.vertices[0]), w);
        } else if along >= edge.length {
            offer(SurfaceFeature::Vertex(edge.vertices[1]), point - polyhedron.vertices[edge.vertices[1] as usize]);
        } else {
            offer(SurfaceFeature::Edge(index as u32), w - edge.direction * along);
        }
    }
    best
}
