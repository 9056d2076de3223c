//! The simultaneous law: all touching contacts at once (Moreau; thesis, end of section 3.4).
//!
//! `0 <= u+ + e u- _|_ p >= 0` on all rows (with errata E19: `p_i = 0` where `u_i+ > -e u_i-`). A row that separated
//! before may come to approach, by at most `e u_i-`; then the whole is repeated with the new velocities, as the thesis
//! asks. Energy: with one `e` for all rows
//! `dT = -1/2 (1 - e)/(1 + e) p.G p <= 0`, and `u+ = -e u-` shows that the problem has a solution. Restitutions that
//! differ can raise the energy, or ask of bodies that fit between others to leave on both sides, which no impulses do;
//! then the smallest is used for all rows, said by the status.
//!
//! Source: thesis, section 3.4 (a), (b), (c) for impulses; Moreau 1988; Baraff 1989.

use super::finish::Impact;
use super::outcome::{ImpactOutcome, ImpactStatus};

/// Repeats the solve until no row approaches.
pub(super) fn simultaneous(impact: &mut Impact<'_>, restitution: &[f64]) -> ImpactOutcome {
    let mut outcome = ImpactOutcome { status: ImpactStatus::Separated, ..impact.nothing() };
    let mut velocities = impact.problem.u_before.to_vec();
    let joints = impact.joints();
    let mut impulses = vec![0.0; velocities.len()];
    impact.stop_joints(&joints, &mut velocities, &mut impulses, &mut outcome);
    outcome.impulses = impulses;
    let rows: Vec<usize> = (0..velocities.len()).collect();
    while velocities.iter().enumerate().any(|(row, &u)| impact.is_violated(row, u)) {
        if outcome.solves >= impact.problem.settings.limit {
            outcome.status = ImpactStatus::LimitReached;
            break;
        }
        let constant: Vec<f64> =
            rows.iter().map(|&row| (1.0 + impact.restitution(restitution, row)) * velocities[row]).collect();
        let noise = impact.noise(&outcome.impulses);
        let solved = impact.solve(&rows, &constant, noise, &mut outcome);
        let before = velocities.clone();
        impact.advance(&mut velocities, &rows, &solved.amounts);
        for &row in &rows {
            outcome.impulses[row] += solved.amounts[row];
            if solved.held[row] {
                velocities[row] = -impact.restitution(restitution, row) * before[row];
            }
        }
        if outcome.status == ImpactStatus::NotSolved {
            break;
        }
    }
    impact.conclude(velocities, &mut outcome);
    outcome
}
