//! Rows that are held at `w = 0` by the least forces, whatever their sign.
//!
//! Where rows depend on each other, or nearly do, the forces that hold them are not, or hardly, determined. A choice
//! of independent rows then puts the load on some of them, and what little the others differ by becomes motion that a
//! symmetric scene does not have: two contacts whose normals are tilted by an angle `a` against each other turn a load
//! that only one of them carries into a moment of order `a`. The least forces treat all rows alike.
//!
//! Method: with rows scaled to unit diagonal, the proximal-point iteration
//! `f <- f - (G + eps 1)^-1 (G f + b)`, `f = 0` at first, converges to the least-norm solution; each round multiplies
//! the error in a direction of eigenvalue `l` by `eps / (eps + l)`, and directions with `l << eps` stay at zero force.
//! One Cholesky factorisation of `G + eps 1`, which always exists, serves all rounds.
//!
//! Sources: Rockafellar 1976 (proximal point); Higham, Accuracy and Stability, chapter 10. Failure: a matrix that is
//! not finite or not positive semidefinite beyond rounding is refused.

use crate::delassus::Delassus;
use crate::dense::kernels::dot;
use crate::error::{ResponseError, check_finite, check_length};

/// The regularisation `eps`, relative to the unit diagonal. Eigenvalues are quadratic in distances: directions in
/// which contacts differ by less than 1e-5 of the lever arm are left to the other rows. Rounding leaves forces of
/// 1e-16 / eps in undetermined directions, which move nothing.
const REGULARIZATION: f64 = 1e-10;

/// Rounds of the iteration: a direction with eigenvalue 1e-6 of the largest has converged to rounding after four.
const ROUNDS: usize = 4;

/// A factorised set of rows that are all held.
#[derive(Debug, Clone)]
pub struct LeastNormHold {
    /// `1 / sqrt(G_ii)`; zero for a row that nothing can move.
    scale: Vec<f64>,
    /// Lower triangle of the Cholesky factor of the scaled and regularised matrix, row by row.
    factor: Vec<f64>,
}

impl LeastNormHold {
    /// Factorises the matrix of the rows.
    ///
    /// # Errors
    /// When the matrix is not finite.
    pub fn factor(delassus: &Delassus) -> Result<Self, ResponseError> {
        delassus.check_finite()?;
        let n = delassus.len();
        let inverse_root = |i: usize| {
            let diagonal = delassus.get(i, i);
            if diagonal > 0.0 { 1.0 / diagonal.sqrt() } else { 0.0 }
        };
        let scale: Vec<f64> = (0..n).map(inverse_root).collect();
        let mut factor: Vec<f64> = Vec::with_capacity(n * (n + 1) / 2);
        for i in 0..n {
            let start = factor.len();
            let row = delassus.row(i);
            for j in 0..i {
                let other = &factor[triangle(j)..triangle(j) + j];
                let entry = scale[i] * row[j] * scale[j] - dot(&factor[start..], other);
                factor.push(entry / factor[triangle(j) + j]);
            }
            let left = 1.0 + REGULARIZATION - dot(&factor[start..], &factor[start..]);
            // Rounding can take at most a few units in the last place from a matrix that is positive semidefinite.
            factor.push(left.max(0.5 * REGULARIZATION).sqrt());
        }
        Ok(Self { scale, factor })
    }

    /// The least forces with `w = G f + b = 0` on all rows.
    ///
    /// # Errors
    /// When lengths differ or `b` is not finite.
    pub fn solve(&self, delassus: &Delassus, b: &[f64]) -> Result<Vec<f64>, ResponseError> {
        let n = self.scale.len();
        check_length("Delassus matrix", n, delassus.len())?;
        check_length("constant terms", n, b.len())?;
        check_finite("constant terms", b)?;
        let mut forces = vec![0.0; n];
        for round in 0..ROUNDS {
            let w = if round == 0 { vec![0.0; n] } else { delassus.times(&forces)? };
            let mut correction: Vec<f64> = (0..n).map(|i| -(w[i] + b[i]) * self.scale[i]).collect();
            self.back_substitute(&mut correction);
            for ((force, change), scale) in forces.iter_mut().zip(&correction).zip(&self.scale) {
                *force += change * scale;
            }
        }
        Ok(forces)
    }

    /// Solves `L L^T x = y` in place.
    fn back_substitute(&self, y: &mut [f64]) {
        let n = y.len();
        for i in 0..n {
            let row = &self.factor[triangle(i)..=triangle(i) + i];
            y[i] = (y[i] - dot(&row[..i], &y[..i])) / row[i];
        }
        for i in (0..n).rev() {
            let row = &self.factor[triangle(i)..=triangle(i) + i];
            let value = y[i] / row[i];
            y[i] = value;
            for (entry, rest) in row[..i].iter().zip(y.iter_mut()) {
                *rest -= entry * value;
            }
        }
    }
}

/// Where row `i` of a packed lower triangle begins.
const fn triangle(i: usize) -> usize {
    i * (i + 1) / 2
}
