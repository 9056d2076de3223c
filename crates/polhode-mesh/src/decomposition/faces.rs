//! The faces of a solid: triangles of one plane as one chain, grown from the largest, so that slivers join a neighbour
//! whose plane is well known.

use super::PLANE_ROUNDINGS;
use super::chain::{Face, reduced};
use super::cut::Space;
use super::plane::Plane;
use crate::TriangleMesh;
use crate::topology::{Topology, names_vertex_twice};
use crate::triangle_mesh::COORDINATE_ROUNDING;
use glam::DVec3;

impl Space {
    /// The space of a mesh that bounds a solid, and the faces of the solid.
    pub(super) fn of(mesh: &TriangleMesh) -> (Self, Vec<Face>) {
        let tolerance = PLANE_ROUNDINGS * COORDINATE_ROUNDING * mesh.bounds().largest_coordinate();
        let mut space = Self::new(mesh.vertices().to_vec(), Vec::new(), tolerance);
        let neighbors = neighbors(mesh);
        let areas: Vec<f64> = mesh.corner_positions().map(twice_area).collect();
        let mut seeds: Vec<u32> = (0..areas.len() as u32).collect();
        seeds.sort_by(|&i, &j| areas[j as usize].total_cmp(&areas[i as usize]).then(i.cmp(&j)));
        let mut is_taken: Vec<bool> = mesh.triangles().iter().map(|&t| names_vertex_twice(t)).collect();
        let mut faces = Vec::new();
        for seed in seeds {
            if is_taken[seed as usize] {
                continue;
            }
            let corners = mesh.corners(mesh.triangles()[seed as usize]);
            // A triangle without area that no neighbour has taken: its normal does not matter, for it bounds nothing.
            let plane = Plane::of_triangle(corners).unwrap_or(Plane { normal: DVec3::Z, origin: corners[0] });
            let region = region(mesh, &neighbors, &plane, tolerance, seed, &mut is_taken);
            let edges = region.iter().flat_map(|&triangle| {
                let [a, b, c] = mesh.triangles()[triangle as usize];
                [(a, b), (b, c), (c, a)]
            });
            faces.push(Face { plane: space.planes.len() as u32, is_flipped: false, edges: reduced(edges) });
            space.planes.push(plane);
        }
        (space, faces)
    }
}

/// The triangles around `seed` whose corners lie in its plane, connected through edges.
fn region(
    mesh: &TriangleMesh,
    neighbors: &[Vec<u32>],
    plane: &Plane,
    tolerance: f64,
    seed: u32,
    is_taken: &mut [bool],
) -> Vec<u32> {
    let mut found = vec![seed];
    is_taken[seed as usize] = true;
    let mut next = 0;
    while let Some(&triangle) = found.get(next) {
        next += 1;
        for &neighbor in &neighbors[triangle as usize] {
            if is_taken[neighbor as usize] {
                continue;
            }
            let corners = mesh.corners(mesh.triangles()[neighbor as usize]);
            let is_in_plane = corners.iter().all(|&corner| plane.distance(corner).abs() <= tolerance);
            // A triangle that faces the other way is the far side of a thin plate, unless it is too thin to face any
            // way.
            let faces_back = Plane::of_triangle(corners).is_some_and(|other| other.normal.dot(plane.normal) < 0.0)
                && height(corners) > tolerance;
            if is_in_plane && !faces_back {
                is_taken[neighbor as usize] = true;
                found.push(neighbor);
            }
        }
    }
    found
}

/// For each triangle those across its edges.
fn neighbors(mesh: &TriangleMesh) -> Vec<Vec<u32>> {
    let mut result = vec![Vec::with_capacity(3); mesh.triangles().len()];
    for edge in Topology::of(mesh).edges() {
        if let [first, second] = edge {
            result[first.triangle as usize].push(second.triangle);
            result[second.triangle as usize].push(first.triangle);
        }
    }
    result
}

fn twice_area([a, b, c]: [DVec3; 3]) -> f64 {
    (b - a).cross(c - a).length()
}

/// Height of a triangle over its longest edge, m.
fn height(corners: [DVec3; 3]) -> f64 {
    let [a, b, c] = corners;
    twice_area(corners) / (b - a).length().max((c - b).length()).max((a - c).length())
}
