//! Right circular cones.

use super::circle::Circle;
use super::error::{ShapeError, check_length, check_point};
use glam::DVec3;
use polhode_spatial::{Pose, UnitVector};

/// A solid cone.
#[derive(Debug, Clone, PartialEq)]
pub struct Cone {
    pub(crate) base: DVec3,
    pub(crate) axis: DVec3,
    pub(crate) radius: f64,
    pub(crate) height: f64,
}

impl Cone {
    /// With the centre of its base (m) and the direction from there to its apex in the body's frame.
    ///
    /// # Errors
    /// When a length is not positive or a number is not finite.
    pub fn new(base: DVec3, axis: UnitVector, radius: f64, height: f64) -> Result<Self, ShapeError> {
        check_point("centre of the base", base)?;
        check_length("radius", radius)?;
        check_length("height", height)?;
        let cone = Self { base, axis: axis.get(), radius, height };
        check_point("apex", cone.apex())?;
        Ok(cone)
    }

    /// Centre of the base in the body's frame, m.
    pub const fn base(&self) -> DVec3 {
        self.base
    }

    /// Unit vector from the base to the apex in the body's frame.
    pub const fn axis(&self) -> DVec3 {
        self.axis
    }

    /// Radius of the base, m.
    pub const fn radius(&self) -> f64 {
        self.radius
    }

    /// Height, m.
    pub const fn height(&self) -> f64 {
        self.height
    }

    /// Apex in the body's frame, m.
    pub fn apex(&self) -> DVec3 {
        self.base + self.axis * self.height
    }

    /// The rim of the base.
    pub(crate) fn rim(&self) -> Circle {
        Circle { center: self.base, axis: -self.axis, radius: self.radius }
    }

    pub(super) fn placed(&self, pose: &Pose) -> Result<Self, ShapeError> {
        let base = pose.transform_point(self.base);
        check_point("centre of the base", base)?;
        Ok(Self { base, axis: pose.rotation.rotate(self.axis), ..*self })
    }

    pub(super) fn size(&self) -> f64 {
        (2.0 * self.radius).max(libm::hypot(self.radius, self.height))
    }
}
