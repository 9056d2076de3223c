//! Poisson's law for several contacts: a compression and an expansion, each a complementarity problem (Glocker and
//! Pfeiffer).
//!
//! Compression: `0 <= u_c _|_ p_c >= 0` with `u_c = u- + G p_c`, the inelastic impact at all rows. Expansion: each row
//! gives back at least `e_i` times the impulse that it took, `0 <= u+ _|_ p_e - e p_c >= 0` with `u+ = u_c + G p_e`: no
//! row approaches afterwards, and it gives more only where the bodies would approach otherwise. `p = p_c + p_e`, `u` in
//! m/s, `p` in N s, `G` in 1/kg.
//!
//! Energy: with one `e` for all rows the impact loses energy for `e < 1` and keeps it for `e = 1` where no row asks for
//! more than `e p_c`. Restitutions that differ are judged by what they do: where they would raise the energy the
//! smallest is used for all rows, said by the status.
//!
//! Assumption: where impulses are not unique, those of the compression are of least norm, which does not depend on the
//! order of the rows. With one `e`, and all rows held in the compression, this law and the simultaneous one agree; they
//! differ where the compression opens a row that approached, and where `e` differs.
//!
//! Source: Poisson 1811; Glocker and Pfeiffer 1995.

use super::finish::Impact;
use super::outcome::{ImpactOutcome, ImpactStatus};

/// The compression and the expansion.
pub(super) fn poisson(impact: &mut Impact<'_>, restitution: &[f64]) -> ImpactOutcome {
    let mut outcome = ImpactOutcome { status: ImpactStatus::Separated, ..impact.nothing() };
    let mut velocities = impact.problem.u_before.to_vec();
    let joints = impact.joints();
    let mut impulses = vec![0.0; velocities.len()];
    impact.stop_joints(&joints, &mut velocities, &mut impulses, &mut outcome);
    let rows: Vec<usize> = (0..velocities.len()).collect();
    let noise = impact.noise(&impulses);
    let compression = impact.solve(&rows, &velocities, noise, &mut outcome);
    if outcome.status != ImpactStatus::NotSolved {
        let given: Vec<f64> =
            rows.iter().map(|&row| impact.restitution(restitution, row) * compression.amounts[row]).collect();
        for &row in &rows {
            impulses[row] += compression.amounts[row] + given[row];
        }
        velocities = compression.w;
        impact.advance(&mut velocities, &rows, &given);
        if velocities.iter().enumerate().any(|(row, &u)| impact.is_violated(row, u)) {
            let noise = impact.noise(&impulses);
            let more = impact.solve(&rows, &velocities, noise, &mut outcome);
            for &row in &rows {
                impulses[row] += more.amounts[row];
            }
            velocities = more.w;
        }
    }
    outcome.impulses = impulses;
    impact.conclude(velocities, &mut outcome);
    outcome
}
