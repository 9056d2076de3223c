//! What acts on each body at one stage of a method: the torque, and the acceleration of the frame's origin.
//!
//! `L' = torque` and `v' = g + F/m` for a free body; of a pivoted body v stays zero ([`FreeMotion::wrenches`]).

use crate::field::Wrench;
use crate::{BodyState, FreeMotion, RigidBody};
use glam::DVec3;

/// On one body.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Load {
    /// N m, world, about the origin of the body's frame.
    pub(crate) torque: DVec3,
    /// m/s^2, world, gravity included.
    pub(crate) acceleration: DVec3,
}

impl Load {
    /// On a body that no wrench acts on.
    pub(crate) fn unloaded(motion: &FreeMotion<'_>, body: &RigidBody) -> Self {
        Self { torque: DVec3::ZERO, acceleration: motion.free_acceleration(body) }
    }
}

/// On all bodies, with the buffers it takes.
#[derive(Debug, Default)]
pub(crate) struct Loads {
    states: Vec<BodyState>,
    wrenches: Vec<Wrench>,
}

impl Loads {
    /// Evaluates the wrenches at `t` (s) on bodies in `states`.
    pub(crate) fn evaluate(&mut self, motion: &FreeMotion<'_>, t: f64, states: impl Iterator<Item = BodyState>) {
        self.states.clear();
        self.states.extend(states);
        self.wrenches.resize(self.states.len(), Wrench::default());
        motion.wrenches(t, &self.states, &mut self.wrenches);
    }

    /// The load last evaluated on the body of this index.
    #[inline]
    pub(crate) fn on(&self, motion: &FreeMotion<'_>, body: &RigidBody, index: usize) -> Load {
        let wrench = self.wrenches.get(index).copied().unwrap_or_default();
        Load {
            torque: wrench.torque,
            acceleration: motion.free_acceleration(body) + wrench.force * body.inverse_mass(),
        }
    }
}
