//! The propagation law: one contact at a time, in order (thesis, section 3.3).
//!
//! The contacts have an order, that of the rows. The first one that approaches gets the impulse of equation (14), and
//! the search starts again from the beginning of the list; when none approaches, the impact is over.
//!
//! Assumption: the order of the rows means something to the caller; another order gives another motion. The sequence
//! may be infinite (thesis, Appendix C; errata E20 to E22: a stick with `e <= tan^2(pi/4 - theta/2)` never leaves), so
//! it is cut off below a threshold relative to the first approach, and what is left is removed by one inelastic solve.

use super::finish::Impact;
use super::{Application, ImpactOutcome, ImpactSettings, ImpactStatus, check, single_contact_impulse};
use crate::complementarity::ComplementaritySolver;
use crate::delassus::Delassus;
use crate::error::ResponseError;
use crate::problem::ContactProblem;

/// Resolves an impact one contact at a time, in the order of the rows.
///
/// # Errors
/// When a list has the wrong length, a number is not finite, or a restitution is outside `[0, 1]`.
pub fn propagation(
    problem: &ContactProblem,
    delassus: &Delassus,
    u_before: &[f64],
    restitution: &[f64],
    settings: &ImpactSettings,
    solver: &mut ComplementaritySolver,
) -> Result<ImpactOutcome, ResponseError> {
    let approach = check(problem, delassus, u_before, restitution, settings)?;
    let tolerance = settings.threshold * approach;
    let mut impact = Impact { problem, delassus, u_before, settings, solver, tolerance };
    let mut outcome = impact.nothing();
    if approach == 0.0 {
        return Ok(outcome);
    }
    outcome.status = ImpactStatus::Separated;
    let mut velocities = u_before.to_vec();
    while let Some(row) = velocities.iter().position(|&u| u < -tolerance) {
        if outcome.applications.len() >= settings.limit {
            outcome.status = ImpactStatus::LimitReached;
            break;
        }
        let before = velocities[row];
        let Some(impulse) = single_contact_impulse(delassus.get(row, row), before, restitution[row]) else {
            outcome.status = ImpactStatus::NotSolved;
            break;
        };
        impact.advance(&mut velocities, &[row], &[impulse]);
        // Newton's law says where the row ends; the sum above says so up to rounding.
        velocities[row] = -restitution[row] * before;
        outcome.impulses[row] += impulse;
        let energy_change = 0.5 * impulse * (before + velocities[row]);
        outcome.applications.push(Application { row, impulse, energy_change });
    }
    impact.conclude(velocities, &mut outcome);
    Ok(outcome)
}
