//! Sums and updates of vectors, in a fixed order of operations.
//!
//! Four independent partial sums let the compiler use vector instructions without changing a bit of the result: the
//! order is part of the source, not of the machine.

use crate::dense::scalar::Scalar;
use polhode_spatial::CompensatedSum;

/// `sum_i x_i y_i` over the shorter of the two.
pub(crate) fn dot<T: Scalar>(x: &[T], y: &[T]) -> T {
    let count = x.len().min(y.len());
    let (x, y) = (&x[..count], &y[..count]);
    let mut partial = [T::default(); 4];
    let (x_blocks, y_blocks) = (x.chunks_exact(4), y.chunks_exact(4));
    let (x_rest, y_rest) = (x_blocks.remainder(), y_blocks.remainder());
    for (a, b) in x_blocks.zip(y_blocks) {
        for lane in 0..4 {
            partial[lane] = partial[lane] + a[lane] * b[lane];
        }
    }
    let mut sum = (partial[0] + partial[1]) + (partial[2] + partial[3]);
    for (&a, &b) in x_rest.iter().zip(y_rest) {
        sum = sum + a * b;
    }
    sum
}

/// `sum_i x_i y_i` over the shorter of the two, for a few numbers: one plain sum.
pub(crate) fn short_dot(x: &[f64], y: &[f64]) -> f64 {
    x.iter().zip(y).map(|(a, b)| a * b).sum()
}

/// `sum_i x_i y_i` with a compensated sum: the products are rounded, their sum is not.
pub(crate) fn compensated_dot(x: &[f64], y: &[f64]) -> f64 {
    x.iter().zip(y).map(|(a, b)| a * b).collect::<CompensatedSum>().value()
}

/// `y += a x` over the shorter of the two.
pub(crate) fn axpy<T: Scalar>(a: T, x: &[T], y: &mut [T]) {
    for (target, &value) in y.iter_mut().zip(x) {
        *target = *target + a * value;
    }
}

/// Largest magnitude, 0 for an empty slice.
pub(crate) fn largest<T: Scalar>(values: &[T]) -> f64 {
    values.iter().fold(0.0, |most: f64, value| most.max(value.to_f64().abs()))
}
