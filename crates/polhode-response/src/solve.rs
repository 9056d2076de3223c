//! One entry for all problems of rows and blocks: it chooses the solver.
//!
//! Without friction the problem is a complementarity problem, solved exactly by an active set
//! ([`complementarity`](crate::complementarity)); with friction in any block it is one over cones
//! ([`friction`](crate::friction)). Which of the two is decided here. (The crate `polhode` does
//! not call it yet: it keeps its solvers and their warm starts from step to step.)

use crate::complementarity::{ComplementaritySolver, WarmStart};
use crate::delassus::Delassus;
use crate::error::{ResponseError, check_length};
use crate::friction::{Blocks, FrictionSettings};
use crate::problem::ContactProblem;
use crate::report::SolverReport;
use crate::settings::SolverSettings;

/// Settings of both kinds of problems.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct SolveSettings {
    /// Of problems without friction.
    pub smooth: SolverSettings,
    /// Of problems with friction.
    pub friction: FrictionSettings,
}

/// Reactions of all rows.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct Solution {
    /// `r`, one for each row: forces (N) or impulses (N s).
    pub reactions: Vec<f64>,
    /// `u = G r + b`: accelerations (m/s^2) or velocities (m/s).
    pub velocities: Vec<f64>,
    /// The certificate.
    pub report: SolverReport,
}

/// Solves a problem of rows and blocks with the constant terms `b`: accelerations without forces (m/s^2) or velocities
/// without impulses (m/s). `start` are reactions of a similar problem, one for each row.
///
/// ```
/// use polhode_response::{ContactProblem, Law, SolveSettings, solve};
/// // A block of 2 kg on a floor, pushed down with 20 N and along with 8 N: friction of 0.5 holds it, 0.3 does not.
/// for (friction, acceleration) in [(0.5, 0.0), (0.3, 1.0), (0.0, 4.0)] {
///     let mut problem = ContactProblem::new(2, vec![0.5, 0.0, 0.0, 0.5])?;
///     problem.push_block(Law::Cone { rows: 2, friction }, &[&[(0, &[0.0, 1.0])], &[(0, &[1.0, 0.0])]])?;
///     let solution = solve(&problem, &problem.delassus(), &[-10.0, 4.0], None, &SolveSettings::default())?;
///     assert!((solution.velocities[1] - acceleration).abs() < 1e-12);
/// }
/// # Ok::<(), polhode_response::ResponseError>(())
/// ```
///
/// A problem that is not solved is no error: see the status of the report.
///
/// # Errors
/// When a list has another length than the problem has rows, a number is not finite, or a setting is out of range.
#[cfg_attr(feature = "census", track_caller)]
pub fn solve(
    problem: &ContactProblem,
    delassus: &Delassus,
    b: &[f64],
    start: Option<&[f64]>,
    settings: &SolveSettings,
) -> Result<Solution, ResponseError> {
    check_length("Delassus matrix", problem.len(), delassus.len())?;
    check_length("constant terms", problem.len(), b.len())?;
    if let Some(start) = start {
        check_length("start", problem.len(), start.len())?;
    }
    if problem.has_friction() {
        let solved = Blocks::of(problem).solve(delassus, b, start, &settings.friction)?;
        return Ok(Solution { reactions: solved.reactions, velocities: solved.velocities, report: solved.report });
    }
    let carrying = |start: &[f64]| (0..start.len()).filter(|&row| start[row] != 0.0).collect();
    let warm = start.map(|start| WarmStart::new(carrying(start)));
    let mut solver = ComplementaritySolver::new(settings.smooth);
    let solved = solver.solve(problem, delassus, b, warm.as_ref())?;
    Ok(Solution {
        reactions: solved.forces.clone(),
        velocities: solved.residual_accelerations.clone(),
        report: solved.report,
    })
}
