//! Signed distance of a point from a core, negative inside, by formulas of its own for each core.

use super::piece::{Core, Hull, Placed};
use glam::{DVec2, DVec3};

/// Of a point of the world, m. The margin is not taken off.
pub(super) fn signed(placed: &Placed, point: DVec3) -> f64 {
    let from_center = point - placed.center;
    let z = from_center.dot(placed.axis());
    let radial = (from_center - placed.axis() * z).length();
    match &placed.core {
        Core::Point => from_center.length(),
        Core::Segment(half) => radial.hypot((z.abs() - half).max(0.0)),
        Core::Circle(radius) => (radial - radius).hypot(z),
        Core::Cylinder(radius, half) => {
            let (out, up) = (radial - radius, z.abs() - half);
            if out <= 0.0 && up <= 0.0 { out.max(up) } else { out.max(0.0).hypot(up.max(0.0)) }
        }
        Core::Cone(radius, base, apex) => cone(DVec2::new(radial, z), *radius, *base, *apex),
        Core::HalfSpace(normal) => from_center.dot(*normal),
        Core::Hull(hull) => of_hull(hull, from_center),
    }
}

/// Of a point at a distance from the axis and a height.
fn cone(at: DVec2, radius: f64, base: f64, apex: f64) -> f64 {
    let (rim, tip) = (DVec2::new(radius, base), DVec2::new(0.0, apex));
    let slant = tip - rim;
    let outwards = DVec2::new(slant.y, -slant.x).normalize();
    let (below, beside) = (base - at.y, outwards.dot(at - rim));
    if below <= 0.0 && beside <= 0.0 {
        return below.max(beside);
    }
    let to_base = DVec2::new((at.x - radius).max(0.0), at.y - base).length();
    let share = (slant.dot(at - rim) / slant.length_squared()).clamp(0.0, 1.0);
    to_base.min((at - rim - slant * share).length())
}

fn of_hull(hull: &Hull, at: DVec3) -> f64 {
    let planes = hull.triangles.iter().zip(&hull.normals).map(|(t, normal)| normal.dot(at - hull.vertices[t[0]]));
    let beyond = planes.fold(f64::NEG_INFINITY, f64::max);
    if beyond <= 0.0 {
        return beyond;
    }
    let corners = |t: &[usize; 3]| t.map(|index| hull.vertices[index]);
    hull.triangles.iter().map(|t| to_triangle(at, corners(t))).fold(f64::INFINITY, f64::min)
}

/// Distance of a point from a triangle: from its plane where the foot lies in it, else from its sides.
fn to_triangle(at: DVec3, [a, b, c]: [DVec3; 3]) -> f64 {
    let normal = (b - a).cross(c - a);
    let sides = [(a, b), (b, c), (c, a)];
    if sides.iter().all(|(p, q)| normal.dot((*q - *p).cross(at - *p)) >= 0.0) {
        return normal.dot(at - a).abs() / normal.length();
    }
    let to_side = |(p, q): &(DVec3, DVec3)| {
        let side = *q - *p;
        let share = (side.dot(at - *p) / side.length_squared()).clamp(0.0, 1.0);
        (at - *p - side * share).length()
    };
    sides.iter().map(to_side).fold(f64::INFINITY, f64::min)
}
