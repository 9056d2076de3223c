//! Problems as text, made into rows and blocks.

use crate::error::ResponseError;
use crate::friction::Blocks;
use crate::problem::ContactProblem;
use crate::problem_text::ProblemText;

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
                // A soft row along a normal is that of a bearing: what presses it is given.
                let is_soft = row.compliance > 0.0;
                if place == 0 && block.law.pushes() && !is_soft {
                    problem.push_row(&entries)?;
                } else {
                    problem.push_held_row(&entries)?;
                }
                if is_soft {
                    problem.soften(number, row.compliance)?;
                }
                constants.push(row.constant);
            }
            blocks.push(block.law, first..problem.len());
        }
        Ok((problem, blocks, constants))
    }
}
