//! The active contacts of an island, with the friction of those that have it.

use super::contact_set::ContactId;
use super::friction_mode::FrictionMode;
use super::turn::{RotationModes, Turn};
use crate::world::World;
use polhode_dynamics::BodyState;
use std::collections::BTreeMap;

/// Active contacts of an island.
#[derive(Debug, Clone, Default)]
pub(crate) struct ActiveContacts {
    /// Ascending.
    pub(crate) held: Vec<ContactId>,
    /// The modes of those with friction.
    pub(crate) friction: BTreeMap<ContactId, FrictionMode>,
    /// The rotations of those with friction of rolling or spinning.
    pub(crate) rotation: BTreeMap<ContactId, RotationModes>,
}

impl ActiveContacts {
    /// The contacts that stick, ascending.
    pub(crate) fn sticking(&self) -> Vec<ContactId> {
        let sticking = self.friction.iter().filter(|(_, mode)| **mode == FrictionMode::Sticking);
        sticking.map(|(&id, _)| id).collect()
    }

    /// Whether one of them slides.
    pub(crate) fn slides(&self) -> bool {
        self.friction.values().any(|mode| *mode != FrictionMode::Sticking)
    }

    /// The friction of a contact, as far as it is known.
    pub(crate) fn modes(&self, id: ContactId) -> (Option<FrictionMode>, RotationModes) {
        (self.friction.get(&id).copied(), self.rotation.get(&id).copied().unwrap_or_default())
    }

    /// The rotations that friction holds at zero, in order.
    pub(crate) fn held_turns(&self) -> Vec<(ContactId, Turn)> {
        let of = |(&id, modes): (&ContactId, &RotationModes)| {
            let modes = *modes;
            Turn::ALL
                .into_iter()
                .filter(move |&turn| modes.get(turn) == Some(FrictionMode::Sticking))
                .map(move |turn| (id, turn))
        };
        self.rotation.iter().flat_map(of).collect()
    }

    /// Gives contacts that slide or turn the direction and speed of their slips in these states, at the start of a
    /// step.
    pub(crate) fn renew_directions(&mut self, world: &World, states: &[BodyState]) {
        for (&id, mode) in &mut self.friction {
            let FrictionMode::Sliding(slide) = mode else { continue };
            if let Some(terms) = world.tangential_kinematics(states, id) {
                *slide = slide.renewed(terms.slip_velocity);
            }
        }
        for (&id, modes) in &mut self.rotation {
            let Some(kinematics) = world.kinematics(states, id) else { continue };
            let rotation = world.relative_rotation(states, id);
            *modes = RotationModes::of(|turn| match modes.get(turn)? {
                FrictionMode::Sticking => Some(FrictionMode::Sticking),
                FrictionMode::Sliding(slide) => {
                    Some(FrictionMode::Sliding(slide.renewed(turn.part(rotation, kinematics.geometry.normal))))
                }
            });
        }
    }
}
