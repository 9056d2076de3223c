//! Ellipsoids: semi-axes a, b, c; moments about x, the others by turns.
//!
//! | body | moment |
//! |---|---|
//! | solid | `m (b^2 + c^2) / 5` |
//! | hollow | `m (<y^2> + <z^2>)`, means over the surface: elliptic integrals, see `surface_moments` |

use super::icosphere::icosphere;
use super::surface_moments::surface_moments;
use super::uniform::Uniform;
use super::{PrimitiveError, Refinement};
use crate::{Amount, SolidMesh};
use glam::DVec3;
use polhode_spatial::MassProperties;
use std::f64::consts::PI;

/// An ellipsoid about the origin, its axes along the coordinate axes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Ellipsoid {
    semi_axes: DVec3,
}

impl Ellipsoid {
    /// With semi-axes `semi_axes`, m.
    ///
    /// # Errors
    /// [`PrimitiveError::SemiAxes`] when one is not positive and finite.
    pub fn new(semi_axes: DVec3) -> Result<Self, PrimitiveError> {
        if semi_axes.cmpgt(DVec3::ZERO).all() && semi_axes.is_finite() {
            Ok(Self { semi_axes })
        } else {
            Err(PrimitiveError::SemiAxes(semi_axes))
        }
    }

    /// Filled with matter, from its density (kg/m^3) or mass.
    ///
    /// # Errors
    /// [`PrimitiveError::MassProperties`] when mass or inertia over- or underflow.
    pub fn solid(&self, amount: impl Into<Amount>) -> Result<MassProperties, PrimitiveError> {
        let s2 = self.semi_axes * self.semi_axes;
        let moments = DVec3::new(s2.y + s2.z, s2.z + s2.x, s2.x + s2.y) / 5.0;
        Uniform::centered(4.0 / 3.0 * PI * self.semi_axes.element_product(), moments).body(amount)
    }

    /// All its mass in its surface, uniform per area, from its density (kg/m^2) or mass.
    ///
    /// # Errors
    /// As [`Ellipsoid::solid`].
    pub fn hollow(&self, amount: impl Into<Amount>) -> Result<MassProperties, PrimitiveError> {
        let (area, squares) = surface_moments(self.semi_axes);
        let moments = DVec3::new(squares.y + squares.z, squares.z + squares.x, squares.x + squares.y);
        Uniform::centered(area, moments).body(amount)
    }

    /// The mesh of a sphere, stretched.
    ///
    /// # Errors
    /// [`PrimitiveError::Mesh`] when it is so thin that it is flat to rounding.
    pub fn mesh(&self, refinement: Refinement) -> Result<SolidMesh, PrimitiveError> {
        Ok(SolidMesh::new(icosphere(refinement, self.semi_axes)?)?)
    }
}
