//! The handle of a joint, and the state of one of its coordinates.

/// The handle of a joint of a scene or simulation: its number in the order in which joints were added, from 0.
///
/// [`SceneBuilder::add_joint`](crate::SceneBuilder::add_joint) returns it.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct JointId(usize);

impl JointId {
    /// The joint of this number. Whether there is one is checked where the handle is used.
    pub const fn new(number: usize) -> Self {
        Self(number)
    }

    /// Number of the joint, which is its place in [`Scene::joints`](crate::Scene::joints).
    pub const fn index(self) -> usize {
        self.0
    }
}

/// A coordinate of a joint at one time.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct CoordinateSample {
    /// Its value, rad or m; an angle with all its revolutions, if it has no limits.
    pub value: f64,
    /// Its rate, rad/s or m/s.
    pub rate: f64,
}
