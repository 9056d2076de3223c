//! Cameras: where a picture is taken from.
//!
//! A camera that looks from a direction stands so near that all points that it is to hold just lie in the picture. Let
//! `x`, `y`, `z` be a point to the right, up and forwards, `tx` and `ty` half the width and height of the picture at
//! distance 1. The camera at `(ex, ey, ez)` sees the point where `|x - ex| <= tx (z - ez)` and `|y - ey| <= ty (z -
//! ez)`. With `R = max(x - tx z)` and `L = max(-x - tx z)` over the points, `ez <= -(R + L) / (2 tx)`, and `ex = (R -
//! L) / 2` puts the camera where both sides are as near; the same up and down. The smaller `ez` is taken. Pages do the
//! same (`viewer/src/camera.js`), with the numbers that they are given from here.

use crate::error::ViewError;
use crate::extent::{Extent, box_corners};
use polhode::spatial::DVec3;

pub use polhode::scene::Standpoint;

/// Vertical field of view of a camera that is put somewhere by itself, rad.
pub(crate) const FIELD_OF_VIEW_RAD: f64 = 0.6;
/// From where it looks: from the front, a little from the right and above.
pub(crate) const FROM: DVec3 = DVec3::new(0.55, -1.0, 0.42);
/// Room around what is shown, as a factor.
pub(crate) const MARGIN: f64 = 1.2;
/// Radius of what is shown at the least, m.
const LEAST_RADIUS_M: f64 = 1e-6;
/// What lies nearer than this part of the distance to what is looked at is cut off.
const NEAR: f64 = 0.02;

/// Views by name, with the direction from what is looked at to the camera.
pub const PRESETS: [(&str, DVec3); 4] = Standpoint::NAMED;

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
    /// How far away what is looked at is, m.
    pub distance_m: f64,
}

/// How a picture is looked at: from where, and at what. What is absent follows from the scene.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Viewpoint {
    /// Where the camera stands; without it where the scene says, or whence it is best seen.
    pub standpoint: Option<Standpoint>,
    /// The place in the middle of the picture, m; without it that of the scene, or the middle of what is there.
    pub target: Option<DVec3>,
}

impl Viewpoint {
    /// The camera that holds what is there in a picture of this width over height; without a standpoint it looks from
    /// the front, a little from the right and above.
    ///
    /// # Errors
    /// When the camera stands at the place that it looks at, or a coordinate is not finite.
    pub fn camera(&self, extent: &Extent, width_over_height: f64) -> Result<Camera, ViewError> {
        let center = extent.bounds().map_or(DVec3::ZERO, |[low, high]| 0.5 * (low + high));
        let target = self.target.unwrap_or(center);
        let nowhere = |eye| ViewError::CameraPlace { eye, target };
        match self.standpoint.unwrap_or(Standpoint::Direction(FROM)) {
            Standpoint::Direction(from) => {
                let camera = Camera::holding(extent, from, self.target, width_over_height);
                if camera.eye.is_finite() { Ok(camera) } else { Err(nowhere(camera.eye)) }
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

    fn facing(eye: DVec3, forwards: DVec3, distance_m: f64) -> Self {
        let right = forwards.cross(DVec3::Z).try_normalize().unwrap_or(DVec3::X);
        let axes = [right, right.cross(forwards), forwards];
        Self { eye, axes, field_of_view_rad: FIELD_OF_VIEW_RAD, near_m: NEAR * distance_m, distance_m }
    }

    /// That looks from a direction and holds all points in a picture of this width over height: as near as that is
    /// possible, or, where a place is to be in the middle, as near as that is possible along the line through it.
    pub fn holding(extent: &Extent, from: DVec3, middle: Option<DVec3>, width_over_height: f64) -> Self {
        let forwards = -from.try_normalize().unwrap_or(-DVec3::Y);
        let [right, up, _] = Self::facing(DVec3::ZERO, forwards, 1.0).axes;
        let center = extent.bounds().map_or(DVec3::ZERO, |[low, high]| 0.5 * (low + high));
        let origin = middle.unwrap_or(center);
        let slope = libm::tan(0.5 * FIELD_OF_VIEW_RAD) / MARGIN;
        let slopes = [slope * width_over_height, slope];
        // By side: right, left; up, down.
        let mut sides = [[f64::NEG_INFINITY; 2]; 2];
        for point in extent.points() {
            let arm = point - origin;
            let z = arm.dot(forwards);
            for ([ahead, behind], (axis, slope)) in sides.iter_mut().zip([right, up].into_iter().zip(slopes)) {
                let at = arm.dot(axis);
                *ahead = ahead.max(at - slope * z);
                *behind = behind.max(-at - slope * z);
            }
        }
        let mut eye = [0.0; 3];
        let mut depth = f64::INFINITY;
        for (place, ([ahead, behind], slope)) in eye.iter_mut().zip(sides.into_iter().zip(slopes)) {
            if middle.is_some() {
                depth = depth.min(-ahead.max(behind) / slope);
            } else {
                *place = 0.5 * (ahead - behind);
                depth = depth.min(-0.5 * (ahead + behind) / slope);
            }
        }
        let least = 1.5 * MARGIN * LEAST_RADIUS_M.max(f64::EPSILON * origin.length());
        let distance = if depth.is_finite() { (-depth).max(least) } else { 1.0 };
        let across = if depth.is_finite() { right * eye[0] + up * eye[1] } else { DVec3::ZERO };
        Self::facing(origin + across - forwards * distance, forwards, distance)
    }

    /// That looks from a direction at a box (two corners, m) and sees all of it in a picture of this width over height.
    pub fn at_box(bounds: [DVec3; 2], from: DVec3, width_over_height: f64) -> Self {
        Self::holding(&Extent::of(box_corners(bounds)), from, None, width_over_height)
    }

    /// That sees a whole box from the front, a little from the right and above.
    pub fn for_box(bounds: [DVec3; 2], width_over_height: f64) -> Self {
        Self::at_box(bounds, FROM, width_over_height)
    }

    /// Pixels that a metre across has at a distance of one metre, in a picture of this height in pixels.
    pub fn focal_length_px(&self, height_px: f64) -> f64 {
        0.5 * height_px / libm::tan(0.5 * self.field_of_view_rad)
    }

    /// Pixels that a metre across has where the camera looks at.
    pub(crate) fn pixels_of_metre(&self, height_px: f64) -> f64 {
        self.focal_length_px(height_px) / self.distance_m
    }

    /// Where a place is on a picture of this width and height, across and down; nothing where it is behind the camera.
    pub(crate) fn spot(&self, place: DVec3, [width, height]: [f64; 2]) -> Option<[f64; 2]> {
        let seen = self.seen(place);
        let focal = self.focal_length_px(height);
        let is_ahead = seen.z > self.near_m;
        is_ahead.then(|| [0.5 * width + focal * seen.x / seen.z, 0.5 * height - focal * seen.y / seen.z])
    }

    /// A point as it is seen: to the right, up, and how far ahead, m.
    pub fn seen(&self, point: DVec3) -> DVec3 {
        let arm = point - self.eye;
        DVec3::from_array(self.axes.map(|axis| axis.dot(arm)))
    }
}
