//! The contacts of a pair of bodies, with identity, geometry and time derivatives.
//!
//! Bodies and features identify a contact, so that its status is kept from one event to the next while its geometry is
//! evaluated anew in every state. Between events the set of contacts is frozen; at an event it is detected again.

use super::contact_kinematics::COUNTERPART_FRACTION;
use super::touch::{FoundContact, Pair};
use crate::collision::{contact_kinematics, passing};
use crate::identity::contact_id::{ContactId, Feature};
use crate::joints::joint_contacts;
use crate::model::plane_of_motion::PlaneOfMotion;
use crate::model::{Model, TOUCH_RELATIVE, tolerances, work};
use polhode_contact::{Manifold, counterpart, separation};
use polhode_dynamics::BodyState;
use polhode_spatial::DVec3;

/// Passes the manifold of two bodies (contacts with a separation of at most `reach`, m, as
/// [`polhode_contact::near_manifold`] gives them) to `read` and returns its result; none for a body without a
/// shape.
pub(crate) fn manifold_of<T>(
    model: &Model,
    states: &[BodyState],
    (a, b): (usize, usize),
    reach: f64,
    read: impl FnOnce(&Manifold) -> T,
) -> Option<T> {
    let (shape_a, shape_b) = contact_kinematics::shapes(model, a, b)?;
    model.work.add(work::OF_PAIR);
    let placed = ((shape_a, &states[a].pose), (shape_b, &states[b].pose));
    Some(model.narrow_phase.read((a, b), placed, (reach, model.bodies.len()), read))
}

/// The signed separation of two bodies, m, at any distance, computed without the memory of the pair. It is for
/// poses far from those in the memory: bodies that a scene or a program has placed, and states at the start of a
/// step. None for a body without a shape.
pub(crate) fn separation_without_memory(model: &Model, states: &[BodyState], a: usize, b: usize) -> Option<f64> {
    let (shape_a, shape_b) = contact_kinematics::shapes(model, a, b)?;
    model.work.add(work::OF_PAIR);
    Some(separation(shape_a, &states[a].pose, shape_b, &states[b].pose))
}

/// Contacts of one pair with a separation of at most `reach` (m), sorted by feature.
pub(crate) fn contacts_of_pair(
    model: &Model,
    states: &[BodyState],
    a: usize,
    b: usize,
    reach: f64,
) -> Vec<FoundContact> {
    pair(model, states, a, b, reach).contacts
}

/// The separation of one pair, m, and its contacts as [`Self::contacts_of_pair`] gives them.
pub(crate) fn pair(model: &Model, states: &[BodyState], a: usize, b: usize, reach: f64) -> Pair {
    if let Some(stops) = pair_of_joint_contacts(model, states, (a, b), reach) {
        return stops;
    }
    let found = manifold_with_counterparts(model, states, (a, b), reach);
    found.map_or_else(Pair::far, |found| pair_of(model, states, (a, b), reach, found))
}

/// [`Self::pair`] where the bodies, or one of their contacts, penetrate by more than `depth` (m); none elsewhere.
pub(crate) fn penetrating_pair(
    model: &Model,
    states: &[BodyState],
    (a, b): (usize, usize),
    reach: f64,
    depth: f64,
) -> Option<Pair> {
    let penetrates = |separation: f64| separation < -depth;
    if let Some(stops) = pair_of_joint_contacts(model, states, (a, b), reach) {
        return penetrates(stops.separation).then_some(stops);
    }
    let (separation, contacts) = manifold_with_counterparts(model, states, (a, b), reach)?;
    let is_deep = contacts.iter().any(|contact| penetrates(contact.kinematics.geometry.separation));
    (is_deep || penetrates(separation)).then(|| pair_of(model, states, (a, b), reach, (separation, contacts)))
}

/// The contacts at the joints of two bodies; none of bodies without them.
fn pair_of_joint_contacts(model: &Model, states: &[BodyState], pair: (usize, usize), reach: f64) -> Option<Pair> {
    if !model.joints.has_joint_contacts() || model.joints.joint_contacts_of_pair(pair).is_empty() {
        return model.joints.lost_joint_contacts(pair).then(Pair::far);
    }
    let contacts = joint_contacts::joint_contacts_within(model, states, pair, reach).into_iter();
    let contacts: Vec<FoundContact> = contacts
        .map(|found| FoundContact {
            kinematics: contact_kinematics::in_plane(model, found.id, found.kinematics),
            ..found
        })
        .collect();
    let separations = contacts.iter().map(|found| found.kinematics.geometry.separation);
    Some(Pair { separation: separations.fold(f64::INFINITY, f64::min), contacts, is_passing: false })
}

