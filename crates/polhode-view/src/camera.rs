//! Cameras: where a picture is taken from.

use polhode::spatial::DVec3;

/// Vertical field of view of a camera that is put somewhere by itself, rad.
const FIELD_OF_VIEW_RAD: f64 = 0.6;
/// From where it looks: from the front, a little from the right and above.
const FROM: DVec3 = DVec3::new(0.55, -1.0, 0.42);
/// Room around what is shown, as a factor.
const MARGIN: f64 = 1.06;
/// Radius of what is shown at the least, m.
const LEAST_RADIUS_M: f64 = 1e-6;

/// A perspective camera.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Camera {
    /// Where it is, m.
    pub eye: DVec3,
    /// Unit vectors to the right, up, and forwards.
    pub axes: [DVec3; 3],
    /// Vertical field of view, rad.
    pub field_of_view_rad: f64,
    /// What lies nearer is cut off, m.
    pub near_m: f64,
}

impl Camera {
    /// That looks from a direction at a box (two corners, m) and sees all of it in a picture of this width over height.
    pub fn at_box(bounds: [DVec3; 2], from: DVec3, width_over_height: f64) -> Self {
        let from = from.try_normalize().unwrap_or(-DVec3::Y);
        let forwards = -from;
        let right = forwards.cross(DVec3::Z).try_normalize().unwrap_or(DVec3::X);
        let up = right.cross(forwards);
        let center = 0.5 * (bounds[0] + bounds[1]);
        let radius = (0.5 * (bounds[1] - bounds[0]).length()).max(LEAST_RADIUS_M);
        let tangent = libm::tan(0.5 * FIELD_OF_VIEW_RAD);
        // Each corner must lie within the four planes that bound the view.
        let mut distance = 0.0_f64;
        for corner in 0..8 {
            let pick = |axis: usize| bounds[corner >> axis & 1][axis];
            let arm = DVec3::new(pick(0), pick(1), pick(2)) - center;
            let across = (arm.dot(right).abs() / width_over_height).max(arm.dot(up).abs());
            distance = distance.max(MARGIN * across / tangent - arm.dot(forwards));
        }
        let distance = distance.max(MARGIN * 1.5 * radius);
        let near_m = 0.02 * distance;
        Self {
            eye: center + from * distance,
            axes: [right, up, forwards],
            field_of_view_rad: FIELD_OF_VIEW_RAD,
            near_m,
        }
    }

    /// That sees a whole box from the front, a little from the right and above.
    pub fn for_box(bounds: [DVec3; 2], width_over_height: f64) -> Self {
        Self::at_box(bounds, FROM, width_over_height)
    }

    /// A point as it is seen: to the right, up, and how far ahead, m.
    pub fn seen(&self, point: DVec3) -> DVec3 {
        let arm = point - self.eye;
        DVec3::from_array(self.axes.map(|axis| axis.dot(arm)))
    }
}
