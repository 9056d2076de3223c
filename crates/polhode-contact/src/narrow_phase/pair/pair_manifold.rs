//! All contacts of two shapes without parts: of polyhedra by separating axes, of round shapes by elements, of others
//! point by point.

use crate::clearance::place_tolerance;
use crate::narrow_phase::axis::gap::{self, Gap};
use crate::narrow_phase::axis::ring;
use crate::narrow_phase::feature::closest_feature::nearest_feature;
use crate::narrow_phase::feature::placed::Placed;
use crate::narrow_phase::pair::measure::measure;
use crate::narrow_phase::pair::pair_separation::pair_separation;
use crate::narrow_phase::pair::polyhedra::along_axes;
use crate::narrow_phase::region::pair_buffers::PairBuffers;
use crate::narrow_phase::region::round_region;
use crate::shape::round::is_round;
use crate::{ContactFeature, Manifold, SeparatingAxis, Shape, Side, SurfaceFeature};

/// The contacts of two shapes of which neither is a compound or a mesh; see [`crate::manifold()`].
pub(crate) fn pair_manifold(buffers: &mut PairBuffers, a: Placed<'_>, b: Placed<'_>, reach: f64, found: &mut Manifold) {
    let (Placed { shape: shape_a, pose: pose_a }, Placed { shape: shape_b, pose: pose_b }) = (a, b);
    if !(pose_a.is_finite() && pose_b.is_finite()) {
        return found.set_empty(f64::NAN, SeparatingAxis::None);
    }
    buffers.features.clear();
    if let (Shape::Convex(polyhedron_a), Shape::Convex(polyhedron_b)) = (shape_a, shape_b) {
        let x_ab = pose_a.relative(pose_b);
        buffers.search.place(polyhedron_b, &x_ab);
        let axes = buffers.search.search_deciding(polyhedron_a, polyhedron_b, &x_ab, reach);
        return along_axes(buffers, [polyhedron_a, polyhedron_b], [a, b], (&axes, None), reach, found);
    }
    if [shape_a, shape_b].into_iter().any(|shape| is_round(shape) || shape.is_ring()) {
        return of_round(buffers, a, b, reach, found);
    }
    let separation = pair_separation(&mut buffers.search, a, b);
    let axis = match (shape_a, shape_b) {
        _ if separation == f64::INFINITY => SeparatingAxis::None,
        (Shape::HalfSpace(_), _) => SeparatingAxis::FaceA(0),
        (_, Shape::HalfSpace(_)) => SeparatingAxis::FaceB(0),
        _ => SeparatingAxis::Nearest,
    };
    found.set_empty(separation, axis);
    if found.is_beyond(reach) {
        return;
    }
    match (shape_a, shape_b) {
        (Shape::HalfSpace(_), _) => against_surface(&mut buffers.features, a, b, Side::B),
        (_, Shape::HalfSpace(_)) => against_surface(&mut buffers.features, b, a, Side::A),
        (Shape::Convex(_), _) => against_surface(&mut buffers.features, a, b, Side::B),
        (_, Shape::Convex(_)) => against_surface(&mut buffers.features, b, a, Side::A),
        (Shape::Sphere(_), Shape::Sphere(_)) => buffers.features.push(ContactFeature::SphereSphere),
        (Shape::Sphere(_), _) => against_sphere(&mut buffers.features, shape_b, Side::B),
        _ => against_sphere(&mut buffers.features, shape_a, Side::A),
    }
    measure(&mut buffers.features, a, b, reach, &mut found.contacts);
}

/// Pairs with a capsule, cylinder, cone or torus: the contacts of the region around the best axis. A cloud has one
/// region for every point, a torus one for every local minimum of the distance along its circle.
fn of_round(buffers: &mut PairBuffers, a: Placed<'_>, b: Placed<'_>, reach: f64, found: &mut Manifold) {
    let features = &mut buffers.features;
    found.set_empty(f64::INFINITY, SeparatingAxis::None);
    let mut add = |gap: Gap| {
        if gap.separation < found.separation {
            found.separation = gap.separation;
            found.axis = match (gap.a, gap.b) {
                (SurfaceFeature::Face(face), _) => SeparatingAxis::FaceA(face),
                (_, SurfaceFeature::Face(face)) => SeparatingAxis::FaceB(face),
                _ => SeparatingAxis::Nearest,
            };
        }
        if gap.separation <= reach {
            round_region::contacts(features, a, b, &gap, reach, |_| true, &mut found.contacts);
        }
    };
    if a.shape.is_half_space() || b.shape.is_half_space() {
        add(gap::above_half_space(a, b));
    } else if a.shape.is_ring() || b.shape.is_ring() {
        ring::each(a, b, reach, add);
        found.contacts.sort_unstable_by_key(|contact| contact.feature);
        found.contacts.dedup_by_key(|contact| contact.feature);
    } else {
        gap::each(a, b, reach, add);
    }
    found.contacts.sort_unstable_by_key(|contact| contact.feature);
}

/// Adds every centre (point of a cloud, vertex, centre of a sphere) of body `of` against the nearest feature of a
/// half-space or polyhedron.
fn against_surface(features: &mut Vec<ContactFeature>, surface: Placed<'_>, body: Placed<'_>, of: Side) {
    let sphere = matches!(body.shape, Shape::Sphere(_));
    let x = surface.pose.relative(body.pose);
    for (index, &center) in body.shape.centers().0.iter().enumerate() {
        let index = index as u32;
        let against = match surface.shape {
            Shape::Convex(polyhedron) => {
                let tolerance = place_tolerance(polyhedron.size, polyhedron.size, x.translation);
                nearest_feature(polyhedron, x.transform_point(center), tolerance).feature
            }
            _ => SurfaceFeature::Face(0),
        };
        features.push(match against {
            SurfaceFeature::Face(face) if !sphere => ContactFeature::VertexFace { vertex_of: of, vertex: index, face },
            _ => ContactFeature::Smooth { center_of: of, center: index, against },
        });
    }
}

/// Adds every point of a cloud against a sphere.
fn against_sphere(features: &mut Vec<ContactFeature>, cloud: &Shape, of: Side) {
    let points = 0..cloud.centers().0.len() as u32;
    features.extend(points.map(|center| ContactFeature::Smooth {
        center_of: of,
        center,
        against: SurfaceFeature::Sphere,
    }));
}
