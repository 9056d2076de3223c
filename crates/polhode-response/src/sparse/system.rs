//! The linear system of one step of every method: rows whose laws say `dr = k - K H dv`, and bodies that say
//! `dv - H^T dr = rest` (velocities scaled by the roots of masses).
//!
//! Together `(I + H^T K H) dv = rest + H^T k`. With contacts that are nearly rigid `K` is large and rounding of the
//! factors is seen: what the bodies' equation is left with, by the reactions found, is solved for again. Symbols:
//! `dv` (m/s kg^1/2), `dr` (N s), `K` (kg).
//!
//! Where no row turns a body, as among balls that nothing rubs, or where bodies have three coordinates in a plane, the
//! first three components are eliminated alone, in blocks of 3 x 3: an eighth of the products. What rounding of points
//! leaves of the lever arms of such rows is not seen in `I + H^T K H`, whose diagonal is 1 for all rotations; what is
//! left of the equation counts it in full.

use crate::law::MOST_ROWS;
use crate::sparse::block6::{Block, TRANSLATION, Vector6, WIDTH, add_scaled};
use crate::sparse::elimination::Elimination;
use crate::sparse::factors::{Factors, Symmetry};
use crate::sparse::problem::{BodyProblem, RowBlock, Side};

/// A matrix of the rows of a block.
pub(crate) type RowMatrix = [[f64; MOST_ROWS]; MOST_ROWS];

/// Factors and memory of the system.
#[derive(Debug, Clone, Default)]
pub(crate) struct BodySystem {
    motion: Motion,
    whole: Factors<WIDTH>,
    translations: Factors<TRANSLATION>,
    stiffness: Vec<RowMatrix>,
    /// The diagonal of each body's rotation.
    turned: Vec<[f64; WIDTH - TRANSLATION]>,
    rest: Vec<Vector6>,
    correction: Vec<Vector6>,
    /// Factorisations so far.
    pub(crate) factorisations: usize,
}

/// What rows do to the bodies.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
enum Motion {
    /// They move them and turn them.
    #[default]
    Whole,
    /// They move them along, and turn none of them.
    Translation,
}

impl BodySystem {
    /// Factorises `I + H^T K H`, one `K` for each block of rows.
    pub(crate) fn factor(&mut self, problem: &BodyProblem, elimination: &Elimination, stiffness: &[RowMatrix]) {
        self.stiffness.clear();
        self.stiffness.extend_from_slice(stiffness);
        self.motion = self.motion_of(problem);
        self.factorisations += match self.motion {
            Motion::Whole => factor(&mut self.whole, problem, elimination, stiffness),
            Motion::Translation => factor(&mut self.translations, problem, elimination, stiffness),
        };
    }

