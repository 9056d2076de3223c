//! Balls.

use super::error::{ShapeError, check_length, check_point};
use glam::DVec3;

/// A ball.
#[derive(Debug, Clone, PartialEq)]
pub struct Sphere {
    pub(crate) center: DVec3,
    pub(crate) radius: f64,
}

impl Sphere {
    /// With its centre (in the body's frame) and radius, m.
    ///
    /// # Errors
    /// When the radius is not positive or a number is not finite.
    pub fn new(center: DVec3, radius: f64) -> Result<Self, ShapeError> {
        check_length("radius", radius)?;
        check_point("centre", center)?;
        Ok(Self { center, radius })
    }

    /// Centre in the body's frame, m.
    pub const fn center(&self) -> DVec3 {
        self.center
    }

    /// Radius, m.
    pub const fn radius(&self) -> f64 {
        self.radius
    }
}
