//! How fast the velocity of a body changes.

use polhode_spatial::DVec3;

/// Acceleration of a body.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Acceleration {
    /// Of the centre of mass, world, m/s^2.
    pub linear: DVec3,
    /// Angular, world, rad/s^2.
    pub angular: DVec3,
}
