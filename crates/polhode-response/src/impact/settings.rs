//! Tolerances and limits of the impact laws.

use crate::settings::SolverSettings;

/// Tolerances and limits of the impact laws.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ImpactSettings {
    /// A row approaches when `u < -threshold * max |u-|` over the rows that approach at first.
    pub threshold: f64,
    /// Limit of applications (propagation) or of rounds (the other laws).
    pub limit: usize,
    /// Settings of the complementarity problems.
    pub solver: SolverSettings,
}

impl Default for ImpactSettings {
    fn default() -> Self {
        Self { threshold: 1e-12, limit: 1_000_000, solver: SolverSettings::default() }
    }
}
