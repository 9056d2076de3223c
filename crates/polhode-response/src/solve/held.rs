//! Rows that hold, by the reactions of least norm: joints under given loads.

use super::answer::Answer;
use super::problem::{Ask, Question, RowProblem};
use super::{matrix, way};
use crate::certificate::nan_max;
use crate::dense::householder::PivotedQr;
use crate::dense::kernels::{dot, largest};
use crate::error::{ResponseError, check_length};
use crate::least_norm_hold::LeastNormHold;
use crate::problem::ContactProblem;
use crate::report::{SolverReport, SolverStatus};
use crate::sparse::{ForestSolution, HeldForest};
use crate::tolerances::{DEPENDENT as DEPENDENT_COLUMN, EXACT_ENOUGH};
use std::ops::Range;

/// The reactions of joints that hold against these constant terms: beside their trees, or with the matrix of all rows;
/// with that one also where it is asked for. The velocities of the answer are what is left of the constant terms.
///
/// # Errors
/// When a number is not finite.
#[cfg_attr(feature = "census", track_caller)]
pub(super) fn hold(problem: &RowProblem<'_>, ask: Ask<'_>) -> Result<Answer, ResponseError> {
    let RowProblem { rows, joints, known: Question { constants, .. } } = problem;
    if ask == Ask::Hold
        && let Some(forest) = way::trees(rows, joints.clone())
    {
        let held = hold_beside(rows, &forest, constants, 0.0)?;
        return Ok(Answer { report: report_of(&held.rates, constants), ..held.into() });
    }
    let delassus = matrix::of(rows)?;
    let reactions = LeastNormHold::factor(&delassus)?.solve(&delassus, constants)?;
    let given = delassus.times(&reactions)?;
    let velocities: Vec<f64> = given.iter().zip(*constants).map(|(given, constant)| given + constant).collect();
    let report = report_of(&velocities, constants);
    Ok(Answer { reactions, velocities, report, ..Answer::default() })
}

/// The certificate of reactions that leave this of the constant terms of rows that hold: rows that contradict each
/// other are not solved for.
pub(super) fn report_of(left: &[f64], constants: &[f64]) -> SolverReport {
    let size = largest(constants);
    // A number that is none stays one: it is not solved.
    let left = left.iter().fold(0.0, |most: f64, left| nan_max(most, left.abs()));
    let residual = if left == 0.0 { 0.0 } else { left / size };
    let is_held = residual <= EXACT_ENOUGH;
    let status = if is_held { SolverStatus::Solved } else { SolverStatus::Inaccurate };
    SolverReport { status, residual, ..SolverReport::default() }
}

/// The same where trees of joints are eliminated first, of rows that are open by this part of the size of their bodies.
#[cfg_attr(feature = "census", track_caller)]
pub(super) fn hold_beside(
    rows: &ContactProblem,
    forest: &HeldForest,
    constants: &[f64],
    opened: f64,
) -> Result<ForestSolution, ResponseError> {
    let of_others = if forest.others().is_empty() {
        Vec::new()
    } else {
        let beside = forest.beside(rows);
        let of_others = forest.constants_beside(rows, constants)?;
        LeastNormHold::factor_beside(&beside, opened)?.solve(&beside.delassus, &of_others)?
    };
    forest.with_others(rows, constants, &of_others)
}

/// How far rows are from depending on each other.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct Independence {
    /// How many do not.
    pub rank: usize,
    /// The least pivot of their Jacobian in the metric of bodies of one mass, relative to the largest (no unit): it
    /// falls linearly with the distance from where one row more depends on the others. 0 without rows.
    pub least: f64,
}

/// The roots of the inverse masses of all coordinates, where each body's mass is scaled so that its largest inverse
/// mass at a row is 1.
fn roots_of_alike_inverse_masses(rows: &ContactProblem) -> Vec<f64> {
    let of_body = |(body, largest): (usize, f64)| {
        let diagonal = rows.inverse_mass(body).iter().step_by(rows.width() + 1);
        diagonal.map(move |own| if largest > 0.0 { (own / largest).sqrt() } else { own.sqrt() })
    };
    rows.largest_inverse_masses().into_iter().enumerate().flat_map(of_body).collect()
}

/// Rows that hold and may depend on each other, as those of the joints of a mechanism with more supports than it needs:
/// which of their reactions do the same.
///
/// Many reactions do the same then. Taken are those of least norm: with `f` (N) of the rows, `sum f^2`, for a joint
/// whose rows are along directions and about axes at right angles `|force|^2 + |moment / l|^2` with its length `l`. So
/// they turn with the bodies, whatever solver found reactions that do the same, and whatever the masses are.
///
/// Method: reactions do nothing beside the range of the Jacobian `J`, whose columns are those of the velocities of the
/// bodies; QR factorisation with column pivoting finds it. Which rows depend is decided in the metric of bodies of one
/// mass, at the square root of the cut of rows that are held while contacts slide: that one is of `J M^-1 J^T`. Source:
/// Golub and Van Loan 2013, 5.4 and 5.5.
#[derive(Debug)]
pub struct Supports {
    /// Factors of `J`.
    factor: PivotedQr,
    /// Whether bodies can move along each row.
    moves: Vec<bool>,
}

impl Supports {
    /// Those of some of these rows.
    pub fn of(rows: &ContactProblem, held: Range<usize>) -> Self {
        let (width, count) = (rows.width(), held.len());
        let metric = roots_of_alike_inverse_masses(rows);
        let mut jacobian = vec![0.0; metric.len() * count];
        for (place, row) in held.clone().enumerate() {
            for entry in rows.entries(row) {
                let of_body = entry.body * width..(entry.body + 1) * width;
                for ((own, root), k) in entry.jacobian.iter().zip(&metric[of_body.clone()]).zip(of_body) {
                    jacobian[k * count + place] += own * root;
                }
            }
        }
        let factor = PivotedQr::factor(count, rows.bodies() * width, jacobian, DEPENDENT_COLUMN.sqrt());
        Self { factor, moves: held.map(|row| rows.mobility(row) > 0.0).collect() }
    }

    /// How far the rows that are independent are from depending on each other.
    pub fn independence(&self) -> Independence {
        Independence { rank: self.factor.rank(), least: self.factor.least_pivot() }
    }

    /// Leaves of reactions, one for each row, the least ones that do the same.
    ///
    /// # Errors
    /// When there is not one reaction for each row.
    pub fn leave_least(&self, reactions: &mut [f64]) -> Result<(), ResponseError> {
        check_length("reactions", self.moves.len(), reactions.len())?;
        let mut idle = reactions.to_vec();
        self.factor.remove_range(&mut idle);
        reactions.iter_mut().zip(&idle).for_each(|(own, idle)| *own -= idle);
        Ok(())
    }

    /// Whether other reactions bear a part of some as well: beyond rounding, which is squared. Rows that nothing can
    /// move, as those across the plane of a planar motion, bear nothing of them.
    ///
    /// # Errors
    /// When there is not one reaction for each row.
    pub fn leave_open(&self, mut reactions: Vec<f64>) -> Result<bool, ResponseError> {
        check_length("reactions", self.moves.len(), reactions.len())?;
        reactions.iter_mut().zip(&self.moves).for_each(|(own, moves)| *own *= f64::from(u8::from(*moves)));
        let whole = dot(&reactions, &reactions);
        self.factor.remove_range(&mut reactions);
        Ok(dot(&reactions, &reactions) > DEPENDENT_COLUMN * whole)
    }
}
