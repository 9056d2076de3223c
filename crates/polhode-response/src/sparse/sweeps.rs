//! Block Gauss-Seidel in the velocities of bodies: about how large each load is.
//!
//! Contact after contact is solved exactly while the others keep their reactions; the velocities of its bodies follow
//! at once, so that a sweep costs a few products for each contact and no matrix is formed. In a heap that falls a few
//! sweeps tell how large each load is, which loads that would hold everything do not: the interior point then takes
//! half its steps. At large ratios of masses, and in high stacks, sweeps hardly help: then the other methods of the
//! chain follow.
//!
//! Sweeps go to and fro over the blocks in their order, so that the bits are those of the problem. Source: Jourdan,
//! Alart and Jean 1998 (NSGS). Assumption: no block resists rotations. Failure: reactions that are no numbers are set
//! to zero.

use crate::friction::coulomb_cone::rows_of;
use crate::friction::single_contact::{self, Square};
use crate::sparse::block6::{Vector6, dot6};
use crate::sparse::problem::{BodyProblem, RowBlock};

/// The method for one problem.
#[derive(Debug)]
pub(crate) struct Sweeps {
    /// The block of `H M^-1 H^T + C` of each block of rows, the identity in the place of missing rows.
    diagonal: Vec<Square>,
    velocities: Vec<Vector6>,
}

impl Sweeps {
    /// For a problem; none where a block resists rotations.
    pub(crate) fn new(problem: &BodyProblem) -> Option<Self> {
        if problem.blocks.iter().any(|block| block.law.resists_rotation()) {
            return None;
        }
        let diagonal = problem.blocks.iter().map(|block| diagonal_of(problem, block)).collect();
        Some(Self { diagonal, velocities: Vec::new() })
    }

    /// Makes so many sweeps to and fro from these reactions.
    pub(crate) fn run(&mut self, problem: &BodyProblem, reactions: &mut [f64], count: usize) {
        problem.scaled_velocities(reactions, &mut self.velocities);
        for _ in 0..count {
            for block in 0..problem.blocks.len() {
                self.solve(problem, block, reactions);
            }
            for block in (0..problem.blocks.len()).rev() {
                self.solve(problem, block, reactions);
            }
        }
    }

    /// Solves one block.
    fn solve(&mut self, problem: &BodyProblem, index: usize, reactions: &mut [f64]) {
        let (block, a) = (&problem.blocks[index], &self.diagonal[index]);
        let (rows, size) = (block.rows.clone(), block.rows.len());
        let old = rows_of(&reactions[rows.clone()]);
        let mut u = rows_of(&problem.bias[rows.clone()]);
        for (u, (c, r)) in u.iter_mut().zip(problem.compliance[rows.clone()].iter().zip(old)) {
            *u += c * r;
        }
        problem.add_rates(block, &self.velocities, &mut u[..size]);
        for i in 0..size {
            u[i] -= (0..size).map(|j| a[i][j] * old[j]).sum::<f64>();
        }
        let mut new = single_contact::solve(block.law, a, u);
        if !new.iter().all(|reaction| reaction.is_finite()) {
            new = [0.0; 3];
        }
        let change: [f64; 3] = std::array::from_fn(|k| new[k] - old[k]);
        if change != [0.0; 3] {
            problem.add_impulses(block, &change[..size], &mut self.velocities);
            reactions[rows].copy_from_slice(&new[..size]);
        }
    }
}

fn diagonal_of(problem: &BodyProblem, block: &RowBlock) -> Square {
    let size = block.rows.len();
    let entry = |i: usize, j: usize| {
        if i >= size || j >= size {
            return f64::from(u8::from(i == j));
        }
        let of_side = |side| {
            let lines = problem.lines(block, side);
            dot6(&lines[i], &lines[j])
        };
        let own = if i == j { problem.compliance[block.rows.start + i] } else { 0.0 };
        block.movable().map(of_side).fold(own, |sum, value| sum + value)
    };
    std::array::from_fn(|i| std::array::from_fn(|j| entry(i, j)))
}
