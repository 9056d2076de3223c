//! Signed distance of a point from a core, in closed form.
//!
//! Positive outside, negative inside; the normal is the unit vector from the core to the point (inside: from the point
//! to the nearest point of the surface). In a tie end faces come before sides, and lower face indices before higher
//! ones; on an axis of symmetry the normal is a fixed direction perpendicular to it.

use super::piece::{Core, Piece};
use crate::narrow_phase::feature::closest_feature::{NearestFeature, nearest_feature};
use crate::shape::support::across;
use crate::shape::triangle::{TriangleFeature, area_vector, from_triangle, on_segment};
use crate::{Cone, Cylinder, SurfaceFeature};
use glam::DVec3;

/// Signed distance from a core, in its frame; never negative for a point, a segment, a triangle and a circle, which
/// have no inside.
pub(crate) fn signed_distance(core: &Core<'_>, point: DVec3) -> NearestFeature {
    match core {
        Core::Point(p) => away(point - *p, DVec3::Z, SurfaceFeature::Sphere),
        Core::Segment([p, q]) => {
            let (place, at) = on_segment(*p, *q, point);
            let feature =
                if let TriangleFeature::Corner(k) = at { core.corner(k as u32) } else { SurfaceFeature::Side(0) };
            away(point - place, (*q - *p).any_orthogonal_vector(), feature)
        }
        Core::Triangle(corners) => from_flat(corners, point),
        Core::Polyhedron(polyhedron) => {
            let nearest = nearest_feature(polyhedron, point, 0.0);
            if nearest.normal.is_finite() {
                return nearest;
            }
            // On an edge or a vertex itself the direction is undefined: the normal of the first face there is used.
            NearestFeature { normal: nearest_feature(polyhedron, point, f64::INFINITY).normal, ..nearest }
        }
        Core::Cylinder(cylinder) => from_cylinder(cylinder, point),
        Core::Cone(cone) => from_cone(cone, point),
        Core::Circle(torus) => {
            let w = point - torus.center;
            let radial = radial_direction(across(w, torus.axis), torus.axis);
            away(w - radial * torus.major, radial, SurfaceFeature::Rim(0))
        }
        Core::HalfSpace(h) => NearestFeature {
            distance: h.normal.dot(point) - h.offset,
            normal: h.normal,
            feature: SurfaceFeature::Face(0),
        },
    }
}

/// Signed distance of a point of the common frame from a piece's core, with the normal in the common frame.
pub(crate) fn signed(place: DVec3, piece: &Piece<'_>) -> NearestFeature {
    let local = signed_distance(&piece.core, piece.pose.inverse_transform_point(place));
    NearestFeature { normal: piece.pose.rotation.rotate(local.normal), ..local }
}

/// Distance `|w|` from a single point; `if_zero` is the normal where `w` is zero.
fn away(w: DVec3, if_zero: DVec3, feature: SurfaceFeature) -> NearestFeature {
    let distance = w.length();
    let direction = if distance > 0.0 { w } else { if_zero };
    let normal = direction.try_normalize().unwrap_or(DVec3::Z);
    NearestFeature { feature, distance, normal }
}

/// Unit vector along a radial component; a fixed one on the axis.
fn radial_direction(radial: DVec3, axis: DVec3) -> DVec3 {
    radial.try_normalize().unwrap_or_else(|| axis.any_orthonormal_vector())
}

/// Distance from a triangle. Over its face the direction is either the triangle's normal or the direction to the point,
/// whichever has the smaller rounding error: that of the normal is relative to the area over the two shortest sides,
/// that of the direction relative to the point's height over its distance from a corner.
fn from_flat(corners: &[DVec3; 3], point: DVec3) -> NearestFeature {
    let (w, at) = from_triangle(corners, point);
    if at != TriangleFeature::Face && w != DVec3::ZERO {
        return away(w, w, feature_of(at));
    }
    let normal = area_vector(*corners);
    let found = away(w, normal, feature_of(at));
    if at != TriangleFeature::Face {
        return found;
    }
    let [ab, bc, ca] = [0, 1, 2].map(|k: usize| corners[k].distance(corners[(k + 1) % 3]));
    let sides = ab * bc * ca / ab.max(bc).max(ca);
    if sides * found.distance > normal.length() * point.distance(corners[0]) {
        return found;
    }
    let side = if w.dot(normal) < 0.0 { -normal } else { normal };
    NearestFeature { normal: side.try_normalize().unwrap_or(found.normal), ..found }
}

/// A feature of a triangle, as queries name it.
fn feature_of(of_triangle: TriangleFeature) -> SurfaceFeature {
    match of_triangle {
        TriangleFeature::Face => SurfaceFeature::Face(0),
        TriangleFeature::Edge(k) => SurfaceFeature::Edge(k as u32),
        TriangleFeature::Corner(k) => SurfaceFeature::Vertex(k as u32),
    }
}

fn from_cylinder(cylinder: &Cylinder, point: DVec3) -> NearestFeature {
    let w = point - cylinder.center;
    let along = w.dot(cylinder.axis);
    let radial = across(w, cylinder.axis);
    let outward = radial_direction(radial, cylinder.axis);
    let side = outward.dot(radial) - cylinder.radius;
    let disc = along.abs() - cylinder.half_height;
    let end = u32::from(along >= 0.0);
    let up = if along < 0.0 { -cylinder.axis } else { cylinder.axis };
    if disc > 0.0 && side > 0.0 {
        let out = outward * side + up * disc;
        return NearestFeature {
            distance: out.length(),
            normal: out / out.length(),
            feature: SurfaceFeature::Rim(end),
        };
    }
    if disc >= side {
        NearestFeature { distance: disc, normal: up, feature: SurfaceFeature::Face(end) }
    } else {
        NearestFeature { distance: side, normal: outward, feature: SurfaceFeature::Side(0) }
    }
}

fn from_cone(cone: &Cone, point: DVec3) -> NearestFeature {
    let w = point - cone.base;
    let above = w.dot(cone.axis);
    let radial = across(w, cone.axis);
    let outward = radial_direction(radial, cone.axis);
    let beyond = outward.dot(radial) - cone.radius;
    let slant = libm::hypot(cone.radius, cone.height);
    // Across the slant line from the rim to the apex, and along it from the rim.
    let across_slant = (beyond * cone.height + above * cone.radius) / slant;
    let along_slant = (above * cone.height - beyond * cone.radius) / slant;
    let on_base = NearestFeature { distance: -above, normal: -cone.axis, feature: SurfaceFeature::Face(0) };
    let slant_normal = (outward * cone.height + cone.axis * cone.radius) / slant;
    let on_side = NearestFeature { distance: across_slant, normal: slant_normal, feature: SurfaceFeature::Side(0) };
    if above >= 0.0 && across_slant <= 0.0 {
        return if on_base.distance >= on_side.distance { on_base } else { on_side };
    }
    if above < 0.0 && beyond <= 0.0 {
        return on_base;
    }
    if along_slant <= 0.0 {
        return away(outward * beyond + cone.axis * above, outward, SurfaceFeature::Rim(0));
    }
    if along_slant >= slant {
        return away(point - cone.apex(), cone.axis, SurfaceFeature::Vertex(0));
    }
    on_side
}
