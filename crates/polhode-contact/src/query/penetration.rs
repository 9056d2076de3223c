//! Depth of penetration of two convex polytopes over all candidate separating axes, with witness points: those where
//! they touch after being moved apart.

use super::found::Found;
use super::piece::{Core, Piece};
use crate::clearance::place_tolerance;
use crate::narrow_phase::axis::axis_search::AxisSearch;
use crate::narrow_phase::axis::gap::between;
use crate::narrow_phase::feature::placed::Placed;
use crate::query::gjk::gjk;
use crate::shape::support::unit;
use crate::{Capsule, Shape};
use glam::DVec3;

/// The largest separation of two polytopes over the normals of faces and the common perpendiculars of edges. In a tie a
/// face of A is taken before one of B, and both before edges; lower indices first.
pub(crate) fn by_all_axes(a: &Piece<'_>, b: &Piece<'_>) -> Found {
    let separation = |n: DVec3| n.dot(a.support(-n) - b.support(n));
    let (mut normal, mut most) = (DVec3::Z, f64::NEG_INFINITY);
    let mut offer = |n: DVec3| {
        let along = separation(n);
        if along > most {
            (normal, most) = (n, along);
        }
    };
    if let (Some(p), Some(q)) = (a.core.polyhedron(), b.core.polyhedron()) {
        let x_ab = a.pose.relative(&b.pose);
        let mut search = AxisSearch::default();
        search.place(&q, &x_ab);
        let axes = search.search(&p, &q, &x_ab, f64::INFINITY);
        offer(-a.pose.rotation.rotate(p.faces[axes.face_a.face as usize].normal));
        offer(b.pose.rotation.rotate(q.faces[axes.face_b.face as usize].normal));
        if let Some(edges) = axes.edges {
            let along_a = a.pose.rotation.rotate(p.edges[edges.edge_a as usize].direction);
            let along_b = b.pose.rotation.rotate(q.edges[edges.edge_b as usize].direction);
            let across = unit(along_a.cross(along_b));
            offer(across);
            offer(-across);
        }
    } else if let Some(axis) = best_axis(a, b) {
        offer(axis);
    }
    witness_points(a, b, normal, most)
}

/// The narrow phase's axis of largest separation of two cores, at least one of which is no polyhedron.
pub(super) fn best_axis(a: &Piece<'_>, b: &Piece<'_>) -> Option<DVec3> {
    let shape = |core: &Core<'_>| match core {
        Core::Cylinder(cylinder) => Some(Shape::Cylinder((*cylinder).clone())),
        Core::Cone(cone) => Some(Shape::Cone((*cone).clone())),
        // A segment is a capsule of radius zero here, which a user cannot make: only its line and ends are used.
        Core::Segment(ends) => Some(Shape::Capsule(Capsule { ends: *ends, radius: 0.0 })),
        core => Some(Shape::Convex(core.polyhedron()?.into_owned())),
    };
    let shapes = [shape(&a.core)?, shape(&b.core)?];
    between(Placed::new(&shapes[0], &a.pose), Placed::new(&shapes[1], &b.pose), f64::INFINITY).map(|gap| gap.normal)
}

/// Witness points: where two polytopes touch after A has been moved out along the normal. They are the nearest points
/// of the hulls of the deepest vertices of each.
fn witness_points(a: &Piece<'_>, b: &Piece<'_>, normal: DVec3, distance: f64) -> Found {
    let tolerance = place_tolerance(a.ball.1, b.ball.1, a.ball.0 - b.ball.0);
    let extreme = |piece: &Piece<'_>, direction: DVec3| -> (Vec<u32>, Vec<DVec3>) {
        let placed: Vec<DVec3> = piece.core.vertices().iter().map(|&v| piece.pose.transform_point(v)).collect();
        let most = placed.iter().map(|p| p.dot(direction)).fold(f64::NEG_INFINITY, f64::max);
        let near = placed.into_iter().enumerate().filter(|(_, p)| p.dot(direction) >= most - tolerance);
        near.map(|(i, p)| (i as u32, p)).unzip()
    };
    let (vertices_a, places_a) = extreme(a, -normal);
    let (vertices_b, places_b) = extreme(b, normal);
    let moved: Vec<DVec3> = places_a.iter().map(|p| *p - normal * distance).collect();
    let support = |direction: DVec3| {
        let along = crate::shape::support::farthest(&moved, direction);
        (along, crate::shape::support::farthest(&places_b, -direction))
    };
    let walk = gjk(&support, a.ball.0 - b.ball.0);
    let (on_a, on_b) = walk.simplex.witnesses();
    let touch = 0.5 * (on_a + on_b);
    Found {
        distance,
        normal,
        on_a: touch + normal * distance,
        on_b: touch,
        feature_a: a.core.spanned(&vertices_a),
        feature_b: b.core.spanned(&vertices_b),
    }
}
