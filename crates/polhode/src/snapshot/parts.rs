//! Contacts and flight records as plain data, for the snapshots of several tiers.

use super::numbers::{Contact, read_state};
use super::{SnapshotError, content};
use crate::collision::contact_kinematics;
use crate::identity::contact_id::{ContactId, Feature};
use crate::model::Model;
use polhode_dynamics::{Flight, RigidBody};
use polhode_spatial::DVec3;

/// The identity of a contact as plain data.
pub(crate) fn save_contact(id: ContactId) -> Contact {
    Contact { a: id.a, b: id.b, feature: id.feature.into() }
}

/// The identity of a contact from plain data.
///
/// # Errors
/// When it is not of two bodies that can touch.
pub(crate) fn restored_id(model: &Model, saved: &Contact) -> Result<ContactId, SnapshotError> {
    let Contact { a, b, feature } = *saved;
    let feature = feature.into();
    let can_touch = match feature {
        Feature::Shapes(_) => a < b && b < model.bodies.len() && contact_kinematics::shapes(model, a, b).is_some(),
        Feature::Stop(_) | Feature::JointFriction(_) => model.joints.joint_contacts_of_pair((a, b)).contains(&feature),
    };
    if can_touch {
        Ok(ContactId { a, b, feature })
    } else {
        Err(SnapshotError::Invalid("a contact is not of two bodies that can touch"))
    }
}

/// Contacts with their forces (N) from plain data.
///
/// # Errors
/// When one is not of two bodies that can touch.
pub(crate) fn restored_forces(model: &Model, saved: &[(Contact, f64)]) -> Result<Vec<(ContactId, f64)>, SnapshotError> {
    saved.iter().map(|(id, force)| Ok((restored_id(model, id)?, *force))).collect()
}

/// A flight record as plain data.
pub(crate) fn save_flight(flight: &Flight) -> content::Flight {
    // A record with free rotation equals the one made from its start; any other has steady rotation.
    let free = Flight::new(flight.body(), flight.t0(), flight.start(), flight.gravity());
    content::Flight {
        t0: flight.t0(),
        start: flight.start().to_array(),
        acceleration: flight.gravity().to_array(),
        rotation: if free == *flight { content::Rotation::Free } else { content::Rotation::Steady },
    }
}

/// The flight record from plain data, of a body with these mass properties.
///
/// # Errors
/// When its start is not a valid state.
pub(crate) fn restored_flight(rigid: &RigidBody, saved: &content::Flight) -> Result<Flight, SnapshotError> {
    let record = match saved.rotation {
        content::Rotation::Free => Flight::new,
        content::Rotation::Steady => Flight::steady,
    };
    Ok(record(rigid, saved.t0, &read_state(&saved.start)?, DVec3::from_array(saved.acceleration)))
}
