//! Half-spaces: floors that fill everything below their surface.

use super::error::{ShapeError, check_finite};
use glam::DVec3;
use polhode_spatial::UnitVector;

/// All points `x` with `normal . x <= offset`: a floor that fills everything below its surface.
#[derive(Debug, Clone, PartialEq)]
pub struct HalfSpace {
    pub(crate) normal: DVec3,
    pub(crate) offset: f64,
}

impl HalfSpace {
    /// With the outward normal of its surface and the surface's signed distance from the frame's origin, m.
    ///
    /// # Errors
    /// When the offset is not finite.
    pub fn new(normal: UnitVector, offset: f64) -> Result<Self, ShapeError> {
        check_finite("offset", offset)?;
        Ok(Self { normal: normal.get(), offset })
    }

    /// Outward unit normal in the body's frame.
    pub const fn normal(&self) -> DVec3 {
        self.normal
    }

    /// Signed distance of the surface from the frame's origin along the normal, m.
    pub const fn offset(&self) -> f64 {
        self.offset
    }
}
