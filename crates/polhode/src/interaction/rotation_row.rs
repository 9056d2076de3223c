//! A row of a rotation: the angular velocity of A relative to B at a contact, along an axis.

use crate::collision::contact_set::ContactId;
use crate::world::World;
use polhode_dynamics::BodyState;
use polhode_spatial::DVec3;

/// A row of a rotation.
#[derive(Debug, Clone, Copy)]
pub(crate) struct RotationRow {
    pub(crate) id: ContactId,
    /// Unit vector, world.
    pub(crate) axis: DVec3,
}

impl RotationRow {
    /// The relative angular velocity along the axis, rad/s.
    pub(crate) fn rate(&self, world: &World, states: &[BodyState]) -> f64 {
        self.axis.dot(world.relative_rotation(states, self.id))
    }

    /// Term of prescribed accelerations at `t` (s) in the derivative of its rate, rad/s^2. The turning of the axis
    /// itself is left out: a rotation that is held is zero, and one that spins about a normal that turns slowly
    /// drifts little within a step.
    pub(crate) fn prescribed_acceleration(&self, world: &World, t: f64) -> f64 {
        let of = |body: usize| {
            if world.trajectory(body).is_some() { world.prescribed_acceleration(body, t).1 } else { DVec3::ZERO }
        };
        self.axis.dot(of(self.id.a) - of(self.id.b))
    }
}
