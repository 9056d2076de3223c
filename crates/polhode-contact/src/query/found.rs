//! The result for two cores: their distance, normal and witness points.

use crate::SurfaceFeature;
use glam::DVec3;

/// Two distances or penetration depths that differ by less than this many epsilon of the extent are equal.
pub(crate) const EQUAL_ULPS: f64 = 16.0;

/// Distance of two cores (m, negative when they overlap), the unit vector from B to A, the witness points, and the
/// features they lie on.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Found {
    pub(crate) distance: f64,
    pub(crate) normal: DVec3,
    pub(crate) on_a: DVec3,
    pub(crate) on_b: DVec3,
    pub(crate) feature_a: SurfaceFeature,
    pub(crate) feature_b: SurfaceFeature,
}

impl Found {
    /// The result with A and B exchanged.
    pub(crate) fn swapped(self) -> Self {
        Self {
            normal: -self.normal,
            on_a: self.on_b,
            on_b: self.on_a,
            feature_a: self.feature_b,
            feature_b: self.feature_a,
            ..self
        }
    }
}
