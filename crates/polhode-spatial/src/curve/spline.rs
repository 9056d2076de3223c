//! The cubic spline through points: curvature changes without a jump.
//!
//! Its parameter is the length of the chords. Between two points at the distance `h` it is the cubic with the second
//! derivatives `m_i` at them, which solve `h_(i-1) m_(i-1) + 2 (h_(i-1) + h_i) m_i + h_i m_(i+1) = 6 (d_i - d_(i-1))`,
//! `d_i` the slopes of the chords; an open one has `m = 0` at its ends (natural spline). Source: de Boor 1978,
//! chapter 4.

use super::error::{CurveError, finite};
use super::piece::{Piece, Stretch};
use glam::DVec3;

/// Whether a spline returns to its first point.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum SplineEnds {
    /// It ends at its last point.
    Open,
    /// It goes on from its last point to its first one.
    Closed,
}

/// The pieces of the spline through these points, with the ranges of their parameters.
pub(super) fn pieces(points: &[DVec3], ends: SplineEnds) -> Result<Vec<Stretch>, CurveError> {
    let least = match ends {
        SplineEnds::Open => 2,
        SplineEnds::Closed => 3,
    };
    let found = points.len();
    if found < least {
        return Err(CurveError::TooFew { what: "points", found, least });
    }
    finite("a point", points.iter().all(|point| point.is_finite()))?;
    let mut all = points.to_vec();
    if ends == SplineEnds::Closed {
        all.push(points[0]);
    }
    let chords: Vec<f64> = all.windows(2).map(|pair| (pair[1] - pair[0]).length()).collect();
    let size = chords.iter().fold(0.0, |most: f64, chord| most.max(*chord));
    if let Some(first) = chords.iter().position(|chord| *chord <= f64::EPSILON * size) {
        return Err(CurveError::Coincident { first, second: (first + 1) % found });
    }
    let slopes: Vec<DVec3> = all.windows(2).zip(&chords).map(|(pair, chord)| (pair[1] - pair[0]) / *chord).collect();
    let second = match ends {
        SplineEnds::Open => natural(&chords, &slopes),
        SplineEnds::Closed => periodic(&chords, &slopes),
    };
    let of_chord = |(i, &h): (usize, &f64)| {
        let (m0, m1) = (second[i], second[i + 1]);
        let first = slopes[i] - (m0 * 2.0 + m1) * (h / 6.0);
        let piece = Piece::Polynomial(vec![all[i], first, m0 * 0.5, (m1 - m0) / (6.0 * h)]);
        Stretch { piece, from: 0.0, to: h }
    };
    Ok(chords.iter().enumerate().map(of_chord).collect())
}

/// Second derivatives at the points of an open spline.
fn natural(chords: &[f64], slopes: &[DVec3]) -> Vec<DVec3> {
    let inner = chords.len() - 1;
    let diagonal: Vec<f64> = (0..inner).map(|i| 2.0 * (chords[i] + chords[i + 1])).collect();
    let right: Vec<DVec3> = (0..inner).map(|i| (slopes[i + 1] - slopes[i]) * 6.0).collect();
    let beside: Vec<f64> = chords.iter().skip(1).take(inner.saturating_sub(1)).copied().collect();
    let mut second = vec![DVec3::ZERO];
    second.extend(tridiagonal(&diagonal, &beside, right));
    second.push(DVec3::ZERO);
    second
}

/// Second derivatives at the points of a closed spline, the first one again at the end: by Sherman and Morrison's
/// formula.
fn periodic(chords: &[f64], slopes: &[DVec3]) -> Vec<DVec3> {
    let n = chords.len();
    let before = |i: usize| (i + n - 1) % n;
    let corner = chords[n - 1];
    let mut diagonal: Vec<f64> = (0..n).map(|i| 2.0 * (chords[before(i)] + chords[i])).collect();
    let right: Vec<DVec3> = (0..n).map(|i| (slopes[i] - slopes[before(i)]) * 6.0).collect();
    let beside = &chords[..n - 1];
    let gamma = -diagonal[0];
    diagonal[0] -= gamma;
    diagonal[n - 1] -= corner * corner / gamma;
    let mut unit = vec![DVec3::ZERO; n];
    unit[0] = DVec3::splat(gamma);
    unit[n - 1] += DVec3::splat(corner);
    let (x, z) = (tridiagonal(&diagonal, beside, right), tridiagonal(&diagonal, beside, unit));
    let share = corner / gamma;
    let factor = (x[0] + x[n - 1] * share) / (z[0] + z[n - 1] * share + DVec3::ONE);
    let mut second: Vec<DVec3> = x.iter().zip(&z).map(|(x, z)| *x - factor * *z).collect();
    second.push(second[0]);
    second
}

/// Solves a symmetric tridiagonal system with a dominant diagonal.
fn tridiagonal(diagonal: &[f64], beside: &[f64], mut right: Vec<DVec3>) -> Vec<DVec3> {
    let mut pivots = diagonal.to_vec();
    for i in 1..pivots.len() {
        let share = beside[i - 1] / pivots[i - 1];
        pivots[i] -= share * beside[i - 1];
        let above = right[i - 1];
        right[i] -= above * share;
    }
    for i in (0..pivots.len()).rev() {
        let below = if i + 1 < pivots.len() { right[i + 1] * beside[i] } else { DVec3::ZERO };
        right[i] = (right[i] - below) / pivots[i];
    }
    right
}
