//! Solves with the factors of trees of held rows: one pass from the leaves to the roots, one back.
//!
//! With impulses `r` on bodies and constant terms `b` of the rows of branches it finds `M v = r + J^T f`,
//! `J v + C f + b = 0`. From the leaves, where `r_c` has what the branches below pass on, `y = L^-1 r_c`,
//! `q = R^-1 (-b - Y^T y)`, and the parent receives `Z^T q`. Back from the roots, `f = R^-T (q - Z v_p)` and
//! `v_c = L^-T (y + Y f)`.
//!
//! What acts on a few bodies passes only those between them and the roots, and velocities are asked for at a few bodies
//! only: those passes leave all others out.

use crate::dense::kernels::axpy;
use crate::problem::ContactProblem;
use crate::sparse::held_forest::{HeldForest, Limb, backward, forward};

/// Memory of the passes.
#[derive(Debug, Clone, Default)]
pub(super) struct ForestPasses {
    /// `y` of each body, in the order of elimination; before the first pass the impulses on it.
    at_bodies: Vec<f64>,
    /// `q` of each row of a branch, in their order; before the first pass their constant terms, after the second one
    /// the forces.
    at_rows: Vec<f64>,
    /// Of the bodies, in the order of elimination.
    velocities: Vec<f64>,
}

impl ForestPasses {
    /// Memory for a forest.
    pub(super) fn new(forest: &HeldForest) -> Self {
        let coordinates = forest.limbs().len() * forest.width();
        Self {
            at_bodies: vec![0.0; coordinates],
            at_rows: vec![0.0; forest.held()],
            velocities: vec![0.0; coordinates],
        }
    }

    /// The forces of the rows of branches, in their order, with these constant terms and no impulses on the bodies.
    pub(super) fn forces(&mut self, forest: &HeldForest, constants: impl Iterator<Item = f64>) -> &[f64] {
        self.at_bodies.fill(0.0);
        self.at_rows.iter_mut().zip(constants).for_each(|(target, constant)| *target = constant);
        for (place, limb) in forest.limbs().iter().enumerate() {
            self.pass_in(forest, (place, limb));
        }
        for (place, limb) in forest.limbs().iter().enumerate().rev() {
            self.pass_out(forest, (place, limb));
        }
        &self.at_rows
    }

    /// The velocities of the bodies at some places (descending, each with its parent) that a unit impulse along a row
    /// of the problem gives; `path` are the places (ascending) between its bodies and the roots.
    pub(super) fn velocities_by_row(
        &mut self,
        forest: &HeldForest,
        (problem, row): (&ContactProblem, usize),
        (path, places): (&[usize], &[usize]),
    ) {
        let width = forest.width();
        for &place in places {
            self.at_bodies[place * width..(place + 1) * width].fill(0.0);
            self.at_rows[forest.limbs()[place].range()].fill(0.0);
        }
        for entry in problem.entries(row) {
            let start = forest.place(entry.body) * width;
            self.at_bodies[start..start + width].copy_from_slice(entry.jacobian);
        }
        for &place in path {
            self.pass_in(forest, (place, &forest.limbs()[place]));
        }
        for &place in places {
            self.pass_out(forest, (place, &forest.limbs()[place]));
        }
    }

    /// The rate of a row of the problem by the velocities of the last pass.
    pub(super) fn rate(&self, forest: &HeldForest, problem: &ContactProblem, row: usize) -> f64 {
        let width = forest.width();
        let rate = |(jacobian, body): (&[f64], usize)| {
            let start = forest.place(body) * width;
            jacobian.iter().zip(&self.velocities[start..start + width]).map(|(a, b)| a * b).sum::<f64>()
        };
        problem.entries(row).map(|entry| rate((entry.jacobian, entry.body))).sum()
    }

    fn pass_in(&mut self, forest: &HeldForest, (place, limb): (usize, &Limb)) {
        let width = forest.width();
        let factors = forest.factors(limb);
        let (below, above) = self.at_bodies.split_at_mut((place + 1) * width);
        let own = &mut below[place * width..];
        forward(factors.mass, width, own);
        let at_rows = &mut self.at_rows[limb.range()];
        for (target, column) in at_rows.iter_mut().zip(factors.own.chunks_exact(width)) {
            let known: f64 = column.iter().zip(&*own).map(|(a, b)| a * b).sum();
            *target = -*target - known;
        }
        forward(factors.matrix, at_rows.len(), at_rows);
        if let Some(parent) = limb.up() {
            let target = &mut above[(parent - place - 1) * width..][..width];
            for (&value, line) in at_rows.iter().zip(factors.parent.chunks_exact(width)) {
                axpy(value, line, target);
            }
        }
    }

    fn pass_out(&mut self, forest: &HeldForest, (place, limb): (usize, &Limb)) {
        let width = forest.width();
        let factors = forest.factors(limb);
        let at_rows = &mut self.at_rows[limb.range()];
        let (below, above) = self.velocities.split_at_mut((place + 1) * width);
        if let Some(parent) = limb.up() {
            let of_parent = &above[(parent - place - 1) * width..][..width];
            for (target, line) in at_rows.iter_mut().zip(factors.parent.chunks_exact(width)) {
                *target -= line.iter().zip(of_parent).map(|(a, b)| a * b).sum::<f64>();
            }
        }
        backward(factors.matrix, at_rows.len(), at_rows);
        let own = &mut below[place * width..];
        own.copy_from_slice(&self.at_bodies[place * width..(place + 1) * width]);
        for (&force, column) in at_rows.iter().zip(factors.own.chunks_exact(width)) {
            axpy(force, column, own);
        }
        backward(factors.mass, width, own);
    }
}
