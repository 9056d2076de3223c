//! Poses over time, kept in memory: what pictures and models are made from.

use crate::error::ViewError;
use crate::extent::Extent;
use crate::framing::{Framing, add_moving, frames_looked_at, is_lost};
use crate::mesh_library::MeshLibrary;
use crate::overlay::Touch;
use crate::shown_scene::ShownScene;
use crate::thinning::Thinning;
use crate::turning::Turning;
use polhode::scene::Appearance;
use polhode::spatial::{DVec3, Pose};
use polhode::{BodySample, Flow, Frame, Observer, Scene};

/// Bodies of which a picture shows the paths at the most: of more it shows a crowd.
pub const MOST_PATHS: usize = 64;
/// Frames of the path that leads to a still.
const PATH_FRAMES: f64 = 1000.0;

/// What is kept of forces.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Keeps {
    Nothing,
    Forces,
}

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
    /// Velocities of centres of mass in the world (m/s), as the poses.
    speeds: Vec<Vec<DVec3>>,
    /// Forces of contacts and joints by time, if they are kept, s.
    touches: Vec<(f64, Vec<Touch>)>,
    keeps: Keeps,
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
            speeds: Vec::new(),
            touches: Vec::new(),
            keeps: Keeps::Nothing,
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

    /// Shown as the file of the scene wants it.
    #[must_use]
    pub fn shown_as(mut self, appearance: &Appearance) -> Self {
        self.shown.show_as(appearance);
        self
    }

    /// With the forces of contacts and joints, for overlays.
    #[must_use]
    pub fn with_forces(self) -> Self {
        Self { keeps: Keeps::Forces, ..self }
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
            self.speeds.pop();
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
        let speed = |&body: &usize| Some(bodies[body].velocity.linear).filter(|v| v.is_finite()).unwrap_or_default();
        self.speeds.push(self.shown.moving.iter().map(speed).collect());
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

    /// Velocities of the centres of mass (m/s) and angular velocities (rad/s) of the bodies that move in a frame.
    pub(crate) fn velocities(&self, frame: usize) -> impl Iterator<Item = [DVec3; 2]> + '_ {
        let (speeds, spins) = (self.speeds.get(frame), self.spins.get(frame));
        speeds.into_iter().flatten().zip(spins.into_iter().flatten()).map(|(&speed, &spin)| [speed, spin])
    }

    /// The forces of contacts and joints that are kept for a frame: those of the last time that is not after it.
    pub(crate) fn touches(&self, frame: usize) -> &[Touch] {
        let t = self.times.get(frame).copied().unwrap_or(f64::NAN);
        let after = self.touches.partition_point(|(time, _)| *time <= t);
        after.checked_sub(1).and_then(|last| self.touches.get(last)).map_or(&[], |(_, touches)| touches)
    }

    /// What a camera holds in all frames.
    pub fn framing(&self) -> Framing {
        self.framing_of(0..self.poses.len()).with_start(&self.shown, &self.initial)
    }

    /// What a camera holds in one frame: the bodies as they stand then; where they are too small to be seen beside the
    /// path that they have come, that path and what attracts them.
    pub fn framing_at(&self, frame: usize) -> Framing {
        let along = self.framing_of(0..frame + 1);
        if self.shown.frame.is_some() || is_lost(&self.shown, &along.moving) {
            return along;
        }
        self.framing_of(frame..frame + 1)
    }

    /// What a camera holds in a range of frames.
    fn framing_of(&self, frames: std::ops::Range<usize>) -> Framing {
        let frames = frames.start..frames.end.min(self.poses.len());
        let stride = (frames.len() / frames_looked_at(self.shown.moving.len())).max(1);
        let last = frames.end.checked_sub(1);
        let mut moving = Extent::new();
        for frame in frames.step_by(stride).chain(last) {
            add_moving(&mut moving, &self.shown, self.poses[frame].iter());
        }
        Framing::new(&self.shown, moving, &self.initial)
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

    fn wants_frames(&self) -> bool {
        self.keeps == Keeps::Forces
    }

    fn frame(&mut self, frame: &Frame) {
        self.touches.push((frame.t_s, Touch::of_frame(frame, &self.shown)));
    }

    fn progress(&mut self, _t: f64) -> Flow {
        if self.fault.is_some() { Flow::Stop } else { Flow::Continue }
    }
}
