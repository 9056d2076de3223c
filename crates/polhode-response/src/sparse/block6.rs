//! Square blocks of numbers, one line after the other: the arithmetic of the sparse elimination. They are of 6 x 6, or
//! of 3 x 3 where no row turns a body.
//!
//! Loops are of known length, so that they are unrolled and run in lanes; every sum has one order, whatever the
//! lanes. Source: Golub and Van Loan, Matrix Computations, sections 3.4 and 4.2. Failure: a pivot that vanishes is
//! replaced by the smallest that can be divided by, which leaves its unknown where it was; none of a positive
//! definite block does.

use crate::tolerances::VANISHING_PIVOT;

/// Components of the velocity of a body in space.
pub(crate) const WIDTH: usize = 6;

/// Those of its translation, which come first.
pub(crate) const TRANSLATION: usize = 3;

/// A block, by its lines.
pub(crate) type Block<const W: usize> = [[f64; W]; W];

/// A column of a block: a velocity, or an impulse.
pub(crate) type Vector6 = [f64; WIDTH];

/// The block of ones on its diagonal.
pub(crate) fn unit<const W: usize>() -> Block<W> {
    std::array::from_fn(|i| std::array::from_fn(|j| f64::from(u8::from(i == j))))
}

/// `sum_i x_i y_i`.
pub(crate) fn dot6(x: &Vector6, y: &Vector6) -> f64 {
    (x[0] * y[0] + x[3] * y[3]) + (x[1] * y[1] + x[4] * y[4]) + (x[2] * y[2] + x[5] * y[5])
}

/// The same of any width, of translations and rotations in the same order.
fn dot<const W: usize>(x: &[f64; W], y: &[f64; W]) -> f64 {
    let mut lanes: [f64; TRANSLATION] = std::array::from_fn(|k| x[k] * y[k]);
    for k in TRANSLATION..W {
        lanes[k % TRANSLATION] += x[k] * y[k];
    }
    (lanes[0] + lanes[1]) + lanes[2]
}

/// `y += a x`.
pub(crate) fn add_scaled<const W: usize>(a: f64, x: &[f64; W], y: &mut [f64; W]) {
    for (y, x) in y.iter_mut().zip(x) {
        *y += a * x;
    }
}

/// `C -= A B`.
pub(crate) fn subtract_product<const W: usize>(a: &Block<W>, b: &Block<W>, c: &mut Block<W>) {
    for (a, c) in a.iter().zip(c) {
        for (&a, b) in a.iter().zip(b) {
            for (c, b) in c.iter_mut().zip(b) {
                *c -= a * b;
            }
        }
    }
}

/// `A^T`.
pub(crate) fn transposed<const W: usize>(block: &Block<W>) -> Block<W> {
    std::array::from_fn(|i| std::array::from_fn(|j| block[j][i]))
}

/// `y -= A x`.
pub(crate) fn subtract_times<const W: usize>(a: &Block<W>, x: &[f64; W], y: &mut [f64; W]) {
    for (line, y) in a.iter().zip(y) {
        *y -= dot(line, x);
    }
}

/// `y -= A^T x`.
pub(crate) fn subtract_transposed_times<const W: usize>(a: &Block<W>, x: &[f64; W], y: &mut [f64; W]) {
    for (line, x) in a.iter().zip(x) {
        add_scaled(-x, line, y);
    }
}

/// A block with its factors `P A = L U` in one place, `L` with a diagonal of ones.
#[derive(Debug, Clone, Copy)]
pub(crate) struct FactoredBlock<const W: usize> {
    factors: Block<W>,
    /// One over the diagonal of `U`.
    inverses: [f64; W],
    /// Which row was taken in each turn.
    pivots: [u8; W],
}

impl<const W: usize> FactoredBlock<W> {
    /// Gauss elimination with the largest pivot of each column.
    pub(crate) fn of(mut factors: Block<W>) -> Self {
        let mut inverses = [0.0; W];
        let mut pivots = [0; W];
        let lines = &mut factors;
        for k in 0..W {
            let larger = |best: usize, row: usize| if lines[row][k].abs() > lines[best][k].abs() { row } else { best };
            let pivot = (k + 1..W).fold(k, larger);
            pivots[k] = pivot as u8;
            lines.swap(k, pivot);
            if lines[k][k].abs() < VANISHING_PIVOT {
                lines[k][k] = VANISHING_PIVOT;
            }
            inverses[k] = 1.0 / lines[k][k];
            let pivot_line = lines[k];
            for line in &mut lines[k + 1..] {
                let factor = line[k] * inverses[k];
                line[k] = factor;
                for column in k + 1..W {
                    line[column] -= factor * pivot_line[column];
                }
            }
        }
        Self { factors, inverses, pivots }
    }

