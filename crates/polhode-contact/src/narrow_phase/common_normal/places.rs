//! The common normals of two elements, with their points on both.
//!
//! Two surfaces are closest, or their penetration is smallest, where one line is normal to both: `F = x_A - x_B` is
//! along the common normal `n`, with `x` a point of each locus. For most pairs of loci they have closed forms:
//!
//!  - point and plane, point, line, circle or cone; plane and circle (its lowest point);
//!  - two of line and cone: their normals obey `o.u = k_u` and `o.v = k_v`, hence `o = p u + q v +- g u x v`;
//!
//! For the others one unknown angle is left, about a cone's axis or along a circle (`minima.rs`): for a circle and a
//! cone in this module, for a circle and a line and for two circles in `curves.rs`.

use crate::clearance::PARALLEL_SINE;
use crate::narrow_phase::common_normal::curves;
use crate::narrow_phase::common_normal::minima::Height;
use crate::narrow_phase::common_normal::place::{Place, Places};
use crate::narrow_phase::feature::element::{ConeSide, Element, Locus};
use crate::shape::circle::Circle;
use crate::shape::support::across;
use glam::DVec3;

/// All common normals of two elements; none for loci without isolated ones (a plane and a line, parallel lines).
pub(crate) fn places(a: &Element<'_>, b: &Element<'_>) -> Places {
    match (a.locus, b.locus) {
        (Locus::Point(p), Locus::Point(q)) => Places::one(between(p, q)),
        (Locus::Point(p), Locus::Line(middle, along)) => {
            Places::one(Some(off_curve(p, middle + along * along.dot(p - middle), along)))
        }
        (Locus::Point(p), Locus::Circle(circle)) => {
            let nearest = circle.nearest(p);
            let tangent = circle.axis.cross(nearest - circle.center).normalize_or_zero();
            Places::one(Some(off_curve(p, nearest, tangent)))
        }
        (Locus::Point(p), Locus::Cone(side)) => Places::one(point_on_cone(p, &side)),
        (Locus::Point(p), Locus::Plane(through, normal)) => Places::one(Some(onto_plane(p, through, normal))),
        (Locus::Circle(circle), Locus::Plane(through, normal)) => {
            let lowest = circle.lowest(normal);
            Places::one(lowest.map(|lowest| onto_plane(lowest, through, normal)))
        }
        (Locus::Line(p, u), Locus::Line(q, v)) => line_line((p, u), (q, v)),
        (Locus::Line(p, u), Locus::Cone(side)) => straight((p, u, 0.0), (side.apex, side.axis, side.sine)),
        (Locus::Cone(side_a), Locus::Cone(side_b)) => {
            straight((side_a.apex, side_a.axis, side_a.sine), (side_b.apex, side_b.axis, side_b.sine))
        }
        (Locus::Line(p, u), Locus::Circle(circle)) => curves::line_circle((p, u), &circle),
        (Locus::Circle(first), Locus::Circle(second)) => curves::circle_circle(&first, &second),
        (Locus::Circle(circle), Locus::Cone(side)) if a.ball > 0.0 => ring_on_cone(&circle, &side),
        (Locus::Circle(circle), Locus::Cone(side)) => rim_on_cone(&circle, &side),
        (Locus::Plane(..), Locus::Plane(..) | Locus::Line(..) | Locus::Cone(_))
        | (Locus::Line(..) | Locus::Cone(_), Locus::Plane(..)) => Places::none(),
        _ => places(b, a).swapped(),
    }
}

/// The normal along the line between two points; none when they coincide.
fn between(p: DVec3, q: DVec3) -> Option<Place> {
    let f = p - q;
    let length = f.length();
    (length > 0.0).then(|| Place { normal: f / length, on_a: p, on_b: q })
}

/// The normal from the nearest point of a curve to a point. It is made perpendicular to the curve, also where the
/// difference of the two points is rounding error; for a point on the curve itself it is an arbitrary perpendicular.
fn off_curve(p: DVec3, nearest: DVec3, tangent: DVec3) -> Place {
    let f = across(p - nearest, tangent);
    let length = f.length();
    if length > 0.0 {
        Place { normal: f / length, on_a: p, on_b: nearest }
    } else {
        Place { normal: tangent.any_orthonormal_vector(), on_a: p, on_b: p }
    }
}

fn onto_plane(p: DVec3, through: DVec3, normal: DVec3) -> Place {
    Place { normal, on_a: p, on_b: p - normal * normal.dot(p - through) }
}

