//! A part of an impact at several contacts: blocks that move each other, with velocities and impulses so far.

use crate::dense::kernels::compensated_dot;
use crate::error::ResponseError;
use crate::friction::coulomb_cone::put_parts_into_discs;
use crate::friction::rows_behind::RowsBehind;
use crate::friction::{BlockMatrix, FrictionProblem, FrictionSettings, FrictionSolution, solve_friction};
use crate::impact::ImpactStatus;
use crate::law::Law;
use crate::report::SolverStatus;
use crate::solve::way::IMPACT_MOST_ROWS;
use crate::sparse::BodySolver;
use crate::sparse::from_blocks::solve_behind;
use std::ops::Range;

/// A rise of energy above this fraction of `sum |p_i| (|u_i-| + |u_i+|) / 2` is real (no unit): cone problems are
/// solved to some 1e-13 of the velocities.
pub(super) const CONE_ENERGY_ROUNDING: f64 = 1e-11;

/// Blocks that move each other, and what is known of the impact there.
#[derive(Debug, Clone)]
pub(super) struct Part {
    /// The blocks with the velocities before as constant terms.
    pub(super) contacts: FrictionProblem,
    /// Restitution of each block; 0 for joints.
    pub(super) restitution: Vec<f64>,
    pub(super) settings: FrictionSettings,
    /// Normal velocities above `-tolerance` do not approach, m/s.
    pub(super) tolerance: f64,
    pub(super) solves: usize,
    pub(super) residual: f64,
    pub(super) status: ImpactStatus,
    /// For parts of many rows.
    bodies: BodySolver,
}

impl Part {
    /// The blocks `chosen` of a problem.
    pub(super) fn of(
        contacts: &FrictionProblem,
        restitution: &[f64],
        chosen: &[usize],
        settings: FrictionSettings,
    ) -> Result<Self, ResponseError> {
        let contacts = chosen_blocks(contacts, chosen, contacts.constant())?;
        let restitution = chosen.iter().map(|&block| restitution[block]).collect();
        let status = ImpactStatus::NoApproach;
        let bodies = BodySolver::default();
        Ok(Self { contacts, restitution, settings, tolerance: 0.0, solves: 0, residual: 0.0, status, bodies })
    }

    /// Whether a block is a joint's.
    pub(super) fn is_joint(&self, block: usize) -> bool {
        self.contacts.blocks()[block].friction().is_none()
    }

    /// The blocks of joints.
    pub(super) fn joints(&self) -> Vec<usize> {
        (0..self.contacts.len()).filter(|&block| self.is_joint(block)).collect()
    }

    /// The blocks of contacts.
    pub(super) fn touching(&self) -> Vec<usize> {
        (0..self.contacts.len()).filter(|&block| !self.is_joint(block)).collect()
    }

    /// The normal row of a contact.
    pub(super) fn normal_row(&self, block: usize) -> usize {
        self.contacts.range(block).start
    }

    /// The rows of a contact without those of its rotations.
    pub(super) fn contact_rows(&self, block: usize) -> Range<usize> {
        let (range, [(slip, _), ..]) = (self.contacts.range(block), self.contacts.blocks()[block].parts());
        range.start..range.start + slip.end
    }

    /// The contacts that approach.
    pub(super) fn approaching(&self, velocities: &[f64]) -> Vec<usize> {
        let approaches =
            |block: &usize| !self.is_joint(*block) && velocities[self.normal_row(*block)] < -self.tolerance;
        (0..self.contacts.len()).filter(approaches).collect()
    }

    /// Says that a cone problem was needed and not solved.
    pub(super) fn not_solved(&mut self) {
        self.status = self.status.max(ImpactStatus::NotSolved);
    }

    /// Takes rounding out of the velocities of joints that are held.
    pub(super) fn hold_joints(&self, velocities: &mut [f64]) {
        for block in self.joints() {
            velocities[self.contacts.range(block)].fill(0.0);
        }
    }

    /// Whether a joint moves.
    pub(super) fn joints_move(&self, velocities: &[f64]) -> bool {
        self.joints().iter().any(|&block| velocities[self.contacts.range(block)].iter().any(|u| *u != 0.0))
    }

    /// Solves the cone problem of the blocks `chosen` for constant terms of all rows.
    pub(super) fn solve(
        &mut self,
        chosen: &[usize],
        constant: &[f64],
        start: Option<&[f64]>,
    ) -> Result<ConeAnswer, ResponseError> {
        let problem = chosen_blocks(&self.contacts, chosen, constant)?;
        let rows: Vec<usize> = chosen.iter().flat_map(|&block| self.contacts.range(block)).collect();
        // From zero where nothing is known: Newton's method finds the same answer for contacts in any order, while
        // sweeps prefer those that come first, where the impulses are not unique.
        let start: Vec<f64> = rows.iter().map(|&row| start.map_or(0.0, |start| start[row])).collect();
        let system = (&mut self.bodies, &self.settings);
        // Bodies that some force cannot move have no factor.
        let in_bodies = problem
            .rows_behind()
            .and_then(|behind| solve_behind((problem.blocks(), behind), problem.constant(), &start, system).ok());
        let is_left = |solution: &FrictionSolution| {
            solution.report.status == SolverStatus::Solved || start.len() > IMPACT_MOST_ROWS
        };
        let solution = match in_bodies.filter(is_left) {
            Some(solution) => solution,
            None => solve_friction(&problem, Some(&start), &self.settings)?,
        };
        self.solves += 1;
        let is_solved = solution.report.status == SolverStatus::Solved;
        if is_solved {
            self.residual = self.residual.max(solution.report.residual);
        }
        let mut impulses = vec![0.0; self.contacts.rows()];
        for (&row, impulse) in rows.iter().zip(&solution.reactions) {
            impulses[row] = *impulse;
        }
        for &block in chosen {
            self.put_into_cone(block, &mut impulses);
        }
        Ok(ConeAnswer { impulses, solution, is_solved })
    }

