//! Joints that hold nothing any more: their bodies have run off the end of a track (`track.rs`).
//!
//! Such a joint keeps its number and its place, but has no rows, no stops, no friction and no forces.

use super::joint::WorldJoint;
use crate::scene::SceneError;
use crate::snapshot::SnapshotError;
use crate::world::World;
use polhode_dynamics::BodyState;
use polhode_spatial::{DVec3, Pose, Velocity};

/// A body that has run off the end of its track.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct RunOff {
    /// Number of the joint.
    pub(crate) joint: usize,
    pub(crate) body: usize,
    /// Where, world, m.
    pub(crate) point: DVec3,
}

impl World {
    /// Whether a joint holds nothing any more.
    pub(crate) fn is_released(&self, joint: &WorldJoint) -> bool {
        !self.released.is_empty() && self.released.contains(&joint.number())
    }

    /// A joint holds nothing from now on.
    ///
    /// # Errors
    /// When the fields cannot be made.
    pub(crate) fn release(&mut self, joint: usize) -> Result<(), SceneError> {
        self.released.insert(joint);
        self.index_joints();
        self.make_fields()
    }

    /// Whether two bodies had contacts at joints that hold nothing any more. Their shapes do not collide for that.
    pub(crate) fn lost_joint_contacts(&self, pair: (usize, usize)) -> bool {
        let is_at = |joint: &WorldJoint| self.is_released(joint) && joint.pair() == pair;
        !self.released.is_empty() && self.joints.iter().any(is_at)
    }

    /// The joints of these bodies on tracks whose ends they have passed in these states, in the order of the scene.
    pub(crate) fn run_off(&self, states: &[BodyState], bodies: &[usize]) -> Vec<RunOff> {
        let motion = |body: usize| -> (Pose, Velocity) { (states[body].pose, self.velocity(body, &states[body])) };
        let bodies = if self.ending_tracks > 0 { bodies } else { &[] };
        let passed = self.joints_among(bodies).filter(|joint| joint.has_passed_end(motion));
        passed.filter_map(|joint| self.place_on_track(states, joint.number())).collect()
    }

    /// Where the body of a joint is that runs off its track in these states.
    pub(crate) fn place_on_track(&self, states: &[BodyState], number: usize) -> Option<RunOff> {
        let motion = |body: usize| -> (Pose, Velocity) { (states[body].pose, self.velocity(body, &states[body])) };
        let joint = self.joint_numbered(number)?;
        Some(RunOff { joint: number, body: joint.bodies().next()?, point: joint.anchor(motion) })
    }

    /// Replaces the joints that hold nothing by these.
    ///
    /// # Errors
    /// When there is no such joint.
    pub(crate) fn replace_released(&mut self, joints: &[usize]) -> Result<(), SnapshotError> {
        let refused = || SnapshotError::Invalid("a joint that has let go does not exist");
        if joints.iter().any(|&joint| self.joint_numbered(joint).is_none()) {
            return Err(refused());
        }
        if joints.is_empty() && self.released.is_empty() {
            return Ok(());
        }
        self.released = joints.iter().copied().collect();
        self.index_joints();
        self.make_fields().map_err(|_| refused())
    }
}
