//! Joints that a program adds to a simulation, between bodies as they are then. Those that it takes away are
//! `released.rs`.

use super::joint::{AddedJoint, ModelJoint};
use crate::identity::contact_id::{ContactId, Feature};
use crate::model::Model;
use crate::scene::{Joint, Scene, SceneError, Tier};
use polhode_dynamics::BodyState;

impl Model {
    /// Adds a joint between bodies in these states, in a run by this tier. Returns its number.
    ///
    /// # Errors
    /// When a scene would refuse it; the world is of no use then.
    pub(crate) fn add_joint(&mut self, joint: &Joint, states: &[BodyState], tier: Tier) -> Result<usize, SceneError> {
        let joint = self.scene.take_joint(joint, tier)?;
        let number = self.scene.joints().len() - 1;
        let added = self.joint_between(number, &joint, states);
        self.joints.ending_tracks += usize::from(added.lets_go_at_ends());
        self.joints.list.push(added);
        if joint.strength().is_some() {
            self.joints.breakable.insert(number);
        }
        let poses = joint.bodies().map(|body| states[body].pose).collect();
        self.joints.added.push(AddedJoint { number, poses });
        self.find_what_collides();
        self.index_joints();
        self.make_fields()?;
        Ok(number)
    }

    /// The scene, with where bodies were when joints were added.
    pub(crate) fn scene_and_joints(&self) -> (&Scene, &[AddedJoint]) {
        (&self.scene, &self.joints.added)
    }

    /// The bodies of a joint that is there, A <= B: the same body twice if it holds a body to the world.
    pub(crate) fn pair_of_joint(&self, joint: usize) -> Option<(usize, usize)> {
        self.joint_numbered(joint).map(ModelJoint::pair)
    }

    /// Whether two bodies may have contacts, of their shapes or at joints.
    pub(crate) fn may_touch(&self, (a, b): (usize, usize)) -> bool {
        !self.joint_contacts_of_pair((a, b)).is_empty() || self.scene.may_collide(a, b)
    }

    /// Whether there may be a contact, after joints of its bodies were added or taken away.
    pub(crate) fn may_have(&self, contact: ContactId) -> bool {
        let pair = (contact.a, contact.b);
        match contact.feature {
            Feature::Shapes(_) => self.scene.may_collide(contact.a, contact.b),
            Feature::Stop(_) | Feature::JointFriction(_) => {
                self.joint_contacts_of_pair(pair).contains(&contact.feature)
            }
        }
    }
}
