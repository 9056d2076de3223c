//! Poses over time, kept in memory: what pictures and models are made from.

use crate::error::ViewError;
use crate::mesh_library::MeshLibrary;
use crate::shown_scene::{ShownBody, ShownScene};
use crate::thinning::Thinning;
use crate::turning::Turning;
use polhode::spatial::{DVec3, Pose};
use polhode::{BodySample, Flow, Observer, Scene};

/// Size of a standing body up to which it is in the picture whole, in sizes of what moves.
const LARGEST_BESIDE: f64 = 1.5;
/// Distance up to which a standing body is in the picture whole, in sizes of what moves.
const FARTHEST_BESIDE: f64 = 1.0;

/// Bodies of which a picture shows the paths at the most: of more it shows a crowd.
pub const MOST_PATHS: usize = 64;
/// Frames of the path that leads to a still.
const PATH_FRAMES: f64 = 1000.0;
/// A body whose path is longer than this many times its size is lost in a picture of the path.
const LOST: f64 = 60.0;

/// The motion of a scene: an [`Observer`] that keeps the poses of the bodies that move.
#[derive(Debug)]
pub struct Recording {
    shown: ShownScene,
    meshes: MeshLibrary,
    thinning: Thinning,
    times: Vec<f64>,
    /// Frame by frame, in the order of the bodies that move.
    poses: Vec<Vec<Pose>>,
    /// Angular velocities in the world (rad/s), as the poses.
    spins: Vec<Vec<DVec3>>,
    /// Poses of all bodies in the first frame.
    initial: Vec<Pose>,
    put_off: Option<(f64, Vec<BodySample>)>,
    fault: Option<ViewError>,
}

impl Recording {
    /// Of a scene, with frames at least this far apart, s.
    ///
    /// # Errors
    /// When the scene has no bodies.
    pub fn new(scene: &Scene, least_interval_s: f64) -> Result<Self, ViewError> {
        if scene.bodies().is_empty() {
            return Err(ViewError::NoBodies(scene.name().to_owned()));
        }
        let mut meshes = MeshLibrary::default();
        Ok(Self {
            shown: ShownScene::new(scene, &mut meshes),
            meshes,
            thinning: Thinning::new(least_interval_s),
            times: Vec::new(),
            poses: Vec::new(),
            spins: Vec::new(),
            initial: Vec::new(),
            put_off: None,
            fault: None,
        })
    }

    /// Of a scene at one time.
    ///
    /// # Errors
    /// When the scene has no bodies, or the sample is not one of it.
    pub fn of_instant(scene: &Scene, t_s: f64, bodies: &[BodySample]) -> Result<Self, ViewError> {
        let mut recording = Self::new(scene, 0.0)?;
        recording.add(t_s, bodies)?;
        Ok(recording)
    }

    /// Of a scene for a still: of few bodies with the path that leads there.
    ///
    /// # Errors
    /// When the scene has no bodies.
    pub fn for_still(scene: &Scene) -> Result<Self, ViewError> {
        let recording = Self::new(scene, scene.duration_s() / PATH_FRAMES)?;
        let is_marked = recording.shown.moving.len() <= MOST_PATHS;
        Ok(if is_marked { recording } else { Self { thinning: Thinning::new(f64::INFINITY), ..recording } })
    }

    /// Ends it with the bodies at a time, s.
    ///
    /// # Errors
    /// When a sample was not one of the scene.
    pub fn end_at(&mut self, t_s: f64, bodies: &[BodySample]) -> Result<(), ViewError> {
        self.put_off = None;
        while self.times.last().is_some_and(|&last| last >= t_s) {
            self.times.pop();
            self.poses.pop();
            self.spins.pop();
        }
        self.add(t_s, bodies)?;
        self.end()
    }

    /// Ends it: the last sample is always a frame.
    ///
    /// # Errors
    /// When a sample was not one of the scene, or there was none.
    pub fn end(&mut self) -> Result<(), ViewError> {
        if let Some((t, bodies)) = self.put_off.take() {
            self.add(t, &bodies)?;
        }
        match self.fault.take() {
            Some(fault) => Err(fault),
            None if self.times.is_empty() => Err(ViewError::NoFrames),
            None => Ok(()),
        }
    }

    fn add(&mut self, t: f64, bodies: &[BodySample]) -> Result<(), ViewError> {
        let needed = self.shown.bodies.len();
        if bodies.len() < needed {
            return Err(ViewError::BodyCount { found: bodies.len(), needed });
        }
        if let Some(body) = bodies[..needed].iter().position(|sample| !sample.pose.is_finite()) {
            return Err(ViewError::NotFinite { t_s: t, body: self.shown.bodies[body].name.clone() });
        }
        if self.times.is_empty() {
            self.initial = bodies[..needed].iter().map(|sample| sample.pose).collect();
        }
        self.times.push(t);
        self.poses.push(self.shown.moving.iter().map(|&body| bodies[body].pose).collect());
        // What is no number turns nothing.
        let spin = |&body: &usize| Some(bodies[body].velocity.angular).filter(|w| w.is_finite()).unwrap_or_default();
        self.spins.push(self.shown.moving.iter().map(spin).collect());
        Ok(())
    }

    /// Orientation and angular velocity of a body that moves in a frame, by its place in [`ShownScene::moving`].
    pub(crate) fn turning(&self, frame: usize, place: usize) -> Turning {
        let pose = self.moving_poses(frame).get(place).copied().unwrap_or(Pose::IDENTITY);
        let spin = self.spins.get(frame).and_then(|spins| spins.get(place)).copied().unwrap_or_default();
        Turning { rotation: pose.rotation, angular_velocity: spin }
    }

