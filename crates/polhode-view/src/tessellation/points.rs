//! Sets of points: a small ball at each and lines that join them, or for many points a small octahedron at each.

use super::detail::Detail;
use super::round;
use crate::surface_mesh::SurfaceMesh;
use polhode::contact::ConvexPolyhedron;
use polhode::spatial::DVec3;

/// Radius of the ball at a point, as a fraction of the diagonal of the box around all.
const RADIUS_RELATIVE: f64 = 0.02;
/// Radius for a single point, m: it has no size of its own.
const RADIUS_ALONE_M: f64 = 0.01;
/// Points up to which balls are drawn.
const MOST_BALLS: usize = 64;

/// Radius of the balls about the points, m.
pub fn radius(points: &[DVec3]) -> f64 {
    let Some(&first) = points.first() else { return RADIUS_ALONE_M };
    let [low, high] = points.iter().fold([first; 2], |[low, high], &p| [low.min(p), high.max(p)]);
    let diagonal = (high - low).length();
    if diagonal > 0.0 { RADIUS_RELATIVE * diagonal } else { RADIUS_ALONE_M }
}

/// The surface of balls about the points.
pub fn surface(points: &[DVec3]) -> SurfaceMesh {
    let mut mesh = SurfaceMesh::default();
    let radius = radius(points);
    let ball = if points.len() <= MOST_BALLS { round::unit_sphere(Detail::new(12)) } else { octahedron() };
    for &point in points {
        mesh.add_moved(&ball, point, radius);
    }
    mesh.lines.clear();
    if points.len() <= MOST_BALLS {
        add_spokes(&mut mesh, points);
    }
    mesh
}

/// Lines from the mean of the points to each: they move as one body.
fn add_spokes(mesh: &mut SurfaceMesh, points: &[DVec3]) {
    let mean = points.iter().sum::<DVec3>() / points.len().max(1) as f64;
    let hub = mesh.add_vertex(mean, DVec3::Z);
    for &point in points {
        let end = mesh.add_vertex(point, DVec3::Z);
        mesh.lines.push([hub, end]);
    }
}

fn octahedron() -> SurfaceMesh {
    let corners = [DVec3::X, DVec3::Y, DVec3::Z].into_iter().flat_map(|axis| [axis, -axis]);
    ConvexPolyhedron::from_points(&corners.collect::<Vec<_>>())
        .map_or_else(|_| round::unit_sphere(Detail::new(4)), |hull| super::polyhedron::surface(&hull))
}
