//! Capsules: radius r, height h along z without the two caps, which are half-balls.
//!
//! | body | along | across |
//! |---|---|---|
//! | solid cylinder, `h / (h + 4/3 r)` of the mass | `m r^2 / 2` | `m (r^2 / 4 + h^2 / 12)` |
//! | solid caps, the rest | `2/5 m r^2` | `m (2/5 r^2 + 3/8 h r + h^2 / 4)` |
//! | hollow wall, `h / (h + 2 r)` of the mass | `m r^2` | `m (r^2 / 2 + h^2 / 12)` |
//! | hollow caps, the rest | `2/3 m r^2` | `m (2/3 r^2 + 1/2 h r + h^2 / 4)` |

use super::error::{checked_height, checked_radius};
use super::revolution::{Profile, arc, revolve};
use super::uniform::{Uniform, across_and_along};
use super::{PrimitiveError, Refinement};
use crate::{Amount, SolidMesh};
use polhode_spatial::MassProperties;
use std::f64::consts::PI;

/// A capsule about the origin, along z.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Capsule {
    radius: f64,
    height: f64,
}

impl Capsule {
    /// Of these sizes, m; the height is without the caps, so that the capsule is `height + 2 radius` long.
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
        let (r, h) = (self.radius, self.height);
        let (r2, h2) = (r * r, h * h);
        let ball = 4.0 / 3.0 * r;
        let (cylinder, caps) = (h / (h + ball), ball / (h + ball));
        let across = cylinder * (r2 / 4.0 + h2 / 12.0) + caps * (0.4 * r2 + 0.375 * h * r + h2 / 4.0);
        let along = cylinder * r2 / 2.0 + caps * 0.4 * r2;
        Uniform::centered(PI * r2 * (h + ball), across_and_along(across, along)).body(amount)
    }

    /// All its mass in its surface, from its density (kg/m^2) or mass.
    ///
    /// # Errors
    /// As [`Capsule::solid`].
    pub fn hollow(&self, amount: impl Into<Amount>) -> Result<MassProperties, PrimitiveError> {
        let (r, h) = (self.radius, self.height);
        let (r2, h2) = (r * r, h * h);
        let (wall, caps) = (h / (h + 2.0 * r), 2.0 * r / (h + 2.0 * r));
        let across = wall * (r2 / 2.0 + h2 / 12.0) + caps * (2.0 / 3.0 * r2 + 0.5 * h * r + h2 / 4.0);
        let along = wall * r2 + caps * 2.0 / 3.0 * r2;
        Uniform::centered(2.0 * PI * r * (h + 2.0 * r), across_and_along(across, along)).body(amount)
    }

    /// Its mesh: rings of a circle's segments, a quarter of their number over each cap.
    ///
    /// # Errors
    /// [`PrimitiveError::Mesh`] when it is so thin that it is flat to rounding.
    pub fn mesh(&self, refinement: Refinement) -> Result<SolidMesh, PrimitiveError> {
        let half = 0.5 * self.height;
        let upper: Vec<[f64; 2]> =
            arc(refinement).into_iter().map(|[x, z]| [self.radius * x, half + self.radius * z]).collect();
        let lower = upper.iter().rev().map(|&[x, z]| [x, -z]);
        let end = half + self.radius;
        revolve(&Profile { bottom: -end, rings: lower.chain(upper.iter().copied()).collect(), top: end }, refinement)
    }
}
