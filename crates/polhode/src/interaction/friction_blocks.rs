//! The rows of an assembly in the blocks that Coulomb's law is stated for.
//!
//! An assembly holds all normal rows first, then those of pivots, then those along tangents. The solver takes the rows of
//! one contact together. Solutions come back in the order of the assembly.

use polhode_response::friction::{
    ContactStatus, FrictionBlock, FrictionMethod, FrictionProblem, FrictionSettings, solve_friction,
};
use polhode_response::{Delassus, Method, ResponseError, SolverReport};
use std::ops::Range;

/// Most rows of one block.
const MOST_ROWS: usize = 3;

/// Blocks of rows.
#[derive(Debug, Clone, Default)]
pub(crate) struct FrictionBlocks {
    blocks: Vec<FrictionBlock>,
    /// The rows of the assembly, in the order of the blocks.
    rows: Vec<usize>,
}

/// Reactions and velocities (forces and accelerations) of all rows, in the order of the assembly.
#[derive(Debug)]
pub(crate) struct RowSolution {
    pub(crate) reactions: Vec<f64>,
    pub(crate) velocities: Vec<f64>,
    /// What the block of each contact does.
    pub(crate) statuses: Vec<ContactStatus>,
    pub(crate) report: SolverReport,
}

impl FrictionBlocks {
    /// Adds a block of these rows.
    pub(crate) fn push(&mut self, block: FrictionBlock, rows: impl Iterator<Item = usize>) {
        self.blocks.push(block);
        self.rows.extend(rows);
    }

    /// How many blocks.
    pub(crate) fn len(&self) -> usize {
        self.blocks.len()
    }

    /// Adds rows that are held, whatever the sign of their reactions.
    pub(crate) fn push_held(&mut self, rows: Range<usize>) {
        for start in rows.clone().step_by(MOST_ROWS) {
            let end = (start + MOST_ROWS).min(rows.end);
            self.push(FrictionBlock::Bilateral { rows: end - start }, start..end);
        }
    }

    /// The problem of these blocks: `delassus` and `constants` are of the rows of the assembly.
    ///
    /// # Errors
    /// When a number is not finite.
    pub(crate) fn problem(&self, delassus: &Delassus, constants: &[f64]) -> Result<FrictionProblem, ResponseError> {
        let rows = &self.rows;
        let matrix: Vec<f64> = rows.iter().flat_map(|&i| rows.iter().map(move |&j| delassus.get(i, j))).collect();
        let constants = rows.iter().map(|&row| constants[row]).collect();
        FrictionProblem::from_dense(self.blocks.clone(), &matrix, constants)
    }

    /// Numbers in the order of the blocks, put into that of the assembly; rows without a block have zero.
    pub(crate) fn in_rows(&self, of_blocks: &[f64]) -> Vec<f64> {
        let rows = self.rows.iter().max().map_or(0, |row| row + 1);
        let mut of_rows = vec![0.0; rows];
        for (&row, &value) in self.rows.iter().zip(of_blocks) {
            of_rows[row] = value;
        }
        of_rows
    }

    /// Numbers of the rows of the assembly, put into the order of the blocks.
    pub(crate) fn of_rows(&self, of_rows: &[f64]) -> Vec<f64> {
        self.rows.iter().map(|&row| of_rows[row]).collect()
    }

    /// Solves for the reactions; `start` are reactions of a similar problem, in the order of the assembly.
    ///
    /// # Errors
    /// When a number is not finite.
    pub(crate) fn solve(
        &self,
        delassus: &Delassus,
        constants: &[f64],
        start: Option<&[f64]>,
        settings: &FrictionSettings,
    ) -> Result<RowSolution, ResponseError> {
        let problem = self.problem(delassus, constants)?;
        let start: Option<Vec<f64>> = start.map(|start| self.rows.iter().map(|&row| start[row]).collect());
        let zero = vec![0.0; self.rows.len()];
        let start = start.as_deref().unwrap_or(&zero);
        let solved = solve_friction(&problem, Some(start), settings)?;
        let method = match solved.report.method {
            FrictionMethod::WarmNewton => Method::WarmStart,
            FrictionMethod::GaussSeidel | FrictionMethod::Newton => Method::ActiveSet,
            _ => Method::ColdStart,
        };
        let report = SolverReport {
            status: solved.report.status,
            method,
            iterations: solved.report.iterations(),
            residual: solved.report.residual,
            ..SolverReport::default()
        };
        Ok(RowSolution {
            reactions: self.in_rows(&solved.reactions),
            velocities: self.in_rows(&solved.velocities),
            statuses: solved.statuses,
            report,
        })
    }
}
