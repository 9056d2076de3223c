//! Common normals of a circle and a line, and of two circles, at which their distance is least.
//!
//! In projection along the line, the circle is an ellipse with half axes `R` and `b = R |a.e|`, and the line is a point
//! `(p, q)`: `G(u) = |(R cos u, b sin u) - (p, q)|^2/2` has at most one minimum on either side of the long axis. For a
//! disc that lies almost flat along the line (small `b`) these two are the points where the line crosses the rim. They
//! stay distinct also where the distance vanishes; so the unknown is the circle's angle, not the normal.
//!
//! On the half `0 < u < pi`, `G'(u)/sin u = R p - c cos u - b q cot u` with `c = R^2 - b^2` rises wherever
//! `c sin^3 u > -b q`: everywhere when the line is on this side of the long axis (`q >= 0`), so that there is one
//! minimum. Otherwise it rises only between `u_1 = asin(cbrt(-b q/c))` and `pi - u_1`, so that there is one minimum
//! when `G'(u_1) <= 0 < G'(pi - u_1)`, and none otherwise. A minimum and a maximum that are about to merge are
//! arbitrarily close to each other, so that samples of `G'` alone would miss them.
//!
//! Two circles: the point of one circle closest to a given point of the other has a closed form. All local minima of
//! this distance are found (`minima.rs`), and each is refined by Newton's method in both angles on `|F|^2/2`, whose
//! matrix is regular at crossings.

use crate::narrow_phase::common_normal::minima::{Height, falling_root};
use crate::narrow_phase::common_normal::place::{Place, Places};
use crate::shape::circle::Circle;
use crate::shape::support::across;
use glam::DVec3;
use polhode_spatial::unit_vector::SAME_DIRECTION;
use std::f64::consts::PI;

/// Parts into which each half of the circle is divided to find the minima of its distance from a line.
const LINE_SAMPLES: usize = 16;

/// How far each half reaches beyond the end of the long axis, rad: far above rounding, far below a sample.
const OVERLAP: f64 = 1e-6;

/// Most Newton steps for two circles; from a minimum of the closed form a few are enough.
const NEWTON_STEPS: usize = 30;

/// Newton's method ends when both angles change by less than this, rad: the square of it is far below rounding.
const ANGLE_CONVERGED: f64 = 1e-14;

/// Largest change of an angle in one step, rad.
const LONGEST_TURN: f64 = 0.3;

/// A line (point and direction) as A and a circle as B.
pub(crate) fn line_circle((point, along): (DVec3, DVec3), circle: &Circle) -> Places {
    let Circle { center, axis, radius } = *circle;
    let long = axis.cross(along);
    let sine = long.length();
    let long = if sine > SAME_DIRECTION { long / sine } else { axis.any_orthonormal_vector() };
    let short = axis.cross(long);
    // Components along the line are projected out.
    let [line, long_seen, short_seen] = [point - center, long, short].map(|v| across(v, along));
    let slope_at = |(sine, cosine): (f64, f64)| {
        let to = long_seen * (radius * cosine) + short_seen * (radius * sine) - line;
        to.dot(short_seen * cosine - long_seen * sine)
    };
    let slope = |u: f64| slope_at(libm::sincos(u));
    // When the line lies just inside a thin ellipse, near an end of its long axis, the two minima are close to each
    // other on either side of that end. A sample between each of them and the end separates them.
    let tip = libm::acos((line.dot(long) / radius).clamp(-1.0, 1.0));
    let step = PI / LINE_SAMPLES as f64;
    let mut found = Places::none();
    for half in [1.0, -1.0] {
        let directed = |u: f64| half * slope(half * u);
        let mut last = 0.0;
        let mut before = directed(0.0);
        let mut seen = false;
        let mut visit = |u: f64| {
            let value = directed(u);
            // A minimum: the slope rises through zero.
            if before <= 0.0 && value > 0.0 {
                let angle = -falling_root(-u, -last, |u| directed(-u));
                push_crossing(&mut found, (point, along), circle, half * angle, (long, short));
                seen = true;
            }
            (last, before) = (u, value);
        };
        if tip < step {
            visit(0.5 * tip);
        }
        (1..LINE_SAMPLES).for_each(|k| visit(step * k as f64));
        if PI - tip < step {
            visit(PI - 0.5 * (PI - tip));
        }
        // A little beyond the other end, so that a minimum exactly there lies between two samples.
        visit(PI + OVERLAP);
        // When the line is on the other side of the long axis, the samples may have missed a minimum with the maximum
        // beside it.
        if !seen && let Some((from, to)) = rising_interval(radius, half * line.dot(short_seen), sine) {
            let rises = directed(from) <= 0.0 && directed(to) > 0.0;
            if rises {
                let angle = -falling_root(-to, -from, |u| directed(-u));
                push_crossing(&mut found, (point, along), circle, half * angle, (long, short));
            }
        }
    }
    // A slope that is zero to rounding everywhere means that the line is the axis of the circle: all points are equally
    // close.
    if found.is_empty() {
        push_crossing(&mut found, (point, along), circle, 0.0, (long, short));
    }
    found
}

