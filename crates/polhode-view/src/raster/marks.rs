//! Marks: bodies too small to be seen are drawn as discs of a least size, with the path that they have come; ropes and
//! rods are drawn as lines.
//!
//! A satellite on its orbit is a millionth of the picture, a point of a point set has no size at all. A body of
//! diameter `s` at distance `z` has a radius of `f s / (2 z)` pixels, `f` being the focal length in pixels; where that
//! is less than `LEAST_RADIUS` of the picture's height, a disc of that radius stands for it. Of very many bodies none
//! is marked: they are seen as a crowd, and discs would swell it.

use crate::camera::Camera;
use crate::recording::{MOST_PATHS, Recording};
use crate::shown_scene::{JointEnd, ShownBody};
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
/// A number of a colour that no body has: what it marks is grey.
const GREY: u16 = u16::MAX - 1;

/// A mark.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Disc {
    /// Its middle, m.
    pub place: DVec3,
    /// Radius, pixels.
    pub radius_px: f64,
    /// Number of its colour.
    pub color: u16,
}

/// Where a marked body has been, or a rope or a rod.
#[derive(Debug, Clone, PartialEq)]
pub struct Path {
    /// Places of its middle in order of time, or its ends, m.
    pub places: Vec<DVec3>,
    /// Number of its colour.
    pub color: u16,
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
        let mut marks = Self { discs: Vec::new(), paths: links(recording, frame) };
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
            let color = (number % usize::from(GREY)) as u16;
            let is_marked = scale.mark(&mut marks.discs, body.middle(pose), 0.5 * body.size_m(), 1.0, color);
            if is_marked {
                has_lost_body = true;
                marks.paths.push(Path { places: path(recording, body, place, frame), color });
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

/// The ropes and rods of a frame, each from end to end.
fn links(recording: &Recording, frame: usize) -> Vec<Path> {
    let links: Vec<_> =
        recording.shown().joints.iter().chain(&recording.shown().tracks).filter(|joint| joint.is_link).collect();
    if links.is_empty() {
        return Vec::new();
    }
    let poses = recording.poses(frame);
    let place = |end: &JointEnd| {
        let pose = end.body.and_then(|body| poses.get(body));
        pose.map_or(end.point, |pose| pose.transform_point(end.point))
    };
    links.iter().map(|joint| Path { places: joint.ends.iter().map(place).collect(), color: GREY }).collect()
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
    fn mark(&self, discs: &mut Vec<Disc>, place: DVec3, radius_m: f64, share: f64, color: u16) -> bool {
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
fn path(recording: &Recording, body: &ShownBody, place: usize, frame: usize) -> Vec<DVec3> {
    let stride = frame / MOST_PLACES + 1;
    let frames = (0..frame).step_by(stride).chain(std::iter::once(frame));
    frames.filter_map(|frame| recording.moving_poses(frame).get(place)).map(|pose: &Pose| body.middle(pose)).collect()
}