fn pair_of(
    model: &Model,
    states: &[BodyState],
    (a, b): (usize, usize),
    reach: f64,
    (separation, mut contacts): (f64, Vec<FoundContact>),
) -> Pair {
    let passing = passing::take_place_of_collisions(model, states, (a, b), &mut contacts);
    let is_passing = !passing.is_empty();
    let contacts = within(model, (a, b), reach, contacts, &passing);
    Pair { separation, contacts, is_passing }
}

/// The separation of one pair, m, and its contacts with a separation of at most `reach` (m) by the poses of its
/// bodies alone: also those at which the bodies pass each other.
pub(crate) fn pair_at_poses(model: &Model, states: &[BodyState], a: usize, b: usize, reach: f64) -> Pair {
    if let Some(stops) = pair_of_joint_contacts(model, states, (a, b), reach) {
        return stops;
    }
    let Some((separation, contacts)) = manifold_with_counterparts(model, states, (a, b), reach) else {
        return Pair::far();
    };
    Pair { separation, contacts: within(model, (a, b), reach, contacts, &[]), is_passing: false }
}

/// Separation (m) and contacts of one pair, sorted by feature; none when its separation exceeds `reach` (m).
fn manifold_with_counterparts(
    model: &Model,
    states: &[BodyState],
    (a, b): (usize, usize),
    reach: f64,
) -> Option<(f64, Vec<FoundContact>)> {
    let (shape_a, shape_b) = contact_kinematics::shapes(model, a, b)?;
    let (pose_a, pose_b) = (&states[a].pose, &states[b].pose);
    let read =
        |found: &Manifold| (found.separation, found.contacts.iter().map(|contact| contact.feature).collect::<Vec<_>>());
    let (separation, mut features) = manifold_of(model, states, (a, b), reach, read)?;
    let distance = COUNTERPART_FRACTION * TOUCH_RELATIVE * tolerances::pair_size(model, a, b);
    for i in 0..features.len() {
        features.extend(counterpart(features[i], shape_a, pose_a, shape_b, pose_b, distance));
    }
    features.sort_unstable();
    features.dedup();
    let found = features.into_iter().filter_map(|feature| {
        let id = ContactId { a, b, feature: Feature::Shapes(feature) };
        Some(FoundContact { id, kinematics: contact_kinematics::kinematics_in_space(model, states, id)? })
    });
    Some((separation, found.collect()))
}

/// Those of the contacts of one pair that are within `reach` (m) and on their features, or among `passing`
/// (ascending); in planar motion, those that are counted.
fn within(
    model: &Model,
    (a, b): (usize, usize),
    reach: f64,
    found: Vec<FoundContact>,
    passing: &[Feature],
) -> Vec<FoundContact> {
    // A contact that has left its features is dropped, even if collision detection keeps it as the last one of its
    // pair.
    let border = -TOUCH_RELATIVE * tolerances::pair_size(model, a, b);
    let within = |contact: &FoundContact| {
        let geometry = &contact.kinematics.geometry;
        geometry.separation <= reach
            && (geometry.margin >= border || passing.binary_search(&contact.id.feature).is_ok())
    };
    let Some(plane) = &model.planar.of_pair(a, b) else { return found.into_iter().filter(within).collect() };
    let distance = COUNTERPART_FRACTION * TOUCH_RELATIVE * tolerances::pair_size(model, a, b);
    let is_counted = |contact: &&FoundContact| is_counted(plane, contact.kinematics.geometry.point, &found, distance);
    let in_motion = |contact: &FoundContact| FoundContact {
        kinematics: contact_kinematics::in_plane(model, contact.id, contact.kinematics),
        ..*contact
    };
    found.iter().filter(is_counted).map(in_motion).filter(within).collect()
}

/// Whether a contact point is kept in planar motion. One below the plane is left out when its mirror image is among
/// `found`; it is kept when collision detection has found it alone, which may happen where both images have the same
/// separation.
fn is_counted(plane: &PlaneOfMotion, point: DVec3, found: &[FoundContact], distance: f64) -> bool {
    let height = plane.height(point);
    if height >= -distance {
        return true;
    }
    let image = point - plane.normal() * (2.0 * height);
    let mut points = found.iter().map(|other| other.kinematics.geometry.point);
    points.all(|other| (other - image).length() > distance / COUNTERPART_FRACTION)
}

/// Whether a contact beyond the border of its face holds, because its bodies pass each other along that face.
pub(crate) fn holds_beyond_border(model: &Model, states: &[BodyState], id: ContactId) -> bool {
    let found = contacts_of_pair(model, states, id.a, id.b, tolerances::touch_distance(model, states, id.a, id.b));
    found.iter().any(|contact| contact.id == id)
}
