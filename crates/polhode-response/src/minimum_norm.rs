//! The least forces among all that give the same motion.
//!
//! Where `G` is rank-deficient the motion does not fix the forces: a beam on three pillars, a table on four legs, any
//! tower of boxes. Every solution shares the set `S` of held rows (`w = 0`), and the forces that give the same motion
//! are `{f >= 0, f = 0 outside S, J_S^T f = J_S^T f_0}`. The one of least Euclidean norm is unique, hence independent
//! of the order of the rows, and symmetric where the scene is: it is what equal springs at the contacts would give.
//!
//! Method: `f = P f_0 + N N^T lambda`, with `P = I - N N^T` the projector on the range of `J_S` (by a pivoted QR of
//! `J_S` with columns scaled, so that neither units nor masses matter), and the multipliers of `f >= 0` solve
//! `0 <= lambda _|_ f >= 0`: a complementarity problem again, with matrix `N N^T`.
//!
//! Source: Moreau's least-norm selection; Lawson and Hanson, Solving Least Squares Problems, chapter 23 (least
//! distance programming); cases RC-07 and RC-17. Failure: when the multipliers are not found or the choice is too
//! ill-conditioned to keep the motion, the forces of the solution are kept and the result says so.

use crate::complementarity::ContactSolution;
use crate::complementarity::active_set::{ActiveSet, Outcome, Problem};
use crate::complementarity::rank::Rank;
use crate::dense::householder::PivotedQr;
use crate::dense::kernels::{axpy, dot, largest};
use crate::dense::scalar::Scalar;
use crate::error::{ResponseError, check_finite, check_length};
use crate::problem::ContactProblem;
use crate::settings::SolverSettings;
use crate::tolerances::LEAST_CHANGE;
use polhode_spatial::rounding;

/// Least forces that change the motion by more than this fraction of its terms are not used (no unit): contacts almost
/// in one place or line make the choice ill-conditioned, and the motion comes first.
const MOTION_LIMIT: f64 = 1e-11;

/// Forces of least norm.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct MinimumNormForces {
    /// `f`, not negative on unilateral rows.
    pub forces: Vec<f64>,
    /// Dimension of the family of forces of one motion: number of held rows less the rank of `J_S`.
    pub freedom: usize,
    /// Largest change of the motion, `|J^T (f - f_0)|` relative to the largest sum of terms of the same body (no
    /// unit): rounding.
    pub motion_change: f64,
    /// Whether the forces are those of least norm; otherwise they are those of the solution.
    pub minimal: bool,
}

/// The least forces among all that give the motion of `solution`.
///
/// # Errors
/// When the solution does not belong to the problem or its forces are not finite, or a setting is out of range.
pub fn minimum_norm(
    problem: &ContactProblem,
    solution: &ContactSolution,
    settings: &SolverSettings,
) -> Result<MinimumNormForces, ResponseError> {
    check_length("forces", problem.len(), solution.forces.len())?;
    check_length("held rows", problem.len(), solution.held.len())?;
    check_finite("forces", &solution.forces)?;
    settings.check()?;
    let rows: Vec<usize> = (0..problem.len()).collect();
    Ok(least_norm(problem, &rows, solution, settings))
}

