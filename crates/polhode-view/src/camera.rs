//! Cameras: where a picture is taken from.

use crate::error::ViewError;
use polhode::spatial::DVec3;

/// Vertical field of view of a camera that is put somewhere by itself, rad.
const FIELD_OF_VIEW_RAD: f64 = 0.6;
/// From where it looks: from the front, a little from the right and above.
const FROM: DVec3 = DVec3::new(0.55, -1.0, 0.42);
/// Room around what is shown, as a factor.
const MARGIN: f64 = 1.06;
/// Radius of what is shown at the least, m.
const LEAST_RADIUS_M: f64 = 1e-6;
/// What lies nearer than this part of the distance to what is looked at is cut off.
const NEAR: f64 = 0.02;

/// Views by name, with the direction from what is looked at to the camera: those of the viewer in a page
/// (`viewer/src/camera.js`). That from the top leans a little: straight from above, "up" has no meaning.
pub const PRESETS: [(&str, DVec3); 4] = [
    ("front", DVec3::new(0.0, -1.0, 0.12)),
    ("side", DVec3::new(1.0, 0.0, 0.12)),
    ("top", DVec3::new(0.0, -0.001, 1.0)),
    ("iso", DVec3::new(0.85, -1.25, 0.75)),
];

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

/// Where a camera stands.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Standpoint {
    /// In this direction from what is looked at, so far away that all of it is seen.
    Direction(DVec3),
    /// Here, m.
    Eye(DVec3),
}

/// How a picture is looked at: from where, and at what.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Viewpoint {
    /// Where the camera stands.
    pub standpoint: Standpoint,
    /// The place in the middle of the picture, m; without it the middle of what moves.
    pub target: Option<DVec3>,
}

impl Default for Viewpoint {
    /// From the front, a little from the right and above.
    fn default() -> Self {
        Self { standpoint: Standpoint::Direction(FROM), target: None }
    }
}

impl Viewpoint {
    /// The camera for a box (two corners, m) in a picture of this width over height.
    ///
    /// # Errors
    /// When the camera stands at the place that it looks at, or a coordinate is not finite.
    pub fn camera(&self, bounds: [DVec3; 2], width_over_height: f64) -> Result<Camera, ViewError> {
        let center = 0.5 * (bounds[0] + bounds[1]);
        let target = self.target.unwrap_or(center);
        let nowhere = |eye| ViewError::CameraPlace { eye, target };
        match self.standpoint {
            Standpoint::Direction(from) => {
                let camera = Camera::at_box(bounds, from, width_over_height);
                let eye = camera.eye + (target - center);
                if eye.is_finite() { Ok(Camera { eye, ..camera }) } else { Err(nowhere(eye)) }
            }
            Standpoint::Eye(eye) => Camera::looking(eye, target).ok_or_else(|| nowhere(eye)),
        }
    }
}

impl Camera {
    /// That stands at a place and looks at another, upright where that has a meaning; none where both are one.
    fn looking(eye: DVec3, target: DVec3) -> Option<Self> {
        let forwards = (target - eye).try_normalize()?;
        Some(Self::facing(eye, forwards, (target - eye).length()))
    }

    fn facing(eye: DVec3, forwards: DVec3, distance: f64) -> Self {
        let right = forwards.cross(DVec3::Z).try_normalize().unwrap_or(DVec3::X);
        let up = right.cross(forwards);
        Self { eye, axes: [right, up, forwards], field_of_view_rad: FIELD_OF_VIEW_RAD, near_m: NEAR * distance }
    }

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
        Self::facing(center + from * distance, forwards, distance)
    }

    /// That sees a whole box from the front, a little from the right and above.
    pub fn for_box(bounds: [DVec3; 2], width_over_height: f64) -> Self {
        Self::at_box(bounds, FROM, width_over_height)
    }

    /// Pixels that a metre across has at a distance of one metre, in a picture of this height in pixels.
    pub fn focal_length_px(&self, height_px: f64) -> f64 {
        0.5 * height_px / libm::tan(0.5 * self.field_of_view_rad)
    }

    /// A point as it is seen: to the right, up, and how far ahead, m.
    pub fn seen(&self, point: DVec3) -> DVec3 {
        let arm = point - self.eye;
        DVec3::from_array(self.axes.map(|axis| axis.dot(arm)))
    }
}
