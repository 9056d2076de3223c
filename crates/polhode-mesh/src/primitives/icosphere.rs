//! Meshes of spheres and ellipsoids: an icosahedron whose triangles are split into four again and again.

use super::{PrimitiveError, Refinement};
use crate::triangle_mesh::TriangleMesh;
use glam::DVec3;

/// The icosahedron's triangles; its vertices are those of [`icosahedron`].
const FACES: [[u32; 3]; 20] = [
    [0, 11, 5],
    [0, 5, 1],
    [0, 1, 7],
    [0, 7, 10],
    [0, 10, 11],
    [1, 5, 9],
    [5, 11, 4],
    [11, 10, 2],
    [10, 7, 6],
    [7, 1, 8],
    [3, 9, 4],
    [3, 4, 2],
    [3, 2, 6],
    [3, 6, 8],
    [3, 8, 9],
    [4, 9, 5],
    [2, 4, 11],
    [6, 2, 10],
    [8, 6, 7],
    [9, 8, 1],
];

/// Vertices of the icosahedron in the unit sphere: corners of three golden rectangles.
fn icosahedron() -> Vec<DVec3> {
    let g = f64::midpoint(1.0, 5.0_f64.sqrt());
    let corners = [
        [-1.0, g, 0.0],
        [1.0, g, 0.0],
        [-1.0, -g, 0.0],
        [1.0, -g, 0.0],
        [0.0, -1.0, g],
        [0.0, 1.0, g],
        [0.0, -1.0, -g],
        [0.0, 1.0, -g],
        [g, 0.0, -1.0],
        [g, 0.0, 1.0],
        [-g, 0.0, -1.0],
        [-g, 0.0, 1.0],
    ];
    corners.map(|corner| DVec3::from_array(corner).normalize()).to_vec()
}

/// The mesh of an ellipsoid with these semi-axes: of the unit sphere, stretched. New vertices are the middles of edges,
/// moved out to the sphere.
pub(super) fn icosphere(refinement: Refinement, semi_axes: DVec3) -> Result<TriangleMesh, PrimitiveError> {
    let (mut vertices, mut triangles) = (icosahedron(), FACES.to_vec());
    for _ in 0..refinement.level() {
        triangles = split_in_four(&mut vertices, &triangles);
    }
    Ok(TriangleMesh::new(vertices.into_iter().map(|v| v * semi_axes).collect(), triangles)?)
}

fn split_in_four(vertices: &mut Vec<DVec3>, triangles: &[[u32; 3]]) -> Vec<[u32; 3]> {
    let key = |i: u32, j: u32| (i.min(j), i.max(j));
    let mut edges: Vec<(u32, u32)> =
        triangles.iter().flat_map(|&[a, b, c]| [key(a, b), key(b, c), key(c, a)]).collect();
    edges.sort_unstable();
    edges.dedup();
    let first = vertices.len() as u32;
    // The middle of every edge has the edge's place in the sorted list.
    let middles: Vec<DVec3> =
        edges.iter().map(|&(i, j)| (vertices[i as usize] + vertices[j as usize]).normalize()).collect();
    vertices.extend(middles);
    let middle = |i: u32, j: u32| first + edges.partition_point(|&edge| edge < key(i, j)) as u32;
    let mut split = Vec::with_capacity(4 * triangles.len());
    for &[a, b, c] in triangles {
        let (ab, bc, ca) = (middle(a, b), middle(b, c), middle(c, a));
        split.extend([[a, ab, ca], [ab, b, bc], [ca, bc, c], [ab, bc, ca]]);
    }
    split
}
