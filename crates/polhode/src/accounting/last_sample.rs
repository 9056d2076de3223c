//! The overlaps of the last sample with its states, as a cache: bodies at rest are measured once. It is no part of the
//! simulation state.

use super::measures::Measure;
use polhode_dynamics::BodyState;

/// The overlaps of the last sample.
#[derive(Debug, Default)]
pub(crate) struct LastSample {
    pub(crate) states: Vec<BodyState>,
    /// How many of the bodies had been removed.
    pub(crate) removed: usize,
    pub(crate) overlaps: Vec<Measure>,
}