    /// Whether the rows turn a body by more than rounding of 1.
    fn motion_of(&mut self, problem: &BodyProblem) -> Motion {
        self.turned.clear();
        self.turned.resize(problem.movable_bodies(), [1.0; WIDTH - TRANSLATION]);
        for (block, stiffness) in problem.blocks.iter().zip(&self.stiffness) {
            for side in block.movable() {
                for (line, weights) in problem.lines(block, side).iter().zip(stiffness) {
                    let most = weights.iter().fold(0.0, |most: f64, weight| most.max(weight.abs()));
                    let arms = &line[TRANSLATION..];
                    self.turned[side.node].iter_mut().zip(arms).for_each(|(own, arm)| *own += most * arm * arm);
                }
            }
        }
        let turns = self.turned.as_flattened().iter().any(|own| *own != 1.0);
        if turns { Motion::Whole } else { Motion::Translation }
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
            match self.motion {
                Motion::Whole => self.whole.solve_bodies(elimination, &mut self.correction),
                Motion::Translation => self.translations.solve_bodies(elimination, &mut self.correction),
            }
            for (found, dv) in self.correction.iter().zip(&mut *dv) {
                add_scaled(1.0, found, dv);
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

/// Factorises a matrix of this width. How often: one that rounding has made indefinite is taken for one that is not
/// symmetric.
fn factor<const W: usize>(
    factors: &mut Factors<W>,
    problem: &BodyProblem,
    elimination: &Elimination,
    stiffness: &[RowMatrix],
) -> usize {
    let is_symmetric = stiffness.iter().all(is_symmetric);
    let symmetry = if is_symmetric { Symmetry::Symmetric } else { Symmetry::General };
    assemble(factors, problem, elimination, (stiffness, symmetry));
    if factors.factor(elimination) {
        return 1;
    }
    assemble(factors, problem, elimination, (stiffness, Symmetry::General));
    factors.factor(elimination);
    2
}

fn assemble<const W: usize>(
    factors: &mut Factors<W>,
    problem: &BodyProblem,
    elimination: &Elimination,
    (stiffness, symmetry): (&[RowMatrix], Symmetry),
) {
    factors.clear(elimination, symmetry);
    for ((index, block), stiffness) in problem.blocks.iter().enumerate().zip(stiffness) {
        if stiffness.as_flattened().iter().all(|value| *value == 0.0) {
            // An open contact.
            continue;
        }
        let mut sides = block.movable();
        let (first, second) = (sides.next(), sides.next());
        for side in block.movable() {
            let turn = elimination.turn(side.node);
            add_block(problem, block, [side, side], stiffness, factors.diagonal_mut(turn));
        }
        let (Some(first), Some(second), Some(place)) = (first, second, elimination.place(index)) else { continue };
        let (later, earlier) = if place.first_is_later { (first, second) } else { (second, first) };
        add_block(problem, block, [later, earlier], stiffness, factors.lower_mut(place.at));
        if let Some(upper) = factors.upper_mut(place.at) {
            add_block(problem, block, [earlier, later], stiffness, upper);
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
fn add_block<const W: usize>(
    problem: &BodyProblem,
    block: &RowBlock,
    [a, b]: [Side; 2],
    stiffness: &RowMatrix,
    target: &mut Block<W>,
) {
    let (a, b) = (problem.lines(block, a), problem.lines(block, b));
    for (left, weights) in a.iter().zip(stiffness) {
        let mut product = [0.0; W];
        for (weight, right) in weights.iter().zip(b) {
            product.iter_mut().zip(right).for_each(|(product, right)| *product += weight * right);
        }
        for (left, line) in left.iter().zip(target.iter_mut()) {
            add_scaled(*left, &product, line);
        }
    }
}

#[cfg(test)]
mod tests {
    //! Both equations hold after a solve, whatever the width of the blocks.
    #![expect(clippy::unwrap_used, reason = "a test that cannot go on has failed")]
    use super::*;
    use crate::law::Law;
    use crate::sparse::body::BodyMass;
    use crate::sparse::problem::BodyRows;

    /// Balls side by side on a floor, pressed together, whose contacts are off their centres by `arm`.
    fn row_of_balls(arm: f64) -> BodyProblem {
        let mass = BodyMass::rigid(1.0, &[0.4, 0.0, 0.0, 0.0, 0.4, 0.0, 0.0, 0.0, 0.4]);
        let mut problem = BodyProblem::new(&[mass; 5], &[[0.0; 6]; 5]).unwrap();
        let (down, along) = ([0.0, 0.0, 1.0, arm, -arm, 0.0], [-1.0, 0.0, 0.0, 0.0, arm, arm]);
        let back = along.map(|entry: f64| -entry);
        for ball in 0..5 {
            let on_floor = [(ball, &down[..])];
            problem.push(&BodyRows { law: Law::Push, bodies: &on_floor, bias: &[0.0], compliance: &[] }).unwrap();
            if ball > 0 {
                let beside = [(ball - 1, &along[..]), (ball, &back[..])];
                problem.push(&BodyRows { law: Law::Push, bodies: &beside, bias: &[0.0], compliance: &[] }).unwrap();
            }
        }
        problem
    }

    #[test]
    fn rounding_of_lever_arms_turns_no_body_and_is_counted() {
        for (arm, motion) in [(0.0, Motion::Translation), (3e-14, Motion::Translation), (0.1, Motion::Whole)] {
            let problem = row_of_balls(arm);
            let elimination = Elimination::of(&problem);
            let stiffness: Vec<RowMatrix> =
                problem.blocks.iter().map(|block| held_stiffness(&problem, block, 1e-6)).collect();
            let mut system = BodySystem::default();
            system.factor(&problem, &elimination, &stiffness);
            assert_eq!((system.motion, system.factorisations), (motion, 1), "{arm}");
            let given = |k: usize| ((7919 * k % 101) as f64 / 101.0) - 0.5;
            let bodies: Vec<Vector6> = (0..5).map(|body| std::array::from_fn(|k| given(6 * body + k))).collect();
            let wanted: Vec<f64> = (0..problem.rows()).map(given).collect();
            let (mut rows, mut dv) = (wanted.clone(), Vec::new());
            system.solve(&problem, &elimination, Sides { bodies: &bodies, rows: &mut rows }, 1, &mut dv);
            let mut left: Vec<Vector6> = bodies;
            for (index, block) in problem.blocks.iter().enumerate() {
                problem.add_impulses(block, &rows[block.rows.clone()], &mut left);
                let mut rate = [0.0];
                problem.add_rates(block, &dv, &mut rate);
                let by_law = wanted[index] - stiffness[index][0][0] * rate[0];
                assert!((rows[index] - by_law).abs() < 1e-8, "{arm}: {} for {by_law}", rows[index]);
            }
            for (left, dv) in left.as_flattened().iter().zip(dv.as_flattened()) {
                assert!((left - dv).abs() < 1e-12, "{arm}: {left} for {dv}");
            }
        }
    }
}
