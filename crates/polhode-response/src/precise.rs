//! `w = b + J (M^-1 J^T f)` body by body in twice the working precision.
//!
//! An entry of `G` between a heavy and a light body is `1/m_light + 1/m_heavy` rounded: at a mass ratio of 1e6 six
//! digits of the heavy body are gone, and forces found from `G` alone are good to 1e-10. The same sum taken body by
//! body does not mix them; one step of iterative refinement with it gives forces to rounding (case RC-15).

use crate::error::{ResponseError, check_length};
use crate::problem::ContactProblem;
use polhode_spatial::DoubleDouble;

/// Largest diagonal entry over smallest pivot of a factor above which refinement uses this module (no unit). At 5e3
/// plain refinement leaves 7e-13 in the forces; bodies of equal mass stay below 100 or so.
const SPREAD: f64 = 256.0;

impl ContactProblem {
    /// `b + J (M^-1 J^T f) + c f`: the accelerations (velocities) of all rows under the forces (impulses) `f`, where
    /// `b` are those without them. Forces are summed body by body in twice the working precision, so that large ones
    /// that cancel on a light body leave the rounding of each of them and no more: that of the entries of `G`, and of
    /// its products, is not in it.
    ///
    /// # Errors
    /// When `b` or `forces` has not one number for each row.
    pub fn accelerations(&self, b: &[f64], forces: &[f64]) -> Result<Vec<f64>, ResponseError> {
        check_length("constant terms", self.len(), b.len())?;
        check_length("forces", self.len(), forces.len())?;
        let rows: Vec<usize> = (0..self.len()).collect();
        Ok(residual(self, &rows, b, forces, &rows))
    }

    /// The same where the forces add up to these loads on the bodies, in blocks of the problem's width. Of soft rows
    /// their own forces count.
    ///
    /// # Errors
    /// When `b` or `forces` has not one number for each row, or `loads` not `width` for each body.
    pub fn accelerations_under(&self, b: &[f64], forces: &[f64], loads: &[f64]) -> Result<Vec<f64>, ResponseError> {
        check_length("constant terms", self.len(), b.len())?;
        check_length("forces", self.len(), forces.len())?;
        check_length("loads", self.bodies() * self.width(), loads.len())?;
        let rows: Vec<usize> = (0..self.len()).collect();
        let [forces, loads] =
            [forces, loads].map(|of| of.iter().map(|&one| DoubleDouble::new(one)).collect::<Vec<_>>());
        Ok(accelerations_under(self, &rows, b, (&forces, &loads)))
    }
}

/// Whether the pivots of a factor ask for refinement in twice the precision.
pub(crate) fn is_worth_it(largest_diagonal: f64, smallest_pivot: f64) -> bool {
    largest_diagonal > SPREAD * smallest_pivot
}

/// `G` of `rows`, row-major: entries exact to 1e-31 of their terms, so that the matrix is semidefinite to that.
pub(crate) fn delassus(problem: &ContactProblem, rows: &[usize], matrix: &mut Vec<DoubleDouble>) {
    let (width, size) = (problem.width(), rows.len());
    matrix.clear();
    matrix.resize(size * size, DoubleDouble::default());
    let mut response = vec![DoubleDouble::default(); width];
    for &(row, compliance) in problem.compliances() {
        if let Some(line) = rows.iter().position(|&own| own == row) {
            matrix[line * size + line] = DoubleDouble::new(compliance);
        }
    }
    for (line, &row) in rows.iter().enumerate() {
        for entry in problem.entries(row) {
            let inverse = problem.inverse_mass(entry.body);
            for (component, value) in response.iter_mut().enumerate() {
                // The block is symmetric to rounding; its mean with its transpose is so exactly.
                let mean = |k: usize| 0.5 * inverse[component * width + k] + 0.5 * inverse[k * width + component];
                let terms = entry.jacobian.iter().enumerate();
                *value = terms.fold(DoubleDouble::default(), |sum, (k, jacobian)| sum.plus_product(mean(k), *jacobian));
            }
            for (column, &other) in rows.iter().enumerate().take(line + 1) {
                for other in problem.entries(other).filter(|other| other.body == entry.body) {
                    let start = matrix[line * size + column];
                    let terms = other.jacobian.iter().zip(&response);
                    matrix[line * size + column] = terms.fold(start, |sum, (j, r)| sum.plus_long_product(*j, *r));
                }
            }
        }
        for column in 0..line {
            matrix[column * size + line] = matrix[line * size + column];
        }
    }
}

