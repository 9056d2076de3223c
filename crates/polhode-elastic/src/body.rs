//! An elastic body: a mesh, a material and the masses of its nodes.
//!
//! Masses are lumped: each node has the integral of its interpolation function (kg for each metre of depth), so that
//! the equations of motion are one for each node. The total and the centre of mass are those of the mesh; moments
//! of inertia are too large by a part that goes with the square of the size of the elements.

use crate::element::{mean_stress, response};
use crate::error::ElasticError;
use crate::guide::Guide;
use crate::material::ElasticMaterial;
use crate::mesh::QuadMesh;
use crate::stability::{longest_step, node_masses};
use glam::{DMat2, DVec2};
use polhode_spatial::CompensatedSum;

/// A body at rest.
#[derive(Debug, Clone, PartialEq)]
pub struct ElasticBody {
    mesh: QuadMesh,
    material: ElasticMaterial,
    guide: Guide,
    masses: Vec<f64>,
    limit_s: f64,
}

/// Elastic energy and forces of a body.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct BodyForces {
    /// J for each metre of depth.
    pub(crate) energy: f64,
    /// On the nodes, N for each metre of depth.
    pub(crate) forces: Vec<DVec2>,
}

/// Momenta of nodes, for each metre of depth.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Momentum {
    /// kg m/s.
    pub linear: DVec2,
    /// About the origin of the mesh and the axis y (z towards x), kg m^2/s.
    pub angular: f64,
}

impl Momentum {
    /// Of an impulse (N s) at a place (m).
    pub(crate) fn of(impulse: DVec2, place: DVec2) -> Self {
        Self { linear: impulse, angular: moment(place, impulse) }
    }
}

/// The moment about the axis y of a vector at a place: z towards x is positive.
pub(crate) fn moment(place: DVec2, vector: DVec2) -> f64 {
    place.y * vector.x - place.x * vector.y
}

impl ElasticBody {
    /// From a mesh and a material.
    pub fn new(mesh: QuadMesh, material: ElasticMaterial, guide: Guide) -> Self {
        let mut masses = vec![0.0; mesh.nodes().len()];
        for quad in mesh.quads() {
            for (node, mass) in quad.nodes.into_iter().zip(node_masses(quad, &material)) {
                masses[node] += mass;
            }
        }
        let limit_s = longest_step(&mesh, &material, guide);
        Self { mesh, material, guide, masses, limit_s }
    }

    /// Its mesh.
    pub const fn mesh(&self) -> &QuadMesh {
        &self.mesh
    }

    /// Its material.
    pub const fn material(&self) -> &ElasticMaterial {
        &self.material
    }

    /// How its nodes may move.
    pub const fn guide(&self) -> Guide {
        self.guide
    }

    /// Masses of the nodes, kg for each metre of depth.
    pub fn masses(&self) -> &[f64] {
        &self.masses
    }

    /// Its mass, kg for each metre of depth.
    pub fn mass(&self) -> f64 {
        self.masses.iter().copied().collect::<CompensatedSum>().value()
    }

    /// The longest step that central differences are stable with, s.
    pub const fn longest_step_s(&self) -> f64 {
        self.limit_s
    }

    /// Its centre of mass where its nodes are displaced so (m), m.
    pub fn center_of_mass(&self, displacements: &[DVec2]) -> DVec2 {
        let mut sums = [CompensatedSum::ZERO; 2];
        for ((place, u), mass) in self.mesh.nodes().iter().zip(displacements).zip(&self.masses) {
            let moved = (*place + *u) * *mass;
            sums[0].add(moved.x);
            sums[1].add(moved.y);
        }
        DVec2::new(sums[0].value(), sums[1].value()) / self.mass()
    }

    /// Its moment of inertia at rest about the axis y through its centre of mass, kg m^2 for each metre of depth.
    pub fn inertia(&self) -> f64 {
        let center = self.center_of_mass(&vec![DVec2::ZERO; self.masses.len()]);
        let terms =
            self.mesh.nodes().iter().zip(&self.masses).map(|(place, mass)| mass * (*place - center).length_squared());
        terms.collect::<CompensatedSum>().value()
    }

    /// Momenta where its nodes are displaced so (m) and move so (m/s).
    pub fn momentum(&self, displacements: &[DVec2], velocities: &[DVec2]) -> Momentum {
        let mut sums = [CompensatedSum::ZERO; 3];
        let nodes = self.mesh.nodes().iter().zip(displacements).zip(velocities).zip(&self.masses);
        for (((place, u), velocity), mass) in nodes {
            let momentum = Momentum::of(*velocity * *mass, *place + *u);
            sums[0].add(momentum.linear.x);
            sums[1].add(momentum.linear.y);
            sums[2].add(momentum.angular);
        }
        Momentum { linear: DVec2::new(sums[0].value(), sums[1].value()), angular: sums[2].value() }
    }

    /// The mean Cauchy stress of every element where the nodes are displaced so (m), Pa, in the axes of the mesh.
    ///
    /// # Errors
    /// Displacements that are not those of the nodes.
    pub fn stresses(&self, displacements: &[DVec2]) -> Result<Vec<DMat2>, ElasticError> {
        self.check_length("displacements", displacements.len())?;
        let stress =
            |quad: &crate::mesh::Quad| mean_stress(quad, &quad.nodes.map(|node| displacements[node]), &self.material);
        Ok(self.mesh.quads().iter().map(stress).collect())
    }

    /// Whether so many are given for the nodes.
    pub(crate) fn check_length(&self, what: &'static str, given: usize) -> Result<(), ElasticError> {
        let nodes = self.masses.len();
        if given == nodes { Ok(()) } else { Err(ElasticError::Length { what, given, nodes }) }
    }

    /// Elastic energy and forces at a time, for messages.
    pub(crate) fn forces(&self, displacements: &[DVec2], t_s: f64) -> Result<BodyForces, ElasticError> {
        let mut forces = vec![DVec2::ZERO; self.masses.len()];
        let mut energy = CompensatedSum::ZERO;
        for (element, quad) in self.mesh.quads().iter().enumerate() {
            let found = response(quad, &quad.nodes.map(|node| displacements[node]), &self.material);
            if !(found.least_volume_ratio > 0.0 && found.least_volume_ratio.is_finite()) {
                return Err(ElasticError::Folds { element, ratio: found.least_volume_ratio, t_s });
            }
            energy.add(found.energy);
            for (node, force) in quad.nodes.into_iter().zip(found.forces) {
                forces[node] += force;
            }
        }
        Ok(BodyForces { energy: energy.value(), forces })
    }
}
