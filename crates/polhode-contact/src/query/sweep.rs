//! The minimum of a signed distance along a segment or a circle.
//!
//! Along a segment the signed distance from a convex body is a convex function, whose slope is the normal times the
//! direction: bisecting the sign of the slope finds the minimum to rounding. Along a circle there may be several local
//! minima: the sign of the slope is computed at [`STARTS`] equal steps, every change from falling to rising is
//! bisected, and the least minimum is taken. Fails where two local minima are less than a step apart: one of them may
//! be missed.

use super::roots::bisect;
use crate::narrow_phase::feature::closest_feature::NearestFeature;
use glam::DVec3;

/// Steps of a circle.
pub(crate) const STARTS: usize = 96;

/// The point of a segment where a convex function is least.
pub(crate) fn along_segment(ends: [DVec3; 2], distance: &dyn Fn(DVec3) -> NearestFeature) -> (DVec3, NearestFeature) {
    let along = ends[1] - ends[0];
    let at = |t: f64| if t < 0.5 { ends[0] + along * t } else { ends[1] - along * (1.0 - t) };
    let slope = |t: f64| distance(at(t)).normal.dot(along);
    if slope(0.0) >= 0.0 {
        return (ends[0], distance(ends[0]));
    }
    let place = bisect(0.0, 1.0, &slope).map_or(ends[1], at);
    (place, distance(place))
}

/// The point of a circle where a function is least; of equal ones the first in the angle from radius `x` to radius `y`.
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
        if previous < 0.0
            && let Some(angle) = bisect(low, high, &slope)
        {
            let found = (at(angle), distance(at(angle)));
            if found.1.distance < best.1.distance {
                best = found;
            }
        }
        previous = next;
    }
    best
}
