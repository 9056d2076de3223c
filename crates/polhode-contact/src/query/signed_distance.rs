//! Signed distance of a point from a core, in closed form.
//!
//! Positive outside, negative inside; the normal is the unit vector from the core to the point (inside: to the nearest
//! place of the surface and on). Ties go to caps before sides, to the face with the lowest index, and on an axis of
//! symmetry to a fixed direction perpendicular to it.

use super::FeatureKind;
use super::element::{Core, Element};
use crate::narrow_phase::nearest_feature;
use crate::shape::support::across;
use crate::{Cone, Cylinder, SurfaceFeature};
use glam::DVec3;

/// A point's place relative to a surface.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Signed {
    pub(crate) distance: f64,
    pub(crate) normal: DVec3,
    pub(crate) kind: FeatureKind,
}

/// Signed distance from a core, in its frame; of a point, a segment, a triangle and a circle, which have no inside, it is
/// never negative. `if_zero` is the normal where the core gives none.
pub(crate) fn signed_distance(core: &Core<'_>, point: DVec3) -> Signed {
    match core {
        Core::Point(p) => away(point - *p, DVec3::Z, FeatureKind::Surface),
        Core::Segment([p, q]) => {
            let (place, kind) = on_segment(*p, *q, point);
            away(point - place, (*q - *p).any_orthogonal_vector(), kind)
        }
        Core::Triangle(corners) => {
            let (place, kind) = on_triangle(corners, point);
            let normal = (corners[1] - corners[0]).cross(corners[2] - corners[0]);
            away(point - place, normal, kind)
        }
        Core::Polyhedron(polyhedron) => {
            let nearest = nearest_feature(polyhedron, point, 0.0);
            let kind = match nearest.feature {
                SurfaceFeature::Edge(i) => FeatureKind::Edge(i),
                SurfaceFeature::Vertex(i) => FeatureKind::Vertex(i),
                SurfaceFeature::Face(i) => FeatureKind::Face(i),
                _ => FeatureKind::Surface,
            };
            if nearest.direction.is_finite() {
                return Signed { distance: nearest.distance, normal: nearest.direction, kind };
            }
            // On an edge or a vertex itself there is no direction: its first face's normal stands in.
            let inside = nearest_feature(polyhedron, point, f64::INFINITY);
            Signed { distance: nearest.distance, normal: inside.direction, kind }
        }
        Core::Cylinder(cylinder) => from_cylinder(cylinder, point),
        Core::Cone(cone) => from_cone(cone, point),
        Core::Circle(torus) => {
            let w = point - torus.center;
            let radial = radial_direction(across(w, torus.axis), torus.axis);
            away(w - radial * torus.major, radial, FeatureKind::Surface)
        }
        Core::HalfSpace(h) => {
            Signed { distance: h.normal.dot(point) - h.offset, normal: h.normal, kind: FeatureKind::Face(0) }
        }
    }
}

/// Signed distance of a place of the common frame from an element's core, with the normal in the common frame.
pub(crate) fn signed(place: DVec3, element: &Element<'_>) -> Signed {
    let local = signed_distance(&element.core, element.pose.inverse_transform_point(place));
    Signed { normal: element.pose.rotation.rotate(local.normal), ..local }
}

/// From a place without extent.
fn away(w: DVec3, if_zero: DVec3, kind: FeatureKind) -> Signed {
    let distance = w.length();
    let direction = if distance > 0.0 { w } else { if_zero };
    let normal = direction.try_normalize().unwrap_or(DVec3::Z);
    Signed { distance, normal, kind }
}

/// Unit vector of a radial part; on the axis a fixed one.
fn radial_direction(radial: DVec3, axis: DVec3) -> DVec3 {
    radial.try_normalize().unwrap_or_else(|| axis.any_orthonormal_vector())
}

