//! A place of a curve.

use glam::DVec3;

/// A place of a curve.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CurvePoint {
    /// World or frame of the curve, m.
    pub point: DVec3,
    /// Unit vector in the direction of growing arc length.
    pub tangent: DVec3,
    /// Derivative of the tangent by the arc length, 1/m.
    pub curvature: DVec3,
    /// Derivative of the curvature by the arc length, 1/m^2.
    pub curvature_rate: DVec3,
    /// Arc length from the start, m: below zero or above the length beyond the ends of an open curve, which goes on
    /// straight there.
    pub arc: f64,
}
