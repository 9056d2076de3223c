//! Rotation matrices: `R' = R [w]x`, w in body axes (thesis 3.3, equation 3: `R' = [w]x R`, w in world axes).
//!
//! The method makes R a little less orthogonal each step. It is brought to the nearest rotation (in the Frobenius norm,
//! the orthogonal factor of its polar decomposition) by Newton's iteration `X <- (X + X^-T)/2`, which converges
//! quadratically from any matrix of positive determinant. Source: docs/REFERENCES.md, Higham 1986.

use super::super::one_step::Span;
use super::{Frame, Representation};
use crate::integrator::IntegrationError;
use glam::{DMat3, DVec3};
use polhode_spatial::Rotation;
use polhode_spatial::rounding;

impl Frame for DMat3 {
    #[inline]
    fn to_body(self, vector: DVec3) -> DVec3 {
        DVec3::new(self.x_axis.dot(vector), self.y_axis.dot(vector), self.z_axis.dot(vector))
    }

    #[inline]
    fn to_world(self, vector: DVec3) -> DVec3 {
        self * vector
    }
}

/// The nearest rotation; NaN or some matrix for one that is singular.
fn orthogonalized(matrix: DMat3) -> DMat3 {
    let mut r = matrix;
    let mut last = f64::INFINITY;
    // Each change is at most half the one before: from entries of 1e6 the first twenty are, the rest converge.
    loop {
        // The columns of the inverse's transpose are the cross products of the columns, divided by the determinant.
        let (a, b, c) = (r.x_axis, r.y_axis, r.z_axis);
        let b_c = b.cross(c);
        let scale = 1.0 / a.dot(b_c);
        let next = (r + DMat3::from_cols(b_c * scale, c.cross(a) * scale, a.cross(b) * scale)) * 0.5;
        let change = next - r;
        r = next;
        let [x, y, z] = [change.x_axis, change.y_axis, change.z_axis].map(DVec3::length_squared);
        let change = (x + y + z).sqrt();
        // Written so that NaN ends it.
        let is_smaller = change < last;
        if change <= rounding::HALF_OF_THE_DIGITS || !is_smaller {
            return r;
        }
        last = change;
    }
}

fn rate(matrix: &DMat3, w: DVec3) -> DMat3 {
    let (a, b, c) = (matrix.x_axis, matrix.y_axis, matrix.z_axis);
    DMat3::from_cols(b * w.z - c * w.y, c * w.x - a * w.z, a * w.y - b * w.x)
}

/// Orthogonalised after each step.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Matrix;

impl Representation for Matrix {
    type Coordinates = DMat3;
    type Frame = DMat3;

    fn of(rotation: Rotation) -> DMat3 {
        rotation.to_matrix()
    }

    fn rotation(matrix: &DMat3) -> Rotation {
        Rotation::from_matrix(matrix)
    }

    #[inline]
    fn frame(matrix: &DMat3) -> DMat3 {
        *matrix
    }

    #[inline]
    fn rate(matrix: &DMat3, w: DVec3, _span: Span) -> Result<DMat3, IntegrationError> {
        Ok(rate(matrix, w))
    }

    #[inline]
    fn settled(matrix: DMat3) -> DMat3 {
        orthogonalized(matrix)
    }

    #[inline]
    fn is_finite(matrix: &DMat3) -> bool {
        matrix.is_finite()
    }
}

/// Never orthogonalised.
#[derive(Debug, Clone, Copy)]
pub(crate) struct MatrixUnorthogonalized;

impl Representation for MatrixUnorthogonalized {
    type Coordinates = DMat3;
    type Frame = DMat3;

    fn of(rotation: Rotation) -> DMat3 {
        rotation.to_matrix()
    }

    fn rotation(matrix: &DMat3) -> Rotation {
        Rotation::from_matrix(&orthogonalized(*matrix))
    }

    #[inline]
    fn frame(matrix: &DMat3) -> DMat3 {
        *matrix
    }

    #[inline]
    fn rate(matrix: &DMat3, w: DVec3, _span: Span) -> Result<DMat3, IntegrationError> {
        Ok(rate(matrix, w))
    }

    #[inline]
    fn is_finite(matrix: &DMat3) -> bool {
        matrix.is_finite()
    }
}
