//! The choice of an impact law.

use super::outcome::ImpactOutcome;
use super::settings::ImpactSettings;
use super::{propagation, reflection, simultaneous};
use crate::complementarity::ComplementaritySolver;
use crate::delassus::Delassus;
use crate::error::ResponseError;
use crate::problem::ContactProblem;

/// Which impact law.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum ImpactLaw {
    /// One contact at a time, in order (thesis, section 3.3).
    Propagation,
    /// All touching contacts at once (Moreau).
    Simultaneous,
    /// Generalised reflection, blended with the inelastic impulse.
    #[default]
    Reflection,
}

impl ImpactLaw {
    /// Resolves an impact by this law.
    ///
    /// # Errors
    /// When a list has the wrong length, a number is not finite, or a restitution is outside `[0, 1]`.
    pub fn resolve(
        self,
        problem: &ContactProblem,
        delassus: &Delassus,
        u_before: &[f64],
        restitution: &[f64],
        settings: &ImpactSettings,
        solver: &mut ComplementaritySolver,
    ) -> Result<ImpactOutcome, ResponseError> {
        match self {
            Self::Propagation => propagation(problem, delassus, u_before, restitution, settings, solver),
            Self::Simultaneous => simultaneous(problem, delassus, u_before, restitution, settings, solver),
            Self::Reflection => reflection(problem, delassus, u_before, restitution, settings, solver),
        }
    }
}
