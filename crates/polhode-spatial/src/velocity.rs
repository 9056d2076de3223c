//! Velocities of rigid bodies.

use glam::DVec3;

/// Velocity of a body: that of its centre of mass and its angular velocity, in the world.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Velocity {
    /// `v_WBcm`, m/s.
    pub linear: DVec3,
    /// `w_WB`, rad/s.
    pub angular: DVec3,
}

impl Velocity {
    /// At rest.
    pub const ZERO: Self = Self { linear: DVec3::ZERO, angular: DVec3::ZERO };

    /// From its two parts.
    pub const fn new(linear: DVec3, angular: DVec3) -> Self {
        Self { linear, angular }
    }

    /// Velocity of the body's point at `arm` from the centre of mass (world axes): `v + w x r` (thesis 3.3).
    pub fn at(&self, arm: DVec3) -> DVec3 {
        self.linear + self.angular.cross(arm)
    }

    /// Whether every component is finite.
    pub fn is_finite(&self) -> bool {
        self.linear.is_finite() && self.angular.is_finite()
    }

    /// Whether the body is exactly at rest.
    pub fn is_zero(&self) -> bool {
        self.linear == DVec3::ZERO && self.angular == DVec3::ZERO
    }
}