/// [`minimum_norm`] for a solution of `rows` alone, in the order of `rows`.
pub(crate) fn least_norm(
    problem: &ContactProblem,
    rows: &[usize],
    solution: &ContactSolution,
    settings: &SolverSettings,
) -> MinimumNormForces {
    // The forces of the solution may stand on rows that are held only nearly; those rows take part as well.
    let positions: Vec<usize> = (0..rows.len()).filter(|&k| solution.held[k] || solution.forces[k] != 0.0).collect();
    let unchanged =
        |freedom, minimal| MinimumNormForces { forces: solution.forces.clone(), freedom, motion_change: 0.0, minimal };
    if positions.is_empty() || solution.report.rank == positions.len() {
        return unchanged(0, true);
    }
    let held: Vec<usize> = positions.iter().map(|&k| rows[k]).collect();
    let given: Vec<f64> = positions.iter().map(|&k| solution.forces[k]).collect();
    let bilateral: Vec<bool> = held.iter().map(|&row| problem.is_bilateral(row)).collect();
    let jacobian = ScaledJacobian::new(problem, &held);
    let qr = jacobian.factor(settings);
    let freedom = held.len() - qr.rank();
    if freedom == 0 {
        return unchanged(0, true);
    }
    let Some(mut least) = admissible_least(&qr, &given, &bilateral, settings) else { return unchanged(freedom, false) };
    let mut motion_change = jacobian.motion_change(&given, &least);
    for cut in [rounding::HALF_OF_THE_DIGITS, settings.null_space_cut] {
        if motion_change > LEAST_CHANGE {
            let restored = jacobian.restored_motion(&given, &least, &bilateral, cut);
            let change = jacobian.motion_change(&given, &restored);
            if change < motion_change {
                (least, motion_change) = (restored, change);
            }
        }
    }
    if motion_change > MOTION_LIMIT {
        return unchanged(freedom, false);
    }
    let mut forces = vec![0.0; rows.len()];
    for (&position, &force) in positions.iter().zip(&least) {
        forces[position] = force;
    }
    MinimumNormForces { forces, freedom, motion_change, minimal: true }
}

/// The columns of `J_S` that are not zero, each scaled to length 1, column-major.
#[derive(Debug)]
struct ScaledJacobian {
    rows: usize,
    matrix: Vec<f64>,
    /// The body of each column.
    bodies: Vec<usize>,
}

impl ScaledJacobian {
    fn new(problem: &ContactProblem, held: &[usize]) -> Self {
        let (width, rows) = (problem.width(), held.len());
        let mut dense = vec![0.0; problem.bodies() * width * rows];
        for (line, &row) in held.iter().enumerate() {
            for entry in problem.entries(row) {
                for (component, value) in entry.jacobian.iter().enumerate() {
                    dense[(entry.body * width + component) * rows + line] = *value;
                }
            }
        }
        let (mut matrix, mut bodies) = (Vec::new(), Vec::new());
        for (index, column) in dense.chunks_exact(rows).enumerate() {
            let size = largest(column);
            if size > 0.0 {
                // Scaling by the largest entry first keeps the squares from overflowing.
                let length = column.iter().map(|value| (value / size) * (value / size)).sum::<f64>().sqrt();
                matrix.extend(column.iter().map(|value| value / size / length));
                bodies.push(index / width);
            }
        }
        Self { rows, matrix, bodies }
    }

    fn factor(&self, settings: &SolverSettings) -> PivotedQr {
        PivotedQr::factor(self.rows, self.bodies.len(), self.matrix.clone(), settings.null_space_cut)
    }

    fn columns(&self) -> impl Iterator<Item = &[f64]> {
        self.matrix.chunks_exact(self.rows)
    }

    /// Takes rounding out of the motion by the least change of the forces that are not zero.
    ///
    /// The orthogonal transformations mix large and small forces; at a mass ratio of 1e6 their rounding is no longer
    /// small for the light bodies, so the part of it that moves bodies is removed.
    fn restored_motion(&self, given: &[f64], forces: &[f64], bilateral: &[bool], cut: f64) -> Vec<f64> {
        let mut forces = forces.to_vec();
        let free: Vec<usize> = (0..self.rows).filter(|&k| forces[k] > 0.0 || bilateral[k]).collect();
        if free.is_empty() {
            return forces;
        }
        let reduced: Vec<f64> = self.columns().flat_map(|column| free.iter().map(|&k| column[k])).collect();
        let qr = PivotedQr::factor(free.len(), self.bodies.len(), reduced, cut);
        for _ in 0..2 {
            let difference: Vec<f64> = given.iter().zip(&forces).map(|(a, b)| a - b).collect();
            let defect: Vec<f64> = self.columns().map(|column| dot(column, &difference)).collect();
            for (&k, correction) in free.iter().zip(qr.solve_transpose(&defect)) {
                forces[k] = admitted(bilateral[k], forces[k] + correction);
            }
        }
        forces
    }

