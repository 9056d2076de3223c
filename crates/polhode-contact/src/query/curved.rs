//! Distance and depth of two convex cores of which one is curved: a cylinder, a cone.
//!
//! Apart, GJK finds the nearest places. It stops when its bounds have met to rounding; its points and normal are then good to
//! the square root of that. They are projected in closed form onto one body and the other in turn, which makes them good to
//! rounding where the surfaces allow it. Overlapping, the best axis of the narrow phase ([`best_axis`]) has the depth: it goes
//! over all pairs of elements. The places are those that are nearest once A has been moved out along it.

use super::found::{EQUAL_ULPS, Found};
use super::penetration::best_axis;
use super::piece::Piece;
use super::signed_distance::{signed, signed_distance};
use crate::query::gjk::gjk;
use glam::DVec3;
use polhode_spatial::Pose;

/// Most projections in turn; each brings the points nearer by a factor that the curvatures decide.
const PROJECTIONS: usize = 32;

/// Most moves out of an overlap.
const MOVES: usize = 8;

/// How far A is moved beyond touch, relative to the extent: enough that the normal between is sharp.
const ROOM: f64 = 0.125;

/// Distance of two cores that are apart; nothing when they overlap, or touch to rounding.
pub(crate) fn apart(a: &Piece<'_>, b: &Piece<'_>) -> Option<Found> {
    let support = |direction: DVec3| (a.support(direction), b.support(-direction));
    let walk = gjk(&support, a.ball.0 - b.ball.0);
    if walk.touching {
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
            feature_a: to_a.feature,
            feature_b: signed_distance(&b.core, b.pose.inverse_transform_point(on_b)).feature,
        };
    }
    Some(best)
}

/// Depth of two cores that overlap.
pub(crate) fn overlapping(a: &Piece<'_>, b: &Piece<'_>) -> Found {
    let depth = |normal: DVec3| normal.dot(b.support(normal) - a.support(-normal));
    // Two circles are searched along the first one, which may miss the best axis where the depth hardly depends on it.
    let axes = [best_axis(a, b), best_axis(b, a).map(|normal| -normal)];
    let depths = axes.into_iter().flatten().map(|normal| (depth(normal), normal));
    let (mut least, mut normal) =
        depths.min_by(|p, q| p.0.total_cmp(&q.0)).unwrap_or_else(|| (depth(DVec3::Z), DVec3::Z));
    let mut middle = 0.5 * (a.support(-normal) + b.support(normal));
    let extent = a.ball.1 + b.ball.1;
    let (room, rounding) = (ROOM * extent, EQUAL_ULPS * f64::EPSILON * extent);
    for _ in 0..MOVES {
        let out = normal * (least + room);
        let moved = Piece {
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

/// Points around the middle of two places.
fn around(a: &Piece<'_>, b: &Piece<'_>, distance: f64, normal: DVec3, middle: DVec3) -> Found {
    let half = normal * (0.5 * distance);
    let (on_a, on_b) = (middle + half, middle - half);
    let feature = |piece: &Piece<'_>, place: DVec3| signed(place, piece).feature;
    Found { distance, normal, on_a, on_b, feature_a: feature(a, on_a), feature_b: feature(b, on_b) }
}
