//! The name of a contact of two surface features, and the two features that a contact names.

use crate::{ContactFeature, Shape, Side, SurfaceFeature};

/// The [`ContactFeature`] of two surface features: the variant for their kinds, or `Elements`.
pub(crate) fn named(a: SurfaceFeature, b: SurfaceFeature) -> ContactFeature {
    use SurfaceFeature::{Cap, Edge, Face, Sphere, Vertex};
    match (a, b) {
        (Vertex(vertex), Face(face)) => ContactFeature::VertexFace { vertex_of: Side::A, vertex, face },
        (Face(face), Vertex(vertex)) => ContactFeature::VertexFace { vertex_of: Side::B, vertex, face },
        (Cap(center), Face(_) | Edge(_) | Vertex(_)) => {
            ContactFeature::Smooth { center_of: Side::A, center, against: b }
        }
        (Face(_) | Edge(_) | Vertex(_), Cap(center)) => {
            ContactFeature::Smooth { center_of: Side::B, center, against: a }
        }
        (Sphere, _) => ContactFeature::Smooth { center_of: Side::A, center: 0, against: b },
        (_, Sphere) => ContactFeature::Smooth { center_of: Side::B, center: 0, against: a },
        _ => ContactFeature::Elements { a, b },
    }
}

/// The two surface features that a contact names, A's first; none when the shapes have no such features.
pub(crate) fn surface_parts(
    feature: ContactFeature,
    shape_a: &Shape,
    shape_b: &Shape,
) -> Option<(SurfaceFeature, SurfaceFeature)> {
    use SurfaceFeature::{Cap, Edge, Face, Sphere, Vertex};
    let (of, first, second) = match feature {
        ContactFeature::Elements { a, b } => (Side::A, a, b),
        ContactFeature::VertexFace { vertex_of, vertex, face } => (vertex_of, Vertex(vertex), Face(face)),
        ContactFeature::EdgeEdge { edge_a, edge_b } => (Side::A, Edge(edge_a), Edge(edge_b)),
        ContactFeature::SphereSphere | ContactFeature::Spheres { .. } => (Side::A, Sphere, Sphere),
        ContactFeature::Smooth { center_of, center, against } => {
            let owner = if center_of == Side::A { shape_a } else { shape_b };
            let own = match owner {
                Shape::Sphere(_) if center == 0 => Sphere,
                Shape::Capsule(_) => Cap(center),
                Shape::Points(_) | Shape::Torus(_) => Vertex(center),
                _ => return None,
            };
            (center_of, own, against)
        }
    };
    Some(if of == Side::A { (first, second) } else { (second, first) })
}
