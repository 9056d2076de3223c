//! Distance of two convex polytopes: points, segments, triangles, polyhedra.
//!
//! GJK finds the nearest features; the distance is then computed from them in closed form. The separation along any
//! unit vector is a lower bound of the distance, and equals it along one direction: the normal of the face that
//! contains the nearest point, the common perpendicular of two edges, or the line between two vertices. These few
//! directions are tried and the largest separation is taken, so that the error is that of the coordinates' rounding,
//! not the tolerance of an iteration. The result is accepted when it agrees with the upper bound. Otherwise the nearest
//! pair of features around those found by GJK is taken; when the bodies overlap, all axes are searched.

use super::found::{EQUAL_ULPS, Found};
use super::nearest_pair::nearest_pair;
use super::penetration::by_all_axes;
use super::piece::{Core, Piece};
use crate::query::gjk::{Gjk, gjk};
use crate::query::simplex::{Difference, Simplex};
use crate::shape::support::unit;
use glam::DVec3;

/// The lower and upper bound of a distance agree when they differ by at most this many epsilon of the extent.
const CERTIFIED_ULPS: f64 = 32.0;

/// Rounding of the direction between two points, in epsilon times the extent over their distance.
const DIRECTION_ULPS: f64 = 2.0;

/// Distance of two polytopes in the common frame; negative when they overlap.
pub(crate) fn distance(a: &Piece<'_>, b: &Piece<'_>) -> Found {
    let support = |direction: DVec3| (a.support(direction), b.support(-direction));
    let walk = gjk(&support, a.ball.0 - b.ball.0);
    if walk.touching {
        return by_all_axes(a, b);
    }
    let extent = a.ball.1 + b.ball.1 + (a.ball.0 - b.ball.0).length();
    let certain = |found: &Found| walk.upper - found.distance <= CERTIFIED_ULPS * f64::EPSILON * extent;
    if let Some(found) = on_features(a, b, &walk, extent).filter(certain) {
        return found;
    }
    // When a vertex or an edge nearly touches, the normal is rounding error, no direction gives a sharp bound, and GJK
    // cannot choose between points that are equally near to rounding. Then the nearest pair of features around the
    // simplex decides.
    let vertices = [vertices_of(a, &walk.simplex, |p| p.a), vertices_of(b, &walk.simplex, |p| p.b)];
    nearest_pair(a, b, &vertices)
}

/// The largest separation along the directions of the features found by GJK. In a tie to rounding, a face normal near
/// GJK's direction is preferred, then that direction, then the others. None when the nearest points are vertices and
/// the separation along the line between them is less than their distance: then other features are nearer.
fn on_features(a: &Piece<'_>, b: &Piece<'_>, walk: &Gjk, extent: f64) -> Option<Found> {
    let vertices = [vertices_of(a, &walk.simplex, |p| p.a), vertices_of(b, &walk.simplex, |p| p.b)];
    let mut last = walk.simplex;
    let between = last.reduce().direction;
    // A face's normal is exact to rounding; the direction between two near points has the relative rounding of their
    // difference.
    let rounding = DIRECTION_ULPS * f64::EPSILON * extent / walk.upper;
    let (mut directions, mut others) = (Vec::new(), Vec::new());
    for (piece, sign, own) in [(a, -1.0, &vertices[0]), (b, 1.0, &vertices[1])] {
        if let (Core::Polyhedron(polyhedron), Some(&first)) = (piece.core, own.first()) {
            let shared = |face: &&u32| own.iter().all(|&v| polyhedron.faces_at.of(v as usize).contains(face));
            for &face in polyhedron.faces_at.of(first as usize).iter().filter(shared) {
                let n = piece.pose.rotation.rotate(polyhedron.faces[face as usize].normal) * sign;
                if (n - between).length() <= rounding { directions.push(n) } else { others.push(n) }
            }
        }
    }
    let faces = directions.len();
    directions.push(between);
    directions.append(&mut others);
    directions.extend(walk.simplex.points().iter().map(|pair| unit(pair.w)));
    directions.push(walk.normal);
    let separation = |n: DVec3| n.dot(a.support(-n) - b.support(n));
    let certified = CERTIFIED_ULPS * f64::EPSILON * extent;
    let (mut normal, mut most, mut chosen) = (walk.normal, f64::NEG_INFINITY, 0);
    for (index, &n) in directions.iter().enumerate().filter(|(_, n)| n.dot(walk.normal) > 0.0) {
        let along = separation(n);
        if along > most + EQUAL_ULPS * f64::EPSILON * extent {
            (normal, most, chosen) = (n, along, index);
        }
    }
    let (on_a, on_b) = walk.simplex.witnesses();
    let [feature_a, feature_b] = [a.core.spanned(&vertices[0]), b.core.spanned(&vertices[1])];
    if chosen >= faces && walk.simplex.points().len() < 3 && walk.upper - most <= certified {
        // A vertex is nearest: distance and direction are those of the two points. The direction that confirmed it may
        // have been the normal of a nearby face.
        let w = on_a - on_b;
        let found = Found { distance: w.length(), normal: unit(w), on_a, on_b, feature_a, feature_b };
        return (found.distance - separation(found.normal) <= certified).then_some(found);
    }
    let middle = 0.5 * (on_a + on_b);
    let half = normal * (0.5 * most);
    Some(Found { distance: most, normal, on_a: middle + half, on_b: middle - half, feature_a, feature_b })
}

/// Numbers of the vertices of a simplex on one body, each once, ascending.
fn vertices_of(piece: &Piece<'_>, simplex: &Simplex, of: impl Fn(&Difference) -> DVec3) -> Vec<u32> {
    let nearest = |point: &Difference| {
        let local = piece.pose.inverse_transform_point(of(point));
        let vertices = piece.core.vertices().iter().enumerate();
        let least = vertices.map(|(i, v)| (v.distance_squared(local), i)).min_by(|p, q| p.0.total_cmp(&q.0));
        least.map_or(0, |(_, i)| i as u32)
    };
    let mut found: Vec<u32> = simplex.points().iter().map(nearest).collect();
    found.sort_unstable();
    found.dedup();
    found
}
