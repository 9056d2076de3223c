//! Separation of two bodies at given poses: positive when they are apart, negative by the depth of their overlap.
//!
//! Along a unit direction d two convex bodies A and B are apart by `min over B of d.x - max over A of d.x`, and their
//! separation is the largest of these. Any direction gives a lower bound, so that one direction proves that two bodies
//! are not in each other. Directions are tried in the order: the one that served last, from centre to centre, normals
//! of faces, axes. If none proves it, the largest value is searched on the tangent plane of the best one: as a function
//! of the two coordinates there it is quasi-concave (exactly for bodies that are apart, and up to the depth itself
//! relative to the sizes for bodies in each other), so that a search by golden sections within one by golden sections
//! finds it. A ring is searched along its circle for the point with the least separation.
//!
//! Fails: an overlap that is deep compared with the bodies may be found deeper than it is.

use super::distance;
use super::piece::{Core, Placed};
use glam::DVec3;
use std::f64::consts::TAU;

/// Points of a circle at which the search along it begins.
const CIRCLE_POINTS: usize = 48;
/// Sections of a search by golden sections: an interval of 3 is cut to 1e-12.
const SECTIONS: u32 = 60;
/// The golden section.
const GOLDEN: f64 = 0.618_033_988_749_894_8;
/// Half the width of the square of the tangent plane that is searched (no unit).
const SQUARES: [f64; 3] = [1.5, 1.5, 1e-3];

/// The separation of two pieces, m, or any lower bound of it that is at least `enough`. `hint` is a unit direction from
/// the first to the second that served last.
pub(super) fn separation(a: &Placed, b: &Placed, enough: f64, hint: &mut DVec3) -> f64 {
    let margins = a.margin + b.margin;
    match (&a.core, &b.core) {
        (Core::HalfSpace(normal), _) => above(a, *normal, b),
        (_, Core::HalfSpace(normal)) => above(b, *normal, a),
        (Core::Circle(radius), _) => around(a, *radius, b, enough + margins) - margins,
        (_, Core::Circle(radius)) => around(b, *radius, a, enough + margins) - margins,
        (Core::Point, _) => distance::signed(b, a.center) - margins,
        (_, Core::Point) => distance::signed(a, b.center) - margins,
        (Core::Segment(half_a), Core::Segment(half_b)) => of_segments(a, *half_a, b, *half_b) - margins,
        _ => of_convex(a, b, enough + margins, hint) - margins,
    }
}

/// Of a half-space and a body above it.
fn above(plane: &Placed, normal: DVec3, body: &Placed) -> f64 {
    normal.dot(body.center - plane.center) - body.support(-normal) - body.margin
}

/// A lower bound of the separation along a direction from the first to the second, which need not be a unit vector.
fn along(a: &Placed, b: &Placed, direction: DVec3) -> f64 {
    let length = direction.length();
    if length == 0.0 {
        return f64::NEG_INFINITY;
    }
    (direction.dot(b.center - a.center) - a.support(direction) - b.support(-direction)) / length
}

fn of_convex(a: &Placed, b: &Placed, enough: f64, hint: &mut DVec3) -> f64 {
    let mut best = (along(a, b, *hint), *hint);
    let mut try_direction = |direction: DVec3| {
        let value = along(a, b, direction);
        if value > best.0 {
            best = (value, direction.normalize());
        }
        best.0 >= enough
    };
    let found = try_direction(b.center - a.center)
        || candidates(a).into_iter().any(&mut try_direction)
        || candidates(b).into_iter().any(|direction| try_direction(-direction));
    if !found {
        for half in SQUARES {
            best = search(a, b, best, half);
            if best.0 >= enough {
                break;
            }
        }
    }
    *hint = best.1;
    best.0
}

/// Outward directions of faces, and of an axis.
fn candidates(piece: &Placed) -> Vec<DVec3> {
    match &piece.core {
        Core::Hull(hull) => hull.normals.clone(),
        Core::Cylinder(..) | Core::Cone(..) => vec![piece.axis(), -piece.axis()],
        _ => Vec::new(),
    }
}

/// The largest value on the tangent plane of a direction, and where it is.
fn search(a: &Placed, b: &Placed, start: (f64, DVec3), half: f64) -> (f64, DVec3) {
    let first = start.1.any_orthonormal_vector();
    let second = start.1.cross(first);
    let at = |u: f64, v: f64| start.1 + first * u + second * v;
    let inner = |u: f64| largest(-half, half, |v| along(a, b, at(u, v)));
    let (_, u) = largest(-half, half, |u| inner(u).0);
    let (value, v) = inner(u);
    if value > start.0 { (value, at(u, v).normalize()) } else { start }
}

/// The largest value of a function that rises and then falls, and where it is.
fn largest(mut low: f64, mut high: f64, value: impl Fn(f64) -> f64) -> (f64, f64) {
    let (mut left, mut right) = (high - GOLDEN * (high - low), low + GOLDEN * (high - low));
    let (mut at_left, mut at_right) = (value(left), value(right));
    for _ in 0..SECTIONS {
        if at_left < at_right {
            (low, left, at_left) = (left, right, at_right);
            right = low + GOLDEN * (high - low);
            at_right = value(right);
        } else {
            (high, right, at_right) = (right, left, at_left);
            left = high - GOLDEN * (high - low);
            at_left = value(left);
        }
    }
    if at_left > at_right { (at_left, left) } else { (at_right, right) }
}

