//! Sums and equations in twice the working precision, for the truth that answers are compared with. Written apart from
//! the arithmetic of the crate.

use crate::scenes::Scene;

/// `high + low`.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub(crate) struct Long(f64, f64);

impl Long {
    pub(crate) const fn new(value: f64) -> Self {
        Self(value, 0.0)
    }

    pub(crate) fn value(self) -> f64 {
        self.0 + self.1
    }

    fn sum_of(a: f64, b: f64) -> Self {
        let sum = a + b;
        let part = sum - a;
        Self(sum, (a - (sum - part)) + (b - part))
    }

    fn product_of(a: f64, b: f64) -> Self {
        let split = |x: f64| {
            let scaled = 134_217_729.0 * x;
            let high = scaled - (scaled - x);
            (high, x - high)
        };
        let (product, (a_high, a_low), (b_high, b_low)) = (a * b, split(a), split(b));
        Self(product, ((a_high * b_high - product) + a_high * b_low + a_low * b_high) + a_low * b_low)
    }

    pub(crate) fn plus(self, other: Self) -> Self {
        let Self(high, low) = Self::sum_of(self.0, other.0);
        let Self(sum, error) = Self::sum_of(high, low + self.1 + other.1);
        Self(sum, error)
    }

    pub(crate) fn minus(self, other: Self) -> Self {
        self.plus(Self(-other.0, -other.1))
    }

    pub(crate) fn times(self, other: Self) -> Self {
        let Self(high, low) = Self::product_of(self.0, other.0);
        Self(high, 0.0).plus(Self::new(low + (self.0 * other.1 + self.1 * other.0)))
    }

    fn over(self, other: Self) -> Self {
        let first = Self::new(self.0 / other.0);
        let rest = self.minus(other.times(first));
        let second = Self::new(rest.0 / other.0);
        let rest = rest.minus(other.times(second));
        first.plus(second).plus(Self::new(rest.0 / other.0))
    }
}

/// `J` of a scene, row by row, dense.
pub(crate) fn dense_jacobian(scene: &Scene) -> Vec<Vec<f64>> {
    let (size, rows) = (scene.free.len(), scene.problem.len());
    let mut jacobian = vec![vec![0.0; size]; rows];
    let mut unit = vec![0.0; size];
    for column in 0..size {
        unit[column] = 1.0;
        for (row, value) in scene.problem.row_velocities(&unit).unwrap().into_iter().enumerate() {
            jacobian[row][column] = value;
        }
        unit[column] = 0.0;
    }
    jacobian
}

/// Inverse masses of a scene with diagonal masses, as the problem has them.
pub(crate) fn inverse_masses(scene: &Scene) -> Vec<f64> {
    let width = scene.problem.width();
    (0..scene.free.len()).map(|k| 1.0 / scene.masses[(k / width * width + k % width) * width + k % width]).collect()
}

/// `J^T f`.
pub(crate) fn loads(jacobian: &[Vec<f64>], forces: &[Long]) -> Vec<Long> {
    let columns = jacobian.first().map_or(0, Vec::len);
    let mut loads = vec![Long::default(); columns];
    for (line, force) in jacobian.iter().zip(forces) {
        for (load, &entry) in loads.iter_mut().zip(line) {
            *load = load.plus(force.times(Long::new(entry)));
        }
    }
    loads
}

/// Solves the rows of `active` for `w = 0`; the forces of the other rows are zero.
pub(crate) fn solve_equations(jacobian: &[Vec<f64>], inverse: &[f64], b: &[f64], active: &[usize]) -> Vec<Long> {
    let n = active.len();
    let entry = |i: usize, j: usize| {
        let terms = jacobian[active[i]].iter().zip(&jacobian[active[j]]).zip(inverse);
        terms
            .fold(Long::default(), |sum, ((a, b), m)| sum.plus(Long::new(*a).times(Long::new(*b)).times(Long::new(*m))))
    };
    let mut matrix: Vec<Vec<Long>> = (0..n).map(|i| (0..n).map(|j| entry(i, j)).collect()).collect();
    let mut right: Vec<Long> = active.iter().map(|&row| Long::new(-b[row])).collect();
    for k in 0..n {
        for i in k + 1..n {
            let factor = matrix[i][k].over(matrix[k][k]);
            for j in k..n {
                let change = factor.times(matrix[k][j]);
                matrix[i][j] = matrix[i][j].minus(change);
            }
            right[i] = right[i].minus(factor.times(right[k]));
        }
    }
    let mut forces = vec![Long::default(); b.len()];
    for k in (0..n).rev() {
        let known = (k + 1..n).fold(right[k], |sum, j| sum.minus(matrix[k][j].times(forces[active[j]])));
        forces[active[k]] = known.over(matrix[k][k]);
    }
    forces
}

/// `w = J M^-1 J^T f + b`.
pub(crate) fn row_accelerations(jacobian: &[Vec<f64>], inverse: &[f64], b: &[f64], forces: &[Long]) -> Vec<f64> {
    let loads = loads(jacobian, forces);
    let motion: Vec<Long> = loads.iter().zip(inverse).map(|(load, m)| load.times(Long::new(*m))).collect();
    let row = |(line, b): (&Vec<f64>, &f64)| {
        line.iter().zip(&motion).fold(Long::new(*b), |sum, (j, a)| sum.plus(a.times(Long::new(*j)))).value()
    };
    jacobian.iter().zip(b).map(row).collect()
}
