//! What is asked of a study: how many samples, how much time, and what cost is measured in.

use crate::ladder::Range;
use crate::timing::Effort;
use polhode::ErrorEstimation;

/// Rounds of timing of a search for an accuracy: enough to choose between methods.
const FEW_ROUNDS: Effort = Effort { fewest_rounds: 2, most_rounds: 5, enough_s: 0.02 };

/// Time that such a search may take, about, s.
const SEARCH_S: f64 = 10.0;

/// Samples that it takes errors from.
const SEARCH_SAMPLES: u32 = 100;

/// What is asked of a study.
#[derive(Debug, Clone, PartialEq)]
pub struct Options {
    /// Samples that errors are taken from.
    pub samples: u32,
    /// How long each candidate is timed.
    pub effort: Effort,
    /// Time that the default candidates may take together, about, s.
    pub budget_s: f64,
    /// The error that is asked for, where one is: settings just coarse enough for it are looked for between the rungs.
    pub target: Option<f64>,
    /// Which candidates are looked for when none are asked for.
    pub range: Range,
    /// Whether cost is counted in instructions too.
    pub counting: Counting,
    /// How the error that a run tells of itself is found, to stand beside its true one: by a run of its own, which is
    /// not timed.
    pub estimation: ErrorEstimation,
}

impl Options {
    /// For the search for the cheapest method that reaches an accuracy under the law of the scene.
    pub const fn for_accuracy(target: f64) -> Self {
        Self {
            samples: SEARCH_SAMPLES,
            effort: FEW_ROUNDS,
            budget_s: SEARCH_S,
            target: Some(target),
            range: Range::Methods,
            counting: Counting::Time,
            estimation: ErrorEstimation::Quick,
        }
    }
}

/// What cost is measured in.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Counting {
    /// Time as a ratio.
    Time,
    /// Instructions; time is given beside.
    Instructions,
}
