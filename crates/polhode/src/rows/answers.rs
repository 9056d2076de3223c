//! What is asked of the rows of an assembly: each question counts as work of the model.

use super::assembly::Assembly;
use crate::model::work;
use polhode_response::{Answer, Ask, Memory, Method, Question, ResponseError, RowProblem, solve};

impl Assembly {
    /// The rows as the problem of which this is known.
    pub(crate) fn with<'a>(&'a self, known: Question<'a>) -> RowProblem<'a> {
        self.work.add_problem(self.problem.len());
        RowProblem { rows: &self.problem, joints: self.joint_rows(), known }
    }

    /// The reactions of the rows: forces (N), impulses (N s), or what displaces bodies.
    ///
    /// # Errors
    /// When a list has another length than there are rows, or a number is not finite.
    #[cfg_attr(feature = "census", track_caller)]
    pub(crate) fn answer(
        &self,
        known: Question<'_>,
        ask: Ask<'_>,
        memory: &mut Memory,
    ) -> Result<Answer, ResponseError> {
        let answer = solve(&self.with(known), ask, memory)?;
        // Linear programmes are solved by an interior point.
        let report = &answer.report;
        if report.tried.contains(Method::InteriorPoint) || report.method == Method::LinearProgramme {
            self.work.add(work::OF_ROW_BY_INTERIOR_POINT * self.problem.len());
        }
        Ok(answer)
    }
}
