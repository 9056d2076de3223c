//! The linear system of one step of every method: rows whose laws say `dr = k - K H dv`, and bodies that say
//! `dv - H^T dr = rest` (velocities scaled by the roots of masses).
//!
//! Together `(I + H^T K H) dv = rest + H^T k`. With contacts that are nearly rigid `K` is large and rounding of the
//! factors is seen: what the bodies' equation is left with, by the reactions found, is solved for again. Symbols:
//! `dv` (m/s kg^1/2), `dr` (N s), `K` (kg).

use crate::law::MOST_ROWS;
use crate::sparse::block6::{Block6, Vector6, WIDTH, add_scaled};
use crate::sparse::elimination::Elimination;
use crate::sparse::factors::{Factors, Symmetry};
use crate::sparse::problem::{BodyProblem, RowBlock, Side};

/// A matrix of the rows of a block.
pub(crate) type RowMatrix = [[f64; MOST_ROWS]; MOST_ROWS];

/// Factors and memory of the system.
#[derive(Debug, Clone, Default)]
pub(crate) struct BodySystem {
    factors: Factors,
    stiffness: Vec<RowMatrix>,
    by_turn: Vec<Vector6>,
    rest: Vec<Vector6>,
    correction: Vec<Vector6>,
    /// Factorisations so far.
    pub(crate) factorisations: usize,
}

impl BodySystem {
    /// Factorises `I + H^T K H`, one `K` for each block of rows.
    pub(crate) fn factor(&mut self, problem: &BodyProblem, elimination: &Elimination, stiffness: &[RowMatrix]) {
        self.stiffness.clear();
        self.stiffness.extend_from_slice(stiffness);
        let is_symmetric = self.stiffness.iter().all(is_symmetric);
        let symmetry = if is_symmetric { Symmetry::Symmetric } else { Symmetry::General };
        self.factorisations += 1;
        self.assemble(problem, elimination, symmetry);
        if !self.factors.factor(elimination) {
            self.factorisations += 1;
            self.assemble(problem, elimination, Symmetry::General);
            self.factors.factor(elimination);
        }
    }

    fn assemble(&mut self, problem: &BodyProblem, elimination: &Elimination, symmetry: Symmetry) {
        self.factors.clear(elimination, symmetry);
        for (index, block) in problem.blocks.iter().enumerate() {
            let stiffness = &self.stiffness[index];
            if stiffness.as_flattened().iter().all(|value| *value == 0.0) {
                // An open contact.
                continue;
            }
            let mut sides = block.movable();
            let (first, second) = (sides.next(), sides.next());
            for side in block.movable() {
                let turn = elimination.turn(side.node);
                add_block(problem, block, [side, side], stiffness, self.factors.diagonal_mut(turn));
            }
            let (Some(first), Some(second), Some(place)) = (first, second, elimination.place(index)) else { continue };
            let (later, earlier) = if place.first_is_later { (first, second) } else { (second, first) };
            add_block(problem, block, [later, earlier], stiffness, self.factors.lower_mut(place.at));
            if let Some(upper) = self.factors.upper_mut(place.at) {
                add_block(problem, block, [earlier, later], stiffness, upper);
            }
        }
    }

    /// `dv` for one `rest` of each body and one `k` of each row; `dr` goes in the place of `k`. `refinements` times
    /// what rounding has left of the bodies' equation is solved for again.
    pub(crate) fn solve(
        &mut self,
        problem: &BodyProblem,
        elimination: &Elimination,
        right: Sides<'_>,
        refinements: usize,
        dv: &mut Vec<Vector6>,
    ) {
        let Sides { bodies, rows } = right;
        self.rest.clear();
        self.rest.extend_from_slice(bodies);
        dv.clear();
        dv.resize(self.rest.len(), [0.0; WIDTH]);
        for _ in 0..=refinements {
            self.correction.clear();
            self.correction.extend_from_slice(&self.rest);
            for (target, dv) in self.correction.iter_mut().zip(&*dv) {
                add_scaled(-1.0, dv, target);
            }
            for block in &problem.blocks {
                problem.add_impulses(block, &rows[block.rows.clone()], &mut self.correction);
            }
            self.by_turn.clear();
            self.by_turn.extend(elimination.order().iter().map(|&body| self.correction[body]));
            self.factors.solve(elimination, &mut self.by_turn);
            for (&body, found) in elimination.order().iter().zip(&self.by_turn) {
                self.correction[body] = *found;
                add_scaled(1.0, found, &mut dv[body]);
            }
            for (block, stiffness) in problem.blocks.iter().zip(&self.stiffness) {
                let mut rates = [0.0; MOST_ROWS];
                problem.add_rates(block, &self.correction, &mut rates);
                let own = &mut rows[block.rows.clone()];
                for (r, line) in own.iter_mut().zip(stiffness) {
                    *r -= line.iter().zip(&rates).map(|(k, u)| k * u).sum::<f64>();
                }
            }
        }
    }
}

/// The right side of a system.
#[derive(Debug)]
pub(crate) struct Sides<'a> {
    /// `rest`.
    pub(crate) bodies: &'a [Vector6],
    /// `k`, and then `dr`.
    pub(crate) rows: &'a mut [f64],
}

/// `K` of rows that are held, with this compliance beside their own (1/kg).
pub(crate) fn held_stiffness(problem: &BodyProblem, block: &RowBlock, shift: f64) -> RowMatrix {
    let mut stiffness = [[0.0; MOST_ROWS]; MOST_ROWS];
    for (k, row) in block.rows.clone().enumerate() {
        stiffness[k][k] = 1.0 / (problem.compliance[row] + shift);
    }
    stiffness
}

fn is_symmetric(matrix: &RowMatrix) -> bool {
    (0..MOST_ROWS).all(|i| (0..i).all(|j| matrix[i][j] == matrix[j][i]))
}

/// Adds `J_a^T K J_b`.
fn add_block(problem: &BodyProblem, block: &RowBlock, [a, b]: [Side; 2], stiffness: &RowMatrix, target: &mut Block6) {
    let (a, b) = (problem.lines(block, a), problem.lines(block, b));
    for (left, weights) in a.iter().zip(stiffness) {
        let mut product = [0.0; WIDTH];
        for (weight, right) in weights.iter().zip(b) {
            add_scaled(*weight, right, &mut product);
        }
        for (left, line) in left.iter().zip(target.as_chunks_mut::<WIDTH>().0) {
            add_scaled(*left, &product, line);
        }
    }
}
