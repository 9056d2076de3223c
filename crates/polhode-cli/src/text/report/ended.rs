//! What is known of a run when it has ended.

use polhode::RunReport;

/// What is known of a run when it has ended.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Ended<'a> {
    /// Its report.
    pub(crate) report: &'a RunReport,
    /// How far what stands is from moving.
    pub(crate) stands: Option<&'a str>,
    /// Time that it took, s.
    pub(crate) wall_s: f64,
}
