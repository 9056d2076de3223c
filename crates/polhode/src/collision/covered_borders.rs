//! Contacts at the border of a body that is no border of the whole surface.
//!
//! A body that lies on several bodies whose surfaces are flush touches each of them up to its border. Where other
//! bodies continue the surface beyond that border, the whole surface has none, and the contacts at it are left out, as
//! within a mesh:
//!
//! - The crossings of the rim of a disc or ring with an edge. Near the place where the rim is parallel to the edge, the
//!   direction of the common normal is uncertain.
//! - Contacts of an edge, a line or a face at one place with two immovable bodies, as where the line of a lying
//!   cylinder crosses a seam. They lie between other contacts. With friction, the motion would depend on what share of
//!   the load they take, which mechanics of rigid bodies leaves open; on one plate there are none. Movable bodies need
//!   the support at their borders.
//!
//! A border is covered when the bodies that the lying body touches cover the contact plane all around the contact: each
//! of some points in the plane, at a distance of `PROBE` times the size of the smaller body, is inside one of them or
//! at its surface, within the touch distance for crossings and within rounding for seams. A compound may cover the edge
//! of one of its parts alone. Where a body covers the plane alone and is touched by an edge or a face, it has no border
//! there.

use crate::collision::touch::Touch;
use crate::identity::contact_id::{ContactId, Feature};
use crate::model::{Model, tolerances};
use polhode_contact::{ContactFeature, DVec3, Side, SurfaceFeature, closest_point};
use polhode_dynamics::BodyState;

/// Distance of the points that are probed, relative to the size of the smaller body (no unit, 1e-7 to 1e-5): gaps
/// between bodies below it are closed, as within compounds. Contacts nearer to each other are at one place, and normals
/// within this sine are parallel.
const PROBE: f64 = 1e-6;

/// Number of points that are probed around a place.
const PROBES: u32 = 16;

/// Angle of the first probe in units of the angle between two: it avoids the directions of symmetric faces.
const TURNED: f64 = 0.3;

/// A contact of a body that lies on another one.
#[derive(Debug, Clone, Copy)]
struct Lying<'a> {
    touch: &'a Touch,
    /// Which of the two bodies of the contact it is.
    side: Side,
    body: usize,
    on: usize,
}

/// Removes the contacts at borders that other touching bodies cover.
pub(crate) fn remove_covered_borders(model: &Model, states: &[BodyState], touches: &mut Vec<Touch>) {
    let others = |body: usize| {
        let mut others = bodies_on(touches, body);
        others.sort_unstable();
        others.dedup();
        others
    };
    let crossings = touches.iter().filter_map(crossed_edge);
    let crossings = crossings.filter(|Lying { touch, body, .. }| {
        cover(model, states, touch, &others(*body), tolerances::touch_distance(model, states, touch.id.a, touch.id.b))
    });
    let both_ways = |touch| [lying_on(touch, Side::A), lying_on(touch, Side::B)];
    let seams = touches.iter().flat_map(both_ways).filter(|lying| is_on_seam(model, lying, touches));
    let seams = seams.filter(|Lying { touch, body, on, .. }| {
        // The border of the higher one of two levels bears a load.
        let level = tolerances::rounding(model, states, touch.id.a, touch.id.b);
        !cover(model, states, touch, &[*on], level) && cover(model, states, touch, &others(*body), level)
    });
    let lying = crossings.chain(seams);
    let mut covered: Vec<ContactId> = lying.map(|lying| lying.touch.id).collect();
    covered.sort_unstable();
    if !covered.is_empty() {
        touches.retain(|touch| covered.binary_search(&touch.id).is_err());
    }
}

/// Whether a contact is one that [`Self::remove_covered_borders`] may remove.
pub(crate) fn may_be_at_border(model: &Model, id: ContactId) -> bool {
    let Feature::Shapes(feature) = id.feature else { return false };
    let lies = |side: Side, body: usize, on: usize| {
        model.bodies[body].moves() && !model.bodies[on].moves() && !is_extreme(id.feature, side)
    };
    is_crossing(feature) || lies(Side::A, id.a, id.b) || lies(Side::B, id.b, id.a)
}

