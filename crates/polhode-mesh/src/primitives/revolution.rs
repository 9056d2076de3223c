//! Meshes of bodies of revolution about z, inscribed in the body.

use super::{PrimitiveError, Refinement};
use crate::SolidMesh;
use crate::triangle_mesh::TriangleMesh;
use glam::DVec3;
use std::f64::consts::{FRAC_PI_2, TAU};

/// A body of revolution: a point on the axis, rings, a point on the axis, with z ascending.
pub(super) struct Profile {
    /// Height of the lowest point of the axis, m.
    pub(super) bottom: f64,
    /// Distance from the axis and height of each ring, from below, m.
    pub(super) rings: Vec<[f64; 2]>,
    /// Height of the highest point of the axis, m.
    pub(super) top: f64,
}

/// Rings of the upper half of the unit sphere, from the equator up, the pole left out: distance from the axis, height.
pub(super) fn arc(refinement: Refinement) -> Vec<[f64; 2]> {
    let count = refinement.segments() / 4;
    (0..count)
        .map(|i| {
            let (sin, cos) = libm::sincos(FRAC_PI_2 * f64::from(i) / f64::from(count));
            [cos, sin]
        })
        .collect()
}

/// The mesh of the profile turned about z: a fan at each end, quadrilaterals of two triangles between the rings.
pub(super) fn revolve(profile: &Profile, refinement: Refinement) -> Result<SolidMesh, PrimitiveError> {
    let segments = refinement.segments();
    let directions: Vec<(f64, f64)> =
        (0..segments).map(|i| libm::sincos(TAU * f64::from(i) / f64::from(segments))).collect();
    // The two points on the axis come first.
    let mut vertices = vec![DVec3::Z * profile.bottom, DVec3::Z * profile.top];
    for &[rho, z] in &profile.rings {
        vertices.extend(directions.iter().map(|&(sin, cos)| DVec3::new(rho * cos, rho * sin, z)));
    }
    let at = |ring: u32, i: u32| 2 + ring * segments + i % segments;
    let rings = profile.rings.len() as u32;
    let mut triangles = Vec::new();
    for i in 0..segments {
        triangles.push([0, at(0, i + 1), at(0, i)]);
        for ring in 1..rings {
            let (lower, upper) = (ring - 1, ring);
            triangles.push([at(lower, i), at(lower, i + 1), at(upper, i + 1)]);
            triangles.push([at(lower, i), at(upper, i + 1), at(upper, i)]);
        }
        triangles.push([1, at(rings - 1, i), at(rings - 1, i + 1)]);
    }
    Ok(SolidMesh::new(TriangleMesh::new(vertices, triangles)?)?)
}
