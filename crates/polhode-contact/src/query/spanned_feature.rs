//! The feature of a polytope that some of its vertices span.

use super::element::{Core, Element};
use super::feature::FeatureKind;

/// The feature that some vertices span: one is a vertex, two may be an edge, otherwise a face that has them all.
pub(crate) fn spanned_feature(element: &Element<'_>, vertices: &[u32]) -> FeatureKind {
    let first = vertices.first().copied().unwrap_or(0);
    match (&element.core, vertices.len()) {
        (Core::Point(_) | Core::Segment(_) | Core::Triangle(_) | Core::Polyhedron(_), 0 | 1) => {
            FeatureKind::Vertex(first)
        }
        (Core::Triangle(_), 2) => FeatureKind::Edge(if vertices == [0, 2] { 2 } else { first }),
        (Core::Polyhedron(polyhedron), _) => {
            let edges = polyhedron.edges_at.of(first as usize).iter();
            let joins = |edge: &&u32| {
                let ends = polyhedron.edges[**edge as usize].vertices;
                vertices.len() == 2 && vertices.iter().all(|v| ends.contains(v))
            };
            if let Some(&edge) = edges.clone().find(joins) {
                return FeatureKind::Edge(edge);
            }
            let mut faces = polyhedron.faces_at.of(first as usize).iter();
            let shared = faces.find(|&&f| vertices.iter().all(|&v| polyhedron.faces_at.of(v as usize).contains(&f)));
            FeatureKind::Face(shared.copied().unwrap_or(0))
        }
        (Core::Segment(_), _) => FeatureKind::Edge(0),
        (Core::Triangle(_), _) => FeatureKind::Face(0),
        _ => FeatureKind::Surface,
    }
}