/// `w` of `rows`, whose forces and constant terms are given in the order of `rows`.
pub(crate) fn accelerations(problem: &ContactProblem, rows: &[usize], b: &[f64], forces: &[f64]) -> Vec<f64> {
    let width = problem.width();
    let mut motion = vec![DoubleDouble::default(); problem.bodies() * width];
    for (&row, &force) in rows.iter().zip(forces) {
        if force != 0.0 {
            for entry in problem.entries(row) {
                let block = &mut motion[entry.body * width..(entry.body + 1) * width];
                for (component, response) in block.iter_mut().zip(entry.response) {
                    *component = component.plus_product(*response, force);
                }
            }
        }
    }
    let forces: Vec<DoubleDouble> = forces.iter().map(|&force| DoubleDouble::new(force)).collect();
    row_accelerations(problem, rows, b, (&forces, &motion))
}

/// `b + J x + c f` of `rows` with these forces, for a motion `x` of all bodies, rounded after the sum.
fn row_accelerations(
    problem: &ContactProblem,
    rows: &[usize],
    b: &[f64],
    (forces, motion): (&[DoubleDouble], &[DoubleDouble]),
) -> Vec<f64> {
    let width = problem.width();
    let acceleration = |((&row, &constant), &force): ((&usize, &f64), &DoubleDouble)| {
        let mut sum = DoubleDouble::new(constant);
        let compliance = problem.compliances().iter().find(|(soft, _)| *soft == row);
        if let Some(&(_, compliance)) = compliance {
            sum = sum.plus_long_product(compliance, force);
        }
        for entry in problem.entries(row) {
            let block = &motion[entry.body * width..(entry.body + 1) * width];
            for (jacobian, component) in entry.jacobian.iter().zip(block) {
                sum = sum.plus_long_product(*jacobian, *component);
            }
        }
        sum.value()
    };
    rows.iter().zip(b).zip(forces).map(acceleration).collect()
}

/// `J^T f` of all bodies: what the forces of `rows` add up to, in blocks of the problem's width.
pub(crate) fn loads(problem: &ContactProblem, rows: &[usize], forces: &[DoubleDouble]) -> Vec<DoubleDouble> {
    let width = problem.width();
    let mut loads = vec![DoubleDouble::default(); problem.bodies() * width];
    for (&row, &force) in rows.iter().zip(forces) {
        for entry in problem.entries(row) {
            let block = &mut loads[entry.body * width..(entry.body + 1) * width];
            for (load, jacobian) in block.iter_mut().zip(entry.jacobian) {
                *load = load.plus_long_product(*jacobian, force);
            }
        }
    }
    loads
}

/// `b + J (M^-1 x) + c f` of `rows` with these forces under the loads `x` on all bodies, rounded after the sum. The
/// inverse masses act on the sum and not on each force, whose rounded products would not cancel.
pub(crate) fn accelerations_under(
    problem: &ContactProblem,
    rows: &[usize],
    b: &[f64],
    (forces, loads): (&[DoubleDouble], &[DoubleDouble]),
) -> Vec<f64> {
    let width = problem.width();
    let mut motion = Vec::with_capacity(loads.len());
    for (body, load) in loads.chunks_exact(width).enumerate() {
        if load.iter().all(|component| component.value() == 0.0) {
            motion.resize(motion.len() + width, DoubleDouble::default());
            continue;
        }
        for line in problem.inverse_mass(body).chunks_exact(width) {
            // Blocks of bodies are mostly zero.
            let terms = line.iter().zip(load).filter(|(m, _)| **m != 0.0);
            motion.push(terms.fold(DoubleDouble::default(), |sum, (m, x)| sum.plus_long_product(*m, *x)));
        }
    }
    row_accelerations(problem, rows, b, (forces, &motion))
}

/// `w` of the rows at `positions` of `rows`, under forces and constant terms that are given in the order of `rows`.
pub(crate) fn residual(
    problem: &ContactProblem,
    rows: &[usize],
    b: &[f64],
    forces: &[f64],
    positions: &[usize],
) -> Vec<f64> {
    let carrying: Vec<usize> = positions.iter().map(|&k| rows[k]).collect();
    let forces: Vec<DoubleDouble> = positions.iter().map(|&k| DoubleDouble::new(forces[k])).collect();
    let constants: Vec<f64> = positions.iter().map(|&k| b[k]).collect();
    let loads = loads(problem, &carrying, &forces);
    accelerations_under(problem, &carrying, &constants, (&forces, &loads))
}
