//! The active contacts of an island, with the friction of those that have it.

use super::contact_set::ContactId;
use super::friction_mode::FrictionMode;
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

    /// Gives contacts that slide the direction and speed of their slips in these states, at the start of a step.
    pub(crate) fn renew_directions(&mut self, world: &World, states: &[BodyState]) {
        for (&id, mode) in &mut self.friction {
            let FrictionMode::Sliding(slide) = mode else { continue };
            if let Some(terms) = world.tangential_kinematics(states, id) {
                *slide = slide.renewed(terms.slip_velocity);
            }
        }
    }
}
