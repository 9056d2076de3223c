//! The convex relative of a problem with friction, in lifted form, and the proof that a problem has no solution.
//!
//! With `G = B B^T` and the correction `s_i = mu |u_t|` held fixed, `min 1/2 |y|^2` subject to `B y + q + s n` in `K*`
//! is convex; its multipliers are the reactions. Repeated with `s` of the last answer it leads towards Coulomb's law
//! (Cadoux; Acary, Cadoux, Lemarechal and Malick 2011), slowly: Newton's method ends what it began. Without the
//! tangents it is the question whether any reactions keep all normal velocities from being negative. If there are none,
//! the multipliers `z >= 0` move nothing and have `q.z < 0`: the problem has no solution.
//!
//! `B` is a Cholesky factor with pivoting, dense: a fallback for problems of some hundred contacts.

use crate::dense::kernels::{axpy, dot, largest};
use crate::dense::scalar::Scalar;
use crate::friction::problem::FrictionProblem;
use crate::interior_point::ANSWER_ERROR;
use crate::interior_point::{ConeProgramme, ConeRows, least_motion};
use crate::law::Law;
use crate::solve::way::CONE_PROGRAMME_MOST_ROWS;

/// The factor `B` of a problem, row by row, each row scaled by `1 / sqrt(g)` of its contact.
#[derive(Debug)]
pub(crate) struct LiftedForm<'a> {
    problem: &'a FrictionProblem,
    rank: usize,
    /// `rows x rank`, row-major.
    factor: Vec<f64>,
    /// `1 / sqrt(g)` of each row.
    scales: Vec<f64>,
}

impl<'a> LiftedForm<'a> {
    /// The lifted form of a problem; nothing for one that is too large or in which
    /// contacts resist rotations, whose cones are others.
    pub(crate) fn of(problem: &'a FrictionProblem) -> Option<Self> {
        let (matrix, size) = (problem.matrix(), problem.rows());
        let resist_rotations = problem.blocks().iter().any(|block| block.resists_rotation());
        if size > CONE_PROGRAMME_MOST_ROWS || size == 0 || resist_rotations {
            return None;
        }
        let mut scales = vec![0.0; size];
        let mut dense = vec![0.0; size * size];
        for block in 0..problem.len() {
            for row in matrix.range(block) {
                scales[row] = 1.0 / problem.inverse_mass(block).sqrt();
            }
        }
        for row in 0..problem.len() {
            for block in matrix.blocks(row) {
                let columns = matrix.range(block.column);
                for (at, value) in block.values.iter().enumerate() {
                    let (i, j) = (matrix.range(row).start + at / columns.len(), columns.start + at % columns.len());
                    // The mean of the matrix and its mirror.
                    let half = 0.5 * value * scales[i] * scales[j];
                    dense[i * size + j] += half;
                    dense[j * size + i] += half;
                }
            }
        }
        let (rank, factor) = pivoted_cholesky(&dense, size);
        Some(Self { problem, rank, factor, scales })
    }

    /// The reactions of the convex programme, where the tangential velocities are those of `velocities`.
    pub(crate) fn reactions(&self, velocities: &[f64]) -> Option<(Vec<f64>, usize)> {
        let problem = self.problem;
        let mut constant = Vec::new();
        let (mut entries, mut cones, mut weights) = (Vec::new(), Vec::new(), Vec::new());
        for (block, kind) in problem.blocks().iter().enumerate() {
            let range = problem.range(block);
            let (rows, cone, friction) = match *kind {
                Law::Hold { rows } => (rows, ConeRows::Zero(rows), 1.0),
                Law::Cone { rows, friction } if rows > 1 && friction > 0.0 => {
                    (rows, ConeRows::SecondOrder(rows), friction)
                }
                // A contact that slides already starts without the effect of its friction.
                Law::Push | Law::Cone { .. } | Law::Slide { .. } | Law::Resist { .. } => {
                    (1, ConeRows::Nonnegative(1), 1.0)
                }
            };
            cones.push(cone);
            for row in range.clone().take(rows) {
                let is_tangent = row > range.start;
                let weight = if is_tangent { friction } else { 1.0 };
                let slip = if !is_tangent && matches!(cone, ConeRows::SecondOrder(_)) {
                    let tangents = &velocities[range.start + 1..range.end];
                    friction * dot(tangents, tangents).sqrt()
                } else {
                    0.0
                };
                self.push_row(row, weight, constant.len(), &mut entries);
                constant.push(weight * (problem.constant()[row] + slip) * self.scales[row]);
                weights.push((row, weight * self.scales[row]));
            }
        }
        let ConeProgramme::Solved { multipliers, iterations, .. } =
            least_motion(self.rank, &entries, &constant, &cones)
        else {
            return None;
        };
        let mut reactions = vec![0.0; problem.rows()];
        for (&(row, weight), multiplier) in weights.iter().zip(&multipliers) {
            reactions[row] = weight * multiplier;
        }
        for (block, kind) in problem.blocks().iter().enumerate() {
            if let Law::Slide { friction } = *kind {
                let normal = problem.range(block).start;
                reactions[normal + 1] = -friction * reactions[normal];
            }
        }
        Some((reactions, iterations))
    }

