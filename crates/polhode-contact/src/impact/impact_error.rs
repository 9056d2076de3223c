//! Why a search for an impact has no result.

use thiserror::Error;

/// Why a search for an impact has no result.
#[derive(Debug, Clone, Copy, PartialEq, Error)]
pub enum ImpactError {
    /// The interval of time is reversed or not finite.
    #[error("the interval of time {t0} s to {t1} s must be finite and in order")]
    Interval {
        /// Start, s.
        t0: f64,
        /// End, s.
        t1: f64,
    },
    /// A pose, velocity or bound is not finite.
    #[error("the motions are not finite at {t} s: poses, velocities and their bounds must be finite")]
    NotFinite {
        /// Time, s.
        t: f64,
    },
    /// The number of evaluations reached its limit, as for a pair that stays close without touching.
    #[error(
        "no result after {limit} evaluations: at {t} s the separation is {separation:e} m; shorten the interval or \
         raise max_evaluations"
    )]
    EvaluationLimit {
        /// Time reached; the pair is clear up to it, s.
        t: f64,
        /// Separation there, m.
        separation: f64,
        /// The limit.
        limit: u32,
    },
}
