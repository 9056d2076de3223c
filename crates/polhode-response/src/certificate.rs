//! Certificates of a contact solve: computable from the answer alone, whatever the method.
//!
//! For `0 <= f _|_ w = G f + b >= 0`:
//! - natural map residual: `max_i |min(G_ii f_i, w_i)| / W_i` with `W_i = |b_i| + sum_k |G_ik| |f_k|`, no unit; zero
//!   exactly at a solution;
//! - energy norm bound: for `f >= 0` and `w >= 0`,
//!   `|a - a*|_M^2 <= f.(w - w*) <= f.w`, so the accelerations `a` (velocities for impulses) differ from the true
//!   ones `a*` by at most `sqrt(f.w)` in the norm `|a|_M^2 = a.M a` (sqrt of kg m^2/s^4; sqrt of joule for impulses).
//!
//! - active set bound: where independent rows `P` carry all of `f >= 0`, with `r = w_P`, `G_PP y = r`, and
//!   `w_i - G_iP y >= 0` on all other rows, `|a - a*|_M <= sqrt(r.G_PP^-1 r) = |L^-1 r|` for the factor `L L^T = G_PP`:
//!   linear in the residual, where the energy norm bound is the root of it.
//!
//! Derivation of the active set bound. The true accelerations are the projection `a* = Proj(a_free)` in the mass norm
//! on the convex set `J a + bias >= 0` (Gauss's principle). Let `d = M^-1 J_P^T y`. Under `a_free - d` in the place of
//! `a_free` the constant terms are `b - J d`, and the same forces leave `w_P - G_PP y = 0` on the rows that carry them
//! and `w_i - G_iP y >= 0` on the others: they solve that problem exactly, so that `a - d = Proj(a_free - d)`.
//! Therefore `a - a* = (1 - Proj)(a_free) - (1 - Proj)(a_free - d)`, and since `1 - Proj` is nonexpansive for a
//! projection on a convex set, `|a - a*|_M <= |d|_M = sqrt(y.G_PP y)`. Neither strict complementarity nor a unique set
//! `P` is needed, and rows that depend on `P` only have to stay above zero. Where they fall below it by no more than
//! the rounding of their terms (`rounding::DOZENS_OF_TERMS`), the bound is that of a problem with `b_i` higher by as
//! much: the data do not tell the two apart. `b`, `J` and `M^-1` count as exact; `r` is summed in twice the precision.
//!
//! Source: natural map, Facchinei and Pang 2003; nonexpansive projection, Moreau 1965; bounds: derived for this project
//! (the projection property of Gauss's principle), never violated on the random problems of the tests. Where rounding
//! makes a `w_i` slightly negative its magnitude is counted in the energy norm bound, which then holds to rounding
//! only.

use crate::delassus::Delassus;
use crate::dense::kernels::axpy;
use crate::dense::scalar::Scalar;
use crate::error::{ResponseError, check_length};

/// The active set bound is enlarged by this, for the rounding of the factor (no unit): relative pivots down to
/// [`TRUSTED_PIVOT`] leave less.
pub(crate) const FACTOR_MARGIN: f64 = 1.01;

/// Residual of the natural map, relative to the terms of each row.
///
/// # Errors
/// When `forces`, `w` and `b` have not one number for each row.
pub fn natural_map_residual(delassus: &Delassus, forces: &[f64], w: &[f64], b: &[f64]) -> Result<f64, ResponseError> {
    let size = delassus.len();
    check_length("forces", size, forces.len())?;
    check_length("residual accelerations", size, w.len())?;
    check_length("constant terms", size, b.len())?;
    let mut scales = vec![0.0; size];
    row_scales(delassus.entries(), b, forces, &mut scales);
    Ok((0..size).map(|i| row_residual(delassus.get(i, i), forces[i], w[i], scales[i])).fold(0.0, nan_max))
}

/// `sqrt(sum_i f_i |w_i|)`: the bound of the error of the motion in the energy norm.
pub(crate) fn power_bound(forces: &[f64], w: &[f64]) -> f64 {
    forces.iter().zip(w).map(|(f, w)| f.abs() * w.abs()).sum::<f64>().max(0.0).sqrt()
}

/// The natural map of one row, relative to its scale; 0 where every term is zero.
pub(crate) fn row_residual(diagonal: f64, force: f64, w: f64, scale: f64) -> f64 {
    if scale == 0.0 { 0.0 } else { (diagonal * force).min(w).abs() / scale }
}

/// `|w|` of a bilateral row, relative to its scale; 0 where every term is zero.
pub(crate) fn bilateral_residual(w: f64, scale: f64) -> f64 {
    if scale == 0.0 { 0.0 } else { w.abs() / scale }
}

/// `W_i = |b_i| + sum_k |G_ik| |f_k|` of a row-major `G`.
pub(crate) fn row_scales(entries: &[f64], b: &[f64], forces: &[f64], scales: &mut [f64]) {
    let size = b.len();
    for (scale, b) in scales.iter_mut().zip(b) {
        *scale = b.abs();
    }
    for (k, &force) in forces.iter().enumerate() {
        if force != 0.0 {
            for (scale, entry) in scales.iter_mut().zip(&entries[k * size..(k + 1) * size]) {
                *scale += (entry * force).abs();
            }
        }
    }
}

/// `w = b + G f` of a row-major symmetric `G`.
pub(crate) fn row_accelerations<T: Scalar>(entries: &[T], b: &[T], forces: &[T], w: &mut [T]) {
    let size = b.len();
    w.copy_from_slice(b);
    for (k, &force) in forces.iter().enumerate() {
        if force != T::default() {
            axpy(force, &entries[k * size..(k + 1) * size], w);
        }
    }
}

/// Maximum that keeps a NaN, so that a broken answer never looks good.
pub(crate) fn nan_max(a: f64, b: f64) -> f64 {
    if a.is_nan() || b.is_nan() { f64::NAN } else { a.max(b) }
}
