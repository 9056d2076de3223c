//! Cones: radius r of the base, height h along z; origin at h/4 above the base, the solid's centre of mass.
//!
//! | body | centre above the base | along | across, about its centre |
//! |---|---|---|---|
//! | solid | `h / 4` | `3/10 m r^2` | `m (3/20 r^2 + 3/80 h^2)` |
//! | hollow side, `s / (s + r)` of the mass | `h / 3` | `m r^2 / 2` | `m (r^2 / 4 + h^2 / 18)` |
//! | hollow base, `r / (s + r)` of the mass | `0` | `m r^2 / 2` | `m r^2 / 4` |
//!
//! with the slant height `s = sqrt(r^2 + h^2)`.

use super::error::{checked_height, checked_radius};
use super::revolution::{Profile, revolve};
use super::uniform::{Uniform, across_and_along};
use super::{PrimitiveError, Refinement};
use crate::{Amount, SolidMesh};
use polhode_spatial::MassProperties;
use std::f64::consts::PI;

/// A cone along z, apex up; its base lies a quarter of the height below the origin.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Cone {
    radius: f64,
    height: f64,
}

impl Cone {
    /// Of these sizes, m.
    ///
    /// # Errors
    /// [`PrimitiveError::Radius`], [`PrimitiveError::Height`] when one is not positive and finite.
    pub fn new(radius: f64, height: f64) -> Result<Self, PrimitiveError> {
        Ok(Self { radius: checked_radius(radius)?, height: checked_height(height)? })
    }

    /// Filled with matter, from its density (kg/m^3) or mass.
    ///
    /// # Errors
    /// [`PrimitiveError::MassProperties`] when mass or inertia over- or underflow.
    pub fn solid(&self, amount: impl Into<Amount>) -> Result<MassProperties, PrimitiveError> {
        let (r2, h2) = (self.radius * self.radius, self.height * self.height);
        let moments = across_and_along((4.0 * r2 + h2) * 3.0 / 80.0, r2 * 3.0 / 10.0);
        Uniform::centered(PI * r2 * self.height / 3.0, moments).body(amount)
    }

    /// All its mass in its surface, base included, from its density (kg/m^2) or mass. The centre of mass is above or
    /// below the origin.
    ///
    /// # Errors
    /// As [`Cone::solid`].
    pub fn hollow(&self, amount: impl Into<Amount>) -> Result<MassProperties, PrimitiveError> {
        let (r, h) = (self.radius, self.height);
        let slant = libm::hypot(r, h);
        let (side, base) = (slant / (slant + r), r / (slant + r));
        let arm = h / 3.0;
        let across = r * r / 4.0 + side * h * h / 18.0 + side * base * arm * arm;
        Uniform {
            measure: PI * r * (slant + r),
            center_z: side * arm - 0.25 * h,
            moments: across_and_along(across, 0.5 * r * r),
        }
        .body(amount)
    }

    /// The pyramid over a regular polygon inscribed in its base.
    ///
    /// # Errors
    /// [`PrimitiveError::Mesh`] when it is so thin that it is flat to rounding.
    pub fn mesh(&self, refinement: Refinement) -> Result<SolidMesh, PrimitiveError> {
        let (base, apex) = (-0.25 * self.height, 0.75 * self.height);
        revolve(&Profile { bottom: base, rings: vec![[self.radius, base]], top: apex }, refinement)
    }
}
