//! Right circular cylinders.

use super::circle::Circle;
use super::error::{ShapeError, check_length, check_point};
use glam::DVec3;
use polhode_spatial::{Pose, UnitVector};

/// A solid cylinder: the points within `radius` of its axis and within `height/2` of its centre along it.
#[derive(Debug, Clone, PartialEq)]
pub struct Cylinder {
    pub(crate) center: DVec3,
    pub(crate) axis: DVec3,
    pub(crate) radius: f64,
    pub(crate) half_height: f64,
}

impl Cylinder {
    /// With its centre (m) and the direction of its axis in the body's frame.
    ///
    /// # Errors
    /// When a length is not positive or a number is not finite.
    pub fn new(center: DVec3, axis: UnitVector, radius: f64, height: f64) -> Result<Self, ShapeError> {
        check_point("centre", center)?;
        check_length("radius", radius)?;
        check_length("height", height)?;
        Ok(Self { center, axis: axis.get(), radius, half_height: 0.5 * height })
    }

    /// Centre in the body's frame, m.
    pub const fn center(&self) -> DVec3 {
        self.center
    }

    /// Unit vector along the axis in the body's frame.
    pub const fn axis(&self) -> DVec3 {
        self.axis
    }

    /// Radius, m.
    pub const fn radius(&self) -> f64 {
        self.radius
    }

    /// Height, m.
    pub const fn height(&self) -> f64 {
        2.0 * self.half_height
    }

    /// The rims, towards `-axis` and towards `axis`.
    pub(crate) fn rims(&self) -> [Circle; 2] {
        let rim = |axis: DVec3| Circle { center: self.center + axis * self.half_height, axis, radius: self.radius };
        [rim(-self.axis), rim(self.axis)]
    }

    pub(super) fn placed(&self, pose: &Pose) -> Result<Self, ShapeError> {
        let center = pose.transform_point(self.center);
        check_point("centre", center)?;
        Ok(Self { center, axis: pose.rotation.rotate(self.axis), ..*self })
    }

    pub(super) fn size(&self) -> f64 {
        2.0 * libm::hypot(self.radius, self.half_height)
    }
}
