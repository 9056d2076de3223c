//! Poses: rotation and translation of one frame in another.
//!
//! `X_AB = (R_AB, p_AB)` maps the components of a point in B to its components in A: `p_AQ = R_AB p_BQ + p_AB`
//! (thesis 3.2, "R x + r").

use crate::Rotation;
use glam::DVec3;

/// The pose `X_AB` of frame B in frame A.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Pose {
    /// `R_AB`.
    pub rotation: Rotation,
    /// `p_AB`, m.
    pub translation: DVec3,
}

impl Pose {
    /// The frames coincide.
    pub const IDENTITY: Self = Self { rotation: Rotation::IDENTITY, translation: DVec3::ZERO };

    /// From its two parts.
    #[inline]
    pub const fn new(rotation: Rotation, translation: DVec3) -> Self {
        Self { rotation, translation }
    }

    /// A translation without rotation.
    #[inline]
    pub const fn from_translation(translation: DVec3) -> Self {
        Self { rotation: Rotation::IDENTITY, translation }
    }

    /// `p_AQ` from `p_BQ`.
    #[inline]
    pub fn transform_point(&self, point: DVec3) -> DVec3 {
        self.rotation.rotate(point) + self.translation
    }

    /// `p_BQ` from `p_AQ`.
    #[inline]
    pub fn inverse_transform_point(&self, point: DVec3) -> DVec3 {
        self.rotation.inverse_rotate(point - self.translation)
    }

    /// `X_BA`.
    #[inline]
    pub fn inverse(&self) -> Self {
        let rotation = self.rotation.inverse();
        Self { rotation, translation: -rotation.rotate(self.translation) }
    }

    /// `X_BC` from `X_AB` (self) and `X_AC`: the pose of `other` seen from `self`, formed from the difference of the
    /// translations, so that two frames far from the origin lose no digits.
    #[inline]
    pub fn relative(&self, other: &Self) -> Self {
        let inverse = self.rotation.inverse();
        Self { rotation: inverse * other.rotation, translation: inverse.rotate(other.translation - self.translation) }
    }

    /// Whether every component is finite.
    #[inline]
    pub fn is_finite(&self) -> bool {
        self.rotation.is_finite() && self.translation.is_finite()
    }
}

impl std::ops::Mul for Pose {
    type Output = Self;
    /// `X_AC = X_AB * X_BC`.
    fn mul(self, other: Self) -> Self {
        Self { rotation: self.rotation * other.rotation, translation: self.transform_point(other.translation) }
    }
}
