//! A circle about an axis: the rim of a disc, or the centre circle of a torus.

use super::support::{across, unit};
use glam::DVec3;
use polhode_spatial::Pose;
use std::f64::consts::FRAC_1_SQRT_2;

/// Number of sample points of a rim, which represent its disc.
pub const RIM_POINTS: u32 = 8;

/// Cosine and sine of the angles of the sample points.
const SAMPLE_ANGLES: [(f64, f64); RIM_POINTS as usize] = [
    (1.0, 0.0),
    (FRAC_1_SQRT_2, FRAC_1_SQRT_2),
    (0.0, 1.0),
    (-FRAC_1_SQRT_2, FRAC_1_SQRT_2),
    (-1.0, 0.0),
    (-FRAC_1_SQRT_2, -FRAC_1_SQRT_2),
    (0.0, -1.0),
    (FRAC_1_SQRT_2, -FRAC_1_SQRT_2),
];

/// Sine of the angle between a circle's axis and a direction below which all its points are equally low: its sample
/// points are then as low as the lowest one to 1e-12 of its radius.
const FLAT_SINE: f64 = 1e-11;

/// A circle about an axis. The axis of a rim is the outward normal of its disc.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Circle {
    pub(crate) center: DVec3,
    pub(crate) axis: DVec3,
    pub(crate) radius: f64,
}

impl Circle {
    /// The circle of a shape at a pose.
    pub(crate) fn placed(&self, pose: &Pose) -> Self {
        Self { center: pose.transform_point(self.center), axis: pose.rotation.rotate(self.axis), ..*self }
    }

    /// Largest coordinate of its points along a unit vector, m.
    pub(crate) fn support(&self, n: DVec3) -> f64 {
        n.dot(self.center) + self.radius * self.axis.cross(n).length()
    }

    /// The support point of its disc along a direction: the centre when the disc is perpendicular to it.
    pub(crate) fn farthest(&self, direction: DVec3) -> DVec3 {
        self.center + unit(across(direction, self.axis)) * self.radius
    }

    /// A sample point; none beyond [`RIM_POINTS`].
    pub(crate) fn point(&self, index: u32) -> Option<DVec3> {
        let (cosine, sine) = *SAMPLE_ANGLES.get(index as usize)?;
        let first = self.axis.any_orthonormal_vector();
        Some(self.center + (first * cosine + self.axis.cross(first) * sine) * self.radius)
    }

    /// The nearest point of the circle to a point; an arbitrary point of it for a point on its axis.
    pub(crate) fn nearest(&self, p: DVec3) -> DVec3 {
        let radial = across(p - self.center, self.axis);
        let radial = radial.try_normalize().unwrap_or_else(|| self.axis.any_orthonormal_vector());
        self.center + radial * self.radius
    }

    /// The point that is lowest along a unit vector; none when all are equally low to rounding.
    pub(crate) fn lowest(&self, up: DVec3) -> Option<DVec3> {
        let radial = across(up, self.axis);
        let sine = radial.length();
        (sine > FLAT_SINE).then(|| self.center - radial * (self.radius / sine))
    }

    /// Two perpendicular radii, the second one anticlockwise from the first.
    pub(crate) fn radii(&self) -> [DVec3; 2] {
        let east = self.axis.any_orthonormal_vector() * self.radius;
        [east, self.axis.cross(east)]
    }
}
