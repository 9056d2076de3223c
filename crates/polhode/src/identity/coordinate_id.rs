//! Identity of a coordinate of a joint.

/// Identity of a coordinate.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) struct CoordinateId {
    /// Number of the joint in the scene.
    pub(crate) joint: usize,
    /// Its place among the coordinates of the joint.
    pub(crate) place: usize,
}
