//! What is asked of a study: how many samples, how much time, and what cost is measured in.

use super::ladder::Range;
use super::timing::Effort;

/// What is asked of a study.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Options {
    /// Samples that errors are taken from.
    pub(crate) samples: u32,
    /// How long each candidate is timed.
    pub(crate) effort: Effort,
    /// Time that the default candidates may take together, about, s.
    pub(crate) budget_s: f64,
    /// The error that is asked for, where one is: settings just coarse enough for it are looked for between the rungs.
    pub(crate) target: Option<f64>,
    /// Which candidates are looked for when none are asked for.
    pub(crate) range: Range,
    /// Whether cost is counted in instructions too.
    pub(crate) counting: Counting,
}

/// What cost is measured in.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Counting {
    /// Time as a ratio.
    Time,
    /// Instructions; time is given beside.
    Instructions,
}