    /// Takes what rounding has left outside of the cone of a contact out of its impulse.
    pub(super) fn put_into_cone(&self, block: usize, impulses: &mut [f64]) {
        let block_of = self.contacts.blocks()[block];
        if block_of.friction().is_some() {
            put_parts_into_discs(block_of, &mut impulses[self.contacts.range(block)]);
        }
    }

    /// `u + G p`.
    pub(super) fn after(&self, velocities: &[f64], impulses: &[f64]) -> Vec<f64> {
        let mut after = Vec::new();
        self.contacts.matrix().times_plus(impulses, velocities, &mut after);
        after
    }
}

/// The answer of a cone problem.
#[derive(Debug, Clone)]
pub(super) struct ConeAnswer {
    /// Impulses of all rows of the part.
    pub(super) impulses: Vec<f64>,
    /// The solution for the chosen blocks.
    pub(super) solution: FrictionSolution,
    pub(super) is_solved: bool,
}

/// What impulses have done to a part so far. Works are by block.
#[derive(Debug, Clone)]
pub(super) struct Struck {
    pub(super) impulses: Vec<f64>,
    pub(super) velocities: Vec<f64>,
    /// Of normal rows; of all rows of joints.
    pub(super) normal_work: Vec<f64>,
    pub(super) friction_work: Vec<f64>,
    pub(super) energy_rises: bool,
    /// Impulses at single contacts.
    pub(super) applications: usize,
}

impl Struck {
    /// Nothing yet.
    pub(super) fn nothing(part: &Part, velocities: &[f64]) -> Self {
        let blocks = part.contacts.len();
        Self {
            impulses: vec![0.0; velocities.len()],
            velocities: velocities.to_vec(),
            normal_work: vec![0.0; blocks],
            friction_work: vec![0.0; blocks],
            energy_rises: false,
            applications: 0,
        }
    }

    /// Adds impulses that lead to these velocities, with their works along the straight way there.
    pub(super) fn add(&mut self, part: &Part, impulses: &[f64], velocities: Vec<f64>) {
        for block in 0..part.contacts.len() {
            let range = part.contacts.range(block);
            for row in range.clone() {
                let work = 0.5 * impulses[row] * (self.velocities[row] + velocities[row]);
                let is_normal = row == range.start || part.is_joint(block);
                let works = if is_normal { &mut self.normal_work } else { &mut self.friction_work };
                works[block] += work;
                self.impulses[row] += impulses[row];
            }
        }
        self.velocities = velocities;
    }
}

/// Change of energy by impulses, `p.(u- + u+)/2`, and the size of its terms, J.
pub(super) fn energy(impulses: &[f64], before: &[f64], after: &[f64]) -> (f64, f64) {
    let mean: Vec<f64> = before.iter().zip(after).map(|(before, after)| 0.5 * (before + after)).collect();
    let speeds = before.iter().zip(after).map(|(before, after)| 0.5 * (before.abs() + after.abs()));
    let size = impulses.iter().zip(speeds).map(|(impulse, speed)| impulse.abs() * speed).sum();
    (compensated_dot(impulses, &mean), size)
}

/// The problem of some blocks, with the constant terms of all rows given.
fn chosen_blocks(
    contacts: &FrictionProblem,
    chosen: &[usize],
    constant: &[f64],
) -> Result<FrictionProblem, ResponseError> {
    let mut place = vec![None; contacts.len()];
    for (index, &block) in chosen.iter().enumerate() {
        place[block] = Some(index);
    }
    let matrix = contacts.matrix();
    let mut entries = Vec::new();
    for (row, &block) in chosen.iter().enumerate() {
        for entry in matrix.blocks(block) {
            if let Some(column) = place[entry.column] {
                entries.push((row, column, entry.values.to_vec()));
            }
        }
    }
    let blocks: Vec<Law> = chosen.iter().map(|&block| contacts.blocks()[block]).collect();
    let sizes: Vec<usize> = blocks.iter().map(|block| block.rows()).collect();
    let constant = chosen.iter().flat_map(|&block| constant[contacts.range(block)].iter().copied()).collect();
    let of_rows = |behind: &RowsBehind| behind.of_rows(chosen.iter().flat_map(|&block| contacts.range(block)));
    let rows = contacts.rows_behind().map(of_rows);
    let problem = FrictionProblem::new(blocks, BlockMatrix::from_blocks(&sizes, entries)?, constant)?;
    #[cfg(feature = "census")]
    let problem = problem.with_origin(contacts.origin().map(of_rows));
    Ok(problem.with_rows(rows))
}
