//! Block Gauss-Seidel: contact after contact is solved exactly while the others keep their reactions.
//!
//! Robust and cheap for a first guess; its error falls slowly where many contacts share few bodies, and hardly at all
//! at large mass ratios. Sources: Jourdan, Alart and Jean 1998; Acary and Brogliato 2008, section 13.7 (NSGS). The
//! order is that of the blocks, so that the bits are those of the problem. Of a contact that resists rotations slip,
//! rolling and spinning are solved in turns, which is a guess: what holds a rotation is cut down to its limit.

use crate::friction::coulomb_cone::{BlockRows, filled_up, put_parts_into_discs, rows_of};
use crate::friction::problem::FrictionProblem;
use crate::friction::single_contact::{self, Square, square};
use crate::law::{CONTACT_ROWS, Law};

/// Rounds over slip, rolling and spinning of one contact (2 to 8): moments hardly move normal forces.
const ROUNDS_OF_PARTS: usize = 4;

/// The method with the blocks on the diagonal at hand.
#[derive(Debug, Clone)]
pub(crate) struct GaussSeidel {
    diagonal: Vec<Square>,
}

impl GaussSeidel {
    /// For a problem.
    pub(crate) fn new(problem: &FrictionProblem) -> Self {
        let matrix = problem.matrix();
        let of = |block: usize| match problem.blocks()[block] {
            Law::Resist { .. } => Square::default(),
            _ => square(matrix.diagonal(block), matrix.size(block)),
        };
        Self { diagonal: (0..matrix.len()).map(of).collect() }
    }

    /// One sweep over all blocks.
    pub(crate) fn sweep(&self, problem: &FrictionProblem, reactions: &mut [f64]) {
        let (matrix, constant) = (problem.matrix(), problem.constant());
        for (block, (kind, a)) in problem.blocks().iter().zip(&self.diagonal).enumerate() {
            let range = matrix.range(block);
            let size = range.len();
            if kind.resists_rotation() {
                let mut velocity: BlockRows = filled_up(&constant[range.clone()]);
                matrix.add_row_product(block, reactions, &mut velocity[..size]);
                let own = &mut reactions[range];
                solve_parts(*kind, matrix.diagonal(block), &velocity[..size], own);
                // Sweeps over contacts that jam diverge: they begin again.
                if own.iter().any(|reaction| !reaction.is_finite()) {
                    own.fill(0.0);
                }
                continue;
            }
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

/// Solves the parts of a contact in turns: slip with the normal, rolling, spinning. `a` is its block of `G`, row-major,
/// `u` its velocities with the reactions `r`.
fn solve_parts(block: Law, a: &[f64], u: &[f64], r: &mut [f64]) {
    let size = r.len();
    let old: BlockRows = filled_up(r);
    let velocity = |row: usize, r: &[f64]| u[row] + (0..size).map(|k| a[row * size + k] * (r[k] - old[k])).sum::<f64>();
    let [(slip, _), turns @ ..] = block.parts();
    for _ in 0..ROUNDS_OF_PARTS {
        let first = Part { start: 0, rows: slip.end };
        let free = first.without(a, size, r, velocity);
        let found = single_contact::solve(block, &first.diagonal(a, size), free);
        r[..slip.end].copy_from_slice(&found[..slip.end]);
        for (rows, _) in turns.clone() {
            let part = Part { start: rows.start, rows: rows.len() };
            let free = part.without(a, size, r, velocity);
            let found = single_contact::hold(&part.diagonal(a, size), free);
            r[rows.clone()].copy_from_slice(&found[..rows.len()]);
            put_parts_into_discs(block, r);
        }
    }
}

/// Some rows of a block that follow each other.
#[derive(Debug, Clone, Copy)]
struct Part {
    start: usize,
    rows: usize,
}

impl Part {
    fn diagonal(self, a: &[f64], size: usize) -> Square {
        let entry = |i: usize, j: usize| {
            let is_own = i < self.rows && j < self.rows;
            if is_own { a[(self.start + i) * size + self.start + j] } else { f64::from(u8::from(i == j)) }
        };
        std::array::from_fn(|i| std::array::from_fn(|j| entry(i, j)))
    }

    /// Its velocities without its own reactions.
    fn without(
        self,
        a: &[f64],
        size: usize,
        r: &[f64],
        velocity: impl Fn(usize, &[f64]) -> f64,
    ) -> [f64; CONTACT_ROWS] {
        let mut free = [0.0; CONTACT_ROWS];
        for (i, free) in free.iter_mut().enumerate().take(self.rows) {
            let row = self.start + i;
            let own: f64 = (self.start..self.start + self.rows).map(|k| a[row * size + k] * r[k]).sum();
            *free = velocity(row, r) - own;
        }
        free
    }
}

/// Reactions after some sweeps of block Gauss-Seidel from zero, to compare other methods with. It stops at nothing
/// earlier.
pub fn gauss_seidel(problem: &FrictionProblem, sweeps: usize) -> Vec<f64> {
    let method = GaussSeidel::new(problem);
    let mut reactions = vec![0.0; problem.rows()];
    for _ in 0..sweeps {
        method.sweep(problem, &mut reactions);
    }
    reactions
}
