//! Problems of all solvers as text.

use crate::friction::problem::FrictionProblem;
use crate::friction::rows_behind::RowsBehind;
use crate::law::Law;
use crate::problem::ContactProblem;
use crate::problem_text::{ProblemText, TextBlock, TextRow};
use crate::sparse::BodyProblem;

/// Coordinates of a body in space.
const WIDTH: usize = 6;

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

#[cfg(test)]
mod tests {
    //! What is written is read again, and is the problem that it was made of.
    #![allow(clippy::unwrap_used, reason = "a test that cannot go on has failed")]
    use super::*;
    use crate::friction::{Blocks, FrictionSettings, solve_friction};

    #[test]
    fn a_problem_is_read_as_it_was_written_and_has_the_same_answer() {
        let contact = Law::Cone { rows: 3, friction: 0.5 };
        let matrix = [0.5, 0.1, 0.0, 0.1, 0.6, 0.0, 0.0, 0.0, 0.7];
        let problem = FrictionProblem::from_dense(vec![contact], &matrix, vec![-3.0, 4.0, 1.0]).unwrap();
        let text = problem.text(None).written(&[("asked", "step".to_owned())]);
        let (read, facts) = ProblemText::read(&text).unwrap();
        assert_eq!(facts, [("asked".to_owned(), "step".to_owned())]);
        assert_eq!(read, problem.text(None));
        let (rows, blocks, constants): (_, Blocks, _) = read.problem().unwrap();
        let settings = FrictionSettings::default();
        let again = blocks.solve(&rows.delassus(), &constants, None, &settings).unwrap();
        assert_eq!(again.reactions, solve_friction(&problem, None, &settings).unwrap().reactions);
    }
}
