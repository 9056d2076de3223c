//! Evaluates contact features at the poses of the bodies.

use crate::narrow_phase::feature::placed::Placed;
use crate::narrow_phase::terms::evaluate::evaluate;
use crate::{Contact, ContactFeature, Shape};
use polhode_spatial::Pose;

/// Replaces the contacts by those of the features whose separation is at most `reach` (m), sorted.
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

/// Evaluates the contacts again with [`evaluate`] at these poses, and removes those with a separation above `most` (m):
/// in the frame of a part rounding may have made it smaller.
pub(crate) fn measure_again(contacts: &mut Vec<Contact>, shapes: [&Shape; 2], poses: [&Pose; 2], most: f64) {
    contacts.retain_mut(|contact| {
        let geometry = evaluate(contact.feature, shapes[0], poses[0], shapes[1], poses[1]);
        contact.geometry = geometry.unwrap_or(contact.geometry);
        geometry.is_some_and(|geometry| geometry.separation <= most)
    });
}
