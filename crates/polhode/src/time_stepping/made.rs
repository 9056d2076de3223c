//! A step that has been made, before what overlaps at its end is removed.

use crate::accounting::time_step_report::TimeStepReport;
use crate::solve::overlap::Overlaps;
use polhode_dynamics::BodyState;

/// A step that has been made, but for the removal of what overlaps at its end.
#[derive(Debug)]
pub(super) struct Made {
    pub(super) report: TimeStepReport,
    /// The states of the bodies at its start, after its impacts.
    pub(super) struck: Vec<BodyState>,
    /// The pairs that may overlap.
    pub(super) pairs: Vec<(usize, usize)>,
    pub(super) overlaps: Overlaps,
}
