//! Energy and forces of one element.
//!
//! Total Lagrangian: with the gradients g_i of the interpolation functions at rest, the displacement gradient is
//! `H = sum_i u_i g_i^T`, and the force on node i is `-sum_q w_q P(H_q) g_i` (N for each metre of depth), the negative
//! derivative of the energy.
//!
//! **Locking.** The dilatation enters the energy by its mean over the element, `lambda/2 A (mean(tr(U - 1)))^2`: four
//! separate dilatations would hold a bilinear element fast when the Poisson ratio is near 0.5. The rest of the energy
//! is integrated in full at the four points, and keeps the modes that have no mean dilatation (hourglass) stiff. Energy
//! and force stay those of one function. Source: docs/REFERENCES.md, Nagtegaal, Parks and Rice 1974; Hughes 1980. What
//! is left: bending of an element is too stiff by its shear, by a factor that goes to 1 with the square of its length;
//! Richardson extrapolation takes that away.

use crate::law::Strained;
use crate::material::ElasticMaterial;
use crate::mesh::{GaussPoint, Quad, smaller};
use glam::{DMat2, DVec2};

/// Energy and forces of an element for each metre of depth.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Response {
    /// J.
    pub(crate) energy: f64,
    /// On its nodes, N.
    pub(crate) forces: [DVec2; 4],
    /// The smallest ratio of volumes, det F, over its Gauss points.
    pub(crate) least_volume_ratio: f64,
}

/// The displacement gradient at a Gauss point.
fn gradient(point: &GaussPoint, displacements: &[DVec2; 4]) -> DMat2 {
    let mut h = DMat2::ZERO;
    for (u, g) in displacements.iter().zip(&point.gradients) {
        h.x_axis += *u * g.x;
        h.y_axis += *u * g.y;
    }
    h
}

/// The element strained at its Gauss points, and the mean dilatation.
struct StrainedQuad {
    points: [Strained; 4],
    mean_dilatation: f64,
}

impl StrainedQuad {
    fn of(quad: &Quad, displacements: &[DVec2; 4]) -> Self {
        let points = quad.points.map(|point| Strained::of(gradient(&point, displacements)));
        let sum: f64 =
            points.iter().zip(&quad.points).map(|(strained, point)| point.weight * strained.dilatation).sum();
        Self { points, mean_dilatation: sum / quad.area() }
    }
}

/// Energy and forces of an element whose nodes are displaced so, m.
pub(crate) fn response(quad: &Quad, displacements: &[DVec2; 4], material: &ElasticMaterial) -> Response {
    let StrainedQuad { points, mean_dilatation } = StrainedQuad::of(quad, displacements);
    let mut energy = 0.5 * material.lambda() * quad.area() * mean_dilatation * mean_dilatation;
    let mut forces = [DVec2::ZERO; 4];
    let mut least_volume_ratio = f64::INFINITY;
    for (strained, point) in points.iter().zip(&quad.points) {
        energy += point.weight * strained.shape_energy(material);
        let stress = strained.stress(material, mean_dilatation) * point.weight;
        for (force, gradient) in forces.iter_mut().zip(&point.gradients) {
            *force -= stress * *gradient;
        }
        least_volume_ratio = smaller(least_volume_ratio, strained.volume_ratio);
    }
    Response { energy, forces, least_volume_ratio }
}

/// The mean Cauchy stress `P F^T / det F` of an element, Pa, in the axes of the mesh.
pub(crate) fn mean_stress(quad: &Quad, displacements: &[DVec2; 4], material: &ElasticMaterial) -> DMat2 {
    let StrainedQuad { points, mean_dilatation } = StrainedQuad::of(quad, displacements);
    let mut sum = DMat2::ZERO;
    for (strained, point) in points.iter().zip(&quad.points) {
        let deformation = strained.stretch + strained.rotation;
        let cauchy =
            strained.stress(material, mean_dilatation) * deformation.transpose() * (1.0 / strained.volume_ratio);
        sum += cauchy * point.weight;
    }
    sum * (1.0 / quad.area())
}

/// Forces of Hooke's law on an element at rest: the response for displacements that go to zero.
pub(crate) fn linear_forces(quad: &Quad, displacements: &[DVec2; 4], material: &ElasticMaterial) -> [DVec2; 4] {
    let gradients = quad.points.map(|point| gradient(&point, displacements));
    let sum: f64 = gradients.iter().zip(&quad.points).map(|(h, point)| point.weight * (h.x_axis.x + h.y_axis.y)).sum();
    let pressure = material.lambda() * sum / quad.area();
    let mut forces = [DVec2::ZERO; 4];
    for (h, point) in gradients.iter().zip(&quad.points) {
        let stress =
            ((*h + h.transpose()) * material.mu() + DMat2::from_diagonal(DVec2::splat(pressure))) * point.weight;
        for (force, gradient) in forces.iter_mut().zip(&point.gradients) {
            *force -= stress * *gradient;
        }
    }
    forces
}
