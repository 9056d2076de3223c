//! Features measured: their geometry at the poses of the bodies.

use crate::narrow_phase::feature::placed::Placed;
use crate::narrow_phase::terms::evaluate::evaluate;
use crate::{Contact, ContactFeature, Shape};
use polhode_spatial::Pose;

/// The features with their geometry, as far as they are within reach, sorted, instead of what the list held.
pub(crate) fn measure(
    features: &mut [ContactFeature],
    a: Placed<'_>,
    b: Placed<'_>,
    reach: f64,
    contacts: &mut Vec<Contact>,
) {
    features.sort_unstable();
    contacts.clear();
    for &feature in features.iter() {
        let geometry = evaluate(feature, a.shape, a.pose, b.shape, b.pose);
        contacts.extend(geometry.filter(|g| g.separation <= reach).map(|geometry| Contact { feature, geometry }));
    }
}

/// Gives contacts the geometry that [`evaluate`] gives them at these poses, and leaves out those that it says to be farther
/// than `most` (m): in the frame of a part they were nearer by rounding.
pub(crate) fn measure_again(contacts: &mut Vec<Contact>, shapes: [&Shape; 2], poses: [&Pose; 2], most: f64) {
    contacts.retain_mut(|contact| {
        let geometry = evaluate(contact.feature, shapes[0], poses[0], shapes[1], poses[1]);
        contact.geometry = geometry.unwrap_or(contact.geometry);
        geometry.is_some_and(|geometry| geometry.separation <= most)
    });
}
