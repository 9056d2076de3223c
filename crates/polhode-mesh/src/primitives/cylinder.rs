//! Cylinders: radius r, height h along z.
//!
//! | body | along | across |
//! |---|---|---|
//! | solid | `m r^2 / 2` | `m (r^2 / 4 + h^2 / 12)` |
//! | hollow wall, `h / (h + r)` of the mass | `m r^2` | `m (r^2 / 2 + h^2 / 12)` |
//! | hollow ends, `r / (h + r)` of the mass | `m r^2 / 2` | `m (r^2 / 4 + h^2 / 4)` |

use super::error::{checked_height, checked_radius};
use super::revolution::{Profile, revolve};
use super::uniform::{Uniform, across_and_along};
use super::{PrimitiveError, Refinement};
use crate::{Amount, SolidMesh};
use polhode_spatial::MassProperties;
use std::f64::consts::PI;

/// A cylinder about the origin, along z.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Cylinder {
    radius: f64,
    height: f64,
}

impl Cylinder {
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
        let moments = across_and_along(r2 / 4.0 + h2 / 12.0, r2 / 2.0);
        Uniform::centered(PI * r2 * self.height, moments).body(amount)
    }

    /// All its mass in its surface, ends included, from its density (kg/m^2) or mass.
    ///
    /// # Errors
    /// As [`Cylinder::solid`].
    pub fn hollow(&self, amount: impl Into<Amount>) -> Result<MassProperties, PrimitiveError> {
        let (r, h) = (self.radius, self.height);
        let (r2, h2) = (r * r, h * h);
        let (wall, ends) = (h / (h + r), r / (h + r));
        let across = wall * (r2 / 2.0 + h2 / 12.0) + ends * (r2 / 4.0 + h2 / 4.0);
        let along = wall * r2 + ends * r2 / 2.0;
        Uniform::centered(2.0 * PI * r * (h + r), across_and_along(across, along)).body(amount)
    }

    /// The prism over a regular polygon inscribed in its circle.
    ///
    /// # Errors
    /// [`PrimitiveError::Mesh`] when it is so thin that it is flat to rounding.
    pub fn mesh(&self, refinement: Refinement) -> Result<SolidMesh, PrimitiveError> {
        let half = 0.5 * self.height;
        let rings = vec![[self.radius, -half], [self.radius, half]];
        revolve(&Profile { bottom: -half, rings, top: half }, refinement)
    }
}
