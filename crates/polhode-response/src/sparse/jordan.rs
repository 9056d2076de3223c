//! The second-order cone `L = { x : x_0 >= |x_1| }` and its algebra: what an interior point computes with.
//!
//! `x o y = (x.y, x_0 y_1 + y_0 x_1)`, `det x = x_0^2 - |x_1|^2`, as a product `(x_0 - |x_1|)(x_0 + |x_1|)`: near the
//! boundary the difference of squares would be rounding alone. The scaling of Nesterov and Todd is the symmetric `W`
//! with `W x = W^-1 y`. Its square is `eta^2 (2 w w^T - J)`, with `det w = 1`; its eigenvalues are `eta^2 (w_0 +-
//! |w_1|)^2` along `(1, +-w_1/|w_1|)` and `eta^2` across. Sources: Alizadeh and Goldfarb 2003; Nesterov and Todd
//! 1997. All vectors are filled up with zeros, which changes nothing. Failure: points on the boundary are taken to be
//! inside by rounding's worth.

use crate::friction::coulomb_cone::BlockRows;
use crate::law::MOST_ROWS;
use crate::sparse::system::RowMatrix;

/// A point is at least this share of `x_0` inside (no unit): a unit in the last place.
const LEAST_INSIDE: f64 = f64::EPSILON;

/// The unit of the algebra.
pub(crate) const UNIT: BlockRows = [1.0, 0.0, 0.0, 0.0, 0.0, 0.0];

/// Length of all but the first.
pub(crate) fn tail(x: &BlockRows) -> f64 {
    x[1..].iter().map(|x| x * x).sum::<f64>().sqrt()
}

/// `x.y` of all but the first.
pub(crate) fn tail_product(x: &BlockRows, y: &BlockRows) -> f64 {
    x[1..].iter().zip(&y[1..]).map(|(x, y)| x * y).sum()
}

/// `x.y`.
pub(crate) fn inner(x: &BlockRows, y: &BlockRows) -> f64 {
    x[0] * y[0] + tail_product(x, y)
}

fn determinant(x: &BlockRows) -> f64 {
    let tail = tail(x);
    (x[0] - tail) * (x[0] + tail)
}

/// The determinant of a point inside.
fn inner_determinant(x: &BlockRows) -> f64 {
    let tail = tail(x);
    (x[0] - tail).max(LEAST_INSIDE * x[0]) * (x[0] + tail)
}

/// `x o y`.
pub(crate) fn product(x: &BlockRows, y: &BlockRows) -> BlockRows {
    let mut product: BlockRows = std::array::from_fn(|k| x[0] * y[k] + y[0] * x[k]);
    product[0] = inner(x, y);
    product
}

/// The `z` with `x o z = y`.
pub(crate) fn quotient(x: &BlockRows, y: &BlockRows) -> BlockRows {
    let first = (x[0] * y[0] - tail_product(x, y)) / inner_determinant(x);
    let mut quotient: BlockRows = std::array::from_fn(|k| (y[k] - first * x[k]) / x[0]);
    quotient[0] = first;
    quotient
}

/// The largest `a` with `x + a d` in the cone, for `x` inside.
pub(crate) fn longest_step(x: &BlockRows, d: &BlockRows) -> f64 {
    // det(x + a d) = A a^2 + B a + C, and the first root above 0.
    let (a, c) = (determinant(d), inner_determinant(x));
    let b = 2.0 * (x[0] * d[0] - tail_product(x, d));
    let discriminant = b * b - 4.0 * a * c;
    let mut longest = if d[0] < 0.0 { -x[0] / d[0] } else { f64::INFINITY };
    if discriminant >= 0.0 {
        let q = -0.5 * (b + if b >= 0.0 { discriminant.sqrt() } else { -discriminant.sqrt() });
        for root in [q / a, c / q] {
            if root > 0.0 {
                longest = longest.min(root);
            }
        }
    }
    longest
}

/// The scaling of a pair of points inside.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct Scaling {
    /// `eta`.
    eta: f64,
    /// `w`.
    w: BlockRows,
    /// `|w_1|`.
    tail: f64,
}

impl Scaling {
    /// For `x` and `y` inside.
    pub(crate) fn of(x: &BlockRows, y: &BlockRows) -> Self {
        let (dx, dy) = (inner_determinant(x).sqrt(), inner_determinant(y).sqrt());
        let gamma = (0.5 * (1.0 + inner(x, y) / (dx * dy))).sqrt();
        let over = 0.5 / gamma;
        let mut w: BlockRows = std::array::from_fn(|k| over * (y[k] / dy - x[k] / dx));
        let tail = tail(&w);
        // det w = 1 holds in this direction to rounding, however long w is.
        w[0] = (1.0 + tail * tail).sqrt();
        Self { eta: (dy / dx).sqrt(), w, tail }
    }

