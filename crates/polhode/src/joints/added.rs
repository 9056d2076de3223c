//! Joints that a program adds to a simulation, between bodies as they are then. Those that it takes away are
//! `released.rs`.

use crate::constraint::joint::{AddedJoint, ModelJoint};
use crate::identity::contact_id::{ContactId, Feature};
use crate::model::{Joints, Model};
use crate::scene::{Joint, Scene, SceneError, Tier};
use polhode_dynamics::BodyState;

impl Joints {
    /// The bodies of a joint that is there, A <= B: the same body twice if it holds a body to the world.
    pub(crate) fn pair_of_joint(&self, joint: usize) -> Option<(usize, usize)> {
        self.joint_numbered(joint).map(ModelJoint::pair)
    }
}

/// Adds a joint between bodies in these states, in a run by this tier. Returns its number.
///
/// # Errors
/// When a scene would refuse it; the world is of no use then.
pub(crate) fn add_joint(
    model: &mut Model,
    joint: &Joint,
    states: &[BodyState],
    tier: Tier,
) -> Result<usize, SceneError> {
    let joint = model.scene.take_joint(joint, tier)?;
    let number = model.scene.joints().len() - 1;
    let added = model.joint_between(number, &joint, states);
    model.joints.ending_tracks += usize::from(added.lets_go_at_ends());
    model.joints.list.push(added);
    if joint.strength().is_some() {
        model.joints.breakable.insert(number);
    }
    let poses = joint.bodies().map(|body| states[body].pose).collect();
    model.joints.added.push(AddedJoint { number, poses });
    model.find_what_collides();
    model.index_joints();
    model.make_fields()?;
    Ok(number)
}

/// The scene, with where bodies were when joints were added.
pub(crate) fn scene_and_joints(model: &Model) -> (&Scene, &[AddedJoint]) {
    (&model.scene, &model.joints.added)
}

/// Whether two bodies may have contacts, of their shapes or at joints.
pub(crate) fn may_touch(model: &Model, (a, b): (usize, usize)) -> bool {
    !model.joints.joint_contacts_of_pair((a, b)).is_empty() || model.scene.may_collide(a, b)
}

/// Whether there may be a contact, after joints of its bodies were added or taken away.
pub(crate) fn may_have(model: &Model, contact: ContactId) -> bool {
    let pair = (contact.a, contact.b);
    match contact.feature {
        Feature::Shapes(_) => model.scene.may_collide(contact.a, contact.b),
        Feature::Stop(_) | Feature::JointFriction(_) => {
            model.joints.joint_contacts_of_pair(pair).contains(&contact.feature)
        }
    }
}
