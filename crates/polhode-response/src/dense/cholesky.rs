//! A Cholesky factor `L L^T` that grows by one row and shrinks by any row.
//!
//! `L` is stored by columns, so that the inner loops run along memory. A row is appended by one triangular solve
//! (k^2/2 operations for k rows) and removed by a rank-one update of the columns behind it. Source: Golub and Van
//! Loan, Matrix Computations, sections 4.2 and 6.5.

use crate::dense::kernels::{axpy, dot};
use crate::dense::scalar::Scalar;

/// Lower triangular factor of a growing matrix of at most `capacity` rows.
#[derive(Debug, Clone, Default)]
pub(crate) struct GrowingCholesky<T = f64> {
    capacity: usize,
    size: usize,
    columns: Vec<T>,
    update: Vec<T>,
}

impl<T: Scalar> GrowingCholesky<T> {
    /// Empties the factor and makes room for `capacity` rows.
    pub(crate) fn reset(&mut self, capacity: usize) {
        if capacity > self.capacity {
            self.columns.resize(capacity * capacity, T::default());
            self.capacity = capacity;
        }
        self.size = 0;
    }

    /// The Schur complements, rounded.
    pub(crate) fn pivots(&self) -> impl Iterator<Item = f64> + '_ {
        let diagonal = |row: usize| self.columns[row * self.capacity + row].to_f64();
        (0..self.size).map(move |row| diagonal(row) * diagonal(row))
    }

    /// The smallest Schur complement, infinite when there is no row.
    pub(crate) fn smallest_pivot(&self) -> f64 {
        self.pivots().fold(f64::INFINITY, f64::min)
    }

    /// Appends the row whose off-diagonal part is `line` (`L^-1` of the new column) and whose Schur complement is
    /// `pivot > 0`.
    pub(crate) fn push(&mut self, line: &[T], pivot: T) {
        let row = self.size;
        for (column, value) in line.iter().enumerate() {
            self.columns[column * self.capacity + row] = *value;
        }
        self.columns[row * self.capacity + row] = pivot.sqrt();
        self.size += 1;
    }

    /// Removes row (and column) `position` of the matrix.
    pub(crate) fn remove(&mut self, position: usize) {
        let (size, stride) = (self.size, self.capacity);
        self.update.clear();
        self.update.extend_from_slice(&self.columns[position * stride + position + 1..position * stride + size]);
        for column in 0..position {
            let start = column * stride;
            self.columns.copy_within(start + position + 1..start + size, start + position);
        }
        // What is left behind `position` is L_33 L_33^T + l l^T with l the removed column: rotate l into L_33.
        for column in position + 1..size {
            let tail = &mut self.columns[column * stride + column..column * stride + size];
            let update = &mut self.update[column - position - 1..];
            let radius = (tail[0] * tail[0] + update[0] * update[0]).sqrt();
            let (cosine, sine) = (tail[0] / radius, update[0] / radius);
            for (entry, extra) in tail.iter_mut().zip(update.iter_mut()) {
                let rotated = cosine * *entry + sine * *extra;
                *extra = cosine * *extra - sine * *entry;
                *entry = rotated;
            }
            let from = column * stride + column;
            self.columns.copy_within(from..from + size - column, (column - 1) * stride + column - 1);
        }
        self.size -= 1;
    }

    /// `L^-1 x`, in place, for as many numbers as there are rows.
    pub(crate) fn solve_lower(&self, x: &mut [T]) {
        for column in 0..self.size {
            let start = column * self.capacity;
            let value = x[column] / self.columns[start + column];
            x[column] = value;
            axpy(-value, &self.columns[start + column + 1..start + self.size], &mut x[column + 1..self.size]);
        }
    }

    /// `L^-T x`, in place, for as many numbers as there are rows.
    pub(crate) fn solve_upper(&self, x: &mut [T]) {
        for column in (0..self.size).rev() {
            let start = column * self.capacity;
            let below = dot(&self.columns[start + column + 1..start + self.size], &x[column + 1..self.size]);
            x[column] = (x[column] - below) / self.columns[start + column];
        }
    }

    /// `(L L^T)^-1 x`, in place.
    pub(crate) fn solve(&self, x: &mut [T]) {
        self.solve_lower(x);
        self.solve_upper(x);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Deterministic numbers in (-1, 1).
    fn noise(seed: &mut u64) -> f64 {
        *seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        ((*seed >> 11) as f64 / (1_u64 << 52) as f64) - 1.0
    }

    /// Appending all rows, removing some and solving gives the solution of the matrix of the rows that are left.
    #[test]
    fn grown_and_shrunk_factor_solves_what_is_left() {
        let (n, mut seed) = (9, 7);
        let a: Vec<f64> = (0..n * n).map(|_| noise(&mut seed)).collect();
        let at = |i: usize, j: usize| {
            (0..n).map(|k| a[i * n + k] * a[j * n + k]).sum::<f64>() + if i == j { 0.5 } else { 0.0 }
        };
        let mut factor = GrowingCholesky::default();
        factor.reset(n);
        let mut kept: Vec<usize> = Vec::new();
        for row in 0..n {
            let mut line: Vec<f64> = kept.iter().map(|&k| at(row, k)).collect();
            factor.solve_lower(&mut line);
            let pivot = at(row, row) - dot(&line, &line);
            factor.push(&line, pivot);
            kept.push(row);
        }
        for position in [8, 0, 3, 3] {
            factor.remove(position);
            kept.remove(position);
            let truth: Vec<f64> = kept.iter().map(|_| noise(&mut seed)).collect();
            let mut x: Vec<f64> =
                kept.iter().map(|&i| kept.iter().zip(&truth).map(|(&j, t)| at(i, j) * t).sum()).collect();
            factor.solve(&mut x);
            assert!(x.iter().zip(&truth).all(|(x, t)| (x - t).abs() < 1e-12), "{x:?} {truth:?}");
        }
    }
}
