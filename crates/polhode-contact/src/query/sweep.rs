//! The least of a signed distance along a segment or a circle.
//!
//! Along a segment the signed distance from a convex body is a convex function, whose slope is the normal times the
//! direction: bisecting the sign of the slope finds the least place to rounding. Along a circle there may be several
//! least places: the slope's sign is taken at [`STARTS`] equal steps, every change from falling to rising is bisected, and
//! the least is taken. Two least places of one circle that are less than a step apart are told apart only by chance.

use crate::narrow_phase::feature::closest_feature::NearestFeature;
use glam::DVec3;

/// Steps of a circle.
pub(crate) const STARTS: usize = 96;

/// Halvings, after which a step is shorter than rounding.
const HALVINGS: usize = 60;

/// Halving ends when a bracket is this much of its place.
const NARROW: f64 = f64::EPSILON;

/// The place on a segment where a convex function is least.
pub(crate) fn along_segment(ends: [DVec3; 2], distance: &dyn Fn(DVec3) -> NearestFeature) -> (DVec3, NearestFeature) {
    let along = ends[1] - ends[0];
    let at = |t: f64| if t < 0.5 { ends[0] + along * t } else { ends[1] - along * (1.0 - t) };
    let slope = |t: f64| distance(at(t)).normal.dot(along);
    if slope(0.0) >= 0.0 {
        return (ends[0], distance(ends[0]));
    }
    if slope(1.0) <= 0.0 {
        return (ends[1], distance(ends[1]));
    }
    let t = turn(0.0, 1.0, &slope);
    nearer(at(t.0), at(t.1), distance)
}

/// The place on a circle where a function is least; of equal ones that with the least angle from `x` towards `y`, the two
/// radii given.
pub(crate) fn along_circle(
    center: DVec3,
    x: DVec3,
    y: DVec3,
    distance: &dyn Fn(DVec3) -> NearestFeature,
) -> (DVec3, NearestFeature) {
    let step = std::f64::consts::TAU / STARTS as f64;
    let at = |angle: f64| center + x * libm::cos(angle) + y * libm::sin(angle);
    let slope = |angle: f64| distance(at(angle)).normal.dot(y * libm::cos(angle) - x * libm::sin(angle));
    let mut best = (at(0.0), distance(at(0.0)));
    let mut previous = slope(0.0);
    for k in 0..STARTS {
        let (low, high) = (step * k as f64, step * (k + 1) as f64);
        let next = slope(high);
        if previous < 0.0 && next >= 0.0 {
            let ends = turn(low, high, &slope);
            let found = nearer(at(ends.0), at(ends.1), distance);
            if found.1.distance < best.1.distance {
                best = found;
            }
        }
        previous = next;
    }
    best
}

/// Bracket of the place where a slope turns from falling to rising.
fn turn(mut low: f64, mut high: f64, slope: &dyn Fn(f64) -> f64) -> (f64, f64) {
    for _ in 0..HALVINGS {
        let middle = 0.5 * (low + high);
        if high - low <= NARROW * high {
            break;
        }
        if slope(middle) < 0.0 {
            low = middle;
        } else {
            high = middle;
        }
    }
    (low, high)
}

fn nearer(p: DVec3, q: DVec3, distance: &dyn Fn(DVec3) -> NearestFeature) -> (DVec3, NearestFeature) {
    let (at_p, at_q) = (distance(p), distance(q));
    if at_p.distance <= at_q.distance { (p, at_p) } else { (q, at_q) }
}
