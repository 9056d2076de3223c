//! Rotations as unit quaternions.
//!
//! `q = cos(a/2) + n sin(a/2)` turns by the angle `a` (rad, anticlockwise) about the unit vector `n`; the rotated
//! vector is `q v q*` and `q^-1 = q*` (thesis 3.3, with erratum E10). `q` and `-q` are the same rotation.
//! Sines and cosines come from `libm`, so that results have the same bits on every platform.

use glam::{DMat3, DQuat, DVec3};
use thiserror::Error;

/// How far from one the length of a quaternion may be for it to be taken as a rounded unit quaternion (dimensionless).
/// Six digits are what a person types; more is an error of meaning that normalisation would hide.
pub const NORM_TOLERANCE: f64 = 1e-6;

/// Below this angle (rad) sin and cos are replaced by their Taylor series, whose first omitted term is below 1e-17.
const SMALL_ANGLE: f64 = 1e-4;

/// Squares between this and its inverse have all their digits, with room for four of them (dimensionless; the smallest
/// normal f64 is 2.2e-308).
const SAFE_SQUARE: f64 = 1e-290;

/// A rotation: `R_AB` turns the components of a vector in B into its components in A.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Rotation(DQuat);

/// Why four numbers are no rotation.
#[derive(Debug, Clone, Copy, PartialEq, Error)]
pub enum RotationError {
    /// The quaternion's length is too far from one.
    #[error("quaternion [w, x, y, z] = {wxyz:?} has length {norm}, which must be 1 within {NORM_TOLERANCE:e}")]
    NotUnit {
        /// The quaternion as given, scalar first.
        wxyz: [f64; 4],
        /// Its length.
        norm: f64,
    },
    /// A component is NaN or infinite.
    #[error("rotation {0:?} has a component that is not finite")]
    NotFinite([f64; 4]),
}

impl Default for Rotation {
    fn default() -> Self {
        Self::IDENTITY
    }
}

impl Rotation {
    /// No rotation.
    pub const IDENTITY: Self = Self(DQuat::IDENTITY);

    /// From a quaternion, scalar first, that is of unit length within [`NORM_TOLERANCE`]; it is normalised.
    ///
    /// # Errors
    /// When a component is not finite or the length is off by more than [`NORM_TOLERANCE`].
    pub fn from_wxyz(wxyz: [f64; 4]) -> Result<Self, RotationError> {
        let [w, x, y, z] = wxyz;
        if wxyz.iter().any(|c| !c.is_finite()) {
            return Err(RotationError::NotFinite(wxyz));
        }
        let q = DQuat::from_xyzw(x, y, z, w);
        let norm = q.length();
        // Also refuses an overflowing length.
        if (norm - 1.0).abs() <= NORM_TOLERANCE {
            Ok(Self::renormalized(q))
        } else {
            Err(RotationError::NotUnit { wxyz, norm })
        }
    }

    /// The rotation whose components, scalar first, [`Rotation::to_wxyz`] has given: it keeps their bits, which
    /// [`Rotation::from_wxyz`] may round once more.
    ///
    /// # Errors
    /// As [`Rotation::from_wxyz`].
    pub fn from_stored_wxyz(wxyz: [f64; 4]) -> Result<Self, RotationError> {
        Self::from_wxyz(wxyz)?;
        let [w, x, y, z] = wxyz;
        Ok(Self(DQuat::from_xyzw(x, y, z, w)))
    }

    /// From a quaternion that arithmetic has moved off the unit sphere; any non-zero finite length is accepted, and
    /// anything else gives NaN, which the next check of the state reports.
    #[inline]
    pub fn renormalized(q: DQuat) -> Self {
        let length_squared = q.length_squared();
        // A quaternion that is already normalised to round-off keeps its bits.
        if (length_squared - 1.0).abs() <= 2.0 * f64::EPSILON {
            return Self(q);
        }
        if (SAFE_SQUARE..=1.0 / SAFE_SQUARE).contains(&length_squared) {
            return Self(q / length_squared.sqrt());
        }
        // The square has lost digits at the ends of f64: bring the largest component to one first.
        let scaled = q / q.x.abs().max(q.y.abs()).max(q.z.abs()).max(q.w.abs());
        Self(scaled / scaled.length())
    }

