//! The handle of a joint.

/// The handle of a joint of a scene or simulation: its number in the order in which joints were added, from 0.
///
/// [`SceneBuilder::add_joint`](crate::scene::SceneBuilder::add_joint) returns it.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct JointId(usize);

impl JointId {
    /// The joint of this number. Whether there is one is checked where the handle is used.
    pub const fn new(number: usize) -> Self {
        Self(number)
    }

    /// Number of the joint, which is its place in [`Scene::joints`](crate::scene::Scene::joints).
    pub const fn index(self) -> usize {
        self.0
    }
}
