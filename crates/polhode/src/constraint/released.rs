//! Joints that hold nothing any more: their bodies have run off the end of a track (`track.rs`), they have broken
//! (`breaking.rs`), or a program has taken them away.
//!
//! Such a joint leaves the joints of the world, and its number is no other one's, until a snapshot from before brings
//! it back.

use super::joint::ModelJoint;
use crate::model::Model;
use crate::scene::SceneError;
use crate::snapshot::SnapshotError;
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

impl Model {
    /// Joints hold nothing from now on. Those that are not there are passed over.
    ///
    /// # Errors
    /// When the fields of the remaining joints cannot be made.
    pub(crate) fn release(&mut self, joints: &[usize]) -> Result<(), SceneError> {
        for joint in joints {
            if let Ok(place) = self.joints.list.binary_search_by_key(joint, ModelJoint::number) {
                let released = self.joints.list.remove(place);
                self.joints.released.insert(*joint, released);
            }
        }
        self.index_joints();
        self.make_fields()
    }

    /// Whether two bodies had contacts at joints that hold nothing any more, or of their shapes before a joint was
    /// added between them. Their shapes do not collide for that.
    pub(crate) fn lost_joint_contacts(&self, pair: (usize, usize)) -> bool {
        let is_added = |number: usize| self.pair_of_joint(number) == Some(pair);
        self.joints.released.values().any(|joint| joint.pair() == pair)
            || self.joints.added.iter().any(|added| is_added(added.number))
    }

    /// The joints of these bodies on tracks whose ends they have passed in these states, in the order of the scene.
    pub(crate) fn run_off(&self, states: &[BodyState], bodies: &[usize]) -> Vec<RunOff> {
        let motion = |body: usize| -> (Pose, Velocity) { (states[body].pose, self.velocity(body, &states[body])) };
        let bodies = if self.joints.ending_tracks > 0 { bodies } else { &[] };
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
        let refused = || SnapshotError::Invalid("a joint has let go that the scene has not");
        if joints.is_empty() && self.joints.released.is_empty() {
            return Ok(());
        }
        self.joints.list.extend(std::mem::take(&mut self.joints.released).into_values());
        self.joints.list.sort_by_key(ModelJoint::number);
        if !joints.iter().all(|&joint| self.joint_numbered(joint).is_some()) {
            return Err(refused());
        }
        self.release(joints).map_err(|_| refused())
    }
}
