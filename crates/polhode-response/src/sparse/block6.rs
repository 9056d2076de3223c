//! Blocks of 6 x 6 numbers, row-major: the arithmetic of the sparse elimination.
//!
//! Loops are of known length, so that they are unrolled and run in lanes; every sum has one order, whatever the
//! lanes. Source: Golub and Van Loan, Matrix Computations, sections 3.4 and 4.2. Failure: a pivot that vanishes is
//! replaced by the smallest that can be divided by, which leaves its unknown where it was; none of a positive
//! definite block does.

/// Components of the velocity of a body in space.
pub(crate) const WIDTH: usize = 6;

/// A block.
pub(crate) type Block6 = [f64; WIDTH * WIDTH];

/// A column of a block: a velocity, or an impulse.
pub(crate) type Vector6 = [f64; WIDTH];

/// The block of zeros.
pub(crate) const ZERO: Block6 = [0.0; WIDTH * WIDTH];

/// What a pivot below it is replaced by (in units of the matrix, whose diagonal is 1 before contacts are added).
const SMALLEST_BLOCK_PIVOT: f64 = 1e-200;

/// `sum_i x_i y_i`.
pub(crate) fn dot6(x: &Vector6, y: &Vector6) -> f64 {
    (x[0] * y[0] + x[3] * y[3]) + (x[1] * y[1] + x[4] * y[4]) + (x[2] * y[2] + x[5] * y[5])
}

/// `y += a x`.
pub(crate) fn add_scaled(a: f64, x: &Vector6, y: &mut Vector6) {
    for (y, x) in y.iter_mut().zip(x) {
        *y += a * x;
    }
}

/// Rows of a block.
pub(crate) fn rows(block: &Block6) -> &[Vector6] {
    block.as_chunks().0
}

fn rows_mut(block: &mut Block6) -> &mut [Vector6] {
    block.as_chunks_mut().0
}

/// `C -= A B`.
pub(crate) fn subtract_product(a: &Block6, b: &Block6, c: &mut Block6) {
    let b = rows(b);
    for (a, c) in rows(a).iter().zip(rows_mut(c)) {
        for (&a, b) in a.iter().zip(b) {
            for (c, b) in c.iter_mut().zip(b) {
                *c -= a * b;
            }
        }
    }
}

/// `A^T`.
pub(crate) fn transposed(block: &Block6) -> Block6 {
    let mut target = ZERO;
    for (i, line) in rows(block).iter().enumerate() {
        for (j, value) in line.iter().enumerate() {
            target[j * WIDTH + i] = *value;
        }
    }
    target
}

/// `y -= A x`.
pub(crate) fn subtract_times(a: &Block6, x: &Vector6, y: &mut Vector6) {
    for (line, y) in rows(a).iter().zip(y) {
        *y -= dot6(line, x);
    }
}

/// `y -= A^T x`.
pub(crate) fn subtract_transposed_times(a: &Block6, x: &Vector6, y: &mut Vector6) {
    for (line, x) in rows(a).iter().zip(x) {
        add_scaled(-x, line, y);
    }
}

/// A block with its factors `P A = L U` in one place, `L` with a diagonal of ones.
#[derive(Debug, Clone, Copy)]
pub(crate) struct FactoredBlock {
    factors: Block6,
    /// One over the diagonal of `U`.
    inverses: Vector6,
    /// Which row was taken in each turn.
    pivots: [u8; WIDTH],
}

impl FactoredBlock {
    /// Gauss elimination with the largest pivot of each column.
    pub(crate) fn of(mut factors: Block6) -> Self {
        let mut inverses = [0.0; WIDTH];
        let mut pivots = [0; WIDTH];
        let lines = rows_mut(&mut factors);
        for k in 0..WIDTH {
            let larger = |best: usize, row: usize| if lines[row][k].abs() > lines[best][k].abs() { row } else { best };
            let pivot = (k + 1..WIDTH).fold(k, larger);
            pivots[k] = pivot as u8;
            lines.swap(k, pivot);
            if lines[k][k].abs() < SMALLEST_BLOCK_PIVOT {
                lines[k][k] = SMALLEST_BLOCK_PIVOT;
            }
            inverses[k] = 1.0 / lines[k][k];
            let pivot_line = lines[k];
            for line in &mut lines[k + 1..] {
                let factor = line[k] * inverses[k];
                line[k] = factor;
                for column in k + 1..WIDTH {
                    line[column] -= factor * pivot_line[column];
                }
            }
        }
        Self { factors, inverses, pivots }
    }

    /// `L^-1 P B` in place of `B`.
    pub(crate) fn solve_lower_block(&self, b: &mut Block6) {
        let lines = rows_mut(b);
        for (k, &pivot) in self.pivots.iter().enumerate() {
            lines.swap(k, usize::from(pivot));
        }
        for (row, factors) in rows(&self.factors).iter().enumerate() {
            let (above, below) = lines.split_at_mut(row);
            for (factor, line) in factors.iter().zip(&*above) {
                add_scaled(-factor, line, &mut below[0]);
            }
        }
    }

    /// `B U^-1` in place of `B`.
    pub(crate) fn solve_upper_from_the_right(&self, b: &mut Block6) {
        let factors = rows(&self.factors);
        for line in rows_mut(b) {
            for k in 0..WIDTH {
                let value = line[k] * self.inverses[k];
                line[k] = value;
                for column in k + 1..WIDTH {
                    line[column] -= value * factors[k][column];
                }
            }
        }
    }

