//! A body as it is reported.

use polhode_spatial::{Pose, Velocity};

/// A body at one time.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BodySample {
    /// `X_WB`: pose of the body's own origin.
    pub pose: Pose,
    /// Velocity of the centre of mass and angular velocity, world.
    pub velocity: Velocity,
}
