//! The handle of a body.

/// The handle of a body of a simulation: its index in the scene, which is also its index in samples, events, reports
/// and queries. The index of a removed body is not given to another one.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct BodyId(usize);

impl BodyId {
    pub(crate) const fn new(number: usize) -> Self {
        Self(number)
    }

    /// Index of the body in the scene, which is its place in samples.
    pub const fn index(self) -> usize {
        self.0
    }
}