    /// `L^-1 P x` in place of `x`.
    pub(crate) fn solve_lower(&self, x: &mut Vector6) {
        for (k, &pivot) in self.pivots.iter().enumerate() {
            x.swap(k, usize::from(pivot));
        }
        for (row, factors) in rows(&self.factors).iter().enumerate() {
            let mut value = x[row];
            for (factor, x) in factors[..row].iter().zip(&x[..row]) {
                value -= factor * x;
            }
            x[row] = value;
        }
    }

    /// `U^-1 x` in place of `x`.
    pub(crate) fn solve_upper(&self, x: &mut Vector6) {
        for (row, factors) in rows(&self.factors).iter().enumerate().rev() {
            let mut value = x[row];
            for (factor, x) in factors[row + 1..].iter().zip(&x[row + 1..]) {
                value -= factor * x;
            }
            x[row] = value * self.inverses[row];
        }
    }
}

/// The factor `C` of a symmetric positive definite block `C C^T`.
#[derive(Debug, Clone, Copy)]
pub(crate) struct CholeskyBlock {
    factor: Block6,
    /// One over the diagonal.
    inverses: Vector6,
}

impl CholeskyBlock {
    /// Factorises; none when the block is not positive definite.
    pub(crate) fn of(block: &Block6) -> Option<Self> {
        let mut factor = ZERO;
        let mut inverses = [0.0; WIDTH];
        for row in 0..WIDTH {
            for column in 0..=row {
                let mut value = block[row * WIDTH + column];
                for k in 0..column {
                    value -= factor[row * WIDTH + k] * factor[column * WIDTH + k];
                }
                if column < row {
                    factor[row * WIDTH + column] = value * inverses[column];
                } else if value > 0.0 && value.is_finite() {
                    factor[row * WIDTH + row] = value.sqrt();
                    inverses[row] = 1.0 / factor[row * WIDTH + row];
                } else {
                    return None;
                }
            }
        }
        Some(Self { factor, inverses })
    }

    /// `C^-1 x` in place of `x`.
    pub(crate) fn solve_lower(&self, x: &mut Vector6) {
        for (row, factors) in rows(&self.factor).iter().enumerate() {
            let mut value = x[row];
            for (factor, x) in factors[..row].iter().zip(&x[..row]) {
                value -= factor * x;
            }
            x[row] = value * self.inverses[row];
        }
    }

    /// `C^-T x` in place of `x`.
    pub(crate) fn solve_upper(&self, x: &mut Vector6) {
        for row in (0..WIDTH).rev() {
            x[row] *= self.inverses[row];
            let value = x[row];
            for column in 0..row {
                x[column] -= self.factor[row * WIDTH + column] * value;
            }
        }
    }

    /// `C^T x` in place of `x`.
    pub(crate) fn times_transposed(&self, x: &mut Vector6) {
        for row in 0..WIDTH {
            x[row] = (row..WIDTH).map(|k| self.factor[k * WIDTH + row] * x[k]).sum();
        }
    }

    /// `C x` in place of `x`.
    pub(crate) fn times(&self, x: &mut Vector6) {
        for row in (0..WIDTH).rev() {
            x[row] = (0..=row).map(|k| self.factor[row * WIDTH + k] * x[k]).sum();
        }
    }

    /// `B C^-T` in place of `B`.
    pub(crate) fn solve_from_the_right(&self, b: &mut Block6) {
        for line in rows_mut(b) {
            self.solve_lower(line);
        }
    }
}

#[cfg(test)]
mod tests {
    //! Factors of a block solve what the block multiplies.
    #![allow(clippy::unwrap_used, reason = "a test that cannot go on has failed")]
    use super::*;

    fn entry(i: usize, j: usize) -> f64 {
        1.0 / (1.0 + i as f64 + j as f64) + f64::from(u8::from(i == j))
    }

    fn times(block: &Block6, x: &Vector6) -> Vector6 {
        let mut y = [0.0; WIDTH];
        subtract_times(block, x, &mut y);
        y.map(|y| -y)
    }

    #[test]
    fn both_factors_solve_what_the_block_multiplies() {
        let symmetric: Block6 = std::array::from_fn(|k| entry(k / WIDTH, k % WIDTH));
        let general: Block6 = std::array::from_fn(|k| entry(k / WIDTH, k % WIDTH) * (1.0 + (k % 5) as f64));
        let x = [1.0, -2.0, 3.0, -4.0, 5.0, -6.0];
        let mut y = times(&symmetric, &x);
        let factor = CholeskyBlock::of(&symmetric).unwrap();
        factor.solve_lower(&mut y);
        factor.solve_upper(&mut y);
        assert!(y.iter().zip(x).all(|(y, x)| (y - x).abs() < 1e-13), "{y:?}");
        let mut z = x;
        factor.times_transposed(&mut z);
        factor.times(&mut z);
        let y = times(&symmetric, &x);
        assert!(y.iter().zip(z).all(|(y, z)| (y - z).abs() < 1e-13), "{z:?}");
        let mut y = times(&general, &x);
        let factor = FactoredBlock::of(general);
        factor.solve_lower(&mut y);
        factor.solve_upper(&mut y);
        assert!(y.iter().zip(x).all(|(y, x)| (y - x).abs() < 1e-12), "{y:?}");
    }

    #[test]
    fn what_is_not_positive_definite_is_refused() {
        let mut block: Block6 = std::array::from_fn(|k| entry(k / WIDTH, k % WIDTH));
        block[35] = -1.0;
        assert!(CholeskyBlock::of(&block).is_none());
        block[35] = f64::NAN;
        assert!(CholeskyBlock::of(&block).is_none());
    }
}