/// Separation of a circle from a core, m.
fn around(ring: &Placed, radius: f64, other: &Placed, enough: f64) -> f64 {
    let apart = (ring.center - other.center).length() - ring.reach - other.reach;
    if apart >= enough {
        return apart;
    }
    let point =
        |angle: f64| ring.center + ring.rotation * (DVec3::new(libm::cos(angle), libm::sin(angle), 0.0) * radius);
    let separation = |angle: f64| distance::signed(other, point(angle));
    let step = TAU / CIRCLE_POINTS as f64;
    let values: Vec<f64> = (0..CIRCLE_POINTS).map(|k| separation(k as f64 * step)).collect();
    let value = |k: usize| values[k % CIRCLE_POINTS];
    let mut least = f64::INFINITY;
    for k in 0..CIRCLE_POINTS {
        let middle = value(k + CIRCLE_POINTS);
        if middle <= value(k + CIRCLE_POINTS - 1) && middle <= value(k + 1) {
            let (low, high) = ((k as f64 - 1.0) * step, (k as f64 + 1.0) * step);
            let (found, _) = largest(low, high, |angle| -separation(angle));
            least = least.min(-found).min(middle);
        }
    }
    least
}

/// Distance of two segments, m.
fn of_segments(a: &Placed, half_a: f64, b: &Placed, half_b: f64) -> f64 {
    // Where the lines are nearest, and from each end: the least of all.
    let (u, v, between) = (a.axis(), b.axis(), b.center - a.center);
    let cosine = u.dot(v);
    let mut least = f64::INFINITY;
    for end in [-half_a, half_a] {
        least = least.min(distance::signed(b, a.center + u * end));
    }
    for end in [-half_b, half_b] {
        least = least.min(distance::signed(a, b.center + v * end));
    }
    let square = 1.0 - cosine * cosine;
    if square > f64::MIN_POSITIVE {
        let s = (between.dot(u) - cosine * between.dot(v)) / square;
        let t = (cosine * between.dot(u) - between.dot(v)) / square;
        if s.abs() <= half_a && t.abs() <= half_b {
            least = least.min((between + v * t - u * s).length());
        }
    }
    least
}

#[cfg(test)]
mod tests {
    //! Separations that are known in closed form.
    use super::super::piece::{Placed, pieces};
    use super::*;
    use crate::random_scene::model::Form;
    use glam::DQuat;
    use std::f64::consts::FRAC_PI_2;

    fn placed(form: &Form, position: DVec3, turn: DVec3) -> Placed {
        let turn = if turn == DVec3::ZERO { DQuat::IDENTITY } else { DQuat::from_scaled_axis(turn) };
        pieces(form)[0].placed(position, turn)
    }

    fn between(a: &Placed, b: &Placed) -> f64 {
        separation(a, b, f64::INFINITY, &mut DVec3::new(0.6, 0.0, 0.8))
    }

    #[test]
    fn crossed_cylinders_touch_along_their_common_perpendicular() {
        let one = placed(&Form::Cylinder(0.1, 1.0), DVec3::ZERO, DVec3::X * FRAC_PI_2);
        for depth in [-1e-3, -1e-9, 1e-9, 1e-3] {
            let turn = DVec3::Y * FRAC_PI_2;
            let other = placed(&Form::Cylinder(0.2, 1.0), DVec3::new(0.1, 0.2, 0.3 - depth), turn);
            assert!((between(&one, &other) + depth).abs() < 1e-14, "{depth}: {}", between(&one, &other));
        }
    }

    #[test]
    fn crossed_edges_of_cubes() {
        let lower = placed(&Form::Cuboid(DVec3::ONE), DVec3::ZERO, DVec3::X * (0.5 * FRAC_PI_2));
        let at = DVec3::new(0.1, 0.05, 2.0_f64.sqrt() - 1e-9);
        let upper = placed(&Form::Cuboid(DVec3::ONE), at, DVec3::Y * (0.5 * FRAC_PI_2));
        assert!((between(&lower, &upper) + 1e-9).abs() < 1e-14, "{}", between(&lower, &upper));
    }

    #[test]
    fn a_ring_leans_on_a_box_and_links_another() {
        let ring = placed(&Form::Torus(0.3, 0.05), DVec3::Z * 0.3499, DVec3::X * FRAC_PI_2);
        let floor = placed(&Form::Cuboid(DVec3::new(2.0, 2.0, 1.0)), DVec3::Z * -0.5, DVec3::ZERO);
        assert!((between(&ring, &floor) + 1e-4).abs() < 1e-12, "{}", between(&ring, &floor));
        let other = placed(&Form::Torus(0.3, 0.05), DVec3::new(0.3, 0.0, 0.3499), DVec3::ZERO);
        assert!((between(&ring, &other) - 0.2).abs() < 1e-12, "{}", between(&ring, &other));
    }

    #[test]
    fn a_cone_on_its_side_and_a_capsule_across_it() {
        let slope = libm::atan2(0.2, 0.6);
        let cone = placed(&Form::Cone(0.2, 0.6), DVec3::ZERO, DVec3::Y * (FRAC_PI_2 - slope));
        // The upper side of the cone is level, below its axis by no more than the height of the apex above the base.
        let top = cone.support(DVec3::Z);
        let capsule = placed(&Form::Capsule(0.05, 0.8), DVec3::new(0.05, 0.0, top + 0.05 - 1e-9), DVec3::X * FRAC_PI_2);
        assert!((between(&cone, &capsule)).abs() < 0.2);
        let floor = placed(&Form::HalfSpace(DVec3::Z), DVec3::ZERO, DVec3::ZERO);
        assert!((between(&floor, &capsule) - top + 1e-9).abs() < 1e-14);
    }
}
