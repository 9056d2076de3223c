//! Complementarity problems of bodies in trees of joints: the joints are eliminated first, what is left is a problem of
//! contacts, limits and loops.
//!
//! The answer is one for all rows, with the certificate of the problem that is left; its residual is the larger one of
//! that and of the rows of the trees. Where nothing is left it is that of the trees alone.

use super::{ComplementaritySolver, ContactSolution, WarmStart};
use crate::certificate::nan_max;
use crate::error::{ResponseError, check_finite, check_length};
use crate::problem::ContactProblem;
use crate::report::{SolverReport, SolverStatus};
use crate::sparse::HeldForest;

impl ComplementaritySolver {
    /// As [`solve`](Self::solve), with the trees of the problem in the place of its matrix.
    ///
    /// # Errors
    /// Those of [`solve`](Self::solve).
    #[cfg_attr(feature = "census", track_caller)]
    pub fn solve_with_forest(
        &mut self,
        problem: &ContactProblem,
        forest: &HeldForest,
        b: &[f64],
        warm_start: Option<&WarmStart>,
    ) -> Result<ContactSolution, ResponseError> {
        problem.check_frictionless()?;
        check_length("constant terms", problem.len(), b.len())?;
        check_finite("constant terms", b)?;
        let others = forest.others();
        let mut of_others = ContactSolution {
            report: SolverReport { certified: true, ..SolverReport::default() },
            ..ContactSolution::default()
        };
        if !others.is_empty() {
            let beside = forest.beside(problem);
            let constants = forest.constants_beside(problem, b)?;
            let place = |row: &usize| others.binary_search(row).ok();
            let start = warm_start.map(|start| WarmStart::new(start.rows().iter().filter_map(place).collect()));
            of_others = self.solve(&beside.problem, &beside.delassus, &constants, start.as_ref())?.clone();
        }
        let found = forest.with_others(problem, b, &of_others.forces)?;
        let mut whole = ContactSolution {
            forces: found.forces,
            residual_accelerations: vec![0.0; problem.len()],
            held: vec![true; problem.len()],
            squeeze: Vec::new(),
            warm_start: WarmStart::new(of_others.warm_start.rows().iter().map(|&place| others[place]).collect()),
            report: of_others.report,
        };
        for (place, &row) in others.iter().enumerate() {
            whole.residual_accelerations[row] = of_others.residual_accelerations[place];
            whole.held[row] = of_others.held[place];
        }
        if !of_others.squeeze.is_empty() {
            let unloaded = vec![0.0; problem.len()];
            whole.squeeze = forest.with_others(problem, &unloaded, &of_others.squeeze)?.forces;
        }
        let report = &mut whole.report;
        report.residual = nan_max(report.residual, found.residual);
        report.rank += forest.held();
        report.bound += found.bound;
        // Written so that NaN is not solved.
        let is_held = found.residual <= self.settings().acceptance;
        if !is_held && report.status == SolverStatus::Solved {
            (report.status, report.certified) = (SolverStatus::Inaccurate, false);
        }
        Ok(whole)
    }
}
