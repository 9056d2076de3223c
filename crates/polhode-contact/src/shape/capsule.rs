//! Capsules: all points within a radius of a segment.

use super::error::{ShapeError, check_length, check_point};
use glam::DVec3;
use polhode_spatial::Pose;

/// A cylinder with a hemisphere at each end.
#[derive(Debug, Clone, PartialEq)]
pub struct Capsule {
    pub(crate) ends: [DVec3; 2],
    pub(crate) radius: f64,
}

impl Capsule {
    /// About the segment between two points of the body's frame, m.
    ///
    /// # Errors
    /// When the radius or the length of the segment is not positive, or a number is not finite.
    pub fn new(ends: [DVec3; 2], radius: f64) -> Result<Self, ShapeError> {
        check_length("radius", radius)?;
        ends.iter().try_for_each(|&end| check_point("end of the axis", end))?;
        check_length("length of the axis", ends[0].distance(ends[1]))?;
        Ok(Self { ends, radius })
    }

    /// Centres of the two hemispheres in the body's frame, m.
    pub const fn ends(&self) -> [DVec3; 2] {
        self.ends
    }

    /// Radius, m.
    pub const fn radius(&self) -> f64 {
        self.radius
    }

    pub(super) fn placed(&self, pose: &Pose) -> Result<Self, ShapeError> {
        Self::new(self.ends.map(|end| pose.transform_point(end)), self.radius)
    }

    pub(super) fn size(&self) -> f64 {
        self.ends[0].distance(self.ends[1]) + 2.0 * self.radius
    }
}
