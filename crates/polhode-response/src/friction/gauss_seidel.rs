//! Block Gauss-Seidel: contact after contact is solved exactly while the others keep their reactions.
//!
//! Robust and cheap for a first guess; its error falls slowly where many contacts share few bodies, and hardly at all at large
//! mass ratios. Sources: Jourdan, Alart and Jean 1998; Acary and Brogliato 2008, section 13.7 (NSGS). The order is that of the
//! blocks, so that the bits are those of the problem.

use crate::friction::coulomb_cone::rows_of;
use crate::friction::problem::FrictionProblem;
use crate::friction::single_contact::{self, Square, square};

/// The method with the blocks on the diagonal at hand.
#[derive(Debug, Clone)]
pub(crate) struct GaussSeidel {
    diagonal: Vec<Square>,
}

impl GaussSeidel {
    /// For a problem.
    pub(crate) fn new(problem: &FrictionProblem) -> Self {
        let matrix = problem.matrix();
        Self { diagonal: (0..matrix.len()).map(|block| square(matrix.diagonal(block), matrix.size(block))).collect() }
    }

    /// One sweep over all blocks.
    pub(crate) fn sweep(&self, problem: &FrictionProblem, reactions: &mut [f64]) {
        let (matrix, constant) = (problem.matrix(), problem.constant());
        for (block, (kind, a)) in problem.blocks().iter().zip(&self.diagonal).enumerate() {
            let range = matrix.range(block);
            let size = range.len();
            let mut velocity = rows_of(&constant[range.clone()]);
            matrix.add_row_product(block, reactions, &mut velocity[..size]);
            let old = rows_of(&reactions[range.clone()]);
            for i in 0..size {
                velocity[i] -= (0..size).map(|j| a[i][j] * old[j]).sum::<f64>();
            }
            let new = single_contact::solve(*kind, a, velocity);
            reactions[range].copy_from_slice(&new[..size]);
        }
    }
}

/// Reactions after some sweeps of block Gauss-Seidel from zero, to compare other methods with. It stops at nothing earlier.
pub fn gauss_seidel(problem: &FrictionProblem, sweeps: usize) -> Vec<f64> {
    let method = GaussSeidel::new(problem);
    let mut reactions = vec![0.0; problem.rows()];
    for _ in 0..sweeps {
        method.sweep(problem, &mut reactions);
    }
    reactions
}
