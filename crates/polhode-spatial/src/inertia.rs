//! Rotational inertia.
//!
//! `I = int rho (|r|^2 1 - r r^T) dV` (thesis 3.2, equation 1), symmetric. A physical inertia has non-negative
//! principal moments that satisfy the triangle inequality `I1 + I2 >= I3`; here they must be positive, because a
//! body without inertia about an axis has no equation of motion about it.

use crate::rounding;
use crate::{PrincipalAxes, Rotation};
use glam::{DMat3, DVec3};
use thiserror::Error;

/// A valid rotational inertia about some point in some axes, kg m^2.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Inertia(DMat3);

/// Why a matrix is no rotational inertia.
#[derive(Debug, Clone, Copy, PartialEq, Error)]
pub enum InertiaError {
    /// An element is NaN or infinite.
    #[error("inertia has an element that is not finite")]
    NotFinite,
    /// The matrix is not symmetric.
    #[error("inertia must be symmetric: elements ({row}, {column}) and ({column}, {row}) are {upper} and {lower}")]
    NotSymmetric {
        /// Row of the upper element, from 0.
        row: usize,
        /// Column of the upper element, from 0.
        column: usize,
        /// The upper element.
        upper: f64,
        /// The lower element.
        lower: f64,
    },
    /// A principal moment is zero or negative, or not to be told from that in the precision of the matrix.
    #[error("principal moments of inertia must be positive beyond rounding of the matrix, found {0} kg m^2")]
    NotPositive(f64),
    /// The triangle inequality fails: no distribution of mass has these moments.
    #[error(
        "principal moments {}, {}, {} kg m^2 break the triangle inequality (the largest may be at most the sum of the \
         others): no body has them",
        .0.x, .0.y, .0.z
    )]
    TriangleInequality(DVec3),
}

impl Inertia {
    /// From a matrix that is symmetric to [`rounding::DIGITS_OF_A_FILE`]; the mean of the two triangles is kept.
    ///
    /// # Errors
    /// When the matrix is not finite, not symmetric, not positive definite or breaks the triangle inequality.
    pub fn new(matrix: DMat3) -> Result<Self, InertiaError> {
        if !matrix.is_finite() {
            return Err(InertiaError::NotFinite);
        }
        let scale = matrix.to_cols_array().iter().fold(0.0f64, |m, x| m.max(x.abs()));
        for (row, column) in [(0, 1), (0, 2), (1, 2)] {
            let (upper, lower) = (matrix.col(column)[row], matrix.col(row)[column]);
            if (upper - lower).abs() > rounding::DIGITS_OF_A_FILE * scale {
                return Err(InertiaError::NotSymmetric { row, column, upper, lower });
            }
        }
        // Halved before they are added, so that the largest f64 does not overflow.
        let symmetric = matrix * 0.5 + matrix.transpose() * 0.5;
        let moments = PrincipalAxes::of(&symmetric).moments();
        let correlation = smallest_correlation(&symmetric);
        if moments.x <= 0.0 || correlation <= rounding::FEW_TERMS || correlation.is_nan() {
            return Err(InertiaError::NotPositive(moments.x));
        }
        if moments.z - moments.x - moments.y > rounding::DIGITS_OF_A_FILE * moments.z {
            return Err(InertiaError::TriangleInequality(moments));
        }
        Ok(Self(symmetric))
    }

    /// From principal moments along the axes.
    ///
    /// # Errors
    /// As [`Inertia::new`].
    pub fn from_diagonal(moments: DVec3) -> Result<Self, InertiaError> {
        Self::new(DMat3::from_diagonal(moments))
    }

    /// The matrix.
    pub const fn matrix(&self) -> DMat3 {
        self.0
    }

    /// Principal moments and axes.
    pub fn principal_axes(&self) -> PrincipalAxes {
        PrincipalAxes::of(&self.0)
    }

    /// The same inertia in other axes: `I_A = R_AB I_B R_AB^T` (thesis, above equation 4).
    pub fn rotated(&self, rotation: Rotation) -> Self {
        let r = rotation.to_matrix();
        let m = r * self.0 * r.transpose();
        Self((m + m.transpose()) * 0.5)
    }

    /// The inertia of the image in a mirror in the plane x = 0 of its axes.
    pub fn mirrored(&self) -> Self {
        let mirror = DMat3::from_diagonal(DVec3::new(-1.0, 1.0, 1.0));
        Self(mirror * self.0 * mirror)
    }

    /// Sum of two inertias about the same point in the same axes.
    pub fn plus(&self, other: &Self) -> Self {
        Self(self.0 + other.0)
    }

    /// Inertia about a point at `arm` (m) from the centre of mass, from that about the centre of mass: the theorem of
    /// parallel axes, `I + m (|r|^2 1 - r r^T)`.
    pub fn shifted_from_center_of_mass(&self, mass: f64, arm: DVec3) -> Self {
        Self(self.0 + point_inertia(mass, arm))
    }
}

/// Smallest eigenvalue of the matrix with rows and columns scaled to a diagonal of ones; its distance from zero, unlike
/// that of the smallest moment, does not depend on how different the moments are (docs/REFERENCES.md, Demmel and
/// Veselic 1992).
fn smallest_correlation(matrix: &DMat3) -> f64 {
    let diagonal = DVec3::new(matrix.x_axis.x, matrix.y_axis.y, matrix.z_axis.z);
    // Rows, then columns: the product of two square roots neither over- nor underflows.
    let scale = DMat3::from_diagonal(diagonal.map(|x| 1.0 / x.sqrt()));
    PrincipalAxes::of(&(scale * *matrix * scale)).moments().x
}

/// Inertia of a particle: `m (|r|^2 1 - r r^T)`, kg m^2.
pub fn point_inertia(mass: f64, arm: DVec3) -> DMat3 {
    // The diagonal is `y^2 + z^2`, not `|r|^2 - x^2`, which would lose the small moment of a needle.
    let squares = arm * arm;
    let diagonal = DVec3::new(squares.y + squares.z, squares.z + squares.x, squares.x + squares.y);
    let (yz, zx, xy) = (-arm.y * arm.z, -arm.z * arm.x, -arm.x * arm.y);
    let matrix = DMat3::from_cols(
        DVec3::new(diagonal.x, xy, zx),
        DVec3::new(xy, diagonal.y, yz),
        DVec3::new(zx, yz, diagonal.z),
    );
    matrix * mass
}