    /// Normal reactions that prove that the problem has no solution, the largest 1; checked against the matrix.
    pub(crate) fn squeeze(&self) -> Option<Vec<f64>> {
        let problem = self.problem;
        let (mut constant, mut entries, mut cones, mut rows) = (Vec::new(), Vec::new(), Vec::new(), Vec::new());
        for (block, kind) in problem.blocks().iter().enumerate() {
            let (count, cone) = match *kind {
                Law::Hold { rows } => (rows, ConeRows::Zero(rows)),
                Law::Push | Law::Cone { .. } | Law::Slide { .. } | Law::Resist { .. } => (1, ConeRows::Nonnegative(1)),
            };
            cones.push(cone);
            for row in problem.range(block).take(count) {
                self.push_row(row, 1.0, constant.len(), &mut entries);
                constant.push(problem.constant()[row] * self.scales[row]);
                rows.push(row);
            }
        }
        let ConeProgramme::Infeasible { multipliers, .. } = least_motion(self.rank, &entries, &constant, &cones) else {
            return None;
        };
        let mut squeeze = vec![0.0; problem.rows()];
        for (&row, multiplier) in rows.iter().zip(&multipliers) {
            squeeze[row] = multiplier * self.scales[row];
        }
        let most = largest(&squeeze);
        for value in &mut squeeze {
            *value /= most;
        }
        self.is_proof(&squeeze).then_some(squeeze)
    }

    /// Whether reactions move nothing and do work on the velocities without reactions.
    fn is_proof(&self, squeeze: &[f64]) -> bool {
        let problem = self.problem;
        let mut moved = Vec::new();
        problem.matrix().times_plus(squeeze, &vec![0.0; squeeze.len()], &mut moved);
        let alone = (0..problem.len()).map(|block| problem.inverse_mass(block)).fold(0.0, f64::max);
        let work = dot(problem.constant(), squeeze);
        let terms: f64 = problem.constant().iter().zip(squeeze).map(|(q, z)| (q * z).abs()).sum();
        largest(&moved) <= ANSWER_ERROR * alone && work < -ANSWER_ERROR.sqrt() * terms
    }

    fn push_row(&self, row: usize, weight: f64, at: usize, entries: &mut Vec<(usize, usize, f64)>) {
        for (column, value) in self.factor[row * self.rank..(row + 1) * self.rank].iter().enumerate() {
            if *value != 0.0 {
                entries.push((at, column, weight * value));
            }
        }
    }
}

/// Rank and factor `B` (`size x rank`, row-major) of `B B^T`, the largest remaining diagonal entry first.
fn pivoted_cholesky(dense: &[f64], size: usize) -> (usize, Vec<f64>) {
    let mut rest: Vec<f64> = (0..size).map(|row| dense[row * size + row]).collect();
    let cut = f64::ROUNDING * largest(&rest);
    let mut columns: Vec<Vec<f64>> = Vec::new();
    let mut is_used = vec![false; size];
    loop {
        let free = (0..size).filter(|&row| !is_used[row]);
        let pivot = free.fold(None, |best: Option<usize>, row| match best {
            Some(other) if rest[other] >= rest[row] => Some(other),
            _ => Some(row),
        });
        let Some(pivot) = pivot.filter(|&pivot| rest[pivot] > cut) else { break };
        is_used[pivot] = true;
        let over = 1.0 / rest[pivot].sqrt();
        let mut column = dense[pivot * size..(pivot + 1) * size].to_vec();
        for earlier in &columns {
            let factor = earlier[pivot];
            if factor != 0.0 {
                axpy(-factor, earlier, &mut column);
            }
        }
        for row in 0..size {
            let is_earlier = is_used[row] && row != pivot;
            column[row] = if is_earlier { 0.0 } else { column[row] * over };
            rest[row] -= column[row] * column[row];
        }
        columns.push(column);
    }
    let rank = columns.len();
    let mut factor = vec![0.0; size * rank];
    for (k, column) in columns.iter().enumerate() {
        for (row, value) in column.iter().enumerate() {
            factor[row * rank + k] = *value;
        }
    }
    (rank, factor)
}
