//! Convex polyhedra: every face by itself, every edge a line.

use crate::surface_mesh::SurfaceMesh;
use polhode::contact::ConvexPolyhedron;

/// Cosine of the bend at an edge above which no line is drawn (about 8 degrees): a finely faceted body would be all
/// lines.
const SMOOTH_COSINE: f64 = 0.99;

/// The surface of a polyhedron in its own frame.
pub fn surface(polyhedron: &ConvexPolyhedron) -> SurfaceMesh {
    let mut mesh = SurfaceMesh::default();
    let vertices = polyhedron.vertices();
    let normals: Vec<_> = polyhedron.faces().map(|face| face.normal).collect();
    for (number, face) in polyhedron.faces().enumerate() {
        let first = mesh.positions.len() as u32;
        for &vertex in face.vertices {
            mesh.add_vertex(vertices[vertex as usize], face.normal);
        }
        let count = face.vertices.len() as u32;
        mesh.triangles.extend((1..count.saturating_sub(1)).map(|i| [first, first + i, first + i + 1]));
        for (i, &edge) in face.edges.iter().enumerate() {
            let [a, b] = polyhedron.edges()[edge as usize].faces.map(|face| face as usize);
            // Each edge is drawn once, by the first of its faces.
            if a == number && normals[a].dot(normals[b]) < SMOOTH_COSINE {
                mesh.lines.push([first + i as u32, first + (i as u32 + 1) % count]);
            }
        }
    }
    mesh
}