/// Whether an edge, a line or a face of a body that may move touches a second immovable body at the place of its
/// contact with an immovable one.
fn is_on_seam(model: &Model, &Lying { touch, side, body, on }: &Lying<'_>, touches: &[Touch]) -> bool {
    let moves = |body: usize| model.bodies[body].moves();
    if !moves(body) || moves(on) || is_extreme(touch.id.feature, side) {
        return false;
    }
    let near = PROBE * tolerances::pair_size(model, touch.id.a, touch.id.b);
    let here = &touch.kinematics.geometry;
    touches.iter().any(|other| {
        let partner = partner(other, body);
        let there = &other.kinematics.geometry;
        partner.is_some_and(|partner| partner != on && !moves(partner))
            && there.point.distance(here.point) <= near
            && there.normal.cross(here.normal).length() <= PROBE
    })
}

/// Whether some bodies cover the contact plane all around a contact, within `allowed` (m) of their surfaces.
fn cover(model: &Model, states: &[BodyState], touch: &Touch, bodies: &[usize], allowed: f64) -> bool {
    let geometry = &touch.kinematics.geometry;
    let size = tolerances::pair_size(model, touch.id.a, touch.id.b);
    places_around(geometry.point, geometry.normal, size)
        .all(|place| bodies.iter().any(|&body| reaches(model, states, body, place, allowed)))
}

/// Whether a place is inside a body or at its surface, within `allowed` (m).
pub(super) fn reaches(model: &Model, states: &[BodyState], body: usize, place: DVec3, allowed: f64) -> bool {
    let near = model.bodies[body].shape.as_ref().map(|shape| closest_point(shape, &states[body].pose, place));
    near.is_some_and(|near| near.is_ok_and(|near| near.distance <= allowed))
}

/// The places that are probed around one, in the plane with this normal, where the smaller body has this size (m).
pub(super) fn places_around(place: DVec3, normal: DVec3, size: f64) -> impl Iterator<Item = DVec3> {
    let (u, w) = normal.any_orthonormal_pair();
    (0..PROBES).map(move |k| {
        let angle = (f64::from(k) + TURNED) / f64::from(PROBES) * std::f64::consts::TAU;
        place + (u * libm::cos(angle) + w * libm::sin(angle)) * (PROBE * size)
    })
}

const fn lying_on(touch: &Touch, side: Side) -> Lying<'_> {
    let ContactId { a, b, .. } = touch.id;
    match side {
        Side::A => Lying { touch, side, body: a, on: b },
        Side::B => Lying { touch, side, body: b, on: a },
    }
}

/// The body whose rim crosses an edge at a contact, on the body of that edge; none for another contact.
fn crossed_edge(touch: &Touch) -> Option<Lying<'_>> {
    use SurfaceFeature::{Edge, RimEntry, RimExit};
    let Feature::Shapes(feature) = touch.id.feature else { return None };
    match feature {
        ContactFeature::Elements { a: RimExit(_) | RimEntry(_), b: Edge(_) } => Some(lying_on(touch, Side::A)),
        ContactFeature::Elements { a: Edge(_), b: RimExit(_) | RimEntry(_) } => Some(lying_on(touch, Side::B)),
        _ => None,
    }
}

/// Whether a rim crosses an edge at a contact.
const fn is_crossing(feature: ContactFeature) -> bool {
    use SurfaceFeature::{Edge, RimEntry, RimExit};
    matches!(
        feature,
        ContactFeature::Elements { a: RimExit(_) | RimEntry(_), b: Edge(_) }
            | ContactFeature::Elements { a: Edge(_), b: RimExit(_) | RimEntry(_) }
    )
}

/// Whether a body touches by a point that moves with it: a vertex, a sphere or a point of a rim. The load that it takes
/// is taken by no other contact.
fn is_extreme(feature: Feature, side: Side) -> bool {
    // A stop is on no surface.
    let Feature::Shapes(feature) = feature else { return true };
    match feature {
        ContactFeature::EdgeEdge { .. } => false,
        ContactFeature::VertexFace { vertex_of, .. } => vertex_of == side,
        ContactFeature::Elements { a, b } => {
            let own = if side == Side::A { a } else { b };
            !matches!(own, SurfaceFeature::Edge(_) | SurfaceFeature::Face(_) | SurfaceFeature::Side(_))
        }
        _ => true,
    }
}

/// The body that touches `body` at a contact; none for a contact of others.
fn partner(touch: &Touch, body: usize) -> Option<usize> {
    match (touch.id.a == body, touch.id.b == body) {
        (true, _) => Some(touch.id.b),
        (_, true) => Some(touch.id.a),
        _ => None,
    }
}

/// The bodies that touch one body, with repetitions.
fn bodies_on(touches: &[Touch], body: usize) -> Vec<usize> {
    touches.iter().filter_map(|touch| partner(touch, body)).collect()
}
