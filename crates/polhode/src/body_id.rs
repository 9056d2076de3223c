//! The handle of a body.

/// A body of a simulation, by its number in the scene: the same number in samples, events, fields of the report and
/// queries. Numbers are never given again: the handle of a body that has been removed stays that of a removed body.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct BodyId(usize);

impl BodyId {
    pub(crate) const fn new(number: usize) -> Self {
        Self(number)
    }

    /// The number of the body in the scene, which is its place in samples.
    pub const fn index(self) -> usize {
        self.0
    }
}
