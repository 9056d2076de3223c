//! Directions.

use glam::DVec3;
use thiserror::Error;

/// Directions that differ by less than this are one (a component, a length, a sine or a cosine to a right angle; no
/// unit): far above the rounding of computed directions, far below the angle of any two faces that are not coplanar.
pub const SAME_DIRECTION: f64 = 1e-9;

/// A vector of length one to round-off.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct UnitVector(DVec3);

/// Why a vector gives no direction.
#[derive(Debug, Clone, Copy, PartialEq, Error)]
#[error("({}, {}, {}) has no direction: a finite vector that is not zero is needed", .0.x, .0.y, .0.z)]
pub struct UnitVectorError(pub DVec3);

impl UnitVector {
    /// The x axis.
    pub const X: Self = Self(DVec3::X);
    /// The y axis.
    pub const Y: Self = Self(DVec3::Y);
    /// The z axis.
    pub const Z: Self = Self(DVec3::Z);

    /// The direction of `vector`, of any length.
    ///
    /// # Errors
    /// When `vector` is zero or not finite.
    pub fn new(vector: DVec3) -> Result<Self, UnitVectorError> {
        // Scaling by the largest component first keeps tiny and huge vectors from under- or overflowing when squared.
        let largest = vector.abs().max_element();
        if !vector.is_finite() || largest == 0.0 {
            return Err(UnitVectorError(vector));
        }
        let scaled = vector / largest;
        Ok(Self(scaled / scaled.length()))
    }

    /// Of a vector that is known to be of length one to round-off.
    pub(crate) const fn known(vector: DVec3) -> Self {
        Self(vector)
    }

    /// The vector.
    pub const fn get(self) -> DVec3 {
        self.0
    }
}

impl std::ops::Neg for UnitVector {
    type Output = Self;
    fn neg(self) -> Self {
        Self(-self.0)
    }
}
