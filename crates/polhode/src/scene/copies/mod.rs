//! Scenes set otherwise: turned, shifted, mirrored, with all that they name in the opposite order.
//!
//! What moves in such a scene is what moves in the first one, seen from elsewhere; what computes it has other axes,
//! other coordinates and another order to work in. The difference of both, undone, is an error of the method alone: no
//! rounding, tie or order of elimination is the same.
//!
//! | module | holds |
//! |---|---|
//! | `body` | bodies set otherwise |
//! | `force` | forces set otherwise |
//! | `error` | [`CopyError`]: why a scene cannot be set otherwise |
//!
//! Joints are set otherwise where their kinds are known (`scene/joint_copy.rs`).

mod body;
mod error;
mod force;

pub use error::CopyError;

use super::{Gear, GearEnd, Joint, Scene, SceneBuilder};
use crate::identity::body_id::BodyId;
use crate::identity::joint_id::JointId;
use crate::report::body_sample::BodySample;
use polhode_spatial::{Handedness, Isometry};
use std::sync::Arc;

/// In which order bodies, joints, gears and forces stand.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum ListOrder {
    /// As in the scene.
    #[default]
    Kept,
    /// The last one first.
    Reversed,
}

impl ListOrder {
    /// The place of what stands at a place of a list of this length.
    const fn place(self, place: usize, length: usize) -> usize {
        match self {
            Self::Kept => place,
            // A place beyond the list stays one.
            Self::Reversed => {
                if place < length {
                    length - 1 - place
                } else {
                    place
                }
            }
        }
    }

    fn of<T>(self, mut list: Vec<T>) -> Vec<T> {
        if self == Self::Reversed {
            list.reverse();
        }
        list
    }
}

/// How a scene is set otherwise. By default it stays as it is.
///
/// ```
/// use polhode::mesh::solid_box;
/// use polhode::scene::{ListOrder, SceneCopy};
/// use polhode::spatial::{DVec3, Handedness, Isometry, Mass, Pose, Rotation, Velocity};
/// use polhode::{Body, Scene, Simulation};
/// let brick = Body::movable("brick", solid_box(DVec3::new(0.1, 0.2, 0.3), Mass::new(1.0)?)?)
///     .velocity(Velocity::new(DVec3::X, DVec3::new(1.0, 2.0, 3.0)));
/// let scene = Scene::builder("thrown").body(brick).build()?;
/// let space = Isometry::new(Rotation::from_rotation_vector(DVec3::X), DVec3::Y, Handedness::Mirrored);
/// let copy = SceneCopy::new(space, ListOrder::Reversed);
/// let [mut own, mut other] = [Simulation::new(&scene)?, Simulation::new(&copy.of(&scene)?)?];
/// own.advance_to(0.5)?;
/// other.advance_to(0.5)?;
/// let difference = copy.undone(&other.bodies())[0].pose.translation - own.bodies()[0].pose.translation;
/// assert!(difference.length() < 1e-14);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct SceneCopy {
    space: Isometry,
    order: ListOrder,
}

impl SceneCopy {
    /// In a space set otherwise, with its lists in this order.
    pub const fn new(space: Isometry, order: ListOrder) -> Self {
        Self { space, order }
    }

    /// How its space is set.
    pub const fn space(&self) -> &Isometry {
        &self.space
    }

    /// In which order its bodies, joints, gears and forces stand.
    pub const fn order(&self) -> ListOrder {
        self.order
    }

    /// The parts of the scene set otherwise, unchecked. `tier/scene_copies.rs` builds the scene of them.
    ///
    /// # Errors
    /// When a part cannot be set otherwise.
    pub(crate) fn parts_of(&self, scene: &Scene) -> Result<SceneBuilder, CopyError> {
        let Scene {
            name,
            duration_s,
            output_interval_s,
            gravity,
            method,
            bodies,
            forces,
            joints,
            tracks,
            gears,
            coordinate_motions,
            pair_rules,
            no_contact,
            start_separation_m,
        } = scene.clone();
        let space = &self.space;
        let number = |body: BodyId| BodyId::new(self.order.place(body.index(), bodies.len()));
        let pair_rules = match space.handedness() {
            Handedness::Kept => pair_rules,
            Handedness::Mirrored => pair_rules.into_iter().map(super::PairRule::mirrored).collect(),
        };
        let forces = forces.iter().enumerate().map(|(place, force)| force::moved(place, force, space, number));
        let tracks = tracks.iter().enumerate().map(|(number, track)| {
            let moved = track.moved(space).map_err(|source| CopyError::Track { number, source })?;
            Ok::<_, CopyError>(Arc::new(moved))
        });
        let end = |end: GearEnd| GearEnd { joint: self.joint(end.joint, &joints), ..end };
        let motions = coordinate_motions.into_iter().map(|(own, motion)| {
            let is_reversed = self.factor(own, &joints) < 0.0;
            (end(own), if is_reversed { motion.reversed() } else { motion })
        });
        let copy = Scene {
            name,
            duration_s,
            output_interval_s,
            gravity: space.vector(gravity),
            method,
            forces: self.order.of(forces.collect::<Result<_, _>>()?),
            tracks: tracks.collect::<Result<_, _>>()?,
            gears: self.order.of(gears.iter().map(|gear| self.gear(gear, &joints)).collect()),
            coordinate_motions: self.order.of(motions.collect()),
            pair_rules,
            no_contact: no_contact
                .iter()
                .map(|group| group.iter().map(|&body| self.order.place(body, bodies.len())).collect())
                .collect(),
            start_separation_m,
            joints: self.order.of(joints.iter().map(|joint| joint.moved(space, number)).collect()),
            bodies: self.order.of(bodies.iter().map(|body| body::moved(body, space)).collect::<Result<_, _>>()?),
        };
        Ok(SceneBuilder::of(copy))
    }

    /// Bodies of the scene as they would be in the scene set otherwise, in its order.
    pub fn samples(&self, samples: &[BodySample]) -> Vec<BodySample> {
        let moved = |sample: &BodySample| BodySample {
            pose: self.space.pose(&sample.pose),
            velocity: self.space.velocity(&sample.velocity),
        };
        self.order.of(samples.iter().map(moved).collect())
    }

    /// Bodies of the scene set otherwise as they would be in the scene itself, in its order.
    pub fn undone(&self, samples: &[BodySample]) -> Vec<BodySample> {
        let before = |sample: &BodySample| BodySample {
            pose: self.space.pose_before(&sample.pose),
            velocity: self.space.velocity_before(&sample.velocity),
        };
        self.order.of(samples.iter().map(before).collect())
    }

    fn joint(&self, joint: JointId, joints: &[Joint]) -> JointId {
        JointId::new(self.order.place(joint.index(), joints.len()))
    }

    /// 1, or -1 where the coordinate changes its sign.
    fn factor(&self, end: GearEnd, joints: &[Joint]) -> f64 {
        let kind = joints.get(end.joint.index()).map(Joint::kind);
        let own = end.coordinate.or_else(|| kind?.coordinates().first().copied());
        kind.zip(own).map_or(1.0, |(kind, own)| kind.sign(own, self.space.handedness()).factor())
    }

    fn gear(&self, gear: &Gear, joints: &[Joint]) -> Gear {
        let ends = gear.ends();
        let factor = self.factor(ends[0], joints) * self.factor(ends[1], joints);
        gear.between_ends(ends.map(|end| GearEnd { joint: self.joint(end.joint, joints), ..end }), factor)
    }
}
