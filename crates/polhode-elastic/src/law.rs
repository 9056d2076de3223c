//! The law of the material: stress from the deformation gradient, right for any rotation.
//!
//! John's harmonic (semi-linear) material: with `F = R U` (R the rotation, U the stretch) the energy of a unit of
//! volume at rest is `W = mu |U - 1|^2 + lambda/2 (tr(U - 1))^2` and the first Piola-Kirchhoff stress
//! `P = 2 mu (F - R) + lambda tr(U - 1) R` (Pa). It is linear in the stretches: Hooke's law in a frame that turns with
//! the material. A rotation changes neither W nor the stresses in that frame, so angular momentum is kept exactly, and
//! in uniaxial strain it is linear at any amplitude, so that a confined bar has waves of one speed and a closed form to
//! be held against. In the plane (plane strain: the third stretch is 1) the polar decomposition is closed:
//! `R = [[a, -w], [w, a]] / d`, `a = F11 + F22`, `w = F21 - F12`, `d = tr U = sqrt(a^2 + w^2)`.
//!
//! All is computed from the displacement gradient `H = F - 1` without a difference of numbers near one: small strains
//! keep all their digits. Source: docs/REFERENCES.md, John 1960; Lurie 1990.
//!
//! Assumes that the material is compressed or sheared moderately: W stays finite where the volume goes to zero, so that
//! nothing but [`crate::ElasticError::Folds`] keeps an element from being turned inside out.

use crate::material::ElasticMaterial;
use glam::DMat2;

/// A displacement gradient, taken apart.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Strained {
    /// R.
    pub(crate) rotation: DMat2,
    /// F - R.
    pub(crate) stretch: DMat2,
    /// tr(U - 1).
    pub(crate) dilatation: f64,
    /// det F.
    pub(crate) volume_ratio: f64,
}

impl Strained {
    /// Of the displacement gradient H, whose columns are the derivatives along the axes.
    pub(crate) fn of(h: DMat2) -> Self {
        let (trace, w) = (h.x_axis.x + h.y_axis.y, h.x_axis.y - h.y_axis.x);
        let a = 2.0 + trace;
        let d = (a * a + w * w).sqrt();
        // d - a, without the difference where it is small.
        let lag = if a > 0.0 { w * w / (d + a) } else { d - a };
        let (lag, cos, sin) = (lag / d, a / d, w / d);
        let mut stretch = h;
        stretch.x_axis.x += lag;
        stretch.y_axis.y += lag;
        stretch.x_axis.y -= sin;
        stretch.y_axis.x += sin;
        let volume_ratio = 1.0 + (trace + (h.x_axis.x * h.y_axis.y - h.x_axis.y * h.y_axis.x));
        Self {
            rotation: DMat2::from_cols_array(&[cos, sin, -sin, cos]),
            stretch,
            dilatation: (trace * (4.0 + trace) + w * w) / (d + 2.0),
            volume_ratio,
        }
    }

    /// The part of W that is not of the dilatation, J/m^3.
    pub(crate) fn shape_energy(&self, material: &ElasticMaterial) -> f64 {
        material.mu() * (self.stretch.x_axis.length_squared() + self.stretch.y_axis.length_squared())
    }

    /// P where the dilatation is taken to be this, Pa.
    pub(crate) fn stress(&self, material: &ElasticMaterial, dilatation: f64) -> DMat2 {
        self.stretch * (2.0 * material.mu()) + self.rotation * (material.lambda() * dilatation)
    }
}

#[cfg(test)]
mod tests {
    //! The law is that of an energy, sees no rotation, and is Hooke's law for small strains.
    #![allow(clippy::unwrap_used, reason = "a test that cannot go on has failed")]
    use super::*;
    use glam::DVec2;

    fn rubber() -> ElasticMaterial {
        ElasticMaterial::new(1e6, 0.3, 1000.0).unwrap()
    }

    fn energy(h: DMat2) -> f64 {
        let (strained, material) = (Strained::of(h), rubber());
        strained.shape_energy(&material) + 0.5 * material.lambda() * strained.dilatation * strained.dilatation
    }

    fn stress(h: DMat2) -> DMat2 {
        let strained = Strained::of(h);
        strained.stress(&rubber(), strained.dilatation)
    }

    #[test]
    fn stress_is_the_derivative_of_the_energy() {
        let h = DMat2::from_cols(DVec2::new(0.2, -0.4), DVec2::new(0.7, -0.1));
        let p = stress(h);
        let step = 1e-6;
        for (column, row) in [(0, 0), (0, 1), (1, 0), (1, 1)] {
            let mut e = DMat2::ZERO;
            e.col_mut(column)[row] = step;
            let slope = (energy(h + e) - energy(h - e)) / (2.0 * step);
            assert!((slope - p.col(column)[row]).abs() < 1e-2, "{slope} {p}");
        }
    }

    #[test]
    fn a_rotation_has_no_energy_and_no_stress() {
        for angle in [0.1, 1.0, 2.0, 3.0, -2.5] {
            let (sin, cos) = (libm::sin(angle), libm::cos(angle));
            let h = DMat2::from_cols_array(&[cos - 1.0, sin, -sin, cos - 1.0]);
            assert!(energy(h) < 1e-20, "{angle}: {}", energy(h));
            assert!(stress(h).to_cols_array().into_iter().all(|p| p.abs() < 1e-8), "{angle}: {}", stress(h));
        }
    }

    #[test]
    fn a_small_strain_obeys_hookes_law_with_all_its_digits() {
        let size = 1e-12;
        let h = DMat2::from_cols(DVec2::new(3.0, 1.0), DVec2::new(2.0, -1.0)) * size;
        let (material, p) = (rubber(), stress(h));
        let normal = |strain: f64| material.lambda() * 2.0 * size + 2.0 * material.mu() * strain * size;
        let shear = material.mu() * 3.0 * size;
        let expected = [normal(3.0), shear, shear, normal(-1.0)];
        for (found, right) in p.to_cols_array().into_iter().zip(expected) {
            assert!((found - right).abs() < 1e-11 * right.abs(), "{found} {right}");
        }
    }

    #[test]
    fn uniaxial_strain_is_linear_at_any_amplitude() {
        let modulus = rubber().lambda() + 2.0 * rubber().mu();
        for strain in [-0.5, -0.1, 0.3] {
            let p = stress(DMat2::from_diagonal(DVec2::new(0.0, strain)));
            assert!((p.y_axis.y - modulus * strain).abs() < 1e-9 * modulus);
        }
    }
}
