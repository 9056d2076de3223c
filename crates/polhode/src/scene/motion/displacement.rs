//! Displacement of a body by a prescribed motion, with its first and second time derivatives.

use crate::report::acceleration::Acceleration;
use polhode_spatial::{DVec3, Rotation, Velocity};

/// Displacement of a body's own origin (m) and rotation by a motion at one time, with their derivatives, world.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Displacement {
    pub(super) translation: DVec3,
    pub(super) rotation: Rotation,
    pub(super) velocity: DVec3,
    pub(super) angular_velocity: DVec3,
    pub(super) acceleration: DVec3,
    pub(super) angular_acceleration: DVec3,
}

impl Displacement {
    /// Linear and angular velocity.
    pub(super) const fn rate(&self) -> Velocity {
        Velocity::new(self.velocity, self.angular_velocity)
    }

    /// Linear and angular acceleration.
    pub(super) const fn acceleration(&self) -> Acceleration {
        Acceleration { linear: self.acceleration, angular: self.angular_acceleration }
    }
}
