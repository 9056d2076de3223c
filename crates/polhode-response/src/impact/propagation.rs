//! The propagation law: one contact at a time, in order (thesis, section 3.3).
//!
//! The contacts have an order, that of the rows. The first one that approaches gets the impulse of equation (14), and
//! the search starts again from the beginning of the list; when none approaches, the impact is over.
//!
//! Assumption: the order of the rows means something to the caller; another order ([`propagation_in_order`]) gives
//! another motion. The sequence
//! may be infinite (thesis, Appendix C; errata E20 to E22: a stick with `e <= tan^2(pi/4 - theta/2)` never leaves), so
//! it is cut off below a threshold relative to the first approach, and what is left is removed by one inelastic solve.

use super::finish::Impact;
use super::impact_problem::ImpactProblem;
use super::outcome::{Application, ImpactOutcome, ImpactStatus};
use super::single_contact_impulse;
use crate::complementarity::ComplementaritySolver;
use crate::error::{ResponseError, check_length};

/// Resolves an impact one contact at a time, in the order of the rows.
///
/// # Errors
/// When a list has the wrong length, a number is not finite, or a restitution is outside `[0, 1]`.
pub fn propagation(
    problem: &ImpactProblem<'_>,
    solver: &mut ComplementaritySolver,
) -> Result<ImpactOutcome, ResponseError> {
    let order: Vec<usize> = (0..problem.u_before.len()).collect();
    propagation_in_order(problem, solver, &order)
}

/// [`propagation`] with the rows in another order: of those that approach, the one that comes first in `order` is
/// struck.
///
/// # Errors
/// Those of [`propagation`], and when `order` does not name each row.
pub fn propagation_in_order(
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
    let ImpactProblem { delassus, u_before, restitution, settings, .. } = *problem;
    let mut impact = Impact::new(problem, approach, solver);
    let tolerance = impact.tolerance;
    let mut outcome = impact.nothing();
    if approach == 0.0 {
        return Ok(outcome);
    }
    outcome.status = ImpactStatus::Separated;
    let mut velocities = u_before.to_vec();
    let joints = impact.joints();
    if !joints.is_empty() {
        strike_with_joints(&mut impact, (&joints, order), restitution, &mut velocities, &mut outcome);
        impact.conclude(velocities, &mut outcome);
        return Ok(outcome);
    }
    while let Some(row) = order.iter().copied().find(|&row| velocities[row] < -tolerance) {
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

/// One contact at a time, each together with all joints, whose velocities are zero after every application.
fn strike_with_joints(
    impact: &mut Impact<'_>,
    (joints, order): (&[usize], &[usize]),
    restitution: &[f64],
    velocities: &mut [f64],
    outcome: &mut ImpactOutcome,
) {
    let before = velocities.to_vec();
    let mut impulses = vec![0.0; velocities.len()];
    impact.stop_joints(joints, velocities, &mut impulses, outcome);
    for &row in joints.iter().filter(|&&row| impulses[row] != 0.0) {
        let impulse = impulses[row];
        outcome.applications.push(Application { row, impulse, energy_change: 0.5 * impulse * before[row] });
    }
    outcome.impulses = impulses;
    while let Some(row) = order.iter().copied().find(|&row| impact.is_violated(row, velocities[row])) {
        if outcome.applications.len() >= impact.problem.settings.limit {
            outcome.status = ImpactStatus::LimitReached;
            return;
        }
        let struck: Vec<usize> =
            std::iter::once(row).filter(|row| !joints.contains(row)).chain(joints.iter().copied()).collect();
        let before: Vec<f64> = struck.iter().map(|&row| velocities[row]).collect();
        let constants: Vec<f64> =
            struck.iter().zip(&before).map(|(&row, u)| (1.0 + impact.restitution(restitution, row)) * u).collect();
        let noise = impact.noise(&outcome.impulses);
        let solved = impact.solve(&struck, &constants, noise, outcome);
        if outcome.status == ImpactStatus::NotSolved {
            return;
        }
        impact.advance(velocities, &struck, &solved.amounts);
        for (k, &row) in struck.iter().enumerate() {
            let impulse = solved.amounts[k];
            velocities[row] = -impact.restitution(restitution, row) * before[k];
            outcome.impulses[row] += impulse;
            if impulse != 0.0 {
                let energy_change = 0.5 * impulse * (before[k] + velocities[row]);
                outcome.applications.push(Application { row, impulse, energy_change });
            }
        }
    }
}
