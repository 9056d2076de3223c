//! The signed distance of a point from a feature of a shape, with its gradient and curvature.

use crate::clearance::COINCIDENCE;
use crate::narrow_phase::feature::face_border::face_margin;
use crate::narrow_phase::feature::mesh_feature::patch_margin;
use crate::shape::TriangleMesh;
use crate::shape::polyhedron::ConvexPolyhedron;
use crate::{Shape, SurfaceFeature};
use glam::DVec3;

/// Distance of a point from a feature and its derivatives, in the frame of the feature's body. Symbols are those of
/// `evaluate.rs`: gradient `g`, Hessian `H`, direction `e` of an edge.
pub(crate) struct Distance {
    pub(crate) value: f64,
    /// Unit vector from the feature to the point.
    pub(crate) gradient: DVec3,
    /// `H` is `(1 - g g' - e e')` times this, 1/m.
    pub(crate) curvature: f64,
    /// `e`; zero for a vertex, a face or a sphere.
    pub(crate) along: DVec3,
    pub(crate) margin: f64,
}

/// Distance of the point `y` (frame of the shape) from one of the shape's features.
pub(crate) fn distance(shape: &Shape, feature: SurfaceFeature, y: DVec3) -> Option<Distance> {
    match (shape, feature) {
        (Shape::HalfSpace(h), SurfaceFeature::Face(0)) => {
            Some(from_plane(h.normal(), h.normal().dot(y) - h.offset(), f64::INFINITY))
        }
        (Shape::Convex(p), SurfaceFeature::Face(face)) => {
            let face = p.face(face as usize)?;
            Some(from_plane(face.normal, face.normal.dot(y) - face.offset, face_margin(p, &face, y)))
        }
        (Shape::Convex(p), SurfaceFeature::Edge(edge)) => {
            let edge = p.edges.get(edge as usize)?;
            let [left, right] = edge.faces.map(|f| p.faces[f as usize].normal);
            let sides = [edge.direction.cross(left), -edge.direction.cross(right)];
            let w = y - p.vertices[edge.vertices[0] as usize];
            from_edge(w, (edge.direction, edge.length), sides, COINCIDENCE * p.size)
        }
        (Shape::Convex(p), SurfaceFeature::Vertex(vertex)) => from_vertex(p, vertex as usize, y),
        (Shape::TriangleMesh(mesh), feature) => from_mesh(mesh, feature, y),
        (Shape::Sphere(s), SurfaceFeature::Sphere) => {
            from_point(y - s.center(), COINCIDENCE * s.radius(), f64::INFINITY)
        }
        _ => None,
    }
}

pub(crate) fn from_plane(normal: DVec3, value: f64, margin: f64) -> Distance {
    Distance { value, gradient: normal, curvature: 0.0, along: DVec3::ZERO, margin }
}

/// Distance from an edge of the point at `w` (m) from the edge's first end. The Voronoi region of an edge ends at its
/// two vertices and at its two faces; `sides` are the unit vectors in the faces, perpendicular to the edge and out of
/// the face.
fn from_edge(
    w: DVec3,
    (direction, length): (DVec3, f64),
    sides: impl IntoIterator<Item = DVec3>,
    least: f64,
) -> Option<Distance> {
    let along = direction.dot(w);
    let ends = along.min(length - along);
    let margin = sides.into_iter().map(|side| side.dot(w)).fold(ends, f64::min);
    let found = from_point(w - direction * along, least, margin)?;
    Some(Distance { along: direction, ..found })
}

/// Distance from a vertex. Its Voronoi region ends where that of one of its edges begins.
fn from_vertex(polyhedron: &ConvexPolyhedron, index: usize, y: DVec3) -> Option<Distance> {
    let w = y - *polyhedron.vertices.get(index)?;
    let beyond = |&e: &u32| {
        let edge = &polyhedron.edges[e as usize];
        if edge.vertices[0] as usize == index { -edge.direction.dot(w) } else { edge.direction.dot(w) }
    };
    let margin = polyhedron.edges_at.of(index).iter().map(beyond).fold(f64::INFINITY, f64::min);
    from_point(w, COINCIDENCE * polyhedron.size, margin)
}

/// Distance of a point from a feature of the mesh, in the mesh's frame.
fn from_mesh(mesh: &TriangleMesh, feature: SurfaceFeature, y: DVec3) -> Option<Distance> {
    match feature {
        SurfaceFeature::Face(face) => {
            let plane = mesh.face_plane(face)?;
            let value = plane.normal.dot(y) - plane.offset;
            Some(from_plane(plane.normal, value, patch_margin(mesh, face, y - plane.normal * value)))
        }
        SurfaceFeature::Edge(edge) => {
            let line = mesh.edges.get(edge as usize)?;
            let w = y - mesh.vertices[line.vertices[0] as usize];
            let least = COINCIDENCE * line.length;
            from_edge(w, (line.direction, line.length), mesh.sides_at_edge(edge), least)
        }
        SurfaceFeature::Vertex(vertex) => {
            let x = *mesh.vertices.get(vertex as usize)?;
            let w = y - x;
            let beyond = |corner: DVec3| (x - corner).dot(w) / (x - corner).length();
            let margin = mesh.neighbours(vertex).map(beyond).fold(f64::INFINITY, f64::min);
            from_point(w, COINCIDENCE * mesh.first_edge_length(vertex), margin)
        }
        _ => None,
    }
}

/// The distance `|w|` from a point or an edge; none when it is too short (`least`, m) to have a direction, or so long
/// that its square overflows.
fn from_point(w: DVec3, least: f64, margin: f64) -> Option<Distance> {
    let value = w.length();
    (value > least && value.is_finite()).then(|| Distance {
        value,
        gradient: w / value,
        curvature: 1.0 / value,
        along: DVec3::ZERO,
        margin,
    })
}