/// The interval within `0 < u < pi` in which `G'(u)/sin u` rises, for a line on the other side of the long axis, where
/// `across = b q/R` (m) is negative. `radius` (m) is that of the circle, `sine` that of the angle between the line and
/// the circle's axis. None when it rises nowhere, or when the line is on this side.
fn rising_interval(radius: f64, across: f64, sine: f64) -> Option<(f64, f64)> {
    let part = -across / (radius * sine * sine);
    let least = libm::asin(libm::cbrt(part));
    (part > 0.0 && part < 1.0).then_some((least, PI - least))
}

fn push_crossing(
    found: &mut Places,
    (point, along): (DVec3, DVec3),
    circle: &Circle,
    angle: f64,
    (long, short): (DVec3, DVec3),
) {
    let (sine, cosine) = libm::sincos(angle);
    let on_b = circle.center + (long * cosine + short * sine) * circle.radius;
    let tangent = short * cosine - long * sine;
    let on_a = point + along * along.dot(on_b - point);
    found.push(Place { normal: common_normal(on_a - on_b, along, tangent, circle.radius), on_a, on_b });
}

/// The unit vector along `f` that is perpendicular to two tangents: from their cross product or from `f`, whichever is
/// more accurate; its sign is that of `f`. `scale` is the length that bounds the rounding of `f`, m.
fn common_normal(f: DVec3, first: DVec3, second: DVec3, scale: f64) -> DVec3 {
    let cross = first.cross(second);
    let (sine, length) = (cross.length(), f.length());
    if sine * (scale + length) >= length {
        let normal = cross / sine;
        return if normal.dot(f) < 0.0 { -normal } else { normal };
    }
    f / length
}

/// Two circles: the local minima, along the first, of half the squared distance from the second, which has a closed
/// form.
pub(crate) fn circle_circle(first: &Circle, second: &Circle) -> Places {
    let [east, north] = first.radii();
    let between = first.center - second.center;
    let linear = [east, north].map(|radius| between.dot(radius));
    let seen = [between, east, north].map(|v| across(v, second.axis));
    let mut found = Places::none();
    Height::new(linear, second.radius, seen).each_least(|angle| {
        let (sine, cosine) = libm::sincos(angle);
        let on_first = first.center + east * cosine + north * sine;
        if let Some(place) = polished(first, second, on_first, second.nearest(on_first)) {
            found.push(place);
        }
    });
    found
}

/// Newton's method on `|F|^2/2` in the two angles.
fn polished(first: &Circle, second: &Circle, on_a: DVec3, on_b: DVec3) -> Option<Place> {
    let (mut on_a, mut on_b) = (on_a, on_b);
    for _ in 0..NEWTON_STEPS {
        let (radial_a, radial_b) = (on_a - first.center, on_b - second.center);
        let (tangent_a, tangent_b) = (first.axis.cross(radial_a), second.axis.cross(radial_b));
        let f = on_a - on_b;
        let (g_a, g_b) = (f.dot(tangent_a), -f.dot(tangent_b));
        let mut h_aa = tangent_a.length_squared() - f.dot(radial_a);
        let mut h_bb = tangent_b.length_squared() + f.dot(radial_b);
        let h_ab = -tangent_a.dot(tangent_b);
        // Away from a minimum the curvature is made positive, so that the step goes downhill.
        if h_aa <= 0.0 || h_aa * h_bb - h_ab * h_ab <= 0.0 {
            h_aa = h_aa.abs() + h_ab.abs() + tangent_a.length_squared();
            h_bb = h_bb.abs() + h_ab.abs() + tangent_b.length_squared();
        }
        let determinant = h_aa * h_bb - h_ab * h_ab;
        let turn_a = ((h_ab * g_b - h_bb * g_a) / determinant).clamp(-LONGEST_TURN, LONGEST_TURN);
        let turn_b = ((h_ab * g_a - h_aa * g_b) / determinant).clamp(-LONGEST_TURN, LONGEST_TURN);
        if !(turn_a.is_finite() && turn_b.is_finite()) {
            return None;
        }
        on_a = turned(first, radial_a, tangent_a, turn_a);
        on_b = turned(second, radial_b, tangent_b, turn_b);
        if turn_a.abs().max(turn_b.abs()) <= ANGLE_CONVERGED {
            break;
        }
    }
    let tangent_a = first.axis.cross(on_a - first.center) / first.radius;
    let tangent_b = second.axis.cross(on_b - second.center) / second.radius;
    let normal = common_normal(on_a - on_b, tangent_a, tangent_b, first.radius.min(second.radius));
    Some(Place { normal, on_a, on_b })
}

/// The point of a circle rotated by an angle.
fn turned(circle: &Circle, radial: DVec3, tangent: DVec3, angle: f64) -> DVec3 {
    let (sine, cosine) = libm::sincos(angle);
    let radial = radial * cosine + tangent * sine;
    let radial = radial - circle.axis * circle.axis.dot(radial);
    circle.center + radial * (circle.radius / radial.length())
}
