//! Problems of all solvers as text, and text as rows and blocks.

use super::problem_text::{ProblemText, TextBlock, TextRow};
use crate::error::ResponseError;
use crate::friction::Blocks;
use crate::friction::problem::FrictionProblem;
use crate::friction::rows_behind::RowsBehind;
use crate::law::Law;
use crate::problem::ContactProblem;
use crate::sparse::BodyProblem;

/// Coordinates of a body in space.
const WIDTH: usize = 6;

impl ProblemText {
    /// Rows, blocks and constant terms of the problem.
    ///
    /// # Errors
    /// When rows or masses are refused.
    pub fn problem(&self) -> Result<(ContactProblem, Blocks, Vec<f64>), ResponseError> {
        let mut problem = ContactProblem::new(self.width, self.inverse_masses.concat())?;
        let (mut blocks, mut constants) = (Blocks::default(), Vec::new());
        for block in &self.blocks {
            let first = problem.len();
            for (place, row) in block.rows.iter().enumerate() {
                let mut unit = vec![0.0; if row.entries.is_empty() { self.width } else { 0 }];
                let number = problem.len();
                if let Some(own) = unit.get_mut(number) {
                    *own = 1.0;
                }
                let mut entries: Vec<(usize, &[f64])> = row.entries.iter().map(|(body, of)| (*body, &of[..])).collect();
                if entries.is_empty() {
                    entries.push((0, &unit));
                }
                if place == 0 && block.law.pushes() {
                    problem.push_row(&entries)?;
                } else {
                    problem.push_held_row(&entries)?;
                    if row.compliance > 0.0 {
                        problem.soften(number, row.compliance)?;
                    }
                }
                constants.push(row.constant);
            }
            blocks.push(block.law, first..problem.len());
        }
        Ok((problem, blocks, constants))
    }
}

impl ContactProblem {
    /// These rows (all when `None`) with their constant terms.
    pub(crate) fn text(&self, rows: Option<&[usize]>, constants: &[f64]) -> ProblemText {
        let rows = rows.map_or_else(|| (0..self.len()).collect(), <[usize]>::to_vec);
        let block = |(&row, &constant): (&usize, &f64)| {
            let soft = self.compliances().iter().find(|(own, _)| *own == row);
            let entries = self.entries(row).map(|entry| (entry.body, entry.jacobian.to_vec()));
            let compliance = soft.map_or(0.0, |soft| soft.1);
            TextBlock {
                law: if self.is_bilateral(row) { Law::Hold { rows: 1 } } else { Law::Push },
                rows: vec![TextRow { constant, compliance, start: 0.0, entries: entries.collect() }],
            }
        };
        ProblemText {
            width: self.width(),
            inverse_masses: (0..self.bodies()).map(|body| self.inverse_mass(body).to_vec()).collect(),
            blocks: rows.iter().zip(constants).map(block).collect(),
        }
    }
}

impl FrictionProblem {
    /// The rows that it comes from; where they are not known, its matrix as the inverse mass of one body.
    pub(crate) fn text(&self, start: Option<&[f64]>) -> ProblemText {
        let mut text = self.matrix_text(start);
        let Some(RowsBehind { problem, rows, scales }) = self.origin() else { return text };
        text.width = problem.width();
        text.inverse_masses = (0..problem.bodies()).map(|body| problem.inverse_mass(body).to_vec()).collect();
        let own = text.blocks.iter_mut().flat_map(|block| &mut block.rows);
        for ((own, &row), scale) in own.zip(rows).zip(scales) {
            let entries = problem.entries(row);
            let scaled = |jacobian: &[f64]| jacobian.iter().map(|value| scale * value).collect();
            own.entries = entries.map(|entry| (entry.body, scaled(entry.jacobian))).collect();
            let soft = problem.compliances().iter().find(|(soft, _)| *soft == row);
            own.compliance = soft.map_or(0.0, |soft| scale * scale * soft.1);
        }
        text
    }

    fn matrix_text(&self, start: Option<&[f64]>) -> ProblemText {
        let size = self.rows();
        let mut matrix = vec![0.0; size * size];
        for line in 0..self.len() {
            for block in self.matrix().blocks(line) {
                let columns = self.range(block.column);
                for (row, values) in self.range(line).zip(block.values.chunks_exact(columns.len().max(1))) {
                    matrix[row * size..][columns.clone()].copy_from_slice(values);
                }
            }
        }
        let row = |row: usize| TextRow {
            constant: self.constant()[row],
            start: start.map_or(0.0, |start| start[row]),
            ..TextRow::default()
        };
        let blocks = self.blocks().iter().enumerate();
        ProblemText {
            width: size,
            inverse_masses: vec![matrix],
            blocks: blocks.map(|(k, &law)| TextBlock { law, rows: self.range(k).map(row).collect() }).collect(),
        }
    }
}

impl BodyProblem {
    /// Its rows over unit masses, as it has them inside.
    pub(crate) fn text(&self, start: Option<&[f64]>) -> ProblemText {
        let mut unit = vec![0.0; WIDTH * WIDTH];
        unit.iter_mut().step_by(WIDTH + 1).for_each(|entry| *entry = 1.0);
        let mut constants = Vec::new();
        self.rates(&self.free, &vec![0.0; self.rows()], &mut constants);
        let blocks = self.blocks.iter().map(|block| {
            let row = |(place, row): (usize, usize)| {
                let entries = block.movable().map(|side| (side.node, self.lines(block, side)[place].to_vec()));
                TextRow {
                    constant: constants[row],
                    compliance: self.compliance[row],
                    start: start.map_or(0.0, |start| start[row]),
                    entries: entries.collect(),
                }
            };
            TextBlock { law: block.law, rows: block.rows.clone().enumerate().map(row).collect() }
        });
        ProblemText { width: WIDTH, inverse_masses: vec![unit; self.movable_bodies()], blocks: blocks.collect() }
    }
}
