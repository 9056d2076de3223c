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

    /// Gives contacts that slide the direction of their slips in these states, at the start of a step.
    pub(crate) fn renew_directions(&mut self, world: &World, states: &[BodyState]) {
        for (&id, mode) in &mut self.friction {
            let Some(terms) = world.tangential_kinematics(states, id) else { continue };
            if let Some(direction) = mode.direction(terms.slip_velocity, world.slip_rounding(states, id)) {
                *mode = FrictionMode::Sliding(direction);
            }
        }
    }
}
