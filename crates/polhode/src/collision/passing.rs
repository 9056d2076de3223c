//! Bodies that pass over the border of another one without a collision.
//!
//! A body slides from one body to the next, whose surface is flush with the first. At the border of the second one it
//! touches an edge or a side towards which it moves. It does not collide there as long as the two do not approach along
//! a face at that border (`polhode_contact::Passing`, where the rule stands): the contacts with the plane of
//! this face take the place of those that would collide.

use crate::collision::contact_kinematics;
use crate::collision::touch::FoundContact;
use crate::identity::contact_id::{ContactId, Feature};
use crate::model::{Model, tolerances};
use polhode_contact::{ContactKinematics, Moving, Passing};
use polhode_dynamics::BodyState;
use polhode_spatial::Velocity;

/// Contacts that approach by less than this part of the speeds of their bodies do not collide: a thousand rounding
/// units.
pub(crate) const SUSTAINED_RELATIVE: f64 = 1e-12;

/// Replaces the contacts of a pair that would collide, although the bodies pass each other along a face, by those
/// with the plane of that face. Returns the features of these, ascending; they may lie beyond the border of the
/// face. The contacts remain sorted.
pub(super) fn take_place_of_collisions(
    model: &Model,
    states: &[BodyState],
    (a, b): (usize, usize),
    contacts: &mut Vec<FoundContact>,
) -> Vec<Feature> {
    let mut passing = Vec::new();
    if contacts.iter().all(|contact| contact.kinematics.separation_rate >= 0.0) {
        return passing;
    }
    let velocities = [a, b].map(|body| model.velocity(body, &states[body]));
    let Some(mut bodies) = passing_of(model, states, (a, b), &velocities) else { return passing };
    let sustained = sustained_rate(model, (a, b), &velocities);
    let mut in_place = |FoundContact { id, kinematics }: &FoundContact| {
        let collides = kinematics.separation_rate < -sustained;
        let Feature::Shapes(feature) = id.feature else { return None };
        collides.then(|| bodies.in_place_of(feature, kinematics.geometry.normal)).flatten()
    };
    contacts.retain(|contact| match in_place(contact) {
        Some(features) => {
            passing.extend(features.into_iter().map(Feature::Shapes));
            false
        }
        None => true,
    });
    if passing.is_empty() {
        return passing;
    }
    passing.sort_unstable();
    passing.dedup();
    passing.retain(|&feature| contacts.iter().all(|contact| contact.id.feature != feature));
    contacts.extend(passing.iter().filter_map(|&feature| {
        let id = ContactId { a, b, feature };
        Some(FoundContact { id, kinematics: contact_kinematics::kinematics_in_space(model, states, id)? })
    }));
    contacts.sort_by_key(|contact| contact.id);
    passing
}

/// The rate of approach up to which a contact of a pair with these velocities does not collide, m/s.
fn sustained_rate(model: &Model, (a, b): (usize, usize), velocities: &[Velocity; 2]) -> f64 {
    SUSTAINED_RELATIVE
        * (tolerances::fastest_point(model, a, &velocities[0]) + tolerances::fastest_point(model, b, &velocities[1]))
}

/// Two bodies that may pass each other; none where one of them has no shape.
fn passing_of<'a>(
    model: &'a Model,
    states: &'a [BodyState],
    (a, b): (usize, usize),
    velocities: &'a [Velocity; 2],
) -> Option<Passing<'a>> {
    let (shape_a, shape_b) = contact_kinematics::shapes(model, a, b)?;
    let first = Moving { shape: shape_a, pose: &states[a].pose, velocity: &velocities[0] };
    let second = Moving { shape: shape_b, pose: &states[b].pose, velocity: &velocities[1] };
    Some(Passing::new(first, second, tolerances::touch_distance(model, states, a, b)))
}

/// Whether the bodies of a contact pass each other along a face, so that they do not collide there.
pub(crate) fn pass_each_other(
    model: &Model,
    states: &[BodyState],
    id: ContactId,
    kinematics: &ContactKinematics,
) -> bool {
    let pair = (id.a, id.b);
    let velocities = [id.a, id.b].map(|body| model.velocity(body, &states[body]));
    let Feature::Shapes(feature) = id.feature else { return false };
    kinematics.separation_rate < -sustained_rate(model, pair, &velocities)
        && passing_of(model, states, pair, &velocities)
            .and_then(|mut bodies| bodies.in_place_of(feature, kinematics.geometry.normal))
            .is_some()
}
