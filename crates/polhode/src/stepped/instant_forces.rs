//! Forces of contacts at one instant, with the accelerations that they give.

use polhode_spatial::DVec3;

/// Forces on body A of some contacts, in their order, and accelerations of their bodies.
#[derive(Debug, Clone, Default)]
pub(super) struct PresentForces {
    /// Along the normals, N.
    pub(super) normal: Vec<f64>,
    /// Of friction, world, N.
    pub(super) friction: Vec<DVec3>,
    /// Of bodies: linear, m/s^2, and angular, rad/s^2.
    pub(super) accelerations: Vec<BodyAcceleration>,
}

/// Acceleration of one body, of the origin of its moving frame.
#[derive(Debug, Clone, Copy)]
pub(super) struct BodyAcceleration {
    pub(super) body: usize,
    /// m/s^2.
    pub(super) linear: DVec3,
    /// rad/s^2.
    pub(super) angular: DVec3,
}
