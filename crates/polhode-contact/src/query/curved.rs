//! Distance and depth of two convex cores of which one is curved: a cylinder, a cone.
//!
//! GJK and the expanding polytope stop when their bounds have met to rounding; their points and normals are then good to
//! the square root of that. Apart, the points are projected in closed form onto one body and the other in turn, which makes
//! them good to rounding where the surfaces allow it. Overlapping, the best axis of the narrow phase, over all pairs of
//! elements, takes part: where the depth hardly depends on the axis an iteration ends anywhere. A is then moved out along the
//! normal found, and the normal between the two is taken, of which the normal of the least depth is a fixed point.

use super::element::{Core, Element};
use super::found::{EQUAL_ULPS, Found};
use super::penetration::face_normals;
use super::signed_distance::{signed, signed_distance};
use crate::narrow_phase::axis::gap::between;
use crate::narrow_phase::feature::placed::Placed;
use crate::query::epa::epa;
use crate::query::gjk::{GjkStatus, gjk};
use crate::shape::topology::flat_triangle;
use crate::shape::triangle::area_vector;
use crate::{Capsule, Shape};
use glam::DVec3;
use polhode_spatial::Pose;

/// Most projections in turn; each brings the points nearer by a factor that the curvatures decide.
const PROJECTIONS: usize = 32;

/// Most moves out of an overlap.
const MOVES: usize = 8;

/// How far A is moved beyond touch, relative to the extent: enough that the normal between is sharp.
const ROOM: f64 = 0.125;

/// Distance of two cores that are apart; nothing when they overlap, or touch to rounding.
pub(crate) fn apart(a: &Element<'_>, b: &Element<'_>) -> Option<Found> {
    let support = |direction: DVec3| (a.support(direction), b.support(-direction));
    let walk = gjk(&support, a.ball.0 - b.ball.0);
    if walk.status == GjkStatus::Touching {
        return None;
    }
    let (mut on_a, mut on_b) = walk.simplex.witnesses();
    let mut best = around(a, b, walk.lower, walk.normal, 0.5 * (on_a + on_b));
    let mut least = f64::INFINITY;
    for _ in 0..PROJECTIONS {
        let to_b = signed(on_a, b);
        on_b = on_a - to_b.normal * to_b.distance;
        let to_a = signed(on_b, a);
        on_a = on_b - to_a.normal * to_a.distance;
        if !(to_a.distance > 0.0 && to_b.distance > 0.0 && to_a.distance < least) {
            break;
        }
        least = to_a.distance;
        best = Found {
            distance: to_a.distance,
            normal: -to_a.normal,
            on_a,
            on_b,
            kind_a: to_a.kind,
            kind_b: signed_distance(&b.core, b.pose.inverse_transform_point(on_b)).kind,
        };
    }
    Some(best)
}

/// Depth of two cores that overlap.
pub(crate) fn by_expansion(a: &Element<'_>, b: &Element<'_>) -> Found {
    let support = |direction: DVec3| (a.support(direction), b.support(-direction));
    let hints: Vec<DVec3> = flat_normals(a).into_iter().chain(flat_normals(b)).flat_map(|n| [n, -n]).collect();
    let Some(found) = epa(&support, &hints) else {
        // A flat difference has no depth.
        let walk = gjk(&support, a.ball.0 - b.ball.0);
        let (on_a, on_b) = walk.simplex.witnesses();
        return around(a, b, 0.0, walk.normal, 0.5 * (on_a + on_b));
    };
    let depth = |normal: DVec3| normal.dot(b.support(normal) - a.support(-normal));
    let (mut normal, mut least) = (-found.outward, found.upper);
    let extent = a.ball.1 + b.ball.1;
    let (room, rounding) = (ROOM * extent, EQUAL_ULPS * f64::EPSILON * extent);
    if let Some(axis) = best_axis(a, b)
        && depth(axis) <= least + rounding
    {
        (normal, least) = (axis, depth(axis));
    }
    let mut middle = 0.5 * (found.witnesses.0 + found.witnesses.1);
    for _ in 0..MOVES {
        let out = normal * (least + room);
        let moved = Element {
            pose: Pose::new(a.pose.rotation, a.pose.translation + out),
            ball: (a.ball.0 + out, a.ball.1),
            ..*a
        };
        let Some(between) = apart(&moved, b) else { break };
        let along = depth(between.normal);
        if along > least + rounding {
            break;
        }
        middle = 0.5 * ((between.on_a - out) + between.on_b);
        if along >= least - rounding {
            break;
        }
        (normal, least) = (between.normal, along);
    }
    around(a, b, -least, normal, middle)
}

/// The axis along which the narrow phase separates two cores best.
fn best_axis(a: &Element<'_>, b: &Element<'_>) -> Option<DVec3> {
    let shape = |core: &Core<'_>| match core {
        Core::Polyhedron(polyhedron) => Some(Shape::Convex((*polyhedron).clone())),
        Core::Cylinder(cylinder) => Some(Shape::Cylinder((*cylinder).clone())),
        Core::Cone(cone) => Some(Shape::Cone((*cone).clone())),
        // Without a radius, which no capsule of a user has: only its line and its ends are asked for.
        Core::Segment(ends) => Some(Shape::Capsule(Capsule { ends: *ends, radius: 0.0 })),
        Core::Triangle(corners) => {
            let normal = area_vector(*corners).try_normalize()?;
            Some(Shape::Convex(flat_triangle(*corners, normal)))
        }
        _ => None,
    };
    let shapes = [shape(&a.core)?, shape(&b.core)?];
    between(Placed::new(&shapes[0], &a.pose), Placed::new(&shapes[1], &b.pose), f64::INFINITY).map(|gap| gap.normal)
}

/// Points around the middle of two places.
fn around(a: &Element<'_>, b: &Element<'_>, distance: f64, normal: DVec3, middle: DVec3) -> Found {
    let half = normal * (0.5 * distance);
    let (on_a, on_b) = (middle + half, middle - half);
    let kind = |element: &Element<'_>, place: DVec3| signed(place, element).kind;
    Found { distance, normal, on_a, on_b, kind_a: kind(a, on_a), kind_b: kind(b, on_b) }
}

/// Normals of flat faces, and the direction of an axis.
fn flat_normals(element: &Element<'_>) -> Vec<DVec3> {
    match &element.core {
        Core::Cylinder(c) => vec![element.pose.rotation.rotate(c.axis)],
        Core::Cone(c) => vec![element.pose.rotation.rotate(c.axis)],
        _ => face_normals(element),
    }
}
