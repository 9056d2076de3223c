//! Restitutions that differ from contact to contact: what all laws do where they contradict each other.
//!
//! With one `e` a law of several contacts has a solution that does not raise the energy. Restitutions that differ may
//! ask for energy (`dT > 0`), or of bodies that fit between others to leave on both sides, which no impulses do. A law
//! then resolves the impact once more with one lower restitution `e` for all rows, and the status says so
//! ([`ImpactStatus::RestitutionLowered`]).
//!
//! Source: Glocker 2001 (energy of unequal restitutions).

use super::finish::{Impact, gains_energy};
use super::impact_problem::ImpactProblem;
use super::outcome::{ImpactOutcome, ImpactStatus};

/// The smallest and the largest restitution of the contacts of an impact; 0 where there are none.
pub(super) fn extremes(problem: &ImpactProblem<'_>) -> [f64; 2] {
    let found =
        problem.contact_restitutions().fold([1.0, 0.0], |[least, most]: [f64; 2], e| [least.min(e), most.max(e)]);
    if found[0] > found[1] { [0.0, 0.0] } else { found }
}

/// The restitution that takes the place of those that contradict each other: the smallest, where they differ.
pub(super) fn smallest_where_they_differ(problem: &ImpactProblem<'_>) -> Option<f64> {
    let [least, most] = extremes(problem);
    (least < most).then_some(least)
}

/// An outcome, or the one with this lower restitution for all rows where it has no solution or raises the energy by
/// more than rounding.
pub(super) fn or_lowered(
    impact: &mut Impact<'_>,
    found: ImpactOutcome,
    lower: Option<f64>,
    with_one: impl FnOnce(&mut Impact<'_>, f64) -> ImpactOutcome,
) -> ImpactOutcome {
    let contradict = found.status == ImpactStatus::NotSolved || gains_energy(impact.problem.u_before, &found);
    let Some(restitution) = lower.filter(|_| contradict) else { return found };
    let mut outcome = with_one(impact, restitution);
    if outcome.status == ImpactStatus::Separated {
        outcome.status = ImpactStatus::RestitutionLowered;
    }
    outcome
}

/// What a law does with these restitutions of the rows, or with this lower one for all of them, likewise.
pub(super) fn by_one_or_lowered(
    impact: &mut Impact<'_>,
    law: fn(&mut Impact<'_>, &[f64]) -> ImpactOutcome,
    lower: Option<f64>,
) -> ImpactOutcome {
    let restitution = impact.problem.restitution;
    let found = law(impact, restitution);
    or_lowered(impact, found, lower, |impact, one| law(impact, &vec![one; restitution.len()]))
}
