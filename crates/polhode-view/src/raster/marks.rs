//! Marks: bodies too small to be seen are drawn as discs of a least size, with the path that they have come.
//!
//! A satellite on its orbit is a millionth of the picture, a point of a point set has no size at all. A body of
//! diameter `s` at distance `z` has a radius of `f s / (2 z)` pixels, `f` being the focal length in pixels; where that
//! is less than `LEAST_RADIUS` of the picture's height, a disc of that radius stands for it. Of very many bodies none
//! is marked: they are seen as a crowd, and discs would swell it.

use crate::camera::Camera;
use crate::recording::{MOST_PATHS, Recording};
use crate::shown_body::ShownBody;
use polhode::spatial::{DVec3, Pose};

/// Radius of a mark, as a fraction of the picture's height: at 720 pixels 5.
const LEAST_RADIUS: f64 = 0.007;
/// Radius of a mark at the least, pixels.
const LEAST_RADIUS_PX: f64 = 2.5;
/// Radius of the mark of a point of a body, as a fraction of that of a body.
const POINT: f64 = 0.6;
/// Radius of the mark of a centre of attraction, as a fraction of that of a body.
const CENTER: f64 = 1.8;
/// Places of a path at the most.
const MOST_PLACES: usize = 1000;
/// What marks a centre of attraction, sRGB.
const GREY: [u8; 3] = [188, 188, 188];
/// How dark a path is, as a fraction of the colour of its body.
const PATH: f64 = 0.45;

/// A mark.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Disc {
    /// Its middle, m.
    pub place: DVec3,
    /// Radius, pixels.
    pub radius_px: f64,
    /// Its colour, sRGB.
    pub color: [u8; 3],
}

/// Where a marked body has been.
#[derive(Debug, Clone, PartialEq)]
pub struct Path {
    /// Places of its middle in order of time, m.
    pub places: Vec<DVec3>,
    /// Its colour, sRGB.
    pub color: [u8; 3],
}

/// The marks of a picture.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Marks {
    /// Discs.
    pub discs: Vec<Disc>,
    /// Paths.
    pub paths: Vec<Path>,
}

impl Marks {
    /// Those of a frame that a camera sees in a picture of this height, pixels.
    pub fn of_frame(recording: &Recording, frame: usize, camera: &Camera, height_px: u32) -> Self {
        let shown = recording.shown();
        let mut marks = Self::default();
        if shown.moving.len() > MOST_PATHS {
            return marks;
        }
        let height = f64::from(height_px);
        let scale = Scale {
            camera,
            focal_px: camera.focal_length_px(height),
            least_px: (LEAST_RADIUS * height).max(LEAST_RADIUS_PX),
        };
        let mut has_lost_body = false;
        for (place, (&number, pose)) in shown.moving.iter().zip(recording.moving_poses(frame)).enumerate() {
            let body = &shown.bodies[number];
            if body.look.opacity <= 0.0 {
                continue;
            }
            let color = shown.color(number);
            let is_marked = scale.mark(&mut marks.discs, body.middle(pose), 0.5 * body.size_m(), 1.0, color);
            if is_marked {
                has_lost_body = true;
                let dark = color.map(|channel| (PATH * f64::from(channel)) as u8);
                marks.paths.push(Path { places: path(recording, body, place, frame), color: dark });
            } else {
                for point in &body.shape.points {
                    let at = pose.transform_point(point.place);
                    scale.mark(&mut marks.discs, at, point.radius_m, POINT, color);
                }
            }
        }
        if has_lost_body {
            for &center in &shown.centers {
                scale.mark(&mut marks.discs, center, 0.0, CENTER, GREY);
            }
        }
        marks
    }
}

/// How large things are in a picture.
struct Scale<'a> {
    camera: &'a Camera,
    focal_px: f64,
    /// Radius of a mark, pixels.
    least_px: f64,
}

impl Scale<'_> {
    /// Marks what lies ahead and is smaller than its mark, which is `share` of the largest; whether it has.
    fn mark(&self, discs: &mut Vec<Disc>, place: DVec3, radius_m: f64, share: f64, color: [u8; 3]) -> bool {
        let ahead_m = self.camera.seen(place).z;
        let radius_px = share * self.least_px;
        let is_marked = ahead_m > self.camera.near_m && radius_m * self.focal_px < radius_px * ahead_m;
        if is_marked {
            discs.push(Disc { place, radius_px, color });
        }
        is_marked
    }
}

/// Where the middle of a body that moves (by its place among them) has been up to a frame.
pub(crate) fn path(recording: &Recording, body: &ShownBody, place: usize, frame: usize) -> Vec<DVec3> {
    let stride = frame / MOST_PLACES + 1;
    let frames = (0..frame).step_by(stride).chain(std::iter::once(frame));
    frames.filter_map(|frame| recording.moving_poses(frame).get(place)).map(|pose: &Pose| body.middle(pose)).collect()
}
