//! Linear and angular acceleration of a body.

use polhode_spatial::DVec3;

/// Acceleration of a body.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Acceleration {
    /// Acceleration of the centre of mass, world, m/s^2; of a kinematic body that of its own origin.
    pub linear: DVec3,
    /// Angular acceleration, world, rad/s^2.
    pub angular: DVec3,
}
