//! Tori: all points within a radius of a circle. The one smooth shape that is not convex.

use super::circle::Circle;
use super::error::{ShapeError, check_length, check_point};
use glam::DVec3;
use polhode_spatial::{Pose, UnitVector};

/// A torus: the points within `minor` of the circle of radius `major` about its axis.
#[derive(Debug, Clone, PartialEq)]
pub struct Torus {
    pub(crate) center: DVec3,
    pub(crate) axis: DVec3,
    pub(crate) major: f64,
    pub(crate) minor: f64,
}

impl Torus {
    /// With its centre (m) and the direction of its axis in the body's frame; `major` is the radius of the centre
    /// circle of the tube, `minor` that of the tube, m.
    ///
    /// # Errors
    /// When a length is not positive, a number is not finite, or the tube closes the hole (`minor >= major`).
    pub fn new(center: DVec3, axis: UnitVector, major: f64, minor: f64) -> Result<Self, ShapeError> {
        check_point("centre", center)?;
        check_length("major radius", major)?;
        check_length("minor radius", minor)?;
        if minor >= major {
            return Err(ShapeError::NoHole { major, minor });
        }
        Ok(Self { center, axis: axis.get(), major, minor })
    }

    /// Centre in the body's frame, m.
    pub const fn center(&self) -> DVec3 {
        self.center
    }

    /// Unit vector along the axis in the body's frame.
    pub const fn axis(&self) -> DVec3 {
        self.axis
    }

    /// Radius of the centre circle of the tube, m.
    pub const fn major(&self) -> f64 {
        self.major
    }

    /// Radius of the tube, m.
    pub const fn minor(&self) -> f64 {
        self.minor
    }

    /// The centre circle of the tube.
    pub(crate) const fn ring(&self) -> Circle {
        Circle { center: self.center, axis: self.axis, radius: self.major }
    }

    pub(super) fn placed(&self, pose: &Pose) -> Result<Self, ShapeError> {
        let center = pose.transform_point(self.center);
        check_point("centre", center)?;
        Ok(Self { center, axis: pose.rotation.rotate(self.axis), ..*self })
    }

    pub(super) fn size(&self) -> f64 {
        2.0 * (self.major + self.minor)
    }
}
