//! Contacts at the border of a body that is no border of the whole surface.
//!
//! A body that lies on several bodies whose surfaces are flush touches each of them up to its border. Where other bodies
//! continue the surface beyond that border, the whole surface has none, and the contacts at it are left out, as within a
//! mesh:
//!
//! - The crossings of the rim of a disc or ring with an edge. Near the place where the rim is parallel to the edge, the
//!   direction of the common normal is uncertain.
//! - Contacts at one place with two immovable bodies, as where the line of a lying cylinder crosses a seam. They lie
//!   between other contacts. With friction, the motion would depend on what share of the load they take, which mechanics
//!   of rigid bodies leaves open; on one plate there are none. Movable bodies need the support at their borders.
//!
//! A border is covered when the bodies that the lying body touches cover the contact plane all around the contact: each of
//! some points in the plane, at a distance of `PROBE` times the size of the smaller body, is inside one of them or within
//! the touch distance of its surface. A body that covers the plane there alone has no border there.

use super::contact_set::{ContactId, Touch};
use crate::world::World;
use polhode_contact::{ContactFeature, DVec3, SurfaceFeature, closest_point};
use polhode_dynamics::BodyState;

/// Distance of the points that are probed, relative to the size of the smaller body (no unit, 1e-7 to 1e-5): gaps
/// between bodies below it are closed, as within compounds. Contacts nearer to each other are at one place.
const PROBE: f64 = 1e-6;

/// Number of points that are probed around a place.
const PROBES: u32 = 16;

/// Angle of the first probe in units of the angle between two: it avoids the directions of symmetric faces.
const TURNED: f64 = 0.3;

/// A contact of a body that lies on another one.
#[derive(Debug, Clone, Copy)]
struct Lying<'a> {
    touch: &'a Touch,
    body: usize,
    on: usize,
}

impl World {
    /// Removes the contacts at borders that other touching bodies cover.
    pub(crate) fn remove_covered_borders(&self, states: &[BodyState], touches: &mut Vec<Touch>) {
        let is_seam = |lying: &Lying<'_>| self.is_on_seam(lying, touches);
        let lying = touches.iter().flat_map(|touch| {
            let of_rim = body_of_rim(touch).map(|body| lying_on(touch, body));
            let [on_a, on_b] = [touch.id.b, touch.id.a].map(|body| lying_on(touch, body));
            of_rim.into_iter().chain([on_a, on_b].into_iter().filter(is_seam))
        });
        let is_covered = |Lying { touch, body, on }: &Lying<'_>| {
            let mut others = bodies_on(touches, *body);
            others.sort_unstable();
            others.dedup();
            others.len() > 1 && !self.cover(states, touch, &[*on]) && self.cover(states, touch, &others)
        };
        let mut covered: Vec<ContactId> = lying.filter(is_covered).map(|lying| lying.touch.id).collect();
        covered.dedup();
        if !covered.is_empty() {
            touches.retain(|touch| covered.binary_search(&touch.id).is_err());
        }
    }

    /// Whether a body that may move touches a second immovable body at the place of a contact with an immovable one.
    fn is_on_seam(&self, &Lying { touch, body, on }: &Lying<'_>, touches: &[Touch]) -> bool {
        let moves = |body: usize| self.bodies[body].moves();
        if !moves(body) || moves(on) {
            return false;
        }
        let near = PROBE * self.pair_size(touch.id.a, touch.id.b);
        let point = touch.kinematics.geometry.point;
        touches.iter().any(|other| {
            let partner = partner(other, body);
            partner.is_some_and(|partner| partner != on && !moves(partner))
                && other.kinematics.geometry.point.distance(point) <= near
        })
    }

    /// Whether some bodies cover the contact plane all around a contact.
    fn cover(&self, states: &[BodyState], touch: &Touch, bodies: &[usize]) -> bool {
        let geometry = &touch.kinematics.geometry;
        let size = self.pair_size(touch.id.a, touch.id.b);
        let allowed = self.touch_distance(states, touch.id.a, touch.id.b);
        let (u, w) = geometry.normal.any_orthonormal_pair();
        let covers = |body: usize, place: DVec3| {
            let near = self.bodies[body].shape.as_ref().map(|shape| closest_point(shape, &states[body].pose, place));
            near.is_some_and(|near| near.is_ok_and(|near| near.distance <= allowed))
        };
        (0..PROBES).all(|k| {
            let angle = (f64::from(k) + TURNED) / f64::from(PROBES) * std::f64::consts::TAU;
            let place = geometry.point + (u * libm::cos(angle) + w * libm::sin(angle)) * (PROBE * size);
            bodies.iter().any(|&body| covers(body, place))
        })
    }
}

const fn lying_on(touch: &Touch, body: usize) -> Lying<'_> {
    Lying { touch, body, on: if body == touch.id.a { touch.id.b } else { touch.id.a } }
}

/// The body whose rim crosses an edge or another rim at a contact; none for another contact.
fn body_of_rim(touch: &Touch) -> Option<usize> {
    use SurfaceFeature::{RimEntry, RimExit};
    match touch.id.feature {
        ContactFeature::Elements { a: RimExit(_) | RimEntry(_), .. } => Some(touch.id.a),
        ContactFeature::Elements { b: RimExit(_) | RimEntry(_), .. } => Some(touch.id.b),
        _ => None,
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
