//! Surfaces of revolution about z.
//!
//! A profile is a curve in the half-plane (distance from the axis, height) that has the solid on its left: it runs from
//! the lowest point of the axis outwards and up to the highest. It consists of smooth pieces; where two of them meet
//! the surface has a sharp edge.

use super::detail::Detail;
use crate::surface_mesh::SurfaceMesh;
use polhode::spatial::DVec3;
use std::f64::consts::TAU;

/// A point of a profile.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ProfilePoint {
    /// Distance from the axis, and height.
    pub place: [f64; 2],
    /// Outward unit normal, in the same two directions.
    pub normal: [f64; 2],
    /// Whether the circle through the point is drawn as a line.
    pub line: Line,
}

/// Whether a line is drawn.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Line {
    /// It is.
    Drawn,
    /// It is not.
    Absent,
}

/// The surface of a profile turned about z, each piece by itself; `meridians` says whether four lines run along it.
pub fn revolve(pieces: &[Vec<ProfilePoint>], meridians: Line, detail: Detail) -> SurfaceMesh {
    let segments = detail.segments();
    let directions: Vec<(f64, f64)> =
        (0..segments).map(|i| libm::sincos(TAU * f64::from(i) / f64::from(segments))).collect();
    let mut mesh = SurfaceMesh::default();
    for piece in pieces {
        let first = mesh.positions.len() as u32;
        for point in piece {
            let ([r, z], [across, along]) = (point.place, point.normal);
            for &(sin, cos) in &directions {
                mesh.add_vertex(DVec3::new(r * cos, r * sin, z), DVec3::new(across * cos, across * sin, along));
            }
        }
        let at = |ring: usize, i: u32| first + ring as u32 * segments + i % segments;
        for (ring, point) in piece.iter().enumerate() {
            let radius = point.place[0];
            for i in 0..segments {
                if point.line == Line::Drawn && radius > 0.0 {
                    mesh.lines.push([at(ring, i), at(ring, i + 1)]);
                }
                let Some(above) = piece.get(ring + 1) else { continue };
                // At a pole the circle is a point, and one of the two triangles has no area.
                if radius > 0.0 {
                    mesh.triangles.push([at(ring, i), at(ring, i + 1), at(ring + 1, i + 1)]);
                }
                if above.place[0] > 0.0 {
                    mesh.triangles.push([at(ring, i), at(ring + 1, i + 1), at(ring + 1, i)]);
                }
                if meridians == Line::Drawn && i.is_multiple_of(segments / 4) {
                    mesh.lines.push([at(ring, i), at(ring + 1, i)]);
                }
            }
        }
    }
    mesh
}
