//! What a picture holds: the corners of the bodies that move, those of standing bodies that are not much larger, and
//! the places of joints, springs and tracks.

use crate::camera::{Camera, Viewpoint};
use crate::error::ViewError;
use crate::extent::{Extent, box_corners};
use crate::shown_scene::ShownScene;
use polhode::scene::Standpoint;
use polhode::spatial::{DVec3, Pose};

/// Size of a standing body up to which it is held whole, in sizes of what else is held. A floor of boards is not, a bin
/// and a peg are.
const LARGEST_STANDING: f64 = 4.0;

/// A body whose path is longer than this many times its size is lost in a picture of the path.
const LOST: f64 = 60.0;
/// Bodies times frames that are looked at to find how far a motion reaches, and the most and fewest frames.
const CELLS_LOOKED_AT: usize = 50_000;
const FRAMES_LOOKED_AT: [usize; 2] = [4, 200];

/// Frames that are looked at to find how far the motion of so many bodies reaches.
pub(crate) fn frames_looked_at(bodies: usize) -> usize {
    (CELLS_LOOKED_AT / bodies.max(1)).clamp(FRAMES_LOOKED_AT[0], FRAMES_LOOKED_AT[1])
}

/// What a picture holds, and from where it is looked at.
#[derive(Debug, Clone)]
pub struct Framing {
    /// What is held of bodies that move.
    pub moving: Extent,
    /// What is held of all else.
    pub standing: Extent,
    /// From where it is looked at.
    pub viewpoint: Viewpoint,
}

impl Framing {
    /// Of a scene with bodies that move as far as this, and stand at these poses.
    pub(crate) fn new(shown: &ShownScene, moving: Extent, poses: &[Pose]) -> Self {
        let viewpoint = Viewpoint {
            standpoint: shown.viewpoint.standpoint.or(Some(Standpoint::Direction(shown.usual_from))),
            ..shown.viewpoint
        };
        if let Some(frame) = shown.frame {
            return Self { moving: Extent::new(), standing: Extent::of(box_corners(frame)), viewpoint };
        }
        let mut standing = standing(shown, &moving, poses);
        if is_lost(shown, &moving) {
            shown.centers.iter().for_each(|&center| standing.add(center));
        }
        Self { moving, standing, viewpoint }
    }

    /// With the bodies that move as they stand at first, whatever the scene wants held: who watches a motion sees its
    /// start.
    pub(crate) fn with_start(mut self, shown: &ShownScene, initial: &[Pose]) -> Self {
        add_moving(&mut self.moving, shown, shown.moving.iter().filter_map(|&body| initial.get(body)));
        self
    }

    /// All that is held.
    pub fn extent(&self) -> Extent {
        let mut all = self.standing.clone();
        all.add_all(&self.moving);
        all
    }

    /// Corners of the box around all that is held, m.
    pub fn bounds(&self) -> [DVec3; 2] {
        self.extent().bounds().unwrap_or([DVec3::splat(-1.0), DVec3::ONE])
    }

    /// The camera for a picture of this width over height. What is asked comes before what the scene says.
    ///
    /// # Errors
    /// When the camera stands at the place that it looks at.
    pub fn camera(&self, asked: &Viewpoint, width_over_height: f64) -> Result<Camera, ViewError> {
        // Who puts the camera somewhere looks at what is there.
        let own = if asked.standpoint.is_some() { None } else { self.viewpoint.target };
        let viewpoint =
            Viewpoint { standpoint: asked.standpoint.or(self.viewpoint.standpoint), target: asked.target.or(own) };
        viewpoint.camera(&self.extent(), width_over_height)
    }
}

/// Whether the bodies that move are too small to be seen where all of their motion is.
pub(crate) fn is_lost(shown: &ShownScene, moving: &Extent) -> bool {
    let largest = shown.moving.iter().map(|&body| shown.bodies[body].size_m()).fold(0.0, f64::max);
    largest > 0.0 && moving.size_m() > LOST * largest
}

/// What is held of all that stands.
fn standing(shown: &ShownScene, moving: &Extent, poses: &[Pose]) -> Extent {
    let mut held = Extent::new();
    let mut all = moving.clone();
    for &place in &shown.fixtures.places {
        held.add(place);
        all.add(place);
    }
    let is_seen = |body: usize| !shown.bodies[body].moves && shown.bodies[body].look.opacity > 0.0;
    let mut bodies: Vec<usize> = (0..shown.bodies.len()).filter(|&body| is_seen(body)).collect();
    bodies.retain(|&body| shown.bodies[body].bounds.is_some());
    bodies.sort_by(|&a, &b| shown.bodies[a].size_m().total_cmp(&shown.bodies[b].size_m()));
    for body in bodies {
        let shape = &shown.bodies[body];
        let size = all.size_m();
        let (Some(corners), Some(pose)) = (shape.bounds, poses.get(body)) else { continue };
        if moving.bounds().is_none() || size == 0.0 || shape.size_m() <= LARGEST_STANDING * size {
            held.add_box(corners, pose);
            all.add_box(corners, pose);
        }
    }
    held
}

/// Adds the corners of bodies that move, in the order of [`ShownScene::moving`].
pub(crate) fn add_moving<'a>(extent: &mut Extent, shown: &ShownScene, poses: impl Iterator<Item = &'a Pose>) {
    for (&body, pose) in shown.moving.iter().zip(poses) {
        let body = &shown.bodies[body];
        if let Some(corners) = body.bounds.filter(|_| body.look.opacity > 0.0) {
            extent.add_box(corners, pose);
        }
    }
}
