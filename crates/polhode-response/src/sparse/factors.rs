//! Sparse elimination in blocks of 6 x 6, or of 3 x 3 where no row turns a body: `A = I + H^T K H`, symmetric positive
//! definite (Cholesky) or not symmetric (LU).
//!
//! A symmetric `K` comes from contacts that are held or whose slip is taken as known, one that is not from contacts
//! that slide: the velocity along the normal changes the reaction along the slip, and not the other way round. The
//! pattern is that of the [`Elimination`] in both cases. Bodies are eliminated one after the other, within a body with
//! the largest pivot of each column, between bodies without exchanges: `A` has a diagonal of ones before contacts are
//! added. Couplings without entries, as those by open contacts, are passed over. Every sum has one order. Sources:
//! George and Liu 1989; Golub and Van Loan, section 4.2. Failure: a symmetric matrix that rounding has made indefinite
//! is told, and taken for one that is not symmetric.

use crate::sparse::block6::{
    Block, CholeskyBlock, FactoredBlock, Vector6, subtract_product, subtract_times, subtract_transposed_times,
    transposed, unit,
};
use crate::sparse::elimination::Elimination;

/// Whether a matrix is symmetric.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub(crate) enum Symmetry {
    /// Only blocks below the diagonal are kept.
    #[default]
    Symmetric,
    /// Blocks above the diagonal are kept too.
    General,
}

/// The matrix, and then its factors in its place.
#[derive(Debug, Clone, Default)]
pub(crate) struct Factors<const W: usize> {
    symmetry: Symmetry,
    diagonal: Vec<Block<W>>,
    /// The block of each coupling, below the diagonal.
    lower: Vec<Block<W>>,
    /// Above it.
    upper: Vec<Block<W>>,
    /// Whether each coupling has entries: bodies that only open contacts couple have none.
    filled: Vec<bool>,
    general: Vec<FactoredBlock<W>>,
    symmetric: Vec<CholeskyBlock<W>>,
    by_turn: Vec<[f64; W]>,
}

impl<const W: usize> Factors<W> {
    /// The unit matrix.
    pub(crate) fn clear(&mut self, elimination: &Elimination, symmetry: Symmetry) {
        self.symmetry = symmetry;
        self.diagonal.clear();
        self.diagonal.resize(elimination.bodies(), unit());
        self.lower.clear();
        self.lower.resize(elimination.couplings(), [[0.0; W]; W]);
        self.filled.clear();
        self.filled.resize(elimination.couplings(), false);
        self.upper.clear();
        if symmetry == Symmetry::General {
            self.upper.resize(elimination.couplings(), [[0.0; W]; W]);
        }
    }

    /// The diagonal block of a turn.
    pub(crate) fn diagonal_mut(&mut self, turn: usize) -> &mut Block<W> {
        &mut self.diagonal[turn]
    }

    /// The block of a coupling below the diagonal, which then counts as filled.
    pub(crate) fn lower_mut(&mut self, coupling: usize) -> &mut Block<W> {
        self.filled[coupling] = true;
        &mut self.lower[coupling]
    }

    /// The block above it; none in a symmetric matrix.
    pub(crate) fn upper_mut(&mut self, coupling: usize) -> Option<&mut Block<W>> {
        self.upper.get_mut(coupling)
    }

    /// Factorises in place; false when a symmetric matrix is not positive definite to rounding.
    pub(crate) fn factor(&mut self, elimination: &Elimination) -> bool {
        self.general.clear();
        self.symmetric.clear();
        match self.symmetry {
            Symmetry::Symmetric => (0..elimination.bodies()).all(|turn| self.eliminate_symmetric(elimination, turn)),
            Symmetry::General => {
                for turn in 0..elimination.bodies() {
                    self.eliminate(elimination, turn);
                }
                true
            }
        }
    }

    fn eliminate_symmetric(&mut self, elimination: &Elimination, turn: usize) -> bool {
        let Some(pivot) = CholeskyBlock::of(&self.diagonal[turn]) else { return false };
        let range = elimination.range(turn);
        let (own, rest) = self.lower[range.start..].split_at_mut(range.len());
        let (own_filled, rest_filled) = self.filled[range.start..].split_at_mut(range.len());
        let later = &elimination.later()[range.clone()];
        for (block, _) in own.iter_mut().zip(&*own_filled).filter(|(_, filled)| **filled) {
            pivot.solve_from_the_right(block);
        }
        for (place, &column) in later.iter().enumerate().filter(|(place, _)| own_filled[*place]) {
            let right = transposed(&own[place]);
            subtract_product(&own[place], &right, &mut self.diagonal[column as usize]);
            let mut target = elimination.range(column as usize).start;
            for other in (place + 1..later.len()).filter(|other| own_filled[*other]) {
                while elimination.later()[target] != later[other] {
                    target += 1;
                }
                let at = target - range.end;
                subtract_product(&own[other], &right, &mut rest[at]);
                rest_filled[at] = true;
            }
        }
        self.symmetric.push(pivot);
        true
    }

