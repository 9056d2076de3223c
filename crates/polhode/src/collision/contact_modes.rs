//! The modes of a contact between two events: whether it sticks or slides, and whether its rotations are held or turn.

use super::contact_set::ContactId;
use super::friction_mode::FrictionMode;
use super::turn::RotationModes;
use crate::world::World;
use polhode_dynamics::BodyState;

/// The modes of a contact.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(crate) struct ContactModes {
    /// Whether it sticks or slides. None for a contact without friction, and where that is to be found from its forces.
    pub(crate) friction: Option<FrictionMode>,
    /// Its rotations, likewise.
    pub(crate) rotation: RotationModes,
}

impl ContactModes {
    /// Gives what slides or turns the direction and speed of its slip in these states, at the start of a step.
    pub(super) fn renew(&mut self, world: &World, states: &[BodyState], id: ContactId) {
        if let Some(FrictionMode::Sliding(slide)) = &mut self.friction
            && let Some(terms) = world.tangential_kinematics(states, id)
        {
            *slide = slide.renewed(terms.slip_velocity);
        }
        if self.rotation.is_empty() {
            return;
        }
        let Some(kinematics) = world.kinematics(states, id) else { return };
        let rotation = world.relative_rotation(states, id);
        let modes = self.rotation;
        self.rotation = RotationModes::of(|turn| match modes.get(turn)? {
            FrictionMode::Sticking => Some(FrictionMode::Sticking),
            FrictionMode::Sliding(slide) => {
                Some(FrictionMode::Sliding(slide.renewed(turn.part(rotation, kinematics.geometry.normal))))
            }
        });
    }
}
