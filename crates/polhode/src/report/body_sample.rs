//! Pose and velocity of a body, as samples and reports hold them.

use crate::identity::body_id::BodyId;
use polhode_spatial::{Pose, Velocity};

/// Pose and velocity of a body at one time.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BodySample {
    /// `X_WB`: pose of the body's own origin.
    pub pose: Pose,
    /// Velocity of the centre of mass (of a kinematic body: of its own origin) and angular velocity, world.
    pub velocity: Velocity,
}

/// A body at the end of a run.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct ReportedBody {
    /// Its handle.
    pub body: BodyId,
    /// Its name.
    pub name: String,
    /// Where it is, and how it moves; of a removed body its last state.
    pub state: BodySample,
}
