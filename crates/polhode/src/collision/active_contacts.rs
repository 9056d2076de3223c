//! The active contacts of an island, each with its modes.

use super::contact_modes::ContactModes;
use super::friction_mode::{FrictionMode, Slide};
use super::turn::{RotationModes, Turn};
use crate::collision::contact_kinematics;
use crate::collision::touch::Touch;
use crate::identity::contact_id::ContactId;
use crate::model::Model;
use polhode_dynamics::BodyState;

/// Active contacts of an island.
#[derive(Debug, Clone, Default)]
pub(crate) struct ActiveContacts {
    /// Ascending.
    held: Vec<ContactId>,
    /// In the order of the contacts.
    modes: Vec<ContactModes>,
}

impl ActiveContacts {
    /// Contacts, ascending, with their modes.
    pub(crate) fn new(contacts: impl Iterator<Item = (ContactId, ContactModes)>) -> Self {
        let (held, modes) = contacts.unzip();
        Self { held, modes }
    }

    /// The contacts, ascending.
    pub(crate) fn held(&self) -> &[ContactId] {
        &self.held
    }

    /// Whether this contact is one of them.
    pub(crate) fn holds(&self, id: ContactId) -> bool {
        self.held.binary_search(&id).is_ok()
    }

    /// The contacts with their modes, ascending.
    pub(crate) fn with_modes(&self) -> impl Iterator<Item = (ContactId, &ContactModes)> {
        self.held.iter().copied().zip(&self.modes)
    }

    /// The modes of a contact, as far as they are known.
    pub(crate) fn modes(&self, id: ContactId) -> ContactModes {
        self.held.binary_search(&id).ok().and_then(|place| self.modes.get(place).copied()).unwrap_or_default()
    }

    /// Whether one of them has friction.
    pub(crate) fn rub(&self) -> bool {
        self.modes.iter().any(|modes| modes.friction.is_some())
    }

    /// Whether friction resists a rotation at one of them.
    pub(crate) fn resist_rotation(&self) -> bool {
        self.modes.iter().any(|modes| !modes.rotation.is_empty())
    }

    /// The contacts that stick, ascending.
    pub(crate) fn sticking(&self) -> Vec<ContactId> {
        let sticking = self.with_modes().filter(|(_, modes)| modes.friction == Some(FrictionMode::Sticking));
        sticking.map(|(id, _)| id).collect()
    }

    /// The contacts that slide, ascending.
    pub(crate) fn sliding(&self) -> impl Iterator<Item = (ContactId, Slide)> {
        self.with_modes().filter_map(|(id, modes)| match modes.friction? {
            FrictionMode::Sliding(slide) => Some((id, slide)),
            FrictionMode::Sticking => None,
        })
    }

    /// Whether one of them slides.
    pub(crate) fn slides(&self) -> bool {
        self.sliding().next().is_some()
    }

    /// The rotations that turn, in order.
    pub(crate) fn turning(&self) -> impl Iterator<Item = (ContactId, Turn, Slide)> {
        let turns =
            self.with_modes().flat_map(|(id, modes)| Turn::ALL.map(|turn| (id, turn, modes.rotation.get(turn))));
        turns.filter_map(|(id, turn, mode)| match mode? {
            FrictionMode::Sliding(slide) => Some((id, turn, slide)),
            FrictionMode::Sticking => None,
        })
    }

    /// The rotations that friction holds at zero, in order.
    pub(crate) fn held_turns(&self) -> Vec<(ContactId, Turn)> {
        self.with_modes().flat_map(|(id, modes)| modes.rotation.held().map(move |turn| (id, turn))).collect()
    }

    /// Gives contacts that slide or turn the direction and speed of their slips in these states, at the start of a
    /// step.
    pub(crate) fn renew_directions(&mut self, model: &Model, states: &[BodyState]) {
        for (&id, modes) in self.held.iter().zip(&mut self.modes) {
            renew(modes, model, states, id);
        }
    }
}

/// Gives what slides or turns at a contact the direction and speed of its slip in these states.
fn renew(modes: &mut ContactModes, model: &Model, states: &[BodyState], id: ContactId) {
    if let Some(FrictionMode::Sliding(slide)) = &mut modes.friction
        && let Some(terms) = contact_kinematics::tangential_kinematics(model, states, id)
    {
        *slide = slide.renewed(terms.slip_velocity);
    }
    if modes.rotation.is_empty() {
        return;
    }
    let Some(kinematics) = contact_kinematics::kinematics(model, states, id) else { return };
    let (rotation, before) = (contact_kinematics::relative_rotation(model, states, id), modes.rotation);
    modes.rotation = RotationModes::of(|turn| match before.get(turn)? {
        FrictionMode::Sticking => Some(FrictionMode::Sticking),
        FrictionMode::Sliding(slide) => {
            Some(FrictionMode::Sliding(slide.renewed(turn.part(rotation, kinematics.geometry.normal))))
        }
    });
}

impl<'a> FromIterator<&'a Touch> for ActiveContacts {
    fn from_iter<T: IntoIterator<Item = &'a Touch>>(touches: T) -> Self {
        Self::new(touches.into_iter().map(|touch| (touch.id, touch.modes)))
    }
}