    /// `|J^T (f - f_0)|` relative to the largest sum of terms of the same body, the largest over all bodies.
    fn motion_change(&self, given: &[f64], forces: &[f64]) -> f64 {
        let mut worst: f64 = 0.0;
        let columns: Vec<(usize, &[f64])> = self.bodies.iter().copied().zip(self.columns()).collect();
        for body in columns.chunk_by(|a, b| a.0 == b.0) {
            let (mut change, mut terms) = (0.0_f64, 0.0_f64);
            for (_, column) in body {
                let (mut sum, mut size) = (0.0, 0.0);
                for ((entry, before), after) in column.iter().zip(given).zip(forces) {
                    sum += entry * (after - before);
                    size += entry.abs() * (before.abs() + after.abs());
                }
                (change, terms) = (change.max(f64::abs(sum)), terms.max(size));
            }
            if terms > 0.0 {
                worst = worst.max(change / terms);
            }
        }
        worst
    }
}

/// A force, or zero when it is that of a contact and pulls.
fn admitted(bilateral: bool, force: f64) -> f64 {
    if bilateral { force } else { force.max(0.0) }
}

/// The least forces that differ from `given` by a vector of the null space, not negative on unilateral rows.
fn admissible_least(qr: &PivotedQr, given: &[f64], bilateral: &[bool], settings: &SolverSettings) -> Option<Vec<f64>> {
    let count = given.len();
    let mut projected = given.to_vec();
    qr.apply_transpose(&mut projected);
    projected[qr.rank()..].fill(0.0);
    qr.apply(&mut projected);
    let rounding = f64::ROUNDING * largest(&projected);
    if projected.iter().zip(bilateral).all(|(&force, &bilateral)| bilateral || force >= -rounding) {
        return Some(projected.iter().zip(bilateral).map(|(&force, &bilateral)| admitted(bilateral, force)).collect());
    }
    // The projector N N^T on the null space, N the last columns of Q.
    let mut projector = vec![0.0; count * count];
    let mut null_vector = vec![0.0; count];
    for column in qr.rank()..count {
        null_vector.fill(0.0);
        null_vector[column] = 1.0;
        qr.apply(&mut null_vector);
        for (row, &value) in null_vector.iter().enumerate() {
            axpy(value, &null_vector[..=row], &mut projector[row * count..=row * count + row]);
        }
    }
    for row in 0..count {
        for column in row + 1..count {
            projector[row * count + column] = projector[column * count + row];
        }
    }
    // Only contacts have multipliers: the forces of bilateral rows follow.
    let contacts: Vec<usize> = (0..count).filter(|&k| !bilateral[k]).collect();
    let matrix: Vec<f64> = contacts
        .iter()
        .flat_map(|&row| contacts.iter().map(move |&column| (row, column)))
        .map(|(row, column)| projector[row * count + column])
        .collect();
    let constant: Vec<f64> = contacts.iter().map(|&row| projected[row]).collect();
    let mut active_set = ActiveSet::default();
    let start: Vec<usize> = (0..contacts.len()).filter(|&k| constant[k] < -rounding).collect();
    // The projection mixes all forces, so its rounding is that of the largest.
    let settings = &SolverSettings { noise_floor: rounding, ..*settings };
    let (rank, squeeze_rounding) = (Rank::Pivot(rounding::HUNDREDS_OF_TERMS), rounding::HALF_OF_THE_DIGITS);
    let problem = Problem { matrix: &matrix, constant: &constant, bilateral: &[], rank, squeeze_rounding, settings };
    if active_set.run(problem, &start) != Outcome::Converged {
        return None;
    }
    let mut forces = projected;
    for (&row, multiplier) in contacts.iter().zip(&active_set.forces) {
        for k in (0..count).filter(|&k| bilateral[k]) {
            forces[k] += projector[k * count + row] * multiplier;
        }
    }
    for (&row, force) in contacts.iter().zip(&active_set.w) {
        forces[row] = force.max(0.0);
    }
    for &position in active_set.rows() {
        forces[contacts[position]] = 0.0;
    }
    Some(forces)
}
