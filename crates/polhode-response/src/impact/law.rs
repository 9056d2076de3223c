//! The choice of an impact law.

use super::friction::PulseExponent;
use super::impact_problem::ImpactProblem;
use super::outcome::ImpactOutcome;
use super::{energetic, poisson, propagation, pulse, reflection, simultaneous};
use crate::complementarity::ComplementaritySolver;
use crate::error::ResponseError;

/// Which impact law.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
#[non_exhaustive]
pub enum ImpactLaw {
    /// One contact at a time, in order (thesis, section 3.3).
    Propagation,
    /// All touching contacts at once (Moreau).
    Simultaneous,
    /// Generalised reflection, blended with the inelastic impulse.
    #[default]
    Reflection,
    /// A compression and an expansion of all touching contacts (Poisson; Glocker and Pfeiffer).
    Poisson,
    /// Each contact gives back a part of the work that it took (Stronge).
    Energetic,
    /// The contacts as springs that spend their energy (Liu, Zhao and Brogliato).
    Pulse(PulseExponent),
}

impl ImpactLaw {
    /// Resolves an impact by this law.
    ///
    /// # Errors
    /// When a list has the wrong length, a number is not finite, or a restitution is outside `[0, 1]`.
    pub fn resolve(
        self,
        problem: &ImpactProblem<'_>,
        solver: &mut ComplementaritySolver,
    ) -> Result<ImpactOutcome, ResponseError> {
        match self {
            Self::Propagation => propagation(problem, solver),
            Self::Simultaneous => simultaneous(problem, solver),
            Self::Reflection => reflection(problem, solver),
            Self::Poisson => poisson(problem, solver),
            Self::Energetic => energetic(problem, solver),
            Self::Pulse(exponent) => pulse(problem, solver, exponent),
        }
    }
}
