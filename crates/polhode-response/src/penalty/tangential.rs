//! Stiffness of a contact along its tangent plane, after Mindlin, and the elastic constants of two materials.
//!
//! ```text
//! 1/E* = (1 - nu_1^2)/E_1 + (1 - nu_2^2)/E_2,    1/G* = 2 (2 - nu_1)(1 + nu_1)/E_1 + 2 (2 - nu_2)(1 + nu_2)/E_2
//! k_n = (4/3) E* sqrt(R)   (F = k_n d^(3/2)),     k_t = 8 G* sqrt(R d)
//! ```
//!
//! d is the overlap (m), R the effective radius of curvature (m), E Young's modulus (Pa), nu Poisson's ratio. A linear
//! spring has the constant ratio `k_t/k_n = 2 (1 - nu)/(2 - nu)` instead, which is that of two balls of one material
//! (Mindlin). A rigid material has an infinite modulus. Source: docs/REFERENCES.md, Johnson; Mindlin. How it fails: two
//! rigid materials have no finite constants; that is refused where constants are made.

use super::{Growth, SpringError};

/// E* and G* of two materials.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ElasticPair {
    /// E*, Pa.
    pub normal_modulus: f64,
    /// G*, Pa.
    pub shear_modulus: f64,
}

impl ElasticPair {
    /// Of two materials, each Young's modulus (Pa) and Poisson's ratio; `None` is rigid.
    ///
    /// # Errors
    /// When both are rigid, or a modulus is not positive and finite.
    pub fn new(materials: [Option<[f64; 2]>; 2]) -> Result<Self, SpringError> {
        let (mut normal, mut shear) = (0.0, 0.0);
        for [young, poisson] in materials.into_iter().flatten() {
            if !(young.is_finite() && young > 0.0) {
                return Err(SpringError::Number { what: "Young's modulus (Pa)", value: young });
            }
            normal += (1.0 - poisson * poisson) / young;
            shear += 2.0 * (2.0 - poisson) * (1.0 + poisson) / young;
        }
        if !(normal > 0.0 && shear > 0.0) {
            return Err(SpringError::Number { what: "the compliance (1/Pa) of two materials", value: normal });
        }
        Ok(Self { normal_modulus: 1.0 / normal, shear_modulus: 1.0 / shear })
    }

    /// k_n of Hertz's spring, N/m^(3/2), with an effective radius (m).
    pub fn hertz_stiffness(&self, radius: f64) -> f64 {
        4.0 / 3.0 * self.normal_modulus * radius.sqrt()
    }
}

/// The stiffness along the tangent plane.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TangentialSpring {
    growth: Growth,
    coefficient: f64,
}

impl TangentialSpring {
    /// Beside Hertz's spring: `k_t = 8 G* sqrt(R d)`.
    pub fn mindlin(pair: &ElasticPair, radius: f64) -> Self {
        Self { growth: Growth::Hertz, coefficient: 8.0 * pair.shear_modulus * radius.sqrt() }
    }

    /// Beside a linear spring of this stiffness (N/m), with Poisson's ratio.
    pub fn beside_linear(stiffness: f64, poisson: f64) -> Self {
        Self { growth: Growth::Linear, coefficient: stiffness * 2.0 * (1.0 - poisson) / (2.0 - poisson) }
    }

    /// Of a coefficient as [`TangentialSpring::coefficient`] gives it.
    pub fn of_coefficient(growth: Growth, coefficient: f64) -> Self {
        Self { growth, coefficient }
    }

    /// Its coefficient: N/m, for Hertz N/m^(3/2).
    pub fn coefficient(&self) -> f64 {
        self.coefficient
    }

    /// k_t at an overlap (m), N/m.
    pub fn stiffness(&self, depth: f64) -> f64 {
        match self.growth {
            Growth::Linear => self.coefficient,
            Growth::Hertz => self.coefficient * depth.max(0.0).sqrt(),
        }
    }

    /// `k_t'/k_t` at an overlap (m) that changes at a rate (m/s), 1/s; zero without overlap.
    pub fn relative_rate(&self, depth: f64, rate: f64) -> f64 {
        match self.growth {
            Growth::Hertz if depth > 0.0 => 0.5 * rate / depth,
            Growth::Linear | Growth::Hertz => 0.0,
        }
    }

    /// Elastic energy of a tangential force (N) at an overlap (m), J; zero where there is no stiffness.
    pub fn energy(&self, depth: f64, force: f64) -> f64 {
        let stiffness = self.stiffness(depth);
        if stiffness > 0.0 { 0.5 * force * force / stiffness } else { 0.0 }
    }
}