    /// Rotation by `|vector|` radians about the direction of `vector`; NaN, which the next check of the state reports,
    /// when `vector` is not finite or longer than 1e154.
    pub fn from_rotation_vector(vector: DVec3) -> Self {
        let angle = vector.length();
        let (half_sin_over_angle, half_cos) = if angle < SMALL_ANGLE {
            let a2 = angle * angle;
            (0.5 - a2 / 48.0 + a2 * a2 / 3840.0, 1.0 - a2 / 8.0 + a2 * a2 / 384.0)
        } else {
            (libm::sin(0.5 * angle) / angle, libm::cos(0.5 * angle))
        };
        let v = vector * half_sin_over_angle;
        Self::renormalized(DQuat::from_xyzw(v.x, v.y, v.z, half_cos))
    }

    /// The rotation vector of at most half a turn, rad: the inverse of [`Rotation::from_rotation_vector`].
    pub fn to_rotation_vector(self) -> DVec3 {
        let v = DVec3::new(self.0.x, self.0.y, self.0.z);
        let sine = v.length();
        // The quaternion and its opposite are one rotation; the one with w >= 0 turns the short way.
        let (v, w) = if self.0.w < 0.0 { (-v, -self.0.w) } else { (v, self.0.w) };
        if sine == 0.0 { DVec3::ZERO } else { v * (2.0 * libm::atan2(sine, w) / sine) }
    }

    /// From a matrix that is a rotation to round-off (columns are the images of the axes).
    pub fn from_matrix(matrix: &DMat3) -> Self {
        Self::renormalized(DQuat::from_mat3(matrix))
    }

    /// The quaternion.
    #[inline]
    pub const fn quaternion(self) -> DQuat {
        self.0
    }

    /// The quaternion's components, scalar first.
    pub fn to_wxyz(self) -> [f64; 4] {
        [self.0.w, self.0.x, self.0.y, self.0.z]
    }

    /// The matrix whose columns are the images of the axes.
    #[inline]
    pub fn to_matrix(self) -> DMat3 {
        DMat3::from_quat(self.0)
    }

    /// The inverse rotation.
    #[inline]
    pub fn inverse(self) -> Self {
        Self(self.0.conjugate())
    }

    /// Turns `v_B` into `v_A`.
    #[inline]
    pub fn rotate(self, vector: DVec3) -> DVec3 {
        // Rodrigues in quaternion form, v + 2 w (u x v) + 2 u x (u x v): exact for the identity, unlike q v q*.
        let u = DVec3::new(self.0.x, self.0.y, self.0.z);
        let t = 2.0 * u.cross(vector);
        vector + self.0.w * t + u.cross(t)
    }

    /// Turns `v_A` into `v_B`.
    #[inline]
    pub fn inverse_rotate(self, vector: DVec3) -> DVec3 {
        self.inverse().rotate(vector)
    }

    /// Angle between two rotations, rad, in [0, pi]; accurate also for tiny angles.
    pub fn angle_to(self, other: Self) -> f64 {
        let d = self.0.conjugate() * other.0;
        2.0 * libm::atan2(DVec3::new(d.x, d.y, d.z).length(), d.w.abs())
    }

    /// Whether every component is finite.
    #[inline]
    pub fn is_finite(self) -> bool {
        self.0.is_finite()
    }
}

impl std::ops::Mul for Rotation {
    type Output = Self;
    /// `R_AC = R_AB * R_BC`.
    #[inline]
    fn mul(self, other: Self) -> Self {
        Self::renormalized(self.0 * other.0)
    }
}