/// Nearest place of a segment, its edge or one of its vertices.
pub(crate) fn on_segment(p: DVec3, q: DVec3, point: DVec3) -> (DVec3, FeatureKind) {
    let along = q - p;
    let (from, to) = ((point - p).dot(along), (q - point).dot(along));
    if from <= 0.0 {
        (p, FeatureKind::Vertex(0))
    } else if to <= 0.0 {
        (q, FeatureKind::Vertex(1))
    } else if from < to {
        (p + along * (from / along.length_squared()), FeatureKind::Edge(0))
    } else {
        (q - along * (to / along.length_squared()), FeatureKind::Edge(0))
    }
}

/// Nearest place of a triangle, which may be flat.
fn on_triangle(corners: &[DVec3; 3], point: DVec3) -> (DVec3, FeatureKind) {
    let [a, b, c] = *corners;
    let normal = (b - a).cross(c - a);
    let outside = |p: DVec3, q: DVec3| (q - p).cross(point - p).dot(normal) < 0.0;
    let square = normal.length_squared();
    if square > 0.0 && !outside(a, b) && !outside(b, c) && !outside(c, a) {
        return (point - normal * (normal.dot(point - a) / square), FeatureKind::Face(0));
    }
    let mut best = (a, FeatureKind::Vertex(0));
    let mut least = f64::INFINITY;
    for i in 0..3 {
        let (place, kind) = on_segment(corners[i], corners[(i + 1) % 3], point);
        let kind = match kind {
            FeatureKind::Vertex(end) => FeatureKind::Vertex((i as u32 + end) % 3),
            _ => FeatureKind::Edge(i as u32),
        };
        let distance = place.distance(point);
        if distance < least {
            least = distance;
            best = (place, kind);
        }
    }
    best
}

fn from_cylinder(cylinder: &Cylinder, point: DVec3) -> Signed {
    let w = point - cylinder.center;
    let along = w.dot(cylinder.axis);
    let radial = across(w, cylinder.axis);
    let outward = radial_direction(radial, cylinder.axis);
    let side = outward.dot(radial) - cylinder.radius;
    let cap = along.abs() - cylinder.half_height;
    let end = u32::from(along >= 0.0);
    let up = if along < 0.0 { -cylinder.axis } else { cylinder.axis };
    if cap > 0.0 && side > 0.0 {
        let out = outward * side + up * cap;
        return Signed { distance: out.length(), normal: out / out.length(), kind: FeatureKind::Edge(end) };
    }
    if cap >= side {
        Signed { distance: cap, normal: up, kind: FeatureKind::Face(end) }
    } else {
        Signed { distance: side, normal: outward, kind: FeatureKind::Surface }
    }
}

fn from_cone(cone: &Cone, point: DVec3) -> Signed {
    let w = point - cone.base;
    let above = w.dot(cone.axis);
    let radial = across(w, cone.axis);
    let outward = radial_direction(radial, cone.axis);
    let beyond = outward.dot(radial) - cone.radius;
    let slant = libm::hypot(cone.radius, cone.height);
    // Across the slant line from the rim to the apex, and along it from the rim.
    let across_slant = (beyond * cone.height + above * cone.radius) / slant;
    let along_slant = (above * cone.height - beyond * cone.radius) / slant;
    let on_base = Signed { distance: -above, normal: -cone.axis, kind: FeatureKind::Face(0) };
    let slant_normal = (outward * cone.height + cone.axis * cone.radius) / slant;
    let on_side = Signed { distance: across_slant, normal: slant_normal, kind: FeatureKind::Surface };
    if above >= 0.0 && across_slant <= 0.0 {
        return if on_base.distance >= on_side.distance { on_base } else { on_side };
    }
    if above < 0.0 && beyond <= 0.0 {
        return on_base;
    }
    if along_slant <= 0.0 {
        return away(outward * beyond + cone.axis * above, outward, FeatureKind::Edge(0));
    }
    if along_slant >= slant {
        return away(point - cone.apex(), cone.axis, FeatureKind::Vertex(0));
    }
    on_side
}
