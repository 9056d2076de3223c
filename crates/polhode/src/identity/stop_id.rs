//! Identity of a stop of a joint (`stop.rs`).

/// Identity of a stop.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) struct StopId {
    /// Number of the joint in the scene.
    pub(crate) joint: usize,
    /// Its place among the stops of the joint.
    pub(crate) stop: usize,
}
