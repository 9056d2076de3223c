//! Crossings of a rim with an edge that is no edge of the whole surface.
//!
//! A disc or ring that lies on several bodies whose surfaces are flush touches each of them at its sample points, and
//! where its rim crosses their edges. Where other bodies continue the surface beyond an edge, the whole surface has no
//! edge there, and the crossing is no contact, as within a compound or a mesh. It would do harm: near the place where
//! the rim is parallel to the edge, the direction of the common normal is uncertain.
//!
//! A crossing is covered when the bodies that the disc touches cover the contact plane all around it: each of some
//! points in the plane, at a distance of `PROBE` times the size of the smaller body, is inside one of them or within the
//! touch distance of its surface. Only bodies that touch the disc count. A body that covers the plane there alone has no
//! edge there: its crossing is a contact of two smooth surfaces, and remains.

use super::contact_set::Touch;
use crate::world::World;
use polhode_contact::{ContactFeature, DVec3, SurfaceFeature, closest_point};
use polhode_dynamics::BodyState;

/// Distance of the points that are probed, relative to the size of the smaller body (no unit, 1e-7 to 1e-5): gaps
/// between bodies below it are closed, as within compounds.
const PROBE: f64 = 1e-6;

/// Number of points that are probed around a place.
const PROBES: u32 = 16;

/// Angle of the first probe in units of the angle between two: it avoids the directions of symmetric faces.
const TURNED: f64 = 0.3;

impl World {
    /// Removes the crossings of rims with edges that other touching bodies cover.
    pub(crate) fn remove_covered_crossings(&self, states: &[BodyState], touches: &mut Vec<Touch>) {
        let candidates = touches.iter().filter_map(|touch| Some((touch, body_of_rim(touch)?)));
        let covered: Vec<_> = candidates
            .filter(|&(touch, round)| {
                let mut others = bodies_on(touches, round);
                others.sort_unstable();
                others.dedup();
                let crossed = if round == touch.id.a { touch.id.b } else { touch.id.a };
                others.len() > 1
                    && !self.is_covered(states, touch, &[crossed])
                    && self.is_covered(states, touch, &others)
            })
            .map(|(touch, _)| touch.id)
            .collect();
        if !covered.is_empty() {
            touches.retain(|touch| covered.binary_search(&touch.id).is_err());
        }
    }

    /// Whether some bodies cover the contact plane all around a contact.
    fn is_covered(&self, states: &[BodyState], touch: &Touch, bodies: &[usize]) -> bool {
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

/// The body whose rim crosses an edge or another rim at a contact; none for another contact.
fn body_of_rim(touch: &Touch) -> Option<usize> {
    use SurfaceFeature::{RimEntry, RimExit};
    match touch.id.feature {
        ContactFeature::Elements { a: RimExit(_) | RimEntry(_), .. } => Some(touch.id.a),
        ContactFeature::Elements { b: RimExit(_) | RimEntry(_), .. } => Some(touch.id.b),
        _ => None,
    }
}

/// The bodies that touch one body, with repetitions.
fn bodies_on(touches: &[Touch], body: usize) -> Vec<usize> {
    let other = |touch: &Touch| match (touch.id.a == body, touch.id.b == body) {
        (true, _) => Some(touch.id.b),
        (_, true) => Some(touch.id.a),
        _ => None,
    };
    touches.iter().filter_map(other).collect()
}
