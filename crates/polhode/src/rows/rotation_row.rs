//! A row of a rotation: the angular velocity of A relative to B at a contact, along an axis, times a length.
//!
//! The length `l` (m) is of the order of the size of the pair. With it the rate `l w` is a velocity (m/s), and the
//! reaction `M / l` a force (N): rows of rotations and of contacts stand in one problem, whose norms and thresholds
//! would otherwise add newtons to newton metres and depend on the unit of length. It is a power of two, so that it
//! rounds nothing.

use crate::collision::contact_kinematics;
use crate::identity::contact_id::ContactId;
use crate::model::{Model, prescribed, tolerances};
use polhode_dynamics::BodyState;
use polhode_spatial::DVec3;

/// A row of a rotation.
#[derive(Debug, Clone, Copy)]
pub(crate) struct RotationRow {
    pub(crate) id: ContactId,
    /// The axis (world) times the length, m.
    pub(crate) axis: DVec3,
}

impl RotationRow {
    /// The row of a rotation about an axis (unit vector, world).
    pub(crate) fn about(model: &Model, id: ContactId, axis: DVec3) -> Self {
        Self { id, axis: axis * tolerances::turning_length(model, id.a, id.b) }
    }

    /// The relative angular velocity along the axis, times the length, m/s.
    pub(crate) fn rate(&self, model: &Model, states: &[BodyState]) -> f64 {
        self.axis.dot(contact_kinematics::relative_rotation(model, states, self.id))
    }

    /// Term of prescribed accelerations at `t` (s) in the derivative of its rate, m/s^2. The turning of the axis
    /// itself is left out: a rotation that is held is zero, and one that spins about a normal that turns slowly
    /// drifts little within a step.
    pub(crate) fn prescribed_acceleration(&self, model: &Model, t: f64) -> f64 {
        let of = |body: usize| {
            if prescribed::trajectory(model, body).is_some() {
                prescribed::prescribed_acceleration(model, body, t).1
            } else {
                DVec3::ZERO
            }
        };
        self.axis.dot(of(self.id.a) - of(self.id.b))
    }
}