    /// The body that turns the farthest from one frame to the next, with the angle, rad; none where nothing turns.
    pub fn largest_turn(&self) -> Option<(&str, f64)> {
        let mut largest: Option<(usize, f64)> = None;
        for (frame, times) in self.times.windows(2).enumerate() {
            for (place, &body) in self.shown.moving.iter().enumerate() {
                let angle = self.turning(frame, place).angle_to(&self.turning(frame + 1, place), times[1] - times[0]);
                if angle > largest.map_or(0.0, |(_, angle)| angle) {
                    largest = Some((body, angle));
                }
            }
        }
        largest.map(|(body, angle)| (self.shown.bodies[body].name.as_str(), angle))
    }

    /// What is shown.
    pub fn shown(&self) -> &ShownScene {
        &self.shown
    }

    /// The meshes of its bodies.
    pub fn meshes(&self) -> &MeshLibrary {
        &self.meshes
    }

    /// Times of the frames, s.
    pub fn times(&self) -> &[f64] {
        &self.times
    }

    /// Poses of the bodies that move in a frame, in the order of [`ShownScene::moving`].
    pub fn moving_poses(&self, frame: usize) -> &[Pose] {
        self.poses.get(frame).map_or(&[], Vec::as_slice)
    }

    /// Poses of all bodies in a frame.
    pub fn poses(&self, frame: usize) -> Vec<Pose> {
        let mut all = self.initial.clone();
        for (&body, pose) in self.shown.moving.iter().zip(self.moving_poses(frame)) {
            if let Some(place) = all.get_mut(body) {
                *place = *pose;
            }
        }
        all
    }

    /// The number of the frame nearest to a time, s.
    pub fn nearest_frame(&self, t_s: f64) -> usize {
        let after = self.times.partition_point(|&t| t < t_s);
        let nearer =
            |i: usize, j: usize| if (self.times[i] - t_s).abs() <= (self.times[j] - t_s).abs() { i } else { j };
        match (after.checked_sub(1), self.times.len()) {
            (_, 0) => 0,
            (None, _) => after,
            (Some(before), count) if after == count => before,
            (Some(before), _) => nearer(before, after),
        }
    }

    /// Corners of the box that a camera looks at in all frames, m: around the bodies that move, and around those
    /// standing bodies that are near them and of their size. Where none moves, around all.
    pub fn bounds(&self) -> [DVec3; 2] {
        self.bounds_of(&self.poses)
    }

    /// Corners of the box that a camera looks at in one frame, m: that around the bodies as they stand then; where they
    /// are too small to be seen beside the path that they have come, around that path and what attracts them.
    pub fn bounds_at(&self, frame: usize) -> [DVec3; 2] {
        let path = &self.poses[..self.poses.len().min(frame + 1)];
        let mut along = self.bounds_of(path);
        let largest = self.shown.moving.iter().map(|&body| self.shown.bodies[body].size_m()).fold(0.0, f64::max);
        if (along[1] - along[0]).length() <= LOST * largest || largest == 0.0 {
            return self.bounds_of(path.get(frame..).unwrap_or_default());
        }
        for &center in &self.shown.centers {
            along = [along[0].min(center), along[1].max(center)];
        }
        along
    }

    fn bounds_of(&self, frames: &[Vec<Pose>]) -> [DVec3; 2] {
        let mut moving: Option<[DVec3; 2]> = None;
        for poses in frames {
            for (&body, pose) in self.shown.moving.iter().zip(poses) {
                add_box(&mut moving, &self.shown.bodies[body], pose);
            }
        }
        let mut all = moving;
        for (body, pose) in self.shown.bodies.iter().zip(&self.initial).filter(|(body, _)| !body.moves) {
            let mut own = None;
            add_box(&mut own, body, pose);
            if let Some(own) = own
                && moving.is_none_or(|moving| is_beside(own, moving))
            {
                add_box(&mut all, body, pose);
            }
        }
        all.unwrap_or([DVec3::splat(-1.0), DVec3::ONE])
    }
}

/// Whether a box is near another one and not much larger.
fn is_beside(own: [DVec3; 2], other: [DVec3; 2]) -> bool {
    let (size, room) = ((own[1] - own[0]).length(), (other[1] - other[0]).length());
    let apart = 0.5 * ((own[0] + own[1]) - (other[0] + other[1])).length();
    size <= LARGEST_BESIDE * room && apart <= FARTHEST_BESIDE * room
}

/// Widens a box to the corners of the box of a body.
fn add_box(bounds: &mut Option<[DVec3; 2]>, body: &ShownBody, pose: &Pose) {
    let Some(corners) = body.bounds else { return };
    for corner in 0..8 {
        let pick = |axis: usize| corners[corner >> axis & 1][axis];
        let place = pose.transform_point(DVec3::new(pick(0), pick(1), pick(2)));
        let [low, high] = bounds.unwrap_or([place; 2]);
        *bounds = Some([low.min(place), high.max(place)]);
    }
}

impl Observer for Recording {
    fn sample(&mut self, t: f64, bodies: &[BodySample]) {
        if self.fault.is_some() {
            return;
        }
        if self.thinning.shows(t) {
            self.put_off = None;
            self.fault = self.add(t, bodies).err();
        } else {
            self.put_off = Some((t, bodies.to_vec()));
        }
    }

    fn progress(&mut self, _t: f64) -> Flow {
        if self.fault.is_some() { Flow::Stop } else { Flow::Continue }
    }
}
