//! Principal axes: eigenvalues and eigenvectors of symmetric 3x3 matrices.
//!
//! Cyclic Jacobi rotations: each rotation zeroes one off-diagonal element; the sum of their squares falls
//! quadratically, and small eigenvalues of graded matrices (a needle: 1e-13 beside 1e-1) keep their relative accuracy,
//! which the trigonometric solution of the cubic loses. Source: docs/REFERENCES.md, Golub and Van Loan 8.5.

use crate::Rotation;
use glam::{DMat3, DVec3};

/// Principal moments in ascending order and the right-handed axes that belong to them.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PrincipalAxes {
    moments: DVec3,
    rotation: Rotation,
}

impl PrincipalAxes {
    /// Of a symmetric matrix (its upper triangle is read).
    ///
    /// A matrix that is diagonal keeps its axes up to order: no rotation is applied that round-off alone would cause.
    /// The signs are made deterministic: the largest component of the first two axes is positive, the third follows
    /// from the right hand.
    pub fn of(matrix: &DMat3) -> Self {
        let (values, vectors) = symmetric_eigen(matrix);
        let mut order = [0usize, 1, 2];
        order.sort_by(|&i, &j| values[i].total_cmp(&values[j]));
        let axis = |i: usize| positive_largest(vectors.col(order[i]));
        let (x, y) = (axis(0), axis(1));
        let z = x.cross(y);
        Self {
            moments: DVec3::new(values[order[0]], values[order[1]], values[order[2]]),
            rotation: Rotation::from_matrix(&DMat3::from_cols(x, y, z)),
        }
    }

    /// Principal moments, ascending, kg m^2.
    pub const fn moments(&self) -> DVec3 {
        self.moments
    }

    /// `R_BP`: turns components along the principal axes P into components along the body axes B.
    pub const fn rotation(&self) -> Rotation {
        self.rotation
    }
}

/// `vector` or its opposite, whichever has a positive largest component.
fn positive_largest(vector: DVec3) -> DVec3 {
    let a = vector.abs();
    let largest = if a.x >= a.y && a.x >= a.z {
        vector.x
    } else if a.y >= a.z {
        vector.y
    } else {
        vector.z
    };
    if largest < 0.0 { -vector } else { vector }
}

/// Eigenvalues and eigenvectors (columns) of a symmetric matrix, unordered.
fn symmetric_eigen(matrix: &DMat3) -> (DVec3, DMat3) {
    let mut a = matrix.to_cols_array_2d();
    for (i, j) in [(0, 1), (0, 2), (1, 2)] {
        // a[column][row]: the upper triangle has column > row.
        a[i][j] = a[j][i];
    }
    let mut v = DMat3::IDENTITY.to_cols_array_2d();
    // Each rotation lessens the sum of squares off the diagonal, soon quadratically, until they are negligible; five or
    // six sweeps are usual. What is not finite counts as negligible.
    loop {
        let mut rotated = false;
        for (p, q) in [(0, 1), (0, 2), (1, 2)] {
            rotated |= jacobi_rotate(&mut a, &mut v, p, q);
        }
        if !rotated {
            break;
        }
    }
    (DVec3::new(a[0][0], a[1][1], a[2][2]), DMat3::from_cols_array_2d(&v))
}

/// Zeroes `a[p][q]` by a rotation in the plane (p, q); false when it is already negligible.
fn jacobi_rotate(a: &mut [[f64; 3]; 3], v: &mut [[f64; 3]; 3], p: usize, q: usize) -> bool {
    let apq = a[p][q];
    // Negligible means: below the round-off of the geometric mean of the two diagonal elements, the criterion that
    // keeps small eigenvalues of positive definite matrices accurate (Demmel and Veselic).
    let scale = (a[p][p].abs().sqrt()) * (a[q][q].abs().sqrt());
    if apq == 0.0 || apq.abs() <= 0.5 * f64::EPSILON * scale || !apq.is_finite() {
        a[p][q] = 0.0;
        a[q][p] = 0.0;
        return false;
    }
    let theta = (a[q][q] - a[p][p]) / (2.0 * apq);
    let t = theta.signum() / (theta.abs() + (theta * theta + 1.0).sqrt());
    let c = 1.0 / (t * t + 1.0).sqrt();
    let s = t * c;
    let r = 3 - p - q;
    a[p][p] -= t * apq;
    a[q][q] += t * apq;
    a[p][q] = 0.0;
    a[q][p] = 0.0;
    let (arp, arq) = (a[r][p], a[r][q]);
    a[r][p] = c * arp - s * arq;
    a[r][q] = s * arp + c * arq;
    a[p][r] = a[r][p];
    a[q][r] = a[r][q];
    for k in 0..3 {
        let (vp, vq) = (v[p][k], v[q][k]);
        v[p][k] = c * vp - s * vq;
        v[q][k] = s * vp + c * vq;
    }
    true
}
