//! Distance and depth of penetration of two convex cores, at least one of them curved (a cylinder or a cone).
//!
//! For cores apart GJK finds the nearest points. It stops when its bounds agree to rounding; the error of its points
//! and normal is then the square root of that. Alternating projections onto the two bodies, in closed form, reduce it
//! to rounding where the curvatures allow. For cores that overlap the depth is that along the best axis of the narrow
//! phase ([`best_axis`]), which is a minimum over all pairs of elements. The witness points are the nearest points
//! after A has been moved out along this axis.

use super::found::{EQUAL_ULPS, Found};
use super::penetration::best_axis;
use super::piece::Piece;
use super::signed_distance::{signed, signed_distance};
use crate::query::gjk::gjk;
use glam::DVec3;
use polhode_spatial::Pose;

/// Most alternating projections; the rate of convergence depends on the curvatures.
const PROJECTIONS: usize = 32;

/// Most moves out of an overlap.
const MOVES: usize = 8;

/// How far A is moved beyond touch, relative to the extent: enough that the normal between the two is well defined.
const ROOM: f64 = 0.125;

/// Distance of two cores that are apart; none when they overlap, or touch to rounding.
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

/// Depth of penetration of two cores that overlap.
pub(crate) fn overlapping(a: &Piece<'_>, b: &Piece<'_>) -> Found {
    let depth = |normal: DVec3| normal.dot(b.support(normal) - a.support(-normal));
    // Of two circles only the first is searched, which may miss the best axis where the depth hardly depends on it: so
    // both orders are tried.
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

/// The result whose witness points are at half the distance on either side of a point.
fn around(a: &Piece<'_>, b: &Piece<'_>, distance: f64, normal: DVec3, middle: DVec3) -> Found {
    let half = normal * (0.5 * distance);
    let (on_a, on_b) = (middle + half, middle - half);
    let feature = |piece: &Piece<'_>, place: DVec3| signed(place, piece).feature;
    Found { distance, normal, on_a, on_b, feature_a: feature(a, on_a), feature_b: feature(b, on_b) }
}
