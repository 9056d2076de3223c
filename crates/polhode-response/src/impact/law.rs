//! The choice of an impact law.

use super::energetic::energetic;
use super::finish::Impact;
use super::friction::PulseExponent;
use super::impact_problem::ImpactProblem;
use super::outcome::ImpactOutcome;
use super::poisson::poisson;
use super::propagation::propagation;
use super::pulse::pulse;
use super::reflection::reflection;
use super::simultaneous::simultaneous;
use super::unequal::{by_one_or_lowered, smallest_where_they_differ};
use crate::complementarity::ComplementaritySolver;
use crate::error::{ResponseError, check_length};

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
        self.resolve_in_order(problem, solver, &(0..problem.u_before.len()).collect::<Vec<_>>())
    }

    /// The same where propagation has another order of the rows: of those that approach, the one that comes first in
    /// `order` is struck.
    ///
    /// # Errors
    /// Those of [`resolve`](Self::resolve), and when `order` does not name each row.
    pub fn resolve_in_order(
        self,
        problem: &ImpactProblem<'_>,
        solver: &mut ComplementaritySolver,
        order: &[usize],
    ) -> Result<ImpactOutcome, ResponseError> {
        let rows = problem.u_before.len();
        check_length("order of the rows", rows, order.len())?;
        let mut named = order.to_vec();
        named.sort_unstable();
        if let Some((_, &row)) = named.iter().enumerate().find(|(place, row)| place != *row) {
            return Err(ResponseError::UnknownRow { row, rows });
        }
        let approach = problem.approach()?;
        let impact = &mut Impact::new(problem, approach, solver);
        if approach == 0.0 {
            return Ok(impact.nothing());
        }
        let mut outcome = match self {
            Self::Propagation => return Ok(propagation(impact, order)),
            Self::Simultaneous => by_one_or_lowered(impact, simultaneous, smallest_where_they_differ(problem)),
            Self::Reflection => reflection(impact),
            Self::Poisson => by_one_or_lowered(impact, poisson, smallest_where_they_differ(problem)),
            // Rounding of rows that nearly contradict each other: no restitution is left.
            Self::Energetic => by_one_or_lowered(impact, energetic, Some(0.0)),
            Self::Pulse(exponent) => pulse(impact, exponent),
        };
        impact.list_applications(&mut outcome);
        Ok(outcome)
    }
}
