//! The longest stable step of central differences.
//!
//! Central differences are stable for `step <= 2 / omega` with omega (1/s) the highest frequency of the mesh. Where a
//! mesh is the union of patches of elements, each with its share of the masses, no frequency of the whole is above the
//! highest of its patches (for single elements Irons and Treharne 1971; the proof by Rayleigh quotients is the same). A
//! rectangle is taken in patches of four to seven elements along a side, any other mesh element by element. That of a
//! patch is bounded from above by traces of powers of its symmetric matrix A: `omega^2 <= (tr A^n)^(1/n)`, which for
//! n = 2^40 is omega^2 to 1e-11.
//!
//! For squares of side h that move along one axis it gives `h / c_p`, the limit of Courant, Friedrichs and Lewy by the
//! dilatational speed. A free square alone has `h / sqrt(2 (c_p^2 - c_s^2))`, 0.84 of that for nu = 0.3; in patches it
//! is 0.98. Waves disperse the less the nearer the step is to the limit. Source: docs/REFERENCES.md, Irons and
//! Treharne 1971.
//!
//! Assumes stiffness as it is at rest; that of the harmonic law changes only by the turning of what is under stress.

use crate::element::linear_forces;
use crate::guide::Guide;
use crate::material::ElasticMaterial;
use crate::mesh::{Quad, QuadMesh};
use glam::DVec2;

/// The part of the limit that free bodies step by: room for what stress adds to the stiffness.
pub const STABILITY_FACTOR: f64 = 0.99;

/// Squarings of a matrix: its power is 2 to this.
const SQUARINGS: u32 = 40;

/// A square matrix, row by row.
struct Matrix {
    size: usize,
    entries: Vec<f64>,
}

/// The longest stable step of a mesh at rest, s.
pub(crate) fn longest_step(mesh: &QuadMesh, material: &ElasticMaterial, guide: Guide) -> f64 {
    let limits = mesh.patches().iter().map(|patch| {
        let quads: Vec<&Quad> = patch.iter().map(|&element| &mesh.quads()[element]).collect();
        2.0 / scaled_stiffness(&quads, material, guide).largest_eigenvalue().sqrt()
    });
    limits.fold(f64::INFINITY, f64::min)
}

/// `M^-1/2 K M^-1/2` of some elements, for the directions in which their nodes move.
fn scaled_stiffness(quads: &[&Quad], material: &ElasticMaterial, guide: Guide) -> Matrix {
    let mut nodes: Vec<usize> = quads.iter().flat_map(|quad| quad.nodes).collect();
    nodes.sort_unstable();
    nodes.dedup();
    let axes: &[usize] = if guide == Guide::Free { &[0, 1] } else { &[1] };
    let place = |node: usize| nodes.partition_point(|&other| other < node);
    let mut masses = vec![0.0; nodes.len()];
    for quad in quads {
        for (node, mass) in quad.nodes.into_iter().zip(node_masses(quad, material)) {
            masses[place(node)] += mass;
        }
    }
    let mut matrix = Matrix::zero(nodes.len() * axes.len());
    for quad in quads {
        for (node, (column, from)) in (0..4).flat_map(|node| axes.iter().enumerate().map(move |axis| (node, axis))) {
            let mut displacements = [DVec2::ZERO; 4];
            displacements[node][*from] = 1.0;
            let forces = linear_forces(quad, &displacements, material);
            let column_node = place(quad.nodes[node]);
            for (other, force) in quad.nodes.into_iter().zip(forces) {
                let row_node = place(other);
                let scale = (masses[row_node] * masses[column_node]).sqrt();
                for (row, &to) in axes.iter().enumerate() {
                    let at = (row_node * axes.len() + row) * matrix.size + column_node * axes.len() + column;
                    matrix.entries[at] -= force[to] / scale;
                }
            }
        }
    }
    matrix
}

impl Matrix {
    fn zero(size: usize) -> Self {
        Self { size, entries: vec![0.0; size * size] }
    }

    fn trace(&self) -> f64 {
        self.entries.iter().step_by(self.size + 1).sum()
    }

    fn divide(&mut self, by: f64) {
        self.entries.iter_mut().for_each(|entry| *entry /= by);
    }

    /// Its square; it is symmetric, so that rows stand for columns.
    fn squared(&self) -> Self {
        let rows: Vec<&[f64]> = self.entries.chunks_exact(self.size).collect();
        let dot = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(x, y)| x * y).sum::<f64>();
        let mut square = Self::zero(self.size);
        for (i, row) in rows.iter().enumerate() {
            for (j, column) in rows.iter().enumerate().take(i + 1) {
                let entry = dot(row, column);
                square.entries[i * self.size + j] = entry;
                square.entries[j * self.size + i] = entry;
            }
        }
        square
    }

    /// The largest eigenvalue, from above, where none is negative.
    fn largest_eigenvalue(mut self) -> f64 {
        let mut bound = self.trace();
        if !(bound > 0.0 && bound.is_finite()) {
            return bound;
        }
        self.divide(bound);
        for squaring in 1..=SQUARINGS {
            let mut square = self.squared();
            let factor = square.trace();
            square.divide(factor);
            self = square;
            bound *= (0..squaring).fold(factor, |root, _| root.sqrt());
        }
        bound
    }
}

/// The shares of an element's mass that its nodes have, kg for each metre of depth: rows of the mass matrix summed.
pub(crate) fn node_masses(quad: &Quad, material: &ElasticMaterial) -> [f64; 4] {
    let mut masses = [0.0; 4];
    for point in &quad.points {
        for (mass, value) in masses.iter_mut().zip(point.values) {
            *mass += material.density() * point.weight * value;
        }
    }
    masses
}

#[cfg(test)]
mod tests {
    //! The limits of squares are those of the theory of waves, and patches bound the whole.
    #![allow(clippy::unwrap_used, reason = "a test that cannot go on has failed")]
    use super::*;
    use crate::mesh::Cells;

    fn limit(cells: Cells, guide: Guide) -> f64 {
        let mesh = QuadMesh::rectangle(0.1 * cells.columns as f64, 0.1 * cells.rows as f64, cells).unwrap();
        longest_step(&mesh, &rubber(), guide) * rubber().dilatational_speed() / 0.1
    }

    fn rubber() -> ElasticMaterial {
        ElasticMaterial::new(1e6, 0.3, 1000.0).unwrap()
    }

    #[test]
    fn squares_that_move_along_one_axis_have_the_limit_of_courant() {
        for rows in [1, 2, 10, 23] {
            let found = limit(Cells { columns: 9, rows }, Guide::Vertical);
            assert!((found - 1.0).abs() < 1e-10, "{rows}: {found}");
        }
    }

    #[test]
    fn a_square_alone_has_a_closed_form() {
        let (p, s) = (rubber().dilatational_speed(), rubber().shear_speed());
        let found = limit(Cells { columns: 1, rows: 1 }, Guide::Free);
        assert!((found * (2.0 * (p * p - s * s)).sqrt() / p - 1.0).abs() < 1e-10, "{found}");
    }

    #[test]
    fn smaller_patches_have_shorter_steps() {
        let limits = [1, 2, 4, 7].map(|n| limit(Cells { columns: n, rows: n }, Guide::Free));
        assert!(limits.windows(2).all(|pair| pair[0] < pair[1]), "{limits:?}");
        assert!(limits[2] > 0.97 && limits[3] < 1.0, "{limits:?}");
        assert!((limit(Cells { columns: 8, rows: 4 }, Guide::Free) / limits[2] - 1.0).abs() < 1e-12);
    }
}
