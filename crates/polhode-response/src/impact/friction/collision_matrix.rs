//! The collision matrix of one contact: what an impulse there does to the velocity there.
//!
//! `u+ = u- + K p` with `u = (u_n, u_t1, u_t2)` the relative velocity of A over B at the contact point, `p` the impulse
//! on A in the same axes (normal from B to A, then two tangents) and
//! `K = (1/m_A + 1/m_B) 1 - [r_A]x I_A^-1 [r_A]x - [r_B]x I_B^-1 [r_B]x`, 1/kg: the three rows of the contact in the
//! Delassus matrix. `K` is symmetric and positive semidefinite. It is singular where joints hold the bodies: a body on
//! a pivot feels no impulse along the arm.
//!
//! Source: Routh 1905, chapter 5; Keller 1986; Mirtich 1996 (the name).

use super::plane::{self, Symmetric, Tangent};
use crate::delassus::Delassus;
use crate::error::{ResponseError, check_finite};
use crate::tolerances::MATRIX_ROUNDING;
use polhode_spatial::rounding;

/// The collision matrix of one contact, 1/kg.
///
/// ```
/// use polhode_response::CollisionMatrix;
/// // A solid sphere of 1 kg and radius 1 m on a floor: 1/m along the normal, 1/m + r^2/I = 7/2 along the floor.
/// let sphere = CollisionMatrix::new([[1.0, 0.0, 0.0], [0.0, 3.5, 0.0], [0.0, 0.0, 3.5]])?;
/// assert_eq!(sphere.times([2.0, -0.2, 0.0]), [2.0, -0.7000000000000001, 0.0]);
/// # Ok::<(), polhode_response::ResponseError>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CollisionMatrix {
    pub(super) normal: f64,
    pub(super) coupling: Tangent,
    pub(super) tangential: Symmetric,
}

impl CollisionMatrix {
    /// From the whole matrix, rows and columns in the order normal, first tangent, second tangent.
    ///
    /// # Errors
    /// When an entry is not finite, the normal entry is not above zero, or the matrix is not symmetric and positive
    /// semidefinite to rounding.
    pub fn new(matrix: [[f64; 3]; 3]) -> Result<Self, ResponseError> {
        check_finite("collision matrix", matrix.as_flattened())?;
        for (i, j) in [(0, 1), (0, 2), (1, 2)] {
            let size = (matrix[i][i].abs() * matrix[j][j].abs()).sqrt();
            if (matrix[i][j] - matrix[j][i]).abs() > MATRIX_ROUNDING * size {
                return Err(ResponseError::CollisionMatrix);
            }
        }
        let mean = |i: usize, j: usize| 0.5 * matrix[i][j] + 0.5 * matrix[j][i];
        let found = Self {
            normal: matrix[0][0],
            coupling: [mean(0, 1), mean(0, 2)],
            tangential: [matrix[1][1], mean(1, 2), matrix[2][2]],
        };
        if found.is_semidefinite() { Ok(found) } else { Err(ResponseError::CollisionMatrix) }
    }

    /// Of a contact in a plane, with one tangent: the entries `K_nn`, `K_nt`, `K_tt`. Motion out of the plane is
    /// uncoupled from it.
    ///
    /// # Errors
    /// Those of [`new`](Self::new).
    pub fn planar(normal: f64, coupling: f64, tangential: f64) -> Result<Self, ResponseError> {
        Self::new([[normal, coupling, 0.0], [coupling, tangential, 0.0], [0.0, 0.0, tangential]])
    }

    /// Of the contact whose normal and tangent rows are these rows of a Delassus matrix.
    ///
    /// # Errors
    /// When a row does not exist; those of [`new`](Self::new).
    pub fn of_rows(delassus: &Delassus, rows: [usize; 3]) -> Result<Self, ResponseError> {
        if let Some(&row) = rows.iter().find(|row| **row >= delassus.len()) {
            return Err(ResponseError::UnknownRow { row, rows: delassus.len() });
        }
        Self::new(rows.map(|i| rows.map(|j| delassus.get(i, j))))
    }