    fn eliminate(&mut self, elimination: &Elimination, turn: usize) {
        let pivot = FactoredBlock::of(self.diagonal[turn]);
        let range = elimination.range(turn);
        let (lower, lower_rest) = self.lower[range.start..].split_at_mut(range.len());
        let (upper, upper_rest) = self.upper[range.start..].split_at_mut(range.len());
        let (own_filled, rest_filled) = self.filled[range.start..].split_at_mut(range.len());
        let later = &elimination.later()[range.clone()];
        let own = lower.iter_mut().zip(&mut *upper).zip(&*own_filled);
        for ((lower, upper), _) in own.filter(|(_, filled)| **filled) {
            pivot.solve_upper_from_the_right(lower);
            pivot.solve_lower_block(upper);
        }
        for (place, &column) in later.iter().enumerate().filter(|(place, _)| own_filled[*place]) {
            subtract_product(&lower[place], &upper[place], &mut self.diagonal[column as usize]);
            let mut target = elimination.range(column as usize).start;
            for other in (place + 1..later.len()).filter(|other| own_filled[*other]) {
                while elimination.later()[target] != later[other] {
                    target += 1;
                }
                let at = target - range.end;
                subtract_product(&lower[other], &upper[place], &mut lower_rest[at]);
                subtract_product(&lower[place], &upper[other], &mut upper_rest[at]);
                rest_filled[at] = true;
            }
        }
        self.general.push(pivot);
    }

    /// `A^-1 x` in place of the first components of each body's `x`; the others stay.
    pub(crate) fn solve_bodies(&mut self, elimination: &Elimination, x: &mut [Vector6]) {
        let mut by_turn = std::mem::take(&mut self.by_turn);
        by_turn.clear();
        by_turn.extend(elimination.order().iter().map(|&body| -> [f64; W] { std::array::from_fn(|k| x[body][k]) }));
        self.solve(elimination, &mut by_turn);
        for (&body, found) in elimination.order().iter().zip(&by_turn) {
            x[body][..W].copy_from_slice(found);
        }
        self.by_turn = by_turn;
    }

    /// `A^-1 x` in place of `x`, by turns.
    fn solve(&self, elimination: &Elimination, x: &mut [[f64; W]]) {
        for turn in 0..elimination.bodies() {
            match self.symmetry {
                Symmetry::Symmetric => self.symmetric[turn].solve_lower(&mut x[turn]),
                Symmetry::General => self.general[turn].solve_lower(&mut x[turn]),
            }
            let own = x[turn];
            let range = elimination.range(turn);
            for at in range.filter(|at| self.filled[*at]) {
                subtract_times(&self.lower[at], &own, &mut x[elimination.later()[at] as usize]);
            }
        }
        for turn in (0..elimination.bodies()).rev() {
            let mut own = x[turn];
            let filled = elimination.range(turn).filter(|at| self.filled[*at]);
            let row = |at: usize| elimination.later()[at] as usize;
            match self.symmetry {
                Symmetry::Symmetric => {
                    filled.for_each(|at| subtract_transposed_times(&self.lower[at], &x[row(at)], &mut own));
                    self.symmetric[turn].solve_upper(&mut own);
                }
                Symmetry::General => {
                    filled.for_each(|at| subtract_times(&self.upper[at], &x[row(at)], &mut own));
                    self.general[turn].solve_upper(&mut own);
                }
            }
            x[turn] = own;
        }
    }
}

#[cfg(test)]
mod tests {
    //! A chain of bodies: what the matrix multiplies, its factors give back, symmetric or not.
    use super::*;
    use crate::law::Law;
    use crate::sparse::block6::WIDTH;
    use crate::sparse::body::BodyMass;
    use crate::sparse::problem::{BodyProblem, BodyRows};

    fn block(entry: &dyn Fn(usize) -> f64) -> Block<WIDTH> {
        std::array::from_fn(|i| std::array::from_fn(|j| entry(WIDTH * i + j)))
    }

    /// Bodies in a ring with a chord, so that elimination makes new couplings.
    fn elimination(bodies: usize) -> Elimination {
        let mass = BodyMass::rigid(1.0, &[1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0]);
        let mut problem = BodyProblem::new(&vec![mass; bodies], &vec![[0.0; 6]; bodies]).expect("masses are right");
        let line = [1.0, 0.0, 0.0, 0.0, 0.0, 0.0];
        for a in 0..bodies {
            for b in [(a + 1) % bodies, (a + 3) % bodies] {
                let rows =
                    BodyRows { law: Law::Push, bodies: &[(a, &line), (b, &line)], bias: &[0.0], compliance: &[] };
                problem.push(&rows).expect("rows are right");
            }
        }
        Elimination::of(&problem)
    }

    #[test]
    fn factors_give_back_what_the_matrix_multiplies() {
        let (bodies, wave) = (11, |seed: usize| ((seed * 7919 % 101) as f64 / 101.0) - 0.5);
        let elimination = elimination(bodies);
        for symmetry in [Symmetry::Symmetric, Symmetry::General] {
            let mut factors = Factors::<WIDTH>::default();
            factors.clear(&elimination, symmetry);
            let x: Vec<Vector6> = (0..bodies).map(|body| std::array::from_fn(|k| wave(6 * body + k))).collect();
            let mut b = x.clone();
            for turn in 0..bodies {
                for at in elimination.range(turn) {
                    let row = elimination.later()[at] as usize;
                    let lower = block(&|k| 0.1 * wave(36 * at + k));
                    let twisted = block(&|k| 0.1 * wave(17 * at + k));
                    *factors.lower_mut(at) = lower;
                    let upper = if let Some(upper) = factors.upper_mut(at) {
                        *upper = twisted;
                        twisted
                    } else {
                        transposed(&lower)
                    };
                    subtract_times(&lower.map(|line| line.map(|a| -a)), &x[turn], &mut b[row]);
                    subtract_times(&upper.map(|line| line.map(|a| -a)), &x[row], &mut b[turn]);
                }
            }
            assert!(factors.factor(&elimination));
            factors.solve(&elimination, &mut b);
            for (b, x) in b.as_flattened().iter().zip(x.as_flattened()) {
                assert!((b - x).abs() < 1e-12, "{b} instead of {x}");
            }
        }
    }
}
