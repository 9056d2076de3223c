//! QR factorisation with column pivoting, `A P = Q R`, which reveals the rank.
//!
//! Householder reflections on a column-major matrix; at each step the column of largest remaining norm comes next
//! (the first of equal ones), and the factorisation stops where all remaining columns are below a cut. Source: Golub
//! and Van Loan, Matrix Computations, sections 5.2 and 5.4.

use crate::dense::kernels::{axpy, dot, largest};
use polhode_spatial::rounding;

/// The factors of an `m x n` matrix: reflections below the diagonal, `R` on and above it.
#[derive(Debug, Clone)]
pub(crate) struct PivotedQr {
    rows: usize,
    data: Vec<f64>,
    scales: Vec<f64>,
    permutation: Vec<usize>,
    rank: usize,
}

impl PivotedQr {
    /// Factorises the column-major matrix `data` of `rows` rows; columns below `cut` times the largest column count
    /// as zero.
    pub(crate) fn factor(rows: usize, columns: usize, mut data: Vec<f64>, cut: f64) -> Self {
        let mut permutation: Vec<usize> = (0..columns).collect();
        let mut squares: Vec<f64> = data.chunks_exact(rows.max(1)).map(|column| dot(column, column)).collect();
        squares.resize(columns, 0.0);
        let mut references = squares.clone();
        let smallest = cut * cut * largest(&squares);
        let mut scales = Vec::new();
        for step in 0..rows.min(columns) {
            let best = (step + 1..columns).fold(step, |best, k| if squares[k] > squares[best] { k } else { best });
            let positive = squares[best] > smallest;
            if !positive {
                break;
            }
            if best != step {
                for row in 0..rows {
                    data.swap(best * rows + row, step * rows + row);
                }
                permutation.swap(best, step);
                squares.swap(best, step);
                references.swap(best, step);
            }
            let (done, rest) = data.split_at_mut((step + 1) * rows);
            let reflection = &mut done[step * rows + step..];
            let scale = reflect(reflection);
            for (offset, column) in rest.chunks_exact_mut(rows).enumerate() {
                let below = &mut column[step..];
                apply_reflection(reflection, scale, below);
                let other = step + 1 + offset;
                squares[other] -= below[0] * below[0];
                if squares[other] <= rounding::HALF_OF_THE_DIGITS * references[other] {
                    squares[other] = dot(&below[1..], &below[1..]);
                    references[other] = squares[other];
                }
            }
            scales.push(scale);
        }
        let rank = scales.len();
        Self { rows, data, scales, permutation, rank }
    }

    /// Number of independent columns.
    pub(crate) fn rank(&self) -> usize {
        self.rank
    }

    /// The last pivot relative to the first; 0 without columns.
    pub(crate) fn least_pivot(&self) -> f64 {
        self.rank.checked_sub(1).map_or(0.0, |last| (self.r(last, last) / self.r(0, 0)).abs())
    }

    /// `Q x`, in place.
    pub(crate) fn apply(&self, x: &mut [f64]) {
        for step in (0..self.rank).rev() {
            apply_reflection(self.reflection(step), self.scales[step], &mut x[step..]);
        }
    }

    /// `Q^T x`, in place.
    pub(crate) fn apply_transpose(&self, x: &mut [f64]) {
        for step in 0..self.rank {
            apply_reflection(self.reflection(step), self.scales[step], &mut x[step..]);
        }
    }

    /// Subtracts from `x` its projection on the columns of the matrix.
    pub(crate) fn remove_range(&self, x: &mut [f64]) {
        self.apply_transpose(x);
        x[..self.rank].fill(0.0);
        self.apply(x);
    }

    /// A least-squares solution of `A x = b` with at most `rank` entries that are not zero.
    pub(crate) fn solve(&self, b: &[f64]) -> Vec<f64> {
        let mut z = b.to_vec();
        self.apply_transpose(&mut z);
        for column in (0..self.rank).rev() {
            z[column] /= self.r(column, column);
            let value = z[column];
            let start = column * self.rows;
            axpy(-value, &self.data[start..start + column], &mut z[..column]);
        }
        let mut x = vec![0.0; self.permutation.len()];
        for (position, value) in z.iter().take(self.rank).enumerate() {
            x[self.permutation[position]] = *value;
        }
        x
    }

    /// The solution of least norm of `A^T x = c`, for `c` in the range of `A^T`.
    pub(crate) fn solve_transpose(&self, c: &[f64]) -> Vec<f64> {
        let mut x = vec![0.0; self.rows];
        for column in 0..self.rank {
            let above = dot(&self.data[column * self.rows..column * self.rows + column], &x[..column]);
            x[column] = (c[self.permutation[column]] - above) / self.r(column, column);
        }
        self.apply(&mut x);
        x
    }

    fn r(&self, row: usize, column: usize) -> f64 {
        self.data[column * self.rows + row]
    }

    fn reflection(&self, step: usize) -> &[f64] {
        &self.data[step * self.rows + step..(step + 1) * self.rows]
    }
}

/// Turns `x` into the reflection `I - scale v v^T` (with `v_0 = 1` not stored) that maps it onto its first axis, and
/// puts the length there. Returns the scale, 0 for no reflection.
fn reflect(x: &mut [f64]) -> f64 {
    let tail = dot(&x[1..], &x[1..]);
    if tail == 0.0 {
        return 0.0;
    }
    let length = (x[0] * x[0] + tail).sqrt();
    // The sign that adds magnitudes: no cancellation.
    let image = if x[0] > 0.0 { -length } else { length };
    let first = x[0] - image;
    for value in &mut x[1..] {
        *value /= first;
    }
    x[0] = image;
    -first / image
}

fn apply_reflection(reflection: &[f64], scale: f64, x: &mut [f64]) {
    let along = scale * (x[0] + dot(&reflection[1..], &x[1..]));
    x[0] -= along;
    axpy(-along, &reflection[1..], &mut x[1..]);
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A 4 x 3 matrix of rank 2: the rank is found, least squares and least norm solutions satisfy their equations.
    #[test]
    fn rank_deficient_matrix_is_solved_both_ways() {
        let (a, b) = ([1.0, 2.0, 3.0, 4.0], [0.0, 1.0, -1.0, 2.0]);
        let c: Vec<f64> = a.iter().zip(&b).map(|(a, b)| 2.0 * a - b).collect();
        let data = [a.to_vec(), b.to_vec(), c.clone()].concat();
        let qr = PivotedQr::factor(4, 3, data, 1e-12);
        assert_eq!(qr.rank(), 2);
        let target: Vec<f64> = a.iter().zip(&b).map(|(a, b)| 0.5 * a + 3.0 * b).collect();
        let x = qr.solve(&target);
        for row in 0..4 {
            assert!((a[row] * x[0] + b[row] * x[1] + c[row] * x[2] - target[row]).abs() < 1e-14);
        }
        // Least norm of A^T y = A^T a must be a itself projected on the range: a is in it.
        let moments: Vec<f64> = [&a[..], &b[..], &c[..]].iter().map(|column| dot(column, &a)).collect();
        let y = qr.solve_transpose(&moments);
        assert!(y.iter().zip(&a).all(|(y, a)| (y - a).abs() < 1e-13));
    }
}