    /// The whole matrix, in the order of [`new`](Self::new).
    pub const fn entries(&self) -> [[f64; 3]; 3] {
        let ([k1, k2], [t11, t12, t22]) = (self.coupling, self.tangential);
        [[self.normal, k1, k2], [k1, t11, t12], [k2, t12, t22]]
    }

    /// `K p`: the change of velocity by an impulse, m/s.
    pub fn times(&self, impulse: [f64; 3]) -> [f64; 3] {
        let tangential = [impulse[1], impulse[2]];
        let normal = self.normal * impulse[0] + plane::dot(self.coupling, tangential);
        let along = plane::times(self.tangential, tangential);
        [normal, self.coupling[0] * impulse[0] + along[0], self.coupling[1] * impulse[0] + along[1]]
    }

    /// The coefficient of friction above which a contact that slips in this direction jams (Painleve): there a normal
    /// force, with the friction that comes with it, accelerates the bodies into each other. `K_nn / (K_nt . d)`; none
    /// where no coefficient does so.
    ///
    /// ```
    /// use polhode_response::CollisionMatrix;
    /// // A rod of 1 kg and 2 m at 45 degrees, pushed along by its upper end: 5/3.
    /// let rod = CollisionMatrix::planar(2.5, -1.5, 2.5)?;
    /// assert_eq!(rod.critical_friction([-1.0, 0.0]), Some(2.5 / 1.5));
    /// assert_eq!(rod.critical_friction([1.0, 0.0]), None);
    /// # Ok::<(), polhode_response::ResponseError>(())
    /// ```
    pub fn critical_friction(&self, slip: [f64; 2]) -> Option<f64> {
        let pull = plane::dot(self.coupling, plane::direction(slip)?);
        (pull > 0.0).then(|| self.normal / pull)
    }

    /// `K_tt^-1 a`, the least solution where the tangential part is singular.
    pub(super) fn solve_tangential(&self, a: Tangent) -> Tangent {
        plane::solve(self.tangential, a, rounding::HUNDREDS_OF_TERMS)
    }

    /// The matrix over a power of two near its largest diagonal entry, and that power: divisions by it are exact.
    pub(super) fn over_power_of_two(&self) -> (Self, f64) {
        let power = power_of_two(self.normal.max(self.tangential[0]).max(self.tangential[2]));
        let scaled = Self {
            normal: self.normal / power,
            coupling: self.coupling.map(|k| k / power),
            tangential: self.tangential.map(|k| k / power),
        };
        (scaled, power)
    }

    fn is_semidefinite(&self) -> bool {
        let (k, [t11, t12, t22]) = (self.coupling, self.tangential);
        if !(self.normal > 0.0 && t11 >= 0.0 && t22 >= 0.0) {
            return false;
        }
        // What is left of the tangential part below the normal pivot: its diagonal and its determinant.
        let rest =
            [t11 - k[0] * (k[0] / self.normal), t12 - k[0] * (k[1] / self.normal), t22 - k[1] * (k[1] / self.normal)];
        let rounding = [MATRIX_ROUNDING * t11, MATRIX_ROUNDING * t22];
        if rest[0] < -rounding[0] || rest[2] < -rounding[1] {
            return false;
        }
        let (first, second) = (rest[0].max(0.0) + rounding[0], rest[2].max(0.0) + rounding[1]);
        rest[1] * rest[1] <= first * second * (1.0 + MATRIX_ROUNDING) + MATRIX_ROUNDING * t11 * t22
    }
}

/// The largest power of two that is not above a positive number; that of the smallest normal number below it.
pub(super) fn power_of_two(x: f64) -> f64 {
    const EXPONENT: u64 = 0x7ff << 52;
    f64::from_bits(x.abs().max(f64::MIN_POSITIVE).to_bits() & EXPONENT)
}
