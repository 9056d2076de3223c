//! Certificates of a contact solve: computable from the answer alone, whatever the method.
//!
//! For `0 <= f _|_ w = G f + b >= 0`:
//! - natural map residual: `max_i |min(G_ii f_i, w_i)| / W_i` with `W_i = |b_i| + sum_k |G_ik| |f_k|`, no unit; zero
//!   exactly at a solution;
//! - energy norm bound: for `f >= 0` and `w >= 0`,
//!   `|a - a*|_M^2 <= f.(w - w*) <= f.w`, so the accelerations `a` (velocities for impulses) differ from the true
//!   ones `a*` by at most `sqrt(f.w)` in the norm `|a|_M^2 = a.M a` (sqrt of kg m^2/s^4; sqrt of joule for impulses).
//!
//! Source: natural map, Facchinei and Pang 2003; bound: derived for this project (the projection property of Gauss's
//! principle), never violated on the random problems of the tests. Where rounding makes a `w_i`
//! slightly negative its magnitude is counted, so the bound then holds to rounding only.

use crate::delassus::Delassus;
use crate::dense::kernels::axpy;
use crate::dense::scalar::Scalar;
use crate::error::{ResponseError, check_length};

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
///
/// # Errors
/// When `forces` and `w` have not the same length.
pub fn energy_norm_bound(forces: &[f64], w: &[f64]) -> Result<f64, ResponseError> {
    check_length("residual accelerations", forces.len(), w.len())?;
    Ok(power_bound(forces, w))
}

/// [`energy_norm_bound`] without the check.
pub(crate) fn power_bound(forces: &[f64], w: &[f64]) -> f64 {
    forces.iter().zip(w).map(|(f, w)| f * w.abs()).sum::<f64>().max(0.0).sqrt()
}

/// The natural map of one row, relative to its scale; 0 where every term is zero.
pub(crate) fn row_residual(diagonal: f64, force: f64, w: f64, scale: f64) -> f64 {
    if scale == 0.0 { 0.0 } else { (diagonal * force).min(w).abs() / scale }
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
