//! Bodies of uniform density by their measure and their moments per mass.

use super::PrimitiveError;
use crate::Amount;
use glam::DVec3;
use polhode_spatial::{Inertia, MassProperties, MassPropertiesError};

/// A uniform body whose amount of matter is still to be said; its axes are principal.
#[derive(Debug, Clone, Copy)]
pub(super) struct Uniform {
    /// Volume (m^3) of a solid, area (m^2) of a hollow body.
    pub(super) measure: f64,
    /// Height of the centre of mass above the origin, along z, m.
    pub(super) center_z: f64,
    /// Moments about the centre of mass per mass, m^2.
    pub(super) moments: DVec3,
}

impl Uniform {
    /// A body whose centre of mass is the origin.
    pub(super) const fn centered(measure: f64, moments: DVec3) -> Self {
        Self { measure, center_z: 0.0, moments }
    }

    /// With this much matter.
    pub(super) fn body(self, amount: impl Into<Amount>) -> Result<MassProperties, PrimitiveError> {
        let mass = amount.into().mass(self.measure)?;
        let inertia = Inertia::from_diagonal(mass.get() * self.moments).map_err(MassPropertiesError::from)?;
        Ok(MassProperties::new(mass, DVec3::Z * self.center_z, inertia))
    }
}

/// Moments of a body of revolution: twice about the axes across, once about its own.
pub(super) fn across_and_along(across: f64, along: f64) -> DVec3 {
    DVec3::new(across, across, along)
}