    /// `W z`.
    pub(crate) fn times(&self, z: &BlockRows) -> BlockRows {
        let along = tail_product(&self.w, z);
        let factor = z[0] + along / (1.0 + self.w[0]);
        let mut product: BlockRows = std::array::from_fn(|k| self.eta * (z[k] + factor * self.w[k]));
        product[0] = self.eta * (self.w[0] * z[0] + along);
        product
    }

    /// `W^-1 z`.
    pub(crate) fn inverse_times(&self, z: &BlockRows) -> BlockRows {
        let along = tail_product(&self.w, z);
        let factor = along / (1.0 + self.w[0]) - z[0];
        let mut product: BlockRows = std::array::from_fn(|k| (z[k] + factor * self.w[k]) / self.eta);
        product[0] = (self.w[0] * z[0] - along) / self.eta;
        product
    }

    /// `(W^2 + shift)^-1`, for `shift >= 0`.
    pub(crate) fn inverse_square(&self, shift: f64) -> RowMatrix {
        let square = self.eta * self.eta;
        let wide = self.w[0] + self.tail;
        let up = 1.0 / (square * (wide * wide) + shift);
        let down = 1.0 / (square / (wide * wide) + shift);
        let mut direction: BlockRows =
            if self.tail > 0.0 { std::array::from_fn(|k| self.w[k] / self.tail) } else { [0.0; MOST_ROWS] };
        direction[0] = 0.0;
        spectral(&direction, [up, down, 1.0 / (square + shift)])
    }
}

/// The symmetric matrix with eigenvalues along `(1, d)` and `(1, -d)`, and across both, for a direction `d` of unit
/// length with `d_0 = 0`, or none (zeros), where all are the same.
pub(crate) fn spectral(d: &BlockRows, [up, down, across]: [f64; 3]) -> RowMatrix {
    let (mean, half) = (0.5 * (up + down), 0.5 * (up - down));
    let mut matrix: RowMatrix = std::array::from_fn(|i| {
        std::array::from_fn(|j| {
            let own = if i == j { across } else { 0.0 };
            own + (mean - across) * (d[i] * d[j])
        })
    });
    matrix[0][0] = mean;
    for k in 1..MOST_ROWS {
        (matrix[0][k], matrix[k][0]) = (half * d[k], half * d[k]);
    }
    matrix
}

#[cfg(test)]
mod tests {
    //! The algebra's own laws, and the longest step.
    use super::*;

    const X: BlockRows = [2.0, 1.0, -0.5, 0.0, 0.0, 0.0];
    const Y: BlockRows = [3.0, -1.0, 2.5, 0.0, 0.0, 0.0];

    fn close(a: &BlockRows, b: &BlockRows) -> bool {
        a.iter().zip(b).all(|(a, b)| (a - b).abs() < 1e-13)
    }

    #[test]
    fn a_quotient_undoes_a_product() {
        assert!(close(&quotient(&X, &product(&X, &Y)), &Y));
    }

    #[test]
    fn the_scaling_takes_both_points_to_one() {
        let scaling = Scaling::of(&X, &Y);
        assert!(close(&scaling.times(&X), &scaling.inverse_times(&Y)));
        assert!(close(&scaling.times(&scaling.inverse_times(&X)), &X));
        // W^2 x = y.
        let inverse = scaling.inverse_square(0.0);
        let x: BlockRows = std::array::from_fn(|i| inverse[i].iter().zip(Y).map(|(w, y)| w * y).sum());
        assert!(close(&x, &X), "{x:?}");
    }

    #[test]
    fn the_longest_step_ends_on_the_boundary() {
        for d in [[-1.0, 0.2, 0.1, 0.0, 0.0, 0.0], [1.0, 2.0, 2.0, 0.0, 0.0, 0.0], [0.0, 1.0, 0.0, 0.0, 0.0, 0.0]] {
            let a = longest_step(&X, &d);
            let end: BlockRows = std::array::from_fn(|k| X[k] + a * d[k]);
            assert!((end[0] - tail(&end)).abs() < 1e-13, "{d:?}: {a}");
        }
        assert_eq!(longest_step(&X, &[1.0, 0.0, 0.5, 0.0, 0.0, 0.0]), f64::INFINITY);
    }
}
