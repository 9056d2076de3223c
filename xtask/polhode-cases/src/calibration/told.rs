//! What a run tells of its error: the one place where a report is asked for it.

use polhode::RunReport;

/// What a run tells of its error.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(super) struct Told {
    /// The largest error of any body at any time, of its size; none where it is not told.
    pub(super) relative: Option<f64>,
    /// Beyond this time the motion is one of many, s; none where it is not told.
    pub(super) horizon_s: Option<f64>,
}

/// What this report tells.
pub(super) fn told(report: &RunReport) -> Told {
    Told { relative: report.error.relative(), horizon_s: report.error.horizon_s }
}
