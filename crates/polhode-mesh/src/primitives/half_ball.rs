//! Half-balls: radius r, dome towards +z; origin at 3/8 r above the flat face, the solid's centre of mass.
//!
//! | body | centre above the flat face | along | across, about its centre |
//! |---|---|---|---|
//! | solid | `3/8 r` | `2/5 m r^2` | `83/320 m r^2` |
//! | hollow, flat face included | `1/3 r` | `11/18 m r^2` | `5/12 m r^2` |
//! | dome alone | `1/2 r` | `2/3 m r^2` | `5/12 m r^2` |

use super::error::checked_radius;
use super::revolution::{Profile, arc, revolve};
use super::uniform::{Uniform, across_and_along};
use super::{PrimitiveError, Refinement};
use crate::{Amount, SolidMesh};
use polhode_spatial::MassProperties;
use std::f64::consts::PI;

/// Height of the origin above the flat face, in radii.
const ORIGIN: f64 = 0.375;

/// Half a ball, dome up; its flat face lies 3/8 of the radius below the origin.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct HalfBall {
    radius: f64,
}

impl HalfBall {
    /// Of radius `radius`, m.
    ///
    /// # Errors
    /// [`PrimitiveError::Radius`] when it is not positive and finite.
    pub fn new(radius: f64) -> Result<Self, PrimitiveError> {
        Ok(Self { radius: checked_radius(radius)? })
    }

    /// Filled with matter, from its density (kg/m^3) or mass.
    ///
    /// # Errors
    /// [`PrimitiveError::MassProperties`] when mass or inertia over- or underflow.
    pub fn solid(&self, amount: impl Into<Amount>) -> Result<MassProperties, PrimitiveError> {
        let r2 = self.radius * self.radius;
        let moments = across_and_along(83.0 / 320.0 * r2, 0.4 * r2);
        Uniform::centered(2.0 / 3.0 * PI * r2 * self.radius, moments).body(amount)
    }

    /// All its mass in its surface, flat face included, from its density (kg/m^2) or mass. The centre of mass is
    /// `r / 24` below the origin.
    ///
    /// # Errors
    /// As [`HalfBall::solid`].
    pub fn hollow(&self, amount: impl Into<Amount>) -> Result<MassProperties, PrimitiveError> {
        let r2 = self.radius * self.radius;
        Uniform {
            measure: 3.0 * PI * r2,
            center_z: -self.radius / 24.0,
            moments: across_and_along(5.0 / 12.0 * r2, 11.0 / 18.0 * r2),
        }
        .body(amount)
    }

    /// The dome without the flat face, a bowl, from its density (kg/m^2) or mass. The centre of mass is `r / 8` above
    /// the origin.
    ///
    /// # Errors
    /// As [`HalfBall::solid`].
    pub fn dome(&self, amount: impl Into<Amount>) -> Result<MassProperties, PrimitiveError> {
        let r2 = self.radius * self.radius;
        Uniform {
            measure: 2.0 * PI * r2,
            center_z: self.radius / 8.0,
            moments: across_and_along(5.0 / 12.0 * r2, 2.0 / 3.0 * r2),
        }
        .body(amount)
    }

    /// Its mesh: rings of a circle's segments, a quarter of their number over the dome.
    ///
    /// # Errors
    /// [`PrimitiveError::Mesh`] when its volume over- or underflows.
    pub fn mesh(&self, refinement: Refinement) -> Result<SolidMesh, PrimitiveError> {
        let r = self.radius;
        let rings = arc(refinement).into_iter().map(|[x, z]| [r * x, r * (z - ORIGIN)]).collect();
        revolve(&Profile { bottom: -ORIGIN * r, rings, top: (1.0 - ORIGIN) * r }, refinement)
    }
}