    /// `L^-1 P B` in place of the lines of `B`.
    pub(crate) fn solve_lower_block(&self, lines: &mut Block<W>) {
        for (k, &pivot) in self.pivots.iter().enumerate() {
            lines.swap(k, usize::from(pivot));
        }
        for (row, factors) in self.factors.iter().enumerate() {
            let (above, below) = lines.split_at_mut(row);
            for (factor, line) in factors.iter().zip(&*above) {
                add_scaled(-factor, line, &mut below[0]);
            }
        }
    }

    /// `B U^-1` in place of `B`.
    pub(crate) fn solve_upper_from_the_right(&self, b: &mut Block<W>) {
        let factors = self.factors;
        for line in b {
            for k in 0..W {
                let value = line[k] * self.inverses[k];
                line[k] = value;
                for column in k + 1..W {
                    line[column] -= value * factors[k][column];
                }
            }
        }
    }

    /// `L^-1 P x` in place of `x`.
    pub(crate) fn solve_lower(&self, x: &mut [f64; W]) {
        for (k, &pivot) in self.pivots.iter().enumerate() {
            x.swap(k, usize::from(pivot));
        }
        for (row, factors) in self.factors.iter().enumerate() {
            let mut value = x[row];
            for (factor, x) in factors[..row].iter().zip(&x[..row]) {
                value -= factor * x;
            }
            x[row] = value;
        }
    }

    /// `U^-1 x` in place of `x`.
    pub(crate) fn solve_upper(&self, x: &mut [f64; W]) {
        for (row, factors) in self.factors.iter().enumerate().rev() {
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
pub(crate) struct CholeskyBlock<const W: usize> {
    factor: Block<W>,
    /// One over the diagonal.
    inverses: [f64; W],
}

impl<const W: usize> CholeskyBlock<W> {
    /// Factorises; none when the block is not positive definite.
    pub(crate) fn of(block: &Block<W>) -> Option<Self> {
        let mut factor = [[0.0; W]; W];
        let mut inverses = [0.0; W];
        for row in 0..W {
            for column in 0..=row {
                let mut value = block[row][column];
                for k in 0..column {
                    value -= factor[row][k] * factor[column][k];
                }
                if column < row {
                    factor[row][column] = value * inverses[column];
                } else if value > 0.0 && value.is_finite() {
                    factor[row][row] = value.sqrt();
                    inverses[row] = 1.0 / factor[row][row];
                } else {
                    return None;
                }
            }
        }
        Some(Self { factor, inverses })
    }

    /// `C^-1 x` in place of `x`.
    pub(crate) fn solve_lower(&self, x: &mut [f64; W]) {
        for (row, factors) in self.factor.iter().enumerate() {
            let mut value = x[row];
            for (factor, x) in factors[..row].iter().zip(&x[..row]) {
                value -= factor * x;
            }
            x[row] = value * self.inverses[row];
        }
    }

    /// `C^-T x` in place of `x`.
    pub(crate) fn solve_upper(&self, x: &mut [f64; W]) {
        for row in (0..W).rev() {
            x[row] *= self.inverses[row];
            let value = x[row];
            for column in 0..row {
                x[column] -= self.factor[row][column] * value;
            }
        }
    }

    /// `C^T x` in place of `x`.
    pub(crate) fn times_transposed(&self, x: &mut [f64; W]) {
        for row in 0..W {
            x[row] = (row..W).map(|k| self.factor[k][row] * x[k]).sum();
        }
    }

    /// `C x` in place of `x`.
    pub(crate) fn times(&self, x: &mut [f64; W]) {
        for row in (0..W).rev() {
            x[row] = (0..=row).map(|k| self.factor[row][k] * x[k]).sum();
        }
    }

    /// `B C^-T` in place of `B`.
    pub(crate) fn solve_from_the_right(&self, b: &mut Block<W>) {
        for line in b {
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

    fn times(block: &Block<WIDTH>, x: &Vector6) -> Vector6 {
        let mut y = [0.0; WIDTH];
        subtract_times(block, x, &mut y);
        y.map(|y| -y)
    }

    #[test]
    fn both_factors_solve_what_the_block_multiplies() {
        let symmetric: Block<WIDTH> = std::array::from_fn(|i| std::array::from_fn(|j| entry(i, j)));
        let other = |i: usize, j: usize| entry(i, j) * (1.0 + ((WIDTH * i + j) % 5) as f64);
        let general: Block<WIDTH> = std::array::from_fn(|i| std::array::from_fn(|j| other(i, j)));
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
        let mut block: Block<WIDTH> = std::array::from_fn(|i| std::array::from_fn(|j| entry(i, j)));
        block[5][5] = -1.0;
        assert!(CholeskyBlock::of(&block).is_none());
        block[5][5] = f64::NAN;
        assert!(CholeskyBlock::of(&block).is_none());
    }
}
