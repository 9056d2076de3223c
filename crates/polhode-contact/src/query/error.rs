//! Why a query has no result.

use thiserror::Error;

/// Why a query has no result.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum QueryError {
    /// A pose or a coordinate is NaN or infinite.
    #[error("{what} is not finite: give finite coordinates")]
    NotFinite {
        /// The name of the value.
        what: &'static str,
    },
    /// Two half-spaces, which overlap without bound unless they face each other exactly.
    #[error("two half-spaces have no distance: one of the two must be bounded")]
    Unbounded,
    /// A box that is unbounded, or too flat to be a polyhedron.
    #[error("the box is flat or unbounded: every side must be finite and longer than 1e-9 of the diagonal")]
    FlatBox,
    /// More bodies than indices.
    #[error("{count} bodies are given, at most {limit} are possible")]
    TooManyBodies {
        /// How many were given.
        count: usize,
        /// How many are possible.
        limit: usize,
    },
}
