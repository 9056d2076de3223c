//! Tubes: a circle that is carried along a line of points without turning about it.

use crate::surface_mesh::SurfaceMesh;
use polhode::spatial::DVec3;
use std::f64::consts::TAU;

/// Sides of a tube.
const SIDES: u32 = 8;

/// A tube of this radius (m) along points, with a line that shows it where it is thinner than a pixel.
pub fn tube(points: &[DVec3], radius_m: f64) -> SurfaceMesh {
    let mut mesh = SurfaceMesh::default();
    let mut across = DVec3::ZERO;
    for (place, &point) in points.iter().enumerate() {
        let (before, after) = (points[place.saturating_sub(1)], points[(place + 1).min(points.len() - 1)]);
        let Some(along) = (after - before).try_normalize() else { continue };
        // What was across before, without its part along the line: the circle does not turn about it.
        across = (across - along * across.dot(along)).try_normalize().unwrap_or(along.any_orthonormal_vector());
        let up = along.cross(across);
        let first = mesh.positions.len() as u32;
        for side in 0..SIDES {
            let angle = TAU * f64::from(side) / f64::from(SIDES);
            let normal = across * libm::cos(angle) + up * libm::sin(angle);
            mesh.add_vertex(point + normal * radius_m, normal);
        }
        let Some(last) = first.checked_sub(SIDES) else { continue };
        for side in 0..SIDES {
            let next = (side + 1) % SIDES;
            mesh.triangles.push([last + side, last + next, first + side]);
            mesh.triangles.push([last + next, first + next, first + side]);
        }
        mesh.lines.push([last, first]);
    }
    mesh
}
