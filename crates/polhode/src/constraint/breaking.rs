//! Joints of the world that may break, and those that have broken.
//!
//! A joint that breaks leaves the joints of the world until a snapshot from before brings it back.

use super::ConstraintId;
use super::bilateral::{Bilateral, Reaction};
use super::joint::WorldJoint;
use crate::SceneError;
use crate::scene::Strength;
use crate::snapshot::SnapshotError;
use crate::world::World;

impl World {
    /// The load at which a joint breaks; none of one that nothing breaks.
    pub(crate) fn strength_of(&self, joint: usize) -> Option<Strength> {
        self.scene.joints().get(joint)?.strength()
    }

    /// Whether any joint of the scene may break.
    pub(crate) fn may_break(&self) -> bool {
        !self.breakable.is_empty()
    }

    /// Whether any joint of these bodies may break.
    pub(crate) fn may_break_among(&self, bodies: &[usize]) -> bool {
        self.may_break() && self.joints_among(bodies).any(|joint| self.breakable.contains(&joint.number()))
    }

    /// The joints that impulses of an impact (N s) break.
    pub(crate) fn broken_by(&self, impulses: &[(Bilateral, Reaction)]) -> Vec<usize> {
        let is_broken = |(of, impulse): &(Bilateral, Reaction)| match of.id {
            ConstraintId::Joint { joint, .. } => {
                let most = self.strength_of(joint)?.greatest_impulse();
                (impulse.force.length() >= most).then_some(joint)
            }
            _ => None,
        };
        if self.may_break() { impulses.iter().filter_map(is_broken).collect() } else { Vec::new() }
    }

    /// Breaks joints. Those that are not there are passed over.
    ///
    /// # Errors
    /// When the fields of the remaining joints cannot be made.
    pub(crate) fn break_joints(&mut self, joints: &[usize]) -> Result<(), SceneError> {
        for joint in joints {
            if let Ok(place) = self.joints.binary_search_by_key(joint, WorldJoint::number) {
                let broken = self.joints.remove(place);
                self.broken.insert(*joint, broken);
            }
        }
        self.index_joints();
        self.make_fields()
    }

    /// The joints that have broken.
    pub(crate) fn broken(&self) -> Vec<usize> {
        self.broken.keys().copied().collect()
    }

    /// Makes these the joints that have broken.
    ///
    /// # Errors
    /// When one cannot break.
    pub(crate) fn replace_broken(&mut self, joints: &[usize]) -> Result<(), SnapshotError> {
        let refused = || SnapshotError::Invalid("a joint is broken that cannot break");
        if !joints.iter().all(|&joint| self.strength_of(joint).is_some()) {
            return Err(refused());
        }
        if self.broken.is_empty() && joints.is_empty() {
            return Ok(());
        }
        self.joints.extend(std::mem::take(&mut self.broken).into_values());
        self.joints.sort_by_key(WorldJoint::number);
        self.break_joints(joints).map_err(|_| refused())
    }
}
