//! Friction of rolling and of spinning at an instant: which rotations at contacts turn, and which are held.

use super::hold::{Forces, FoundMode};
use super::motions::Motions;
use super::resolve::Resolution;
use super::resolve::slip_noise;
use crate::collision::contact_kinematics;
use crate::collision::friction_mode::{FrictionMode, Slide};
use crate::collision::touch::Touch;
use crate::collision::turn::{RotationModes, Turn};
use crate::model::tolerances;
use crate::tier::core::Core;

impl Motions {
    /// The rotations of a contact that turn in the present states.
    pub(super) fn rotation_of(&self, core: &Core, speed_scale: f64, touch: &Touch) -> RotationModes {
        if !core.model.surfaces.have_rotational_friction() {
            return RotationModes::default();
        }
        let rotation = contact_kinematics::relative_rotation(&core.model, &self.states, touch.id);
        RotationModes::of(|turn| {
            turn.friction(&core.model, (touch.id.a, touch.id.b))?;
            let part = turn.part(rotation, touch.kinematics.geometry.normal);
            let (speed, noise) = (part.length(), rotation_noise(core, speed_scale, touch));
            let turns = speed > noise.max(self.sustained_speed(core, speed_scale, touch) / size_of(core, touch));
            turns.then(|| FrictionMode::Sliding(Slide { direction: part / speed, speed, noise }))
        })
    }
}

impl Resolution<'_> {
    /// The rotations of a contact at an instant: those that turn, or can be held no longer. The moments of the others
    /// decide.
    pub(super) fn rotation_at(&self, touch: &Touch) -> RotationModes {
        let known = self.motions.rotation_of(self.core, self.instant.speed_scale, touch);
        RotationModes::of(|turn| {
            turn.friction(&self.core.model, (touch.id.a, touch.id.b))?;
            let key = (touch.id, turn);
            match self.instant.change.turning.get(&key) {
                Some(&direction) => {
                    let noise = rotation_noise(self.core, self.instant.speed_scale, touch);
                    Some(FrictionMode::Sliding(Slide::beginning(direction, noise)))
                }
                None if self.instant.change.settling.contains(&key) => None,
                None => known.get(turn),
            }
        })
    }

    /// Sets which rotations of a contact are held, from its forces; none when it has none.
    pub(super) fn set_rotation(&mut self, i: usize, found: Option<(usize, &Forces)>) {
        let touch = self.instant.touches[i];
        let noise = rotation_noise(self.core, self.instant.speed_scale, &touch);
        let with_modes = self.with_friction_mode(&touch);
        let mode = |turn: Turn| {
            let (_, forces) = found?;
            Some(match forces.turn_mode(&with_modes, turn)? {
                FoundMode::Known(mode) => mode,
                FoundMode::Begins(direction) => FrictionMode::Sliding(Slide::beginning(direction, noise)),
                FoundMode::Sticks => FrictionMode::Sticking,
            })
        };
        self.instant.touches[i].modes.rotation = RotationModes::of(mode);
    }
}

/// The size of the smaller body of a contact that moves, m.
fn size_of(core: &Core, touch: &Touch) -> f64 {
    tolerances::pair_size(&core.model, touch.id.a, touch.id.b)
}

/// Rounding error of relative rotations at a contact, rad/s.
fn rotation_noise(core: &Core, speed_scale: f64, touch: &Touch) -> f64 {
    slip_noise(core, speed_scale, touch) / size_of(core, touch)
}
