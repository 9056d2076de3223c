//! Spheres: moments `2/5 m r^2` (solid) and `2/3 m r^2` (hollow) about any axis through the centre.

use super::error::checked_radius;
use super::icosphere::icosphere;
use super::uniform::Uniform;
use super::{PrimitiveError, Refinement};
use crate::{Amount, SolidMesh};
use glam::DVec3;
use polhode_spatial::MassProperties;
use std::f64::consts::PI;

/// A sphere about the origin.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Sphere {
    radius: f64,
}

impl Sphere {
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
        Uniform::centered(4.0 / 3.0 * PI * r2 * self.radius, DVec3::splat(0.4 * r2)).body(amount)
    }

    /// All its mass in its surface, from its density (kg/m^2) or mass.
    ///
    /// # Errors
    /// As [`Sphere::solid`].
    pub fn hollow(&self, amount: impl Into<Amount>) -> Result<MassProperties, PrimitiveError> {
        let r2 = self.radius * self.radius;
        Uniform::centered(4.0 * PI * r2, DVec3::splat(2.0 / 3.0 * r2)).body(amount)
    }

    /// The icosahedron in the sphere, its triangles split into four as often as asked, with new vertices on the sphere.
    ///
    /// # Errors
    /// [`PrimitiveError::Mesh`] when its volume over- or underflows.
    pub fn mesh(&self, refinement: Refinement) -> Result<SolidMesh, PrimitiveError> {
        Ok(SolidMesh::new(icosphere(refinement, DVec3::splat(self.radius))?)?)
    }
}

/// A solid sphere of radius `radius` (m), from its density (kg/m^3) or mass: [`Sphere::solid`].
///
/// # Errors
/// [`PrimitiveError`] when `radius` is not positive and finite, or mass or inertia over- or underflow.
pub fn solid_sphere(radius: f64, amount: impl Into<Amount>) -> Result<MassProperties, PrimitiveError> {
    Sphere::new(radius)?.solid(amount)
}

/// A hollow sphere of radius `radius` (m), from its density (kg/m^2) or mass: [`Sphere::hollow`].
///
/// # Errors
/// As [`solid_sphere`].
pub fn hollow_sphere(radius: f64, amount: impl Into<Amount>) -> Result<MassProperties, PrimitiveError> {
    Sphere::new(radius)?.hollow(amount)
}
