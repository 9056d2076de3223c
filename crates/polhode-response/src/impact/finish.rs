//! What all impact laws share: inelastic solves, the end of an impact, its energy.

use super::impact_problem::ImpactProblem;
use super::outcome::{Application, ImpactOutcome, ImpactStatus};
use crate::complementarity::ComplementaritySolver;
use crate::dense::kernels::{axpy, compensated_dot, largest};
use crate::dense::scalar::Scalar;
use crate::minimum_norm::least_norm;
use crate::precise;
use crate::report::SolverStatus;
use crate::settings::SolverSettings;

/// A gain of energy above this fraction of `sum p_i (|u_i-| + |u_i+|) / 2` is real (no unit). Below it is what rounding
/// and rows that are held only nearly leave (`closed_cut`), and is taken out by shortening the impulses.
const HELD_ENERGY_ROUNDING: f64 = 1e-10;

/// The problem of one impact and what is needed to solve it.
#[derive(Debug)]
pub(super) struct Impact<'a> {
    pub(super) problem: &'a ImpactProblem<'a>,
    pub(super) solver: &'a mut ComplementaritySolver,
    /// Velocities above `-tolerance` do not approach, m/s.
    pub(super) tolerance: f64,
}

/// Impulses of least norm with `0 <= p _|_ G p + b >= 0` on some rows.
#[derive(Debug, Clone)]
pub(super) struct Impulses {
    /// In the order of the rows asked for.
    pub(super) amounts: Vec<f64>,
    /// `G p + b`: exactly 0 on held rows.
    pub(super) w: Vec<f64>,
    pub(super) held: Vec<bool>,
}

impl<'a> Impact<'a> {
    /// Of a problem whose largest speed of approach is `approach` (m/s).
    pub(super) fn new(problem: &'a ImpactProblem<'a>, approach: f64, solver: &'a mut ComplementaritySolver) -> Self {
        Self { problem, solver, tolerance: problem.settings.threshold * approach }
    }

    /// Solves for the impulses of `rows` with constant terms `b` that carry a rounding of `noise` (m/s), and books the
    /// solve in `outcome`.
    pub(super) fn solve(&mut self, rows: &[usize], b: &[f64], noise: f64, outcome: &mut ImpactOutcome) -> Impulses {
        let noise_floor = self.problem.settings.solver.noise_floor.max(noise);
        self.solver.set_settings(SolverSettings { noise_floor, ..self.problem.settings.solver });
        let solution = self.solver.solve_rows(self.problem.contacts, self.problem.delassus, rows, b);
        outcome.solves += 1;
        outcome.residual = outcome.residual.max(solution.report.residual);
        let solved = solution.report.status == SolverStatus::Solved;
        if !solved {
            outcome.status = ImpactStatus::NotSolved;
        }
        let least = least_norm(self.problem.contacts, rows, solution, &self.problem.settings.solver);
        let (mut w, held) = (solution.residual_accelerations.clone(), solution.held.clone());
        if solved {
            // What rows of a solved problem still approach by is rounding.
            for (speed, &row) in w.iter_mut().zip(rows) {
                *speed = if self.problem.is_bilateral(row) { 0.0 } else { speed.max(0.0) };
            }
        }
        Impulses { amounts: least.forces, w, held }
    }

    /// The bilateral rows, which take part in every solve.
    pub(super) fn joints(&self) -> Vec<usize> {
        (0..self.problem.u_before.len()).filter(|&row| self.problem.is_bilateral(row)).collect()
    }

    /// Takes the motion of joints out of the velocities, before any contact is struck: joints that move and contacts
    /// that rebound, struck together, could raise the energy. Joints that move no faster than contacts that do not
    /// approach are at rest: joints of closed loops contradict each other by the rounding of their velocities.
    pub(super) fn stop_joints(
        &mut self,
        joints: &[usize],
        velocities: &mut [f64],
        impulses: &mut [f64],
        outcome: &mut ImpactOutcome,
    ) {
        if !joints.iter().any(|&row| self.is_violated(row, velocities[row])) {
            return;
        }
        let before: Vec<f64> = joints.iter().map(|&row| velocities[row]).collect();
        let solved = self.solve(joints, &before, self.tolerance, outcome);
        self.advance(velocities, joints, &solved.amounts);
        for (&row, impulse) in joints.iter().zip(&solved.amounts) {
            impulses[row] += impulse;
            velocities[row] = 0.0;
        }
    }

    /// Whether a row is to be struck at a velocity: it approaches, or is a joint that moves.
    pub(super) fn is_violated(&self, row: usize, velocity: f64) -> bool {
        velocity < -self.tolerance || (velocity > self.tolerance && self.problem.is_bilateral(row))
    }

    /// The restitution of a row; none at a joint.
    pub(super) fn restitution(&self, restitution: &[f64], row: usize) -> f64 {
        if self.problem.is_bilateral(row) { 0.0 } else { restitution[row] }
    }

    /// Rounding that impulses leave in the velocities, m/s. Where impulses have taken most of a velocity away it is all
    /// that tells two opposite rows apart, and must not pass for bodies that are squeezed.
    pub(super) fn noise(&self, impulses: &[f64]) -> f64 {
        let terms = (0..impulses.len()).map(|row| compensated_terms(self.problem.delassus.row(row), impulses));
        f64::ROUNDING * terms.fold(0.0, f64::max)
    }

