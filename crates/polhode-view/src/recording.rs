//! Poses over time, kept in memory: what pictures and models are made from.

use crate::error::ViewError;
use crate::mesh_library::MeshLibrary;
use crate::shown_scene::{ShownBody, ShownScene};
use crate::thinning::Thinning;
use polhode::spatial::{DVec3, Pose};
use polhode::{BodySample, Flow, Observer, Scene};

/// The motion of a scene: an [`Observer`] that keeps the poses of the bodies that move.
#[derive(Debug)]
pub struct Recording {
    shown: ShownScene,
    meshes: MeshLibrary,
    thinning: Thinning,
    times: Vec<f64>,
    /// Frame by frame, in the order of the bodies that move.
    poses: Vec<Vec<Pose>>,
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
        Ok(())
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

    /// Corners of a box around the bodies that move in all frames; of all bodies where none moves.
    pub fn bounds(&self) -> [DVec3; 2] {
        let mut bounds: Option<[DVec3; 2]> = None;
        let mut add = |place: DVec3| {
            let [low, high] = bounds.unwrap_or([place; 2]);
            bounds = Some([low.min(place), high.max(place)]);
        };
        for poses in &self.poses {
            for (&body, pose) in self.shown.moving.iter().zip(poses) {
                add_box(&self.shown.bodies[body], pose, &mut add);
            }
        }
        if self.shown.moving.is_empty() {
            for (body, pose) in self.shown.bodies.iter().zip(&self.initial) {
                add_box(body, pose, &mut add);
            }
        }
        bounds.unwrap_or([DVec3::splat(-1.0), DVec3::ONE])
    }
}

/// Adds the corners of the box of a body.
fn add_box(body: &ShownBody, pose: &Pose, add: &mut impl FnMut(DVec3)) {
    let Some([low, high]) = body.bounds else { return };
    for corner in 0..8 {
        let pick = |axis: usize| if corner >> axis & 1 == 0 { low[axis] } else { high[axis] };
        add(pose.transform_point(DVec3::new(pick(0), pick(1), pick(2))));
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
