//! Joints that hold nothing any more: their bodies have run off the end of a track (`track.rs`), they have broken
//! (`breaking.rs`), or a program has taken them away.
//!
//! Such a joint leaves the joints of the world, and its number is no other one's, until a snapshot from before brings
//! it back.

use crate::constraint::joint::ModelJoint;
use crate::model::{Joints, Model};
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

impl Joints {
    /// Whether two bodies had contacts at joints that hold nothing any more, or of their shapes before a joint was
    /// added between them. Their shapes do not collide for that.
    pub(crate) fn lost_joint_contacts(&self, pair: (usize, usize)) -> bool {
        let is_added = |number: usize| self.pair_of_joint(number) == Some(pair);
        self.released.values().any(|joint| joint.pair() == pair)
            || self.added.iter().any(|added| is_added(added.number))
    }
}

/// Joints hold nothing from now on. Those that are not there are passed over.
///
/// # Errors
/// When the fields of the remaining joints cannot be made.
pub(crate) fn release(model: &mut Model, joints: &[usize]) -> Result<(), SceneError> {
    for joint in joints {
        if let Ok(place) = model.joints.list.binary_search_by_key(joint, ModelJoint::number) {
            let released = model.joints.list.remove(place);
            model.joints.released.insert(*joint, released);
        }
    }
    model.index_joints();
    model.make_fields()
}

/// The joints of these bodies on tracks whose ends they have passed in these states, in the order of the scene.
pub(crate) fn run_off(model: &Model, states: &[BodyState], bodies: &[usize]) -> Vec<RunOff> {
    let motion = |body: usize| -> (Pose, Velocity) { (states[body].pose, model.velocity(body, &states[body])) };
    let bodies = if model.joints.ending_tracks > 0 { bodies } else { &[] };
    let passed = model.joints.joints_among(bodies).filter(|joint| joint.has_passed_end(motion));
    passed.filter_map(|joint| place_on_track(model, states, joint.number())).collect()
}

/// Where the body of a joint is that runs off its track in these states.
pub(crate) fn place_on_track(model: &Model, states: &[BodyState], number: usize) -> Option<RunOff> {
    let motion = |body: usize| -> (Pose, Velocity) { (states[body].pose, model.velocity(body, &states[body])) };
    let joint = model.joints.joint_numbered(number)?;
    Some(RunOff { joint: number, body: joint.bodies().next()?, point: joint.anchor(motion) })
}

/// Replaces the joints that hold nothing by these.
///
/// # Errors
/// When there is no such joint.
pub(crate) fn replace_released(model: &mut Model, joints: &[usize]) -> Result<(), SnapshotError> {
    let refused = || SnapshotError::Invalid("a joint has let go that the scene has not");
    if joints.is_empty() && model.joints.released.is_empty() {
        return Ok(());
    }
    model.joints.list.extend(std::mem::take(&mut model.joints.released).into_values());
    model.joints.list.sort_by_key(ModelJoint::number);
    if !joints.iter().all(|&joint| model.joints.joint_numbered(joint).is_some()) {
        return Err(refused());
    }
    release(model, joints).map_err(|_| refused())
}
