//! Isotropic elastic materials.
//!
//! From Young's modulus E (Pa), the Poisson ratio nu and the density rho (kg/m^3) follow Lame's moduli
//! `lambda = E nu / ((1 + nu)(1 - 2 nu))`, `mu = E / (2 (1 + nu))` (Pa) and the speeds of waves (m/s): dilatational
//! `c_p = sqrt((lambda + 2 mu) / rho)`, also that of plane strain, and of shear `c_s = sqrt(mu / rho)`.
//! Source: docs/REFERENCES.md, Achenbach 1973. Fails: where a modulus is no positive number in f64.

use crate::error::{ElasticError, positive};

/// A material, known to be a stable solid.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ElasticMaterial {
    young: f64,
    poisson: f64,
    density: f64,
    lambda: f64,
    mu: f64,
}

impl ElasticMaterial {
    /// From Young's modulus (Pa), the Poisson ratio and the density (kg/m^3).
    ///
    /// # Errors
    /// A modulus or density that is not positive and finite, a Poisson ratio outside of (-1, 0.5).
    pub fn new(young: f64, poisson: f64, density: f64) -> Result<Self, ElasticError> {
        positive("Young's modulus", "Pa", young)?;
        positive("the density", "kg/m^3", density)?;
        if !(poisson > -1.0 && poisson < 0.5) {
            return Err(ElasticError::Poisson { value: poisson });
        }
        let mu = young / (2.0 * (1.0 + poisson));
        let lambda = young * poisson / ((1.0 + poisson) * (1.0 - 2.0 * poisson));
        let material = Self { young, poisson, density, lambda, mu };
        positive("the shear modulus", "Pa", mu)?;
        positive("the speed of dilatational waves", "m/s", material.dilatational_speed())?;
        positive("the speed of shear waves", "m/s", material.shear_speed())?;
        Ok(material)
    }

    /// Young's modulus, Pa.
    pub const fn young(&self) -> f64 {
        self.young
    }

    /// The Poisson ratio.
    pub const fn poisson(&self) -> f64 {
        self.poisson
    }

    /// The density, kg/m^3.
    pub const fn density(&self) -> f64 {
        self.density
    }

    /// Lame's first modulus, Pa.
    pub const fn lambda(&self) -> f64 {
        self.lambda
    }

    /// Lame's second modulus, that of shear, Pa.
    pub const fn mu(&self) -> f64 {
        self.mu
    }

    /// Speed of dilatational waves, m/s.
    pub fn dilatational_speed(&self) -> f64 {
        ((self.lambda + 2.0 * self.mu) / self.density).sqrt()
    }

    /// Speed of shear waves, m/s.
    pub fn shear_speed(&self) -> f64 {
        (self.mu / self.density).sqrt()
    }
}
