//! Where a prescribed motion has moved a body to, and how it goes on.

use crate::acceleration::Acceleration;
use polhode_spatial::{DVec3, Rotation, Velocity};

/// Where a motion has moved a body to, and how it goes on.
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
    /// The velocity that it goes on with.
    pub(super) const fn rate(&self) -> Velocity {
        Velocity::new(self.velocity, self.angular_velocity)
    }

    /// Its acceleration.
    pub(super) const fn acceleration(&self) -> Acceleration {
        Acceleration { linear: self.acceleration, angular: self.angular_acceleration }
    }
}
