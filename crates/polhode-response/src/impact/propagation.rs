//! The propagation law: one contact at a time, in order (thesis, section 3.3).
//!
//! The contacts have an order, that of the rows. The first one that approaches gets the impulse of equation (14), and
//! the search starts again from the beginning of the list; when none approaches, the impact is over.
//!
//! Assumption: the order of the rows means something to the caller; another order
//! ([`ImpactLaw::resolve_in_order`](super::ImpactLaw::resolve_in_order)) gives another motion. The sequence may be
//! infinite (thesis, Appendix C; errata E20 to E22: a stick with `e <= tan^2(pi/4 - theta/2)` never leaves), so
//! it is cut off below a threshold relative to the first approach, and what is left is removed by one inelastic solve.

use super::finish::Impact;
use super::impact_problem::ImpactProblem;
use super::outcome::{Application, ImpactOutcome, ImpactStatus};
use super::single_contact_impulse;

/// Resolves an impact one contact at a time: of the rows that approach, the one that comes first in `order` is struck.
pub(super) fn propagation(impact: &mut Impact<'_>, order: &[usize]) -> ImpactOutcome {
    let ImpactProblem { delassus, u_before, restitution, settings, .. } = *impact.problem;
    let tolerance = impact.tolerance;
    let mut outcome = ImpactOutcome { status: ImpactStatus::Separated, ..impact.nothing() };
    let mut velocities = u_before.to_vec();
    let joints = impact.joints();
    if !joints.is_empty() {
        strike_with_joints(impact, (&joints, order), restitution, &mut velocities, &mut outcome);
        impact.conclude(velocities, &mut outcome);
        return outcome;
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
    outcome
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