/// The foot of a point on the side of a cone; for a point on the axis the generator is arbitrary.
fn point_on_cone(p: DVec3, side: &ConeSide) -> Option<Place> {
    let from = p - side.apex;
    let radial = across(from, side.axis);
    let distance = radial.length();
    let away = if distance == 0.0 { side.axis.any_orthonormal_vector() } else { radial / distance };
    let outward = side.axis * side.sine + away * side.cosine;
    let axial = side.axis.dot(from) - distance * side.sine / side.cosine;
    (!axial.is_nan()).then(|| Place { normal: outward, on_a: p, on_b: side.apex + side.axis * axial })
}

/// Two lines that are not parallel.
fn line_line((p, u): (DVec3, DVec3), (q, v): (DVec3, DVec3)) -> Places {
    let cross = u.cross(v);
    let sine = cross.length();
    if sine.is_nan() || sine <= PARALLEL_SINE {
        return Places::none();
    }
    let d = q - p;
    let on_a = p + u * (d.cross(v).dot(cross) / (sine * sine));
    let on_b = q + v * (d.cross(u).dot(cross) / (sine * sine));
    let normal = cross / sine;
    Places::one(Some(Place { normal: if normal.dot(d) > 0.0 { -normal } else { normal }, on_a, on_b }))
}

/// Two loci along straight axes (a point, the axis, the normals' component along it), at least one a cone.
fn straight((p, u, k_u): (DVec3, DVec3, f64), (q, v, k_v): (DVec3, DVec3, f64)) -> Places {
    let mut found = Places::none();
    let cross = u.cross(v);
    let square = cross.length_squared();
    if square.is_nan() || square <= PARALLEL_SINE * PARALLEL_SINE {
        return found;
    }
    // A's outward normal o obeys o.u = k_u, B's is -o: o.v = -k_v.
    let c = u.dot(v);
    let (along_u, along_v) = ((k_u + c * k_v) / square, (-k_v - c * k_u) / square);
    let inplane = u * along_u + v * along_v;
    let rest = 1.0 - inplane.length_squared();
    if rest < 0.0 {
        return found;
    }
    for sign in [1.0, -1.0] {
        let outward = inplane + cross * (sign * (rest / square).sqrt());
        // p + s u - q - t v along the normal: components along v x o and u x o vanish.
        let d = p - q;
        let (across_v, across_u) = (v.cross(outward), u.cross(outward));
        let s = -d.dot(across_v) / u.dot(across_v);
        let t = d.dot(across_u) / v.dot(across_u);
        if s.is_finite() && t.is_finite() {
            found.push(Place { normal: -outward, on_a: p + u * s, on_b: q + v * t });
        }
    }
    found
}

/// A rim against a cone: the common normals along which the separation, once around the cone, is largest:
/// `s = o.(c - apex) - R |a x o|`, where the circle's support point along a normal has a closed form.
fn rim_on_cone(circle: &Circle, side: &ConeSide) -> Places {
    let Circle { center, axis, radius } = *circle;
    let first = side.axis.any_orthonormal_vector();
    let around = [first * side.cosine, side.axis.cross(first) * side.cosine];
    let base = side.axis * side.sine;
    let linear = around.map(|v| v.dot(side.apex - center));
    let seen = [base, around[0], around[1]].map(|v| across(v, axis));
    let mut found = Places::none();
    Height::new(linear, -radius, seen).each_least(|angle| {
        let (sine, cosine) = libm::sincos(angle);
        let normal = base + around[0] * cosine + around[1] * sine;
        let on_a = center - across(normal, axis).try_normalize().unwrap_or(DVec3::ZERO) * radius;
        // The point of the cone's axis on the line of the normal.
        let down = side.axis - normal * side.sine;
        let axial = (on_a - side.apex).dot(down) / side.axis.dot(down);
        found.push(Place { normal, on_a, on_b: side.apex + side.axis * axial });
    });
    found
}

/// A torus against a cone: the local minima of the distance of the circle's points from the side.
fn ring_on_cone(circle: &Circle, side: &ConeSide) -> Places {
    let [east, north] = circle.radii();
    let linear = [east, north].map(|radius| side.sine * side.axis.dot(radius));
    let seen = [circle.center - side.apex, east, north].map(|v| across(v, side.axis));
    let mut found = Places::none();
    Height::new(linear, -side.cosine, seen).each_least(|angle| {
        let (sine, cosine) = libm::sincos(angle);
        if let Some(place) = point_on_cone(circle.center + east * cosine + north * sine, side) {
            found.push(place);
        }
    });
    found
}