    /// Whether there is a velocity at which all rows separate: by the least one with `u >= 1` on all rows.
    pub(super) fn can_separate(&mut self, outcome: &mut ImpactOutcome) -> bool {
        let rows: Vec<usize> = (0..self.problem.u_before.len()).collect();
        outcome.solves += 1;
        self.solver.set_settings(self.problem.settings.solver);
        let constants: Vec<f64> =
            rows.iter().map(|&row| if self.problem.is_bilateral(row) { 0.0 } else { -1.0 }).collect();
        let solution = self.solver.solve_rows(self.problem.contacts, self.problem.delassus, &rows, &constants);
        solution.report.status != SolverStatus::Infeasible
    }

    /// `u += G_{:,rows} p`.
    pub(super) fn advance(&self, velocities: &mut [f64], rows: &[usize], impulses: &[f64]) {
        for (&row, &impulse) in rows.iter().zip(impulses) {
            if impulse != 0.0 {
                axpy(impulse, self.problem.delassus.row(row), velocities);
            }
        }
    }

    /// The outcome when nothing approaches.
    pub(super) fn nothing(&self) -> ImpactOutcome {
        ImpactOutcome {
            impulses: vec![0.0; self.problem.u_before.len()],
            velocities_after: self.problem.u_before.to_vec(),
            ..ImpactOutcome::default()
        }
    }

    /// Ends an impact with total impulses and velocities: rounding of zero becomes zero, what still approaches is
    /// stopped by one inelastic solve, and the energy is booked.
    pub(super) fn conclude(&mut self, mut velocities: Vec<f64>, outcome: &mut ImpactOutcome) {
        let count = velocities.len();
        let mut remains = false;
        for row in 0..count {
            let terms =
                compensated_terms(self.problem.delassus.row(row), &outcome.impulses) + self.problem.u_before[row].abs();
            if velocities[row].abs() <= f64::ROUNDING * terms {
                velocities[row] = 0.0;
            }
            remains |= if self.problem.is_bilateral(row) { velocities[row] != 0.0 } else { velocities[row] < 0.0 };
        }
        if remains {
            let rows: Vec<usize> = (0..count).collect();
            // Row by row velocities have drifted apart over many impulses; those of the total belong together, to the
            // rounding of the velocities before.
            velocities = precise::accelerations(self.problem.contacts, &rows, self.problem.u_before, &outcome.impulses);
            let noise = f64::ROUNDING * largest(self.problem.u_before);
            let last = self.solve(&rows, &velocities, noise, outcome);
            for (total, impulse) in outcome.impulses.iter_mut().zip(&last.amounts) {
                *total += impulse;
            }
            outcome.finishing = last.amounts;
            velocities = last.w;
            if outcome.status == ImpactStatus::Separated {
                outcome.status = ImpactStatus::StoppedAtThreshold;
            }
        }
        outcome.velocities_after = velocities;
        outcome.energy_change = self.energy_change(&outcome.impulses);
        if outcome.energy_change > 0.0 && !gains_energy(self.problem.u_before, outcome) {
            // Rounding must not be in favour of energy: shorten the impulses by as much.
            let gain = compensated_dot(&outcome.impulses, &outcome.velocities_after);
            let shorter = 1.0 - outcome.energy_change / gain;
            if shorter > 1.0 - HELD_ENERGY_ROUNDING.sqrt() {
                outcome.impulses.iter_mut().for_each(|impulse| *impulse *= shorter);
                outcome.energy_change = self.energy_change(&outcome.impulses);
            }
        }
    }

    /// `dT = p.(u- + u+)/2` with `u+ = u- + G p` in twice the precision: at large mass ratios the rounding of `G` would
    /// pass for energy.
    fn energy_change(&self, impulses: &[f64]) -> f64 {
        let rows: Vec<usize> = (0..impulses.len()).collect();
        let after = precise::accelerations(self.problem.contacts, &rows, self.problem.u_before, impulses);
        let mean: Vec<f64> =
            self.problem.u_before.iter().zip(&after).map(|(before, after)| 0.5 * (before + after)).collect();
        compensated_dot(impulses, &mean)
    }

    /// Lists one application for each row with an impulse, for the laws that strike all rows at once: all of it, with
    /// what the last inelastic solve gave.
    pub(super) fn list_applications(&self, outcome: &mut ImpactOutcome) {
        let (mut rows, mut impulses) = (Vec::new(), Vec::new());
        for (row, &impulse) in outcome.impulses.iter().enumerate() {
            if impulse > 0.0 || (impulse < 0.0 && self.problem.is_bilateral(row)) {
                rows.push(row);
                impulses.push(impulse);
            }
        }
        let mut change = vec![0.0; self.problem.u_before.len()];
        self.advance(&mut change, &rows, &impulses);
        outcome.applications = rows
            .iter()
            .zip(&impulses)
            .map(|(&row, &impulse)| {
                let energy_change = impulse * (self.problem.u_before[row] + 0.5 * change[row]);
                Application { row, impulse, energy_change }
            })
            .collect();
    }
}

/// Whether the energy of an outcome rose by more than rounding.
pub(super) fn gains_energy(u_before: &[f64], outcome: &ImpactOutcome) -> bool {
    let speeds = u_before.iter().zip(&outcome.velocities_after).map(|(before, after)| before.abs() + after.abs());
    let size: f64 = outcome.impulses.iter().zip(speeds).map(|(impulse, speed)| 0.5 * impulse.abs() * speed).sum();
    outcome.energy_change > HELD_ENERGY_ROUNDING * size
}

fn compensated_terms(line: &[f64], impulses: &[f64]) -> f64 {
    line.iter().zip(impulses).map(|(entry, impulse)| (entry * impulse).abs()).sum()
}
